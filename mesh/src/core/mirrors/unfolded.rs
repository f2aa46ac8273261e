//! A mesh with what its mirror planes show.

use std::borrow::Cow;

use rayon::prelude::*;

use super::cells::{HERE, OnPlanes, is_across, is_inside_out, shared};
use super::images::{Image, Images};
use super::planes::Planes;
use crate::core::raw_mesh::{Features, RawMesh, Tagged};
use crate::core::reference_tet::EDGES;
use crate::core::topology::{Topology, ascending};
use octruss_base::vector3::{Vector3, add, dot3, scale};

/// A mesh as the rules see it: itself, or with images beside its mirror planes. Its own
/// vertices come first and keep their numbers, its own tets keep theirs; edges do not.
pub(crate) struct Unfolded<'a> {
    pub mesh: Cow<'a, RawMesh>,
    pub topology: Cow<'a, Topology>,
    /// The vertices of the mesh itself.
    vertices: usize,
    behind: Option<Behind>,
}

/// What is behind the mirrors.
struct Behind {
    planes: Planes,
    /// For the mesh's own vertices.
    on: Vec<OnPlanes>,
    /// The vertices after the mesh's own.
    images: Vec<Image>,
    /// The unfolded number of each edge of the mesh.
    edges: Vec<u32>,
}

impl<'a> Unfolded<'a> {
    /// Unfolds a mesh at the mirror planes that its features name.
    pub fn new(mesh: &'a RawMesh, topology: &'a Topology) -> Self {
        match &mesh.features {
            Some(features) => Self::with_features(mesh, topology, features),
            None => Self::whole(mesh, topology),
        }
    }

    /// The mesh itself, whatever its features say.
    pub fn whole(mesh: &'a RawMesh, topology: &'a Topology) -> Self {
        let (vertices, behind) = (topology.vertex_count(), None);
        Self { mesh: Cow::Borrowed(mesh), topology: Cow::Borrowed(topology), vertices, behind }
    }

    /// Unfolds a mesh that was refined from this one at the same planes. It needs no
    /// positions; without, those of the unfolded mesh are 0.
    pub fn refined<'b>(&self, fine: &'b RawMesh, topology: &'b Topology) -> Unfolded<'b> {
        match &self.behind {
            Some(Behind { planes, .. }) => {
                Unfolded::at_planes(fine, topology, (fine.features.as_ref(), planes))
            }
            None => Unfolded::whole(fine, topology),
        }
    }

    /// Unfolds a mesh at the mirror planes that other features than its own name. The
    /// unfolded mesh has these features, but one without mirror planes its own.
    pub fn with_features(mesh: &'a RawMesh, topology: &'a Topology, features: &Features) -> Self {
        match Planes::of(mesh, &features.mirrors) {
            Some(planes) => Self::at_planes(mesh, topology, (Some(features), &planes)),
            None => Self::whole(mesh, topology),
        }
    }

    fn at_planes(
        mesh: &'a RawMesh,
        topology: &Topology,
        (features, planes): (Option<&Features>, &Planes),
    ) -> Self {
        let vertices = topology.vertex_count();
        let on = planes.at_vertices(mesh, vertices);
        let images = Images::new(mesh, &on);
        let points = if mesh.points.is_empty() {
            vec![[0.0; 3]; vertices + images.vertices.len()]
        } else {
            let behind = images.vertices.iter();
            let behind =
                behind.map(|image| planes.image(mesh.points[image.of as usize], image.cell));
            mesh.points.iter().copied().chain(behind).collect()
        };
        let unfolding = Unfolding { mesh, on: &on, images: &images };
        let unfolded = RawMesh { points, ..unfolding.mesh(features) };
        let unfolded_topology = Topology::new(&unfolded);
        let edge = |&[a, b]: &[u32; 2]| {
            unfolded_topology.edge_between(a, b).expect("an edge of a mesh is one of it unfolded")
        };
        let edges = topology.edges().par_iter().map(edge).collect();
        let behind = Behind { planes: planes.clone(), on, images: images.vertices, edges };
        Self {
            mesh: Cow::Owned(unfolded),
            topology: Cow::Owned(unfolded_topology),
            vertices,
            behind: Some(behind),
        }
    }

    /// Whether the mesh has mirror planes.
    pub fn has_mirrors(&self) -> bool {
        self.behind.is_some()
    }

    /// How many vertices the mesh itself has.
    pub fn vertices(&self) -> usize {
        self.vertices
    }

    /// How many edges the mesh itself has.
    pub fn edges(&self) -> usize {
        self.behind.as_ref().map_or(self.topology.edges().len(), |behind| behind.edges.len())
    }

    /// The unfolded number of an edge of the mesh.
    pub fn edge(&self, edge: usize) -> u32 {
        self.behind.as_ref().map_or(edge as u32, |behind| behind.edges[edge])
    }

    /// The vertex of the mesh that an unfolded one is, or is an image of.
    pub fn original(&self, vertex: u32) -> u32 {
        match (&self.behind, (vertex as usize).checked_sub(self.vertices)) {
            (Some(behind), Some(image)) => behind.images[image].of,
            _ => vertex,
        }
    }

    /// Whether both ends of an edge of the mesh lie on a common mirror plane.
    pub fn is_in_plane(&self, [a, b]: [u32; 2]) -> bool {
        self.on(a) & self.on(b) != 0
    }

    fn on(&self, vertex: u32) -> OnPlanes {
        self.behind.as_ref().map_or(0, |behind| behind.on[vertex as usize])
    }

    /// One value for each vertex of the mesh, with those of its images.
    pub fn with_images<'b>(&self, points: &'b [Vector3]) -> Cow<'b, [Vector3]> {
        let Some(Behind { planes, images, .. }) = &self.behind else { return points.into() };
        let image = |image: &Image| planes.image(points[image.of as usize], image.cell);
        points.iter().copied().chain(images.iter().map(image)).collect()
    }

    /// Makes the displacements of images those of what they are images of, turned round.
    pub fn turn_images(&self, displacements: &mut [Vector3]) {
        let Some(Behind { planes, images, .. }) = &self.behind else { return };
        let (own, behind) = displacements.split_at_mut(self.vertices);
        for (slot, image) in behind.iter_mut().zip(images) {
            *slot = planes.turned(own[image.of as usize], image.cell);
        }
    }

    /// The part of one tet in the images of a vertex that tets of the mesh itself take:
    /// 1 off the planes, a half on one, a quarter on two.
    pub fn share(&self, vertex: u32) -> f64 {
        0.5f64.powi(self.on(vertex).count_ones() as i32)
    }

    /// A vector by its components along the axes of the planes, where there are planes.
    pub fn to_axes(&self, vector: Vector3) -> Vector3 {
        match &self.behind {
            Some(Behind { planes, .. }) => planes.axes().map(|axis| dot3(axis, vector)),
            None => vector,
        }
    }

    /// The inverse of [`Self::to_axes`].
    pub fn from_axes(&self, components: Vector3) -> Vector3 {
        match &self.behind {
            Some(Behind { planes, .. }) => {
                let parts = planes.axes().iter().zip(components);
                parts.fold([0.0; 3], |sum, (&axis, component)| add(sum, scale(component, axis)))
            }
            None => components,
        }
    }

    /// Which components, along the axes of the planes, a displacement of a vertex may have:
    /// none across a plane that it lies on.
    pub fn is_free(&self, vertex: u32) -> [bool; 3] {
        let on = self.on(vertex);
        [0, 1, 2].map(|axis| !is_across(on, axis))
    }
}

/// A mesh while its images are added.
struct Unfolding<'a> {
    mesh: &'a RawMesh,
    on: &'a [OnPlanes],
    images: &'a Images,
}

impl Unfolding<'_> {
    /// Everything but the positions. Triangles on the planes lose their tags: no surface is
    /// there.
    fn mesh(&self, features: Option<&Features>) -> RawMesh {
        let Self { mesh, images, .. } = *self;
        let tets = images.tets.iter().map(|&image| {
            let mut tet = self.simplex(&mesh.tets, image);
            if is_inside_out(image.cell) {
                // This keeps the marked pair.
                tet.swap(0, 2);
            }
            tet
        });
        let regions = images.tets.iter().map(|image| mesh.regions[image.of as usize]);
        RawMesh {
            points: Vec::new(),
            tets: mesh.tets.iter().copied().chain(tets).collect(),
            regions: mesh.regions.iter().copied().chain(regions).collect(),
            triangles: self.tagged(&mesh.triangles, &images.triangles, |triangle, tag| {
                let on = triangle.iter().map(|&v| self.on[v as usize]);
                if on.fold(OnPlanes::MAX, |all, on| all & on) == 0 { tag } else { 0 }
            }),
            edges: self.tagged(&mesh.edges, &images.edges, |_, tag| tag),
            vertices: mesh.vertices.clone(),
            groups: Vec::new(),
            features: features.map(|features| self.features(features)),
        }
    }

    fn simplex<const N: usize>(&self, simplices: &[[u32; N]], image: Image) -> [u32; N] {
        simplices[image.of as usize].map(|v| self.vertex(v, image))
    }

    /// The unfolded number of a vertex of an image.
    fn vertex(&self, of: u32, Image { cell, .. }: Image) -> u32 {
        let cell = shared(cell, self.on[of as usize]);
        match self.images.vertices.binary_search(&Image { of, cell }) {
            Ok(at) => (self.on.len() + at) as u32,
            Err(_) => {
                debug_assert_eq!(cell, HERE, "the vertices of images are known");
                of
            }
        }
    }

    fn tagged<const N: usize>(
        &self,
        own: &Tagged<N>,
        images: &[Image],
        tag: impl Fn(&[u32; N], i32) -> i32,
    ) -> Tagged<N> {
        let mut tagged = Tagged::default();
        own.iter().for_each(|(simplex, old)| tagged.push(simplex, tag(&simplex, old)));
        for &image in images {
            let of = image.of as usize;
            let simplex = self.simplex(&own.simplices, image);
            tagged.push(simplex, tag(&own.simplices[of], own.tags[of]));
        }
        tagged
    }

    fn features(&self, features: &Features) -> Features {
        let mut creases = features.creases.clone();
        let Images { vertices, tets, triangles, edges } = self.images;
        let mut add = |ends: [u32; 2], image: Image| {
            if features.creases.binary_search(&ascending(ends)).is_ok() {
                creases.push(ascending(ends.map(|v| self.vertex(v, image))));
            }
        };
        if !features.creases.is_empty() {
            for &image in tets {
                let tet = self.mesh.tets[image.of as usize];
                EDGES.iter().for_each(|ends| add(ends.map(|v| tet[v]), image));
            }
            for &image in triangles {
                let [a, b, c] = self.mesh.triangles.simplices[image.of as usize];
                [[a, b], [a, c], [b, c]].into_iter().for_each(|ends| add(ends, image));
            }
            edges.iter().for_each(|&at| add(self.mesh.edges.simplices[at.of as usize], at));
        }
        creases.sort_unstable();
        creases.dedup();
        let corners = (self.on.len() as u32..).zip(vertices);
        let corners = corners.filter(|(_, at)| features.corners.binary_search(&at.of).is_ok());
        let states = &features.cell_states;
        let behind = tets.iter().filter_map(|image| states.get(image.of as usize));
        Features {
            creases,
            corners: features.corners.iter().copied().chain(corners.map(|(v, _)| v)).collect(),
            surfaces: features.surfaces.clone(),
            cell_states: states.iter().chain(behind).copied().collect(),
            ..Features::default()
        }
    }
}

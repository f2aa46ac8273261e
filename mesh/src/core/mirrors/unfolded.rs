//! A mesh with what its mirror planes show.

use std::borrow::Cow;

use rayon::prelude::*;

use super::cells::{OnPlanes, is_across};
use super::images::{Image, Images};
use super::planes::Planes;
use super::unfolding::Unfolding;
use crate::core::raw_mesh::{Features, RawMesh};
use crate::core::topology::Topology;
use octruss_base::ragged::CHUNK;
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

    /// Moves the vertices of a finer mesh, one for each vertex and edge, onto the planes that
    /// their coarse vertices are on to the last bit, so that those of the finer one are, too.
    pub fn keep_in_planes(&self, fine: &mut [Vector3]) {
        let Some(Behind { planes, on, edges, .. }) = &self.behind else { return };
        let points = self.mesh.points.iter().zip(on);
        let exact: Vec<OnPlanes> = points.map(|(&p, &on)| planes.exactly_on(p, on)).collect();
        fine.par_iter_mut().with_min_len(CHUNK).enumerate().for_each(|(row, point)| {
            let on = match row.checked_sub(self.vertices) {
                None => exact[row],
                Some(edge) => {
                    let [a, b] = self.topology.edges()[edges[edge] as usize];
                    exact[a as usize] & exact[b as usize]
                }
            };
            if on != 0 {
                *point = planes.moved_onto(*point, on);
            }
        });
    }

    /// The part of one tet in the images of a vertex that tets of the mesh itself take:
    /// 1 off the planes, a half on one, a quarter on two.
    pub fn share(&self, vertex: u32) -> f64 {
        0.5f64.powi(self.on(vertex).count_ones() as i32)
    }

    /// A vector by its components along the axes of the planes, where there are planes.
    pub fn components(&self, vector: Vector3) -> Vector3 {
        match &self.behind {
            Some(Behind { planes, .. }) => planes.axes().map(|axis| dot3(axis, vector)),
            None => vector,
        }
    }

    /// The inverse of [`Self::components`].
    pub fn along_axes(&self, components: Vector3) -> Vector3 {
        match &self.behind {
            Some(Behind { planes, .. }) => {
                let parts = planes.axes().iter().zip(components);
                parts.fold([0.0; 3], |sum, (&axis, component)| add(sum, scale(component, axis)))
            }
            None => components,
        }
    }

    /// The part of a displacement of a vertex that leads along the planes that it lies on.
    pub fn along_planes(&self, vertex: u32, displacement: Vector3) -> Vector3 {
        let is_free = self.is_free(vertex);
        if is_free == [true; 3] {
            return displacement;
        }
        let components = self.components(displacement);
        let free = |axis: usize| if is_free[axis] { components[axis] } else { 0.0 };
        self.along_axes(std::array::from_fn(free))
    }

    /// Which components, along the axes of the planes, a displacement of a vertex may have:
    /// none across a plane that it lies on.
    pub fn is_free(&self, vertex: u32) -> [bool; 3] {
        let on = self.on(vertex);
        [0, 1, 2].map(|axis| !is_across(on, axis))
    }
}

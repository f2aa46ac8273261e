//! Adding images to a mesh.

use super::cells::{HERE, OnPlanes, is_inside_out, shared};
use super::images::{Image, Images};
use crate::core::raw_mesh::{Features, RawMesh, Tagged};
use crate::core::reference_tet::EDGES;
use crate::core::topology::ascending;

/// A mesh while its images are added.
pub(super) struct Unfolding<'a> {
    pub mesh: &'a RawMesh,
    /// The planes of each vertex.
    pub on: &'a [OnPlanes],
    pub images: &'a Images,
}

impl Unfolding<'_> {
    /// Everything but the positions. Triangles on the planes lose their tags: no surface is
    /// there.
    pub fn mesh(&self, features: Option<&Features>) -> RawMesh {
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

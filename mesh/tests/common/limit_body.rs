//! A mesh with what its limit needs, and random features.

use octruss_mesh::limit::surface::LimitSurface;
use octruss_mesh::{RawMesh, Strata, Topology};

use super::random_block::Random;
use super::slow_surface::Point;

/// A mesh with its strata.
pub struct Body {
    pub mesh: RawMesh,
    pub topology: Topology,
    pub strata: Strata,
}

impl Body {
    pub fn new(mesh: RawMesh) -> Self {
        let topology = Topology::new(&mesh);
        let features = mesh.features.clone().unwrap_or_default();
        let strata = Strata::new(&mesh, &topology, &features);
        Self { mesh, topology, strata }
    }

    pub fn surface(&self) -> LimitSurface<'_> {
        LimitSurface::new(&self.mesh, &self.topology, &self.strata, &self.mesh.points).unwrap()
    }

    pub fn surface_faces(&self) -> Vec<u32> {
        let faces = 0..self.topology.faces().len() as u32;
        faces.filter(|&f| self.strata.is_surface[f as usize]).collect()
    }

    /// Creases and corners at random among the edges and vertices of surfaces.
    pub fn with_random_features(mut self, random: &mut Random, one_in: usize) -> Self {
        let edges = self.topology.edges().iter().zip(&self.strata.edge_dimensions);
        let edges: Vec<[u32; 2]> = edges.filter(|e| *e.1 < 3).map(|e| *e.0).collect();
        let mut features = self.mesh.features.take().unwrap_or_default();
        features.creases.extend(edges.iter().filter(|_| random.below(one_in) == 0));
        features.creases.sort_unstable();
        features.creases.dedup();
        features
            .corners
            .extend(edges.iter().map(|e| e[0]).filter(|_| random.below(4 * one_in) == 0));
        features.corners.sort_unstable();
        features.corners.dedup();
        self.mesh.features = Some(features);
        Self::new(self.mesh)
    }
}

pub fn distance(a: Point, b: Point) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

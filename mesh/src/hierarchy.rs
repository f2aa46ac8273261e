//! Meshes from coarse to fine.

use rayon::prelude::*;

use crate::core::tet_mesh::TetMesh;
use crate::core::topology::Topology;
use crate::features::{FeatureOptions, prepare};
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use crate::subdivide::refine::{Refinement, SubdivideError, subdivide};
use crate::subdivide::step::Step;
use octruss_base::ragged::CHUNK;

/// Meshes from coarse to fine, their topologies, and the refinement between
/// neighbours: refinement l leads from mesh l to mesh l + 1.
///
/// ```
/// use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, shapes};
/// let mut hierarchy = Hierarchy::new(shapes::kuhn_cube(1), &FeatureOptions::default());
/// hierarchy.subdivide(Scheme::BoxSpline)?;
/// assert_eq!(hierarchy.finest().tets().len(), 48);
/// # Ok::<(), octruss_mesh::SubdivideError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Hierarchy {
    /// Coarsest first.
    pub meshes: Vec<TetMesh>,
    /// One a mesh.
    pub topologies: Vec<Topology>,
    /// One fewer than meshes.
    pub refinements: Vec<Refinement>,
}

impl Hierarchy {
    /// Starts from one mesh, which is marked and searched for features unless
    /// it carries them already.
    pub fn new(mesh: TetMesh, options: &FeatureOptions) -> Self {
        let mesh = prepare(mesh, options);
        let topology = Topology::new(mesh.raw());
        Self { meshes: vec![mesh], topologies: vec![topology], refinements: Vec::new() }
    }

    /// Adds a finer level.
    ///
    /// # Errors
    /// As [`subdivide`]; the hierarchy then stays as it was.
    pub fn subdivide(&mut self, step: impl Into<Step>) -> Result<(), SubdivideError> {
        let (mesh, topology) = (self.finest(), &self.topologies[self.topologies.len() - 1]);
        let (fine, fine_topology, refinement) = subdivide(mesh, topology, step, self.meshes.len())?;
        self.meshes.push(fine);
        self.topologies.push(fine_topology);
        self.refinements.push(refinement);
        Ok(())
    }

    /// The finest mesh.
    pub fn finest(&self) -> &TetMesh {
        self.meshes.last().expect("a hierarchy has at least one mesh")
    }

    /// How far a prolongation from mesh `transfer` to mesh `transfer` + 1 misses
    /// the linear functions: max |P x_c − x_f| over the mean length of the coarse
    /// edges. The largest difference of a coordinate counts.
    ///
    /// # Panics
    /// If there is no such transfer, or the matrix is not of its size.
    pub fn affine_defect(&self, transfer: usize, prolongation: &SubdivisionMatrix) -> f64 {
        let (coarse, fine) = (&self.meshes[transfer], &self.meshes[transfer + 1]);
        let carried = prolongation.apply(coarse.points());
        assert_eq!(carried.len(), fine.points().len(), "one row a fine vertex");
        let distance = |(p, q): (&[f64; 3], &[f64; 3])| {
            (0..3).map(|k| (p[k] - q[k]).abs()).fold(0.0, f64::max)
        };
        let miss = carried.par_iter().zip(fine.points()).map(distance).reduce(|| 0.0, f64::max);
        miss / mean_edge_length(coarse, &self.topologies[transfer])
    }
}

/// The mean length of a mesh's edges, in mesh units.
pub fn mean_edge_length(mesh: &TetMesh, topology: &Topology) -> f64 {
    let length = |&[a, b]: &[u32; 2]| {
        let [p, q] = [a, b].map(|v| mesh.points()[v as usize]);
        (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt()
    };
    // By chunks, so that the sum does not depend on the number of threads.
    let edges = topology.edges();
    let sums: Vec<f64> =
        edges.par_chunks(CHUNK).map(|chunk| chunk.iter().map(length).sum()).collect();
    sums.iter().sum::<f64>() / edges.len() as f64
}

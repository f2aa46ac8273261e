//! Meshes from coarse to fine.

use std::sync::Arc;

use rayon::prelude::*;

use crate::core::edge_length::mean_edge_length;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::Topology;
use crate::features::{FeatureOptions, prepare};
use crate::refinement::refinement::Refinement;
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use crate::subdivide::error::SubdivideError;
use crate::subdivide::refine::subdivide;
use crate::subdivide::step::Step;

/// A mesh of a hierarchy, and how it came from the next coarser one.
#[derive(Debug, Clone)]
pub struct Level {
    /// The mesh.
    pub mesh: TetMesh,
    /// Its edges, faces and incidences.
    pub topology: Topology,
    /// How it came from the next coarser level; none for the coarsest.
    pub refinement: Option<Refinement>,
}

impl From<(TetMesh, Topology, Refinement)> for Level {
    /// A level that was made from a coarser one.
    fn from((mesh, topology, refinement): (TetMesh, Topology, Refinement)) -> Self {
        Self { mesh, topology, refinement: Some(refinement) }
    }
}

/// Levels, coarsest first; transfer l leads from level l to level l + 1.
///
/// Levels are shared, not copied, by whatever is cloned or truncated.
///
/// ```
/// use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, shapes};
/// let mut hierarchy = Hierarchy::new(shapes::kuhn_cube(1), &FeatureOptions::default());
/// hierarchy.subdivide(Scheme::BoxSpline)?;
/// assert_eq!(hierarchy.finest().mesh.tets().len(), 48);
/// assert_eq!(hierarchy.refinement(0).matrix.rows(), hierarchy.finest().mesh.points().len());
/// # Ok::<(), octruss_mesh::SubdivideError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Hierarchy {
    /// Never empty; all but the first have a refinement.
    levels: Vec<Arc<Level>>,
}

impl Hierarchy {
    /// Starts from one mesh, which is marked and searched for features unless
    /// it carries them already.
    pub fn new(mesh: TetMesh, options: &FeatureOptions) -> Self {
        let mesh = prepare(mesh, options);
        let topology = Topology::new(mesh.raw());
        Self { levels: vec![Arc::new(Level { mesh, topology, refinement: None })] }
    }

    /// Adds a finer level.
    ///
    /// # Errors
    /// As [`subdivide`]; the hierarchy then stays as it was.
    pub fn subdivide(&mut self, step: impl Into<Step>) -> Result<(), SubdivideError> {
        let Level { mesh, topology, .. } = self.finest();
        let made = subdivide(mesh, topology, step, self.levels.len())?;
        self.levels.push(Arc::new(made.into()));
        Ok(())
    }

    /// Puts other levels in the place of those from a number on.
    pub(crate) fn replace_from(
        &mut self,
        first: usize,
        levels: impl IntoIterator<Item = Arc<Level>>,
    ) {
        debug_assert!((1..=self.levels.len()).contains(&first));
        self.levels.truncate(first);
        self.levels.extend(levels);
    }

    /// The levels, coarsest first; at least one.
    pub fn levels(&self) -> &[Arc<Level>] {
        &self.levels
    }

    /// The level that the hierarchy starts from.
    pub fn coarsest(&self) -> &Level {
        &self.levels[0]
    }

    /// The level that was added last.
    pub fn finest(&self) -> &Level {
        &self.levels[self.transfers()]
    }

    /// The number of pairs of neighbouring levels: one fewer than levels.
    pub fn transfers(&self) -> usize {
        self.levels.len() - 1
    }

    /// The refinement from level `transfer` to level `transfer` + 1.
    ///
    /// # Panics
    /// If there is no such transfer.
    pub fn refinement(&self, transfer: usize) -> &Refinement {
        self.levels[transfer + 1].refinement.as_ref().expect("only the coarsest level has none")
    }

    /// The refinements between neighbouring levels, coarsest first; one a transfer.
    pub fn refinements(&self) -> impl ExactSizeIterator<Item = &Refinement> + DoubleEndedIterator {
        (0..self.transfers()).map(|transfer| self.refinement(transfer))
    }

    /// The coarsest `levels` levels, shared with this hierarchy; all if there are
    /// no more.
    ///
    /// # Panics
    /// If `levels` is 0.
    pub fn truncated(&self, levels: usize) -> Self {
        assert!(levels > 0, "a hierarchy has at least one level");
        Self { levels: self.levels.iter().take(levels).cloned().collect() }
    }

    /// The finest level, which is copied only if others share it.
    pub fn into_finest(mut self) -> Level {
        let finest = self.levels.pop().expect("a hierarchy has at least one level");
        Arc::unwrap_or_clone(finest)
    }

    /// How far a prolongation from level `transfer` to level `transfer` + 1 misses
    /// the linear functions: max |P x_c − x_f| over the mean length of the coarse
    /// edges. The largest difference of a coordinate counts.
    ///
    /// # Panics
    /// If there is no such transfer, or the matrix is not of its size.
    pub fn affine_defect(&self, transfer: usize, prolongation: &SubdivisionMatrix) -> f64 {
        let [coarse, fine] = [transfer, transfer + 1].map(|level| &self.levels[level]);
        let carried = prolongation.apply(coarse.mesh.points());
        assert_eq!(carried.len(), fine.mesh.points().len(), "one row a fine vertex");
        let distance = |(p, q): (&[f64; 3], &[f64; 3])| {
            (0..3).map(|k| (p[k] - q[k]).abs()).fold(0.0, f64::max)
        };
        let pairs = carried.par_iter().zip(fine.mesh.points());
        let miss = pairs.map(distance).reduce(|| 0.0, f64::max);
        miss / mean_edge_length(coarse.mesh.points(), &coarse.topology)
    }
}

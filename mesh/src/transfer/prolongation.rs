//! The matrix that prolongs between two meshes of a hierarchy.
//!
//! Any scheme's matrix can prolong on any hierarchy, whichever scheme made its
//! geometry. Where it is not the one that did, it should be corrected.

use std::borrow::Cow;

use crate::core::edge_length::mean_edge_length;
use crate::core::mirrors::Unfolded;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::{NONE, Topology};
use crate::hierarchy::{Hierarchy, Level};
use crate::refinement::affine_correction::{
    AffineCorrection, CorrectedRows, Geometry, NEGLIGIBLE_DEFECT, corrected,
};
use crate::refinement::subdivision_matrix::{SubdivisionMatrix, linear_matrix};
use crate::scheme::Scheme;
use crate::subdivide::assemble_matrix::subdivision_matrix;

/// Which matrix prolongs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProlongationOptions {
    /// Whose weights.
    pub scheme: Scheme,
    /// What rows on interfaces between regions read.
    pub interface_rows: InterfaceRows,
    /// Which rows are made exact for linear functions.
    pub affine_correction: AffineCorrection,
}

impl From<Scheme> for ProlongationOptions {
    /// The scheme's own rows everywhere, corrected where the transfer needs it.
    fn from(scheme: Scheme) -> Self {
        let (interface_rows, affine_correction) = Default::default();
        Self { scheme, interface_rows, affine_correction }
    }
}

/// The rows of vertices and edges on faces between regions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum InterfaceRows {
    /// The scheme's, within the strata of the interface.
    #[default]
    Strata,
    /// Those of linear interpolation.
    Linear,
}

impl InterfaceRows {
    /// Every choice.
    pub const ALL: [Self; 2] = [Self::Strata, Self::Linear];

    /// The name by which configurations call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Strata => "strata",
            Self::Linear => "linear",
        }
    }
}

/// A matrix that prolongs, and how it came about.
#[derive(Debug, Clone, PartialEq)]
pub struct Prolongation<'a> {
    /// One row a fine vertex, one column a coarse vertex; rows sum to one.
    pub matrix: Cow<'a, SubdivisionMatrix>,
    /// The affine defect before rows were corrected, see [`Hierarchy::affine_defect`];
    /// none if there was no reason to look at it: then it is that of the matrix.
    pub defect_before: Option<f64>,
    /// What correcting did; all 0 if it was not called for.
    pub corrected: CorrectedRows,
}

impl Hierarchy {
    /// The prolongation from mesh `transfer` to mesh `transfer` + 1. That of the
    /// scheme which refined the mesh is its matrix, guard included, and exact.
    ///
    /// Schemes have rules for meshes of which every edge is split. Where only some were,
    /// as by [`Hierarchy::split_marked`], the matrix that made the mesh prolongs,
    /// whatever scheme is asked for.
    ///
    /// # Panics
    /// If there is no such transfer.
    pub fn prolongation(
        &self,
        transfer: usize,
        options: impl Into<ProlongationOptions>,
    ) -> Prolongation<'_> {
        let ProlongationOptions { scheme, interface_rows, affine_correction } = options.into();
        let Level { mesh, topology, .. } = &*self.levels()[transfer];
        let refinement = self.refinement(transfer);
        // Elsewhere vertices stay, and no scheme has a rule for that.
        let is_local = !refinement.ancestry.is_uniform();
        let scheme = if is_local { refinement.scheme } else { scheme };
        let mut matrix = match scheme {
            _ if refinement.scheme == scheme => Cow::Borrowed(&refinement.matrix),
            _ => Cow::Owned(subdivision_matrix(mesh, topology, scheme)),
        };
        if interface_rows == InterfaceRows::Linear && scheme != Scheme::Linear && !is_local {
            matrix = linear_at_interfaces(matrix, mesh, topology);
        }
        let made_the_mesh = matches!(matrix, Cow::Borrowed(_));
        let asks = match affine_correction {
            AffineCorrection::Auto => scheme != Scheme::Linear && !made_the_mesh,
            AffineCorrection::On => true,
            AffineCorrection::Off => false,
        };
        let defect_before = asks.then(|| self.affine_defect(transfer, &matrix));
        let is_wanted = match affine_correction {
            AffineCorrection::On => true,
            _ => defect_before.is_some_and(|defect| defect > NEGLIGIBLE_DEFECT),
        };
        if !is_wanted {
            let corrected = CorrectedRows::default();
            return Prolongation { matrix, defect_before, corrected };
        }
        let fine = self.levels()[transfer + 1].mesh.points();
        let length = mean_edge_length(mesh.points(), topology);
        let coarse = Unfolded::whole(mesh.raw(), topology);
        let geometry = Geometry::new(&coarse, fine, length);
        let (exact, corrected) = corrected(&matrix, &geometry);
        Prolongation { matrix: Cow::Owned(exact), defect_before, corrected }
    }
}

/// The matrix with the linear rule at every vertex and edge on a face between regions.
fn linear_at_interfaces<'a>(
    matrix: Cow<'a, SubdivisionMatrix>,
    mesh: &TetMesh,
    topology: &Topology,
) -> Cow<'a, SubdivisionMatrix> {
    let regions = mesh.regions();
    let n = topology.vertex_count();
    let mut on_interface = vec![false; matrix.rows()];
    let sides = topology.face_tets().iter().enumerate();
    for (face, _) in sides.filter(|(_, [first, second])| {
        *second != NONE && regions[*first as usize] != regions[*second as usize]
    }) {
        topology.faces()[face].iter().for_each(|&v| on_interface[v as usize] = true);
        topology.face_edges()[face].iter().for_each(|&e| on_interface[n + e as usize] = true);
    }
    if !on_interface.contains(&true) {
        return matrix;
    }
    let linear = linear_matrix(topology);
    let row = |row: usize| if on_interface[row] { linear.row(row) } else { matrix.row(row) };
    Cow::Owned(SubdivisionMatrix::from_rows(matrix.rows(), n, |number, entries| {
        let (columns, weights) = row(number);
        columns.iter().zip(weights).for_each(|(&column, &weight)| entries.add(column, weight));
    }))
}

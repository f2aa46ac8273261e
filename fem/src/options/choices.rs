//! The closed choices of a solve.

use octruss_base::choice::Choice;

/// What the cycle is used for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// As preconditioner of conjugate gradients, in their flexible form where it is
    /// not symmetric.
    ConjugateGradients,
    /// Alone: cycle after cycle.
    Cycle,
}

impl Choice for Method {
    const WHAT: &'static str = "method";
    const ALL: &'static [Self] = &[Self::ConjugateGradients, Self::Cycle];
    fn name(self) -> &'static str {
        match self {
            Self::ConjugateGradients => "cg",
            Self::Cycle => "cycle",
        }
    }
}

/// The shape of the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cycle {
    /// Coarser levels are visited once.
    V,
    /// Coarser levels are visited twice from each level.
    W,
    /// A pass of full multigrid, with one V-cycle a level, finds the start; the
    /// iteration goes on with V-cycles.
    Full,
}

impl Choice for Cycle {
    const WHAT: &'static str = "cycle";
    const ALL: &'static [Self] = &[Self::V, Self::W, Self::Full];
    fn name(self) -> &'static str {
        match self {
            Self::V => "v",
            Self::W => "w",
            Self::Full => "full",
        }
    }
}

/// How full multigrid brings the solution of a level to the next finer one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FullTransfer {
    /// By the matrices that refined the mesh.
    Scheme,
    /// By linear interpolation on edges.
    Linear,
    /// By quadratic interpolation on the tets of the level below; linear from the
    /// coarsest level, which has none below.
    Quadratic,
}

impl Choice for FullTransfer {
    const WHAT: &'static str = "transfer";
    const ALL: &'static [Self] = &[Self::Scheme, Self::Linear, Self::Quadratic];
    fn name(self) -> &'static str {
        match self {
            Self::Scheme => "scheme",
            Self::Linear => "linear",
            Self::Quadratic => "quadratic",
        }
    }
}

/// Where coarse matrices come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CoarseOperator {
    /// Pᵀ A P.
    Galerkin,
    /// Assembled on the coarse meshes.
    Reassembled,
}

impl Choice for CoarseOperator {
    const WHAT: &'static str = "coarse operator";
    const ALL: &'static [Self] = &[Self::Galerkin, Self::Reassembled];
    fn name(self) -> &'static str {
        match self {
            Self::Galerkin => "galerkin",
            Self::Reassembled => "reassembled",
        }
    }
}

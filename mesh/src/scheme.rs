//! Which weights a subdivision step uses.

/// A subdivision scheme: everything that changes the shape, as one value.
///
/// Each has a rule for every dimension of stratum; see [`crate::strata`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scheme {
    /// Midpoints: the shape stays, the tets get smaller.
    Linear,
    /// Chang's approximating scheme (thesis, chapter 4): C² in the regular
    /// interior.
    BoxSpline,
    /// The mean of the three box splines of an octet truss (thesis, section
    /// 4.7): does not depend on which pairs are marked.
    Averaged,
    /// Chang's interpolatory scheme (thesis, chapter 5): vertices stay.
    Interpolatory {
        /// The tension w; 0 is linear, 1/16 reproduces cubics on the lattice.
        tension: f64,
        /// The rule of an edge that all its four tets mark.
        marked: MarkedRule,
    },
    /// Wang's Loop-based scheme (thesis, chapter 3): vertices are averaged,
    /// edges halved inside.
    LoopSolid {
        /// The weight c of an interior vertex itself.
        interior: f64,
    },
}

/// The interpolatory rule of an edge that all its four tets mark.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MarkedRule {
    /// The mean of the butterfly rule in the two lattice planes through the
    /// edge: C¹ for 0 < w < 1/6.
    PlaneButterfly,
    /// As published (equation 5.9), for comparison: reproduces degree 1 only
    /// and is not C¹ for any w.
    Literal,
}

impl Scheme {
    /// The interpolatory scheme with its usual tension.
    pub const INTERPOLATORY: Self =
        Self::Interpolatory { tension: 1.0 / 16.0, marked: MarkedRule::PlaneButterfly };
    /// The Loop-based scheme with its usual weight.
    pub const LOOP_SOLID: Self = Self::LoopSolid { interior: 0.8 };

    /// The name by which configurations and the command line call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::BoxSpline => "box-spline",
            Self::Averaged => "averaged",
            Self::Interpolatory { marked: MarkedRule::PlaneButterfly, .. } => "interpolatory",
            Self::Interpolatory { marked: MarkedRule::Literal, .. } => "interpolatory-literal",
            Self::LoopSolid { .. } => "loop-solid",
        }
    }

    /// Every scheme, with its usual parameters.
    pub const ALL: [Self; 6] = [
        Self::Linear,
        Self::BoxSpline,
        Self::Averaged,
        Self::INTERPOLATORY,
        Self::Interpolatory { tension: 1.0 / 16.0, marked: MarkedRule::Literal },
        Self::LOOP_SOLID,
    ];

    /// Whether vertices of the coarse mesh stay where they are.
    pub fn keeps_vertices(self) -> bool {
        matches!(self, Self::Linear | Self::Interpolatory { .. })
    }

    /// Whether some weights are negative, so that values may leave the range of
    /// their stencil.
    pub fn overshoots(self) -> bool {
        matches!(self, Self::Interpolatory { .. })
    }
}

//! What an approximating scheme does at the ends of a curve.

/// The rule of an approximating scheme beside a fixed end of a curve stratum: a
/// corner, or where other curves meet. Interpolatory schemes have their own, and the
/// end of a crease in a smooth surface keeps the B-spline rule.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CurveEnds {
    /// The B-spline rule up to the end: the limit leaves it straight, with no curvature.
    #[default]
    Fixed,
    /// Rules that reproduce a parabola at the end: the first edge (6, 9, −1)/14, the
    /// vertex after it (3, 22, 3)/28; on a curve of two edges (7, 10, −1)/16 and
    /// (3, 26, 3)/32. A curve of one edge stays straight. The eigenvalues at the end are
    /// 1, ½, ¼.
    Parabola,
}

impl CurveEnds {
    /// Every choice.
    pub const ALL: [Self; 2] = [Self::Fixed, Self::Parabola];

    /// The name by which configurations and the command line call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fixed => "fixed",
            Self::Parabola => "parabola",
        }
    }
}

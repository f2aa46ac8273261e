//! Why a curve or a point is one.

/// Why an edge is in the curve stratum, or a vertex in the point stratum. Where
/// several reasons hold, the first in this order is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reason {
    /// Three or more faces of surfaces meet at the edge, for instance where an
    /// interface meets the boundary.
    Junction,
    /// A surface ends at the edge: one face of it is there.
    SurfaceBorder,
    /// Surfaces meet at the vertex and at no edge of it.
    TouchingPoint,
    /// The edge or vertex was asked for by number.
    AskedFor,
    /// The edge is in a curve group.
    CurveGroup,
    /// The vertex is in a point group.
    PointGroup,
    /// The faces at the edge are in different surface groups, whose border is kept.
    GroupBorder,
    /// The angle between the faces at the edge.
    Angle,
    /// The file says so: the mesh was refined before.
    Recorded,
    /// The edge is part of no tet and no face.
    FreeEdge,
    /// Three or more curve edges meet at the vertex.
    CurvesMeet,
    /// The vertex has nothing to follow: it is the end of a free-standing curve,
    /// or stands alone.
    LooseEnd,
}

impl Reason {
    /// Every reason, the first one first.
    pub const ALL: [Self; 12] = [
        Self::Junction,
        Self::SurfaceBorder,
        Self::TouchingPoint,
        Self::AskedFor,
        Self::CurveGroup,
        Self::PointGroup,
        Self::GroupBorder,
        Self::Angle,
        Self::Recorded,
        Self::FreeEdge,
        Self::CurvesMeet,
        Self::LooseEnd,
    ];

    /// The reasons that edges can have.
    pub const OF_CURVES: [Self; 8] = [
        Self::Junction,
        Self::SurfaceBorder,
        Self::AskedFor,
        Self::CurveGroup,
        Self::GroupBorder,
        Self::Angle,
        Self::Recorded,
        Self::FreeEdge,
    ];

    /// The reasons that vertices can have.
    pub const OF_POINTS: [Self; 6] = [
        Self::TouchingPoint,
        Self::AskedFor,
        Self::PointGroup,
        Self::Recorded,
        Self::CurvesMeet,
        Self::LooseEnd,
    ];

    /// The name by which reports and files call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Junction => "junction",
            Self::SurfaceBorder => "surface-border",
            Self::TouchingPoint => "touching-point",
            Self::AskedFor => "asked-for",
            Self::CurveGroup => "curve-group",
            Self::PointGroup => "point-group",
            Self::GroupBorder => "group-border",
            Self::Angle => "angle",
            Self::Recorded => "recorded",
            Self::FreeEdge => "free-edge",
            Self::CurvesMeet => "curves-meet",
            Self::LooseEnd => "loose-end",
        }
    }

    /// Its number in files: its place in [`Reason::ALL`], from 1.
    pub fn code(self) -> u8 {
        self as u8 + 1
    }
}

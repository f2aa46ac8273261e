//! Why the curves and points of a coarsest mesh are what they are.

use super::FeatureOptions;
use super::found::Found;
use crate::core::raw_mesh::Features;
use crate::core::strata::Strata;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::Topology;

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
    /// The faces at the edge are in different surface groups.
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

/// The curve and point strata of a coarsest mesh, with a reason for each part.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct FeatureReasons {
    /// Every edge of the curve stratum, ends ascending, sorted.
    pub curves: Vec<([u32; 2], Reason)>,
    /// Every vertex of the point stratum, ascending.
    pub points: Vec<(u32, Reason)>,
}

impl FeatureReasons {
    /// Explains a mesh that was readied with `options`; without them its features
    /// count as recorded.
    pub fn new(mesh: &TetMesh, topology: &Topology, options: Option<&FeatureOptions>) -> Self {
        let features = mesh.features().cloned().unwrap_or_default();
        let strata = Strata::new(mesh.raw(), topology, &features);
        let found = match options {
            Some(options) => Found::new(mesh.raw(), topology, options),
            None => recorded(features),
        };
        let curves = topology.edges().iter().zip(&strata.edge_dimensions).enumerate();
        let curves =
            curves.filter(|(_, (_, dimension))| **dimension == 1).map(|(edge, (&ends, _))| {
                let otherwise = match strata.opposite_vertices(edge as u32).len() {
                    0 => Reason::FreeEdge,
                    1 => Reason::SurfaceBorder,
                    _ => Reason::Junction,
                };
                (ends, reason_of(&found.creases, ends).unwrap_or(otherwise))
            });
        let points =
            (0u32..).zip(&strata.vertex_dimensions).filter(|(_, dimension)| **dimension == 0);
        let points = points.map(|(vertex, _)| {
            let otherwise = match strata.curve_neighbours(vertex).len() {
                3.. => Reason::CurvesMeet,
                _ => Reason::LooseEnd,
            };
            (vertex, reason_of(&found.corners, vertex).unwrap_or(otherwise))
        });
        Self { curves: curves.collect(), points: points.collect() }
    }
}

fn recorded(features: Features) -> Found {
    Found {
        creases: features.creases.into_iter().map(|ends| (ends, Reason::Recorded)).collect(),
        corners: features.corners.into_iter().map(|vertex| (vertex, Reason::Recorded)).collect(),
        surfaces: features.surfaces,
    }
}

fn reason_of<T: Ord + Copy>(found: &[(T, Reason)], part: T) -> Option<Reason> {
    found.binary_search_by_key(&part, |entry| entry.0).ok().map(|at| found[at].1)
}

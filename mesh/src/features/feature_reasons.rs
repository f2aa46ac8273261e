//! Why the curves and points of a coarsest mesh are what they are.

use crate::core::raw_mesh::Features;
use crate::core::strata::Strata;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::Topology;
use crate::features::found::Found;
use crate::features::options::FeatureOptions;
use crate::features::reason::Reason;

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
        mirrors: features.mirrors,
    }
}

fn reason_of<T: Ord + Copy>(found: &[(T, Reason)], part: T) -> Option<Reason> {
    found.binary_search_by_key(&part, |entry| entry.0).ok().map(|at| found[at].1)
}

//! The rule of each stratum, by scheme.

use super::shares::midpoint;
use super::{averaged, box_spline, curve, interpolatory, loop_solid, surface};
use crate::core::curve_ends::CurveEnds;
use crate::core::raw_mesh::RawMesh;
use crate::core::topology::{EdgeFaces, Topology, VertexEdges};
use crate::refinement::subdivision_matrix::Row;
use crate::scheme::Scheme;
use crate::subdivide::neighbourhoods::Neighbourhoods;
use crate::subdivide::octets::Octets;

/// The rules of one scheme on one mesh.
pub(crate) struct Rules<'a> {
    scheme: Scheme,
    curve_ends: CurveEnds,
    near: Neighbourhoods<'a>,
    /// The cells of the octet truss, for the scheme that lives on it.
    octets: Option<Octets>,
}

impl<'a> Rules<'a> {
    pub fn new(
        mesh: &'a RawMesh,
        topology: &'a Topology,
        incidences: (&'a VertexEdges, &'a EdgeFaces<'a>),
        scheme: Scheme,
        curve_ends: CurveEnds,
    ) -> Self {
        let near = Neighbourhoods::new(mesh, topology, incidences);
        let octets = (scheme == Scheme::Averaged).then(|| Octets::new(&near, mesh, topology));
        Self { scheme, curve_ends, near, octets }
    }

    fn octets(&self) -> &Octets {
        self.octets.as_ref().expect("made for the averaged scheme")
    }

    /// Adds the entries of the row of a coarse vertex.
    pub fn vertex_row(&self, vertex: u32, row: &mut Row) {
        let near = &self.near;
        let dimension = near.strata.vertex_dimensions[vertex as usize];
        match (dimension, self.scheme) {
            (0, _) => row.add(vertex, 1.0),
            _ if self.scheme.keeps_vertices() => row.add(vertex, 1.0),
            (1, _) => curve::smooth_vertex(&near.strata, vertex, self.curve_ends, row),
            (2, _) => surface::loop_vertex(near, vertex, row),
            (_, Scheme::Averaged) => averaged::vertex(near, self.octets(), vertex, row),
            (_, Scheme::LoopSolid { interior, .. }) => {
                loop_solid::vertex(near, vertex, interior, row)
            }
            _ => box_spline::vertex(near, vertex, row),
        }
    }

    /// Adds the entries of the row of an edge, for its new vertex.
    pub fn edge_row(&self, edge: u32, row: &mut Row) {
        let near = &self.near;
        let dimension = near.strata.edge_dimensions[edge as usize];
        match (dimension, self.scheme) {
            (_, Scheme::Linear) => midpoint(near, edge, row),
            (1, Scheme::Interpolatory { tension, .. }) => {
                curve::four_point_edge(near, edge, tension, row)
            }
            (1, _) => curve::smooth_edge(near, edge, self.curve_ends, row),
            (2, Scheme::Interpolatory { tension, .. }) => {
                surface::butterfly_edge(near, edge, tension, row)
            }
            (2, _) => surface::loop_edge(near, edge, row),
            (_, Scheme::Averaged) => averaged::edge(near, self.octets(), edge, row),
            (_, Scheme::Interpolatory { tension, marked }) => {
                interpolatory::edge(near, edge, tension, marked, row)
            }
            (_, Scheme::LoopSolid { .. }) => midpoint(near, edge, row),
            (_, Scheme::BoxSpline) => box_spline::edge(near, edge, row),
        }
    }
}

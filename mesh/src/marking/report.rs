//! How far a marking agrees, and the edges that refinement will have.

use crate::core::reference_tet::edge_in_face;
use crate::core::topology::{NONE, Topology};

/// How many faces two tets mark differently, and how many tets surround the
/// interior edges.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MarkingReport {
    /// Interior faces whose two tets mark different edges of it.
    pub conflicting_faces: usize,
    /// Faces between two tets.
    pub interior_faces: usize,
    /// How many interior edges have k tets round them, as (k, count), k ascending.
    pub edge_valences: Vec<(u32, usize)>,
    /// The same after one red split, in which the halves of an edge keep its
    /// tets, an inner diagonal has 4, and the three new edges in an interior
    /// face have 4, 6, 6 if its tets agree, else 5, 5, 6.
    pub split_edge_valences: Vec<(u32, usize)>,
}

/// Reports on the marking that the tets' order has; the topology is that of the
/// mesh as marked.
pub fn marking_report(topology: &Topology) -> MarkingReport {
    let (interior_faces, conflicting_faces) = count_faces(topology);
    let edges = interior_edge_valences(topology);
    let tets = topology.tet_edges().len();
    let agreeing = interior_faces - conflicting_faces;
    let halves = edges.iter().map(|&(valence, count)| (valence, 2 * count));
    let inner =
        [(4, tets + agreeing), (5, 2 * conflicting_faces), (6, 2 * agreeing + conflicting_faces)];
    let split_edge_valences = histogram(halves.chain(inner).collect());
    MarkingReport { conflicting_faces, interior_faces, edge_valences: edges, split_edge_valences }
}

/// Interior faces, and those of them that are marked differently.
fn count_faces(topology: &Topology) -> (usize, usize) {
    let mut first_marks = vec![NONE; topology.faces().len()];
    let (mut interior, mut conflicting) = (0, 0);
    for (faces, edges) in topology.tet_faces().iter().zip(topology.tet_edges()) {
        for (local, &face) in faces.iter().enumerate() {
            let mark = edges[edge_in_face(0, local)];
            match std::mem::replace(&mut first_marks[face as usize], mark) {
                NONE => {}
                other => {
                    interior += 1;
                    conflicting += usize::from(other != mark);
                }
            }
        }
    }
    (interior, conflicting)
}

fn interior_edge_valences(topology: &Topology) -> Vec<(u32, usize)> {
    let mut valences = vec![0; topology.edges().len()];
    for &edge in topology.tet_edges().as_flattened() {
        valences[edge as usize] += 1;
    }
    for face in (0..topology.faces().len()).filter(|&face| topology.is_boundary(face)) {
        topology.face_edges()[face].iter().for_each(|&edge| valences[edge as usize] = 0);
    }
    histogram(valences.into_iter().map(|valence| (valence, 1)).collect())
}

/// Adds up counts of equal valence; 0 (not in the interior) is left out.
fn histogram(mut counts: Vec<(u32, usize)>) -> Vec<(u32, usize)> {
    counts.retain(|&(valence, count)| valence > 0 && count > 0);
    counts.sort_unstable();
    counts
        .chunk_by(|a, b| a.0 == b.0)
        .map(|equal| (equal[0].0, equal.iter().map(|(_, count)| count).sum()))
        .collect()
}

//! Marking a mesh by a strategy.

use crate::core::raw_mesh::RawMesh;
use crate::core::reference_tet::MARKING_PERMUTATIONS;
use crate::core::topology::Topology;
use crate::marking::agreement::{Marks, Preference};
use crate::marking::breadth_first::breadth_first_parts;
use crate::marking::diagonals::ranks;
use crate::marking::strategy::Marking;

/// Reorders each tet by an even permutation so that it marks the pair that the
/// strategy chooses; numbers of cells and vertices stay.
///
/// The topology is the mesh's before; afterwards its local tables (edges and
/// faces of tets) are out of date.
pub fn mark(mesh: &mut RawMesh, topology: &Topology, marking: Marking) {
    let prefer = |preference: fn([u8; 3]) -> Preference| -> Vec<Preference> {
        let corners = |tet: &[u32; 4]| tet.map(|v| mesh.points[v as usize]);
        mesh.tets.iter().map(|tet| preference(ranks(corners(tet)))).collect()
    };
    let preferences = match marking {
        Marking::AsOrdered => return,
        Marking::Shortest => prefer(Preference::shortest),
        Marking::Agree => prefer(Preference::any),
        Marking::BreadthFirst => prefer(|_| Preference::any([0; 3])),
    };
    let mut marks = Marks::new(topology, preferences);
    for part in breadth_first_parts(topology) {
        match marking {
            Marking::BreadthFirst => marks.spread(&part, 0),
            _ => marks.spread_from_best_root(&part),
        }
    }
    if marking != Marking::BreadthFirst {
        marks.improve();
    }
    for (tet, pair) in mesh.tets.iter_mut().zip(marks.into_pairs()) {
        *tet = MARKING_PERMUTATIONS[usize::from(pair)].map(|v| tet[v]);
    }
}

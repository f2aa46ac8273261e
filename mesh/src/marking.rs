//! Choosing the marked pair of each initial tet.
//!
//! A tet is split along the diagonal between the midpoints of its marked pair,
//! and its children inherit the marking. Two tets *agree* on their common face
//! if they mark the same edge of it: the lattice of the box-spline scheme is
//! then regular there at every level, with edges of 4 and 6 tets; else a third
//! of the edges in the face have 6 tets and two thirds 5, for ever.
//!
//! A marking that agrees on every face exists on a simply connected mesh if and
//! only if the vertices can be coloured with two colours so that every tet has
//! two of each; its marked edges are then the one-coloured ones. The Kuhn
//! lattice has such a colouring (the parity of i + j + k), unstructured meshes
//! generally have none.

mod agreement;
mod breadth_first;
mod diagonals;
mod report;

use agreement::{Marks, Preference};
use breadth_first::breadth_first_parts;
use diagonals::ranks;

pub(crate) use diagonals::shortest_pairs;
pub use report::{MarkingReport, marking_report};

use crate::core::raw_mesh::RawMesh;
use crate::core::reference_tet::MARKING_PERMUTATIONS;
use crate::core::topology::Topology;

/// How the marked pairs of the initial tets are chosen.
///
/// All are deterministic and take time in proportion to the tets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Marking {
    /// The pair whose midpoints are closest, so that children keep the best
    /// shapes ([Bey 1995], and Wang's thesis, section 3.1). Ties go to
    /// agreement with the neighbours, then to the order at hand; never to a
    /// longer diagonal.
    ///
    /// [Bey 1995]: https://doi.org/10.1007/BF02238487
    #[default]
    Shortest,
    /// As few conflicting faces as a greedy choice from tet to tet and a local
    /// search find, whatever the shapes; ties go to the shorter diagonal.
    /// Finds a marking without conflicts wherever there is one.
    Agree,
    /// Chang's algorithm 4.2: breadth first from tet 0, each choosing the pair
    /// that agrees with most visited neighbours, ties by the order at hand. As
    /// printed, it *excludes* the edges that neighbours mark, which makes nearly
    /// all faces conflict; the argument in its section 4.6.2 asks for agreement,
    /// so this is the reading here.
    BreadthFirst,
    /// The order of vertices that the mesh came with.
    AsOrdered,
}

impl Marking {
    /// Every strategy.
    pub const ALL: [Self; 4] = [Self::Shortest, Self::Agree, Self::BreadthFirst, Self::AsOrdered];

    /// The name by which configurations and the command line call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Shortest => "shortest",
            Self::Agree => "agree",
            Self::BreadthFirst => "breadth-first",
            Self::AsOrdered => "as-ordered",
        }
    }

    /// The strategy of a name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|marking| marking.name() == name)
    }
}

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

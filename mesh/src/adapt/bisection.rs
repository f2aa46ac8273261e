//! Bisecting a simplex at several edges, one after the other.
//!
//! **Why neighbours agree.** All cuts of the mesh stand in one order: the longer edge
//! first, and of equally long ones that between the smaller vertices. Let F be a face
//! of a tet with one or two cuts in its own edges. A cut at an edge outside F leaves F
//! to the one part that keeps both ends, as a face of it, uncut; a cut at an edge of F bisects F
//! there. So what the tet makes of F is F bisected at its own edges in the order of
//! the mesh, whatever is cut besides: the same for both tets, and for the tagged
//! triangle that F may be. With two cuts ab before ac, the inner edges are those from
//! the middle of ab to c and to the middle of ac. A face with three cuts is never
//! bisected: its tets are quartered or split into eight, both quarter it. And a tet
//! that is quartered bisects its other faces, of which each has one cut.

use std::cmp::Ordering;

use smallvec::SmallVec;

use crate::adapt::parts::Parts;

/// An edge that is cut at its midpoint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cut {
    /// The ends, ascending.
    pub ends: [u32; 2],
    /// The vertex at the midpoint.
    pub midpoint: u32,
    /// The squared length, from the ends in this order: the same bits for all cells.
    pub length: f64,
}

impl Cut {
    /// Which of two cuts comes first: that of the longer edge, or of that with the smaller ends.
    pub fn order(&self, other: &Self) -> Ordering {
        other.length.total_cmp(&self.length).then(self.ends.cmp(&other.ends))
    }
}

/// The cuts of one cell, in their order.
pub(super) type Cuts = SmallVec<[Cut; 3]>;

/// Bisects a simplex at these cuts, one after the other. Each part is oriented as
/// the whole, and has its vertices in the whole's places.
pub(super) fn bisected<const N: usize>(simplex: [u32; N], cuts: &[Cut]) -> Parts<N> {
    let mut parts = Parts::new();
    parts.push(simplex);
    for cut in cuts {
        let mut at = 0;
        while at < parts.len() {
            let part = parts[at];
            if cut.ends.iter().all(|end| part.contains(end)) {
                let without = |end: u32| part.map(|v| if v == end { cut.midpoint } else { v });
                let [low, high] = cut.ends;
                parts[at] = without(high);
                at += 1;
                parts.insert(at, without(low));
            }
            at += 1;
        }
    }
    parts
}

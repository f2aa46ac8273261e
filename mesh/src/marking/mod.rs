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
mod mark;
mod report;
mod strategy;

pub(crate) use diagonals::{shortest_pair, shortest_pairs};
pub use mark::mark;
pub use report::{MarkingReport, marking_report};
pub use strategy::Marking;

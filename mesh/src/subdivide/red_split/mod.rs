//! The red split of a whole mesh: every tet into eight, with the fine mesh's
//! edges and faces taken over from the parents', in the order that sorting
//! from scratch would give.
//!
//! Fine vertices are the coarse ones, then the midpoint n + e of each edge e.
//! So the fine edges are, in lexicographic order,
//!
//! * the *halves* (v, n + e), in the order of [`VertexEdges`], then
//! * the *inner edges* (n + e, n + e'), grouped by e < e': three *cuts* a face
//!   (each cuts off one corner) and the *diagonal* of each tet;
//!
//! and the fine faces follow their first edge: three *corner faces* and a
//! *middle face* from each coarse face, eight *inner faces* from each tet.
//!
//! The coarse numbering is lexicographic, too, so nearly all of that order is
//! known without sorting. Let e = ab, a < b. The coarse faces that e is the
//! first edge of are (a, b, c) with c ascending, those that it is the middle
//! edge of (a, x, b) with x ascending, and then e < ac < bc and e < xb. What
//! remains to be sorted are one to five entries at a time.

mod children;
mod edges;
mod faces;
pub mod parents;
pub mod parts;
mod slots;
pub mod split;
pub mod tags;

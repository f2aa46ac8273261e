//! Local refinement: tets are split where edges are marked, and no further than it
//! takes to leave no hanging node.
//!
//! A marked edge gets a vertex at its midpoint. Which edges of a tet are marked says
//! how it is split: one, two or three of them by bisecting one after the other, the
//! three of a face by quartering that face (1-to-4), all six by the red split (1-to-8).
//! Four or five are completed to six beforehand, mesh-wide. The three patterns and
//! this completion are those of Wang's thesis, section 4.3.3 and table 4-7; the order
//! of bisections is ours, see `bisection`.

mod bisection;
mod cell_states;
mod closure;
mod levels;
pub mod marked_edges;
mod midpoints;
mod parts;
mod pattern;
mod quarters;
mod red_green;
pub mod split;
mod tags;
mod tets;

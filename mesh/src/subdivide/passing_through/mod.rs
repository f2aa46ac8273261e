//! Refining so that the limit surface passes through the boundary vertices of the
//! mesh that is refined first.
//!
//! Approximating schemes cut corners: their limit lies inside a ball whose vertices are
//! given. So the boundary rules are applied to control points whose limits are the
//! vertices. The mesh is not made of control points, which stick out so far that they
//! would turn tets inside out; it keeps its vertices, and new ones are placed by the
//! limits of their control points.

mod block;
mod harmonic;
pub mod pass;
mod place;
mod solve;
mod spread;
mod strain;

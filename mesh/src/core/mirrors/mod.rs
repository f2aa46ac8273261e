//! Mirror planes: a mesh continued by its own reflection.
//!
//! A rule that reads across a mirror plane reads images of vertices on this side. So rows
//! are made on the *unfolded* mesh, which has images of the tets beside its planes, and
//! are then folded: the weight of an image goes to the vertex that it is an image of.

mod cells;
mod images;
mod plane_fit;
mod planes;
mod unfolded;
mod unfolding;

pub(crate) use plane_fit::PlaneFit;
pub(crate) use planes::Planes;
pub(crate) use unfolded::Unfolded;

//! Tags, names and features as named arrays beside the cells.
//!
//! A grid of tets has no room for tagged triangles, so they go, like all else
//! that is neither points, tets nor fields, into arrays that belong to the file
//! as a whole. Their names start with [`PREFIX`]; what is empty is not written,
//! except for features, where empty differs from unknown.
//!
//! Other programs carry such arrays along unchanged even where they renumber
//! vertices or leave tets out. So a fingerprint of points and tets goes with
//! them; where it no longer fits, vertex numbers mean nothing and are dropped.

mod arrays;
mod control_points;
mod side_array;

pub(crate) use arrays::{derived_arrays, group_arrays, mesh_arrays, restore};
pub(crate) use side_array::{PREFIX, SideArray, SideArrays, SideContent};

//! Tetrahedral meshes, and the ways from a mesh to a finer one.
//!
//! Data moves in one direction:
//!
//! ```text
//! RawMesh ──check──▶ TetMesh ──subdivide──▶ (TetMesh, Refinement) ──▶ Hierarchy
//! ```
//!
//! A [`RawMesh`] is what a file said; a [`TetMesh`] has passed [`check()`] and
//! is immutable; [`Topology`] (edges, faces and incidences) is derived from it
//! by sorting. [`reference_tet`] owns every table about a single tet.

mod buckets;
mod chunks;
pub mod raw_mesh;
mod red_split;
pub mod reference_tet;
pub mod shapes;
pub mod tet_mesh;
pub mod topology;

pub use raw_mesh::{Features, Group, RawMesh, Tagged};
pub use tet_mesh::TetMesh;
pub use topology::Topology;

//! The mesh itself: tets, tagged simplices, their topology and strata.

pub mod bodies;
pub mod components;
pub mod control_points;
pub mod curve_ends;
pub mod edge_length;
pub mod hilbert;
pub(crate) mod incidence;
pub mod locality;
pub(crate) mod mirrors;
pub mod raw_mesh;
pub mod reference_tet;
pub mod shapes;
pub mod strata;
pub mod tet_mesh;
pub mod topology;

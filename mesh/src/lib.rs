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
//! by sorting. [`reference_tet`] owns every table about a single tet,
//! [`Scheme`] every weight, [`strata`] decides which rule holds where.

mod affine_correction;
pub mod analysis;
mod assemble_matrix;
pub mod carry;
pub mod check;
pub mod chunks;
pub mod components;
pub mod features;
pub mod finding;
pub mod groups;
pub mod guard;
pub mod hierarchy;
mod hilbert;
pub mod large_array;
pub mod locality;
pub mod marking;
mod neighbourhoods;
mod octets;
pub mod prolongation;
mod quadratic_matrix;
pub mod quality;
pub mod raw_mesh;
mod red_split;
pub mod reference_tet;
mod rules;
pub mod scheme;
pub mod shapes;
pub mod sided_field;
pub mod step;
pub mod strata;
pub mod subdivide;
pub mod subdivision_matrix;
pub mod tet_mesh;
pub mod topology;

pub use affine_correction::{AffineCorrection, CorrectedRows, NEGLIGIBLE_DEFECT};
pub use assemble_matrix::subdivision_matrix;
pub use carry::{Carried, Overshoot, carry_field};
pub use check::{CheckError, CheckOptions, Checked, check, findings};
pub use features::{ExtraFeatures, FeatureError, FeatureOptions, FeatureReasons, Reason, prepare};
pub use finding::{Finding, FindingKind};
pub use hierarchy::Hierarchy;
pub use locality::{Renumbering, sort_along_curve};
pub use marking::{Marking, MarkingReport, marking_report};
pub use prolongation::{InterfaceRows, Prolongation, ProlongationOptions};
pub use quadratic_matrix::quadratic_matrix;
pub use raw_mesh::{Features, Group, RawMesh, Tagged};
pub use reference_tet::CellState;
pub use scheme::{MarkedRule, Scheme};
pub use sided_field::Sides;
pub use step::{Diagonal, Step};
pub use strata::Strata;
pub use subdivide::{Refinement, SubdivideError, subdivide};
pub use subdivision_matrix::{SubdivisionMatrix, linear_matrix};
pub use tet_mesh::TetMesh;
pub use topology::Topology;

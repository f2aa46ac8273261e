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
//!
//! ```
//! use octruss_mesh::{CheckOptions, FeatureOptions, Hierarchy, Scheme, check, shapes};
//!
//! // What a file might say: the unit cube in five tets.
//! let raw = shapes::five_tet_cube().into_raw();
//! let mesh = check(raw, &CheckOptions::default())?.mesh;
//! // Its edges are sharp and stay so; what is inside is smoothed.
//! let mut hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
//! hierarchy.subdivide(Scheme::BoxSpline)?;
//! hierarchy.subdivide(Scheme::BoxSpline)?;
//! let fine = &hierarchy.finest().mesh;
//! assert_eq!(fine.tets().len(), 5 * 8 * 8);
//! let volume: f64 = (0..fine.tets().len()).map(|tet| fine.volume(tet)).sum();
//! assert!((volume - 1.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod analysis;
mod choices;
mod core;
pub mod features;
pub mod hierarchy;
pub mod marking;
mod refinement;
mod scheme;
mod soundness;
mod subdivide;
mod transfer;

pub use core::locality::{Renumbering, sort_along_curve};
pub use core::raw_mesh::{Features, Group, RawMesh, Tagged};
pub use core::reference_tet::CellState;
pub use core::strata::Strata;
pub use core::tet_mesh::TetMesh;
pub use core::topology::Topology;
pub use core::{components, reference_tet, shapes, strata, topology};
pub use features::{ExtraFeatures, FeatureError, FeatureOptions, FeatureReasons, Reason, prepare};
pub use hierarchy::{Hierarchy, Level};
pub use marking::{Marking, MarkingReport, marking_report};
pub use refinement::ancestry::{Ancestor, Ancestry, SplitEdges};
pub use refinement::carry::{Carried, Overshoot, carry_field};
pub use refinement::guard_report::GuardReport;
pub use refinement::lineage::Lineage;
pub use refinement::refinement::Refinement;
pub use refinement::sided_field::Sides;
pub use refinement::subdivision_matrix::{SubdivisionMatrix, linear_matrix};
pub use scheme::{MarkedRule, Scheme};
pub use soundness::check::{CheckError, CheckOptions, Checked, check, findings};
pub use soundness::finding::{Finding, FindingKind};
pub use soundness::quality;
pub use subdivide::assemble_matrix::subdivision_matrix;
pub use subdivide::error::SubdivideError;
pub use subdivide::guard;
pub use subdivide::refine::subdivide;
pub use subdivide::size::{MAX_TETS, most_levels};
pub use subdivide::step::{Diagonal, Step};
pub use transfer::affine_correction::{AffineCorrection, CorrectedRows, NEGLIGIBLE_DEFECT};
pub use transfer::prolongation::{InterfaceRows, Prolongation, ProlongationOptions};
pub use transfer::quadratic_matrix::quadratic_matrix;

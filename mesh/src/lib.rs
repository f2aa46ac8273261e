//! Tetrahedral meshes, and the ways from a mesh to a finer one.
//!
//! For whoever has a coarse mesh of a solid and wants finer ones of a better
//! shape: smooth inside and on the surface, with edges and corners kept sharp,
//! and with what leads from one level to the next: for fields, for regions and
//! names, and for multigrid.
//!
//! ```
//! use octruss_mesh::{
//!     CheckOptions, FeatureOptions, Hierarchy, Overshoot, RawMesh, Scheme, check,
//! };
//!
//! // A cube of five tets, of which the last is of another material.
//! let corner = |v: u32| [v & 1, v >> 1 & 1, v >> 2].map(f64::from);
//! let raw = RawMesh {
//!     points: (0..8).map(corner).collect(),
//!     tets: vec![[0, 6, 5, 3], [1, 0, 5, 3], [2, 0, 3, 6], [4, 0, 6, 5], [7, 3, 5, 6]],
//!     regions: vec![1, 1, 1, 1, 2],
//!     ..RawMesh::default()
//! };
//! let mesh = check(raw, &CheckOptions::default())?.mesh;
//!
//! // Two levels of the box-spline scheme. Edges sharper than 40 degrees stay.
//! let mut levels = Hierarchy::new(mesh, &FeatureOptions::default());
//! for _ in 0..2 {
//!     levels.subdivide(Scheme::BoxSpline)?;
//! }
//! let finest = &levels.finest().mesh;
//! assert_eq!(finest.tets().len(), 5 * 64);
//!
//! // What is known of the coarse mesh goes down with it.
//! let mut height: Vec<f64> = levels.coarsest().mesh.points().iter().map(|p| p[2]).collect();
//! let mut regions = levels.coarsest().mesh.regions().to_vec();
//! for refinement in levels.refinements() {
//!     height = refinement.carry_point_field(&height, 1, Overshoot::Allow).values;
//!     regions = refinement.inherit(&regions, 1);
//! }
//! assert!(finest.points().iter().zip(&height).all(|(p, z)| (p[2] - z).abs() < 1e-12));
//! assert_eq!(finest.regions(), regions);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Data moves in one direction:
//!
//! ```text
//! RawMesh ──check──▶ TetMesh ──subdivide──▶ (TetMesh, Refinement) ──▶ Hierarchy
//! ```
//!
//! Instead of `subdivide`, [`split_marked`] refines only where edges are marked.
//!
//! A [`RawMesh`] is what a file said; a [`TetMesh`] has passed [`check()`] and
//! is immutable; [`Topology`] (edges, faces and incidences) is derived from it
//! by sorting. [`reference_tet`] owns every table about a single tet,
//! [`Scheme`] every weight, [`strata`] decides which rule holds where; a
//! [`Refinement`] knows which coarse simplex each fine one lies in.

mod adapt;
pub mod analysis;
mod choices;
mod core;
pub mod features;
pub mod hierarchy;
pub mod limit;
pub mod marking;
mod refinement;
mod scheme;
mod soundness;
mod subdivide;
mod transfer;

pub use adapt::marked_edges::MarkedEdges;
pub use adapt::split::split_marked;
pub use core::bodies::{Bodies, Hinge};
pub use core::control_points::{ControlPoints, Placement};
pub use core::curve_ends::CurveEnds;
pub use core::locality::{Renumbering, sort_along_curve};
pub use core::raw_mesh::{Features, Group, RawMesh, Tagged};
pub use core::reference_tet::CellState;
pub use core::strata::Strata;
pub use core::tet_mesh::TetMesh;
pub use core::topology::Topology;
pub use core::{components, reference_tet, shapes, strata, topology};
pub use features::{
    ExtraFeatures, FeatureError, FeatureOptions, FeatureReasons, GroupBorders, MirrorError,
    Mirrors, Reason, mirror_candidates, prepare,
};
pub use hierarchy::{Hierarchy, Level};
pub use limit::distances::LimitDistances;
pub use limit::positions::{limit_matrix, limit_positions};
pub use marking::{Marking, MarkingReport, marking_report};
pub use refinement::affine_correction::{AffineCorrection, CorrectedRows, NEGLIGIBLE_DEFECT};
pub use refinement::ancestry::{Ancestor, Ancestry, SplitEdges};
pub use refinement::carry::{Carried, Overshoot, carry_field};
pub use refinement::guard_report::GuardReport;
pub use refinement::interpolation_report::InterpolationReport;
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
pub use transfer::prolongation::{InterfaceRows, Prolongation, ProlongationOptions};
pub use transfer::quadratic_matrix::quadratic_matrix;

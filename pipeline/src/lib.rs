//! Recipes, stages and reports: the pipeline that strings mesh, files and
//! solver together, and the library behind the `octruss` command.
//!
//! ```text
//! Recipe ─▶ stages over a State ─▶ Report
//! ```
//!
//! ```
//! use octruss::observer::{Event, StagePlace};
//! use octruss_meshio::Dataset;
//! use std::sync::atomic::AtomicBool;
//!
//! let folder = tempfile::tempdir()?;
//! let mesh = octruss_mesh::shapes::kuhn_cube(2).into_raw();
//! let cube = Dataset { mesh, ..Dataset::default() };
//! octruss_meshio::write(&folder.path().join("cube.vtu"), &cube)?;
//!
//! // −Δu = 1 between two walls at 0: u = x (1 − x) / 2, at most 1/8.
//! let config = r#"
//!     name = "walls"
//!     [[stage]]
//!     kind = "import"
//!     path = "cube.vtu"
//!     [[stage]]
//!     kind = "check"
//!     [[stage]]
//!     kind = "subdivide"
//!     scheme = "linear"
//!     levels = 2
//!     [[stage]]
//!     kind = "solve"
//!     problem = "poisson"
//!     source = 1.0
//!     fixed = [{ surface = "x0", value = 0.0 }, { surface = "x1", value = 0.0 }]
//!     prolongation = ["linear"]
//!     [expect]
//!     "solve.linear.maximum" = { min = 0.12, max = 0.13 }
//! "#;
//! let path = folder.path().join("walls.toml");
//! let recipe = octruss::Recipe::parse(&path, config.into(), &[])?;
//! let silent = |_: &StagePlace, _: &Event| {};
//! let out = folder.path().join("out");
//! let report = octruss::run(&recipe, &out, &silent, &AtomicBool::new(false))?;
//! assert!(report.expectations.iter().all(|expected| expected.met));
//! assert!(out.join("report.json").exists());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Configs
//!
//! A config is a TOML file: a `name`, a list of `[[stage]]` tables that run in
//! order, and an `[expect]` table of bounds on numbers of the report. Each stage
//! has a `kind` and the options of [`stages::Import`], [`stages::Check`],
//! [`stages::Subdivide`], [`stages::Solve`] or [`stages::Write`], in kebab case.
//! Input paths are relative to the config.
//!
//! A `--set key=value` replaces one value before the config is read. Keys are
//! joined by dots. A stage goes by its kind, from the second of a kind on with
//! its number (`solve`, `solve-2`), entries of other lists by their number from 0:
//!
//! ```text
//! --set stage.subdivide.levels=1
//! --set stage.solve.fixed.0.value=20
//! --set expect={}
//! ```
//!
//! A value that is no TOML is taken as a string, so names need no quotes.
//!
//! # Features
//!
//! `cli`, on by default, is the command. Without it
//! (`default-features = false`) the library stands alone and needs nothing that only
//! the command does. `pictures`, which `cli` includes, draws the picture of a
//! [`comparison`].

pub mod amount;
pub mod comparison;
pub mod describe;
pub mod error;
pub mod expression;
pub mod memory;
mod null;
pub mod observer;
pub mod options;
pub mod output;
pub mod recipe;
pub mod report;
pub mod run;
pub mod stages;
pub mod state;
pub mod table;

pub use describe::{Description, describe};
pub use error::Error;
pub use observer::Observer;
pub use recipe::Recipe;
pub use report::Report;
pub use run::run;
pub use state::State;

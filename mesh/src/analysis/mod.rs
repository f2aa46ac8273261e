//! The mathematics of a scheme at one place: local matrices and their spectra,
//! characteristic maps, basis functions.
//!
//! ```
//! use octruss_mesh::{Scheme, analysis::{LocalMatrix, stars}};
//! let local = LocalMatrix::new(&stars::octahedron(), 0, Scheme::BoxSpline)?;
//! let [second, _] = local.spectrum()?.eigenvalues[1];
//! assert!((second - 5.0 / 16.0).abs() < 1e-12);
//! # Ok::<(), octruss_mesh::analysis::AnalysisError>(())
//! ```

mod basis;
mod characteristic_map;
mod eigenvectors;
mod error;
mod local_matrix;
mod no_map;
mod place;
mod refined_star;
mod solid_limit;
mod spectrum;
mod star;
pub mod stars;
mod tet_grid;
mod verdict;

pub use basis::{LineSample, basis_function, sample_line};
pub use characteristic_map::CharacteristicMap;
pub use error::AnalysisError;
pub use local_matrix::{LocalMatrix, at_midpoint};
pub use no_map::NoMap;
pub use solid_limit::solid_limit_matrix;
pub use spectrum::Spectrum;
pub use star::star;
pub use verdict::{MapVerdict, Verdict};

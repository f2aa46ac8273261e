//! What a smoothing sweep is: one file each, and the choice between them.

pub mod ancestors;
pub mod chebyshev;
pub mod colouring;
pub mod diagonal;
pub mod domain_rows;
pub mod domains;
pub mod gauss_seidel;
pub mod hybrid_gauss_seidel;
pub mod level_smoother;
pub mod row_smoother;

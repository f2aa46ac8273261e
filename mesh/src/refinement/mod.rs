//! What a refinement leaves behind: its matrix, who descends from whom, and how fields go down.

pub mod carry;
pub mod sided_field;
pub mod subdivision_matrix;

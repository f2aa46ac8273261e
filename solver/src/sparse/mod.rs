//! Sparse matrices whose entries are numbers or 3 × 3 blocks, and the passes over them.

pub mod accumulator;
pub mod backward_error;
pub mod blocks;
pub mod csr;
pub mod dot;
pub mod entry;
pub mod kernels;
pub mod multiply;
pub mod noise;
pub mod pattern;
pub mod real;
pub mod rows;
pub mod symmetric;
pub mod transpose;

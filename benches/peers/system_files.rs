//! The files of a system, in one folder.
//!
//! `system.json`; `rhs.npy`; `points.npy`, the position of each row, and
//! `coarsest-points.npy`, of each row of the coarsest level; and of the matrix
//! and each prolongation, finest first, the three arrays of compressed sparse rows:
//! `matrix.offsets.npy`, `matrix.indices.npy`, `matrix.values.npy`, and so on.

use crate::arrays;
use anyhow::Result;
use octruss_solver::{Csr, SystemEntry};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// What `system.json` holds.
#[derive(Debug, Serialize, Deserialize)]
pub struct Description {
    /// Unknowns a row: 1 or 3. Entries of the matrix are numbers or 3 × 3 blocks.
    pub block: usize,
    /// Rows of each level, finest first.
    pub rows: Vec<usize>,
    /// What is known of each kind of prolongation.
    pub prolongations: Vec<Prolongation>,
}

/// The prolongations that one scheme makes.
#[derive(Debug, Serialize, Deserialize)]
pub struct Prolongation {
    /// The scheme.
    pub name: String,
    /// Seconds to make all of them from the refined meshes.
    pub seconds: f64,
    /// How far they miss linear functions, in mean edge lengths, at most.
    pub affine_defect: f64,
}

/// Where an array lies.
pub fn array(folder: &Path, name: &str) -> PathBuf {
    folder.join(format!("{name}.npy"))
}

/// Writes the three arrays of a matrix.
pub fn write_matrix<E: SystemEntry>(folder: &Path, name: &str, matrix: &Csr<E>) -> Result<()> {
    let path = |part: &str| array(folder, &format!("{name}.{part}"));
    let offsets = (0..matrix.rows() + 1).map(|row| matrix.offset(row) as i32);
    arrays::write(&path("offsets"), offsets)?;
    arrays::write(&path("indices"), matrix.indices().iter().map(|&column| column as i32))?;
    arrays::write(&path("values"), E::flat(matrix.values()).iter().copied())
}

/// Reads a matrix.
pub fn read_matrix<E: SystemEntry>(folder: &Path, name: &str, columns: usize) -> Result<Csr<E>> {
    let path = |part: &str| array(folder, &format!("{name}.{part}"));
    let offsets = arrays::read::<i32>(&path("offsets"))?;
    let offsets = offsets.into_iter().map(|offset| offset as usize).collect();
    let indices = arrays::read::<i32>(&path("indices"))?;
    let indices = indices.into_iter().map(|column| column as u32).collect();
    let numbers = arrays::read::<f64>(&path("values"))?;
    let entry = |numbers: &[f64]| E::from_fn(|i, j| numbers[E::SIZE * i + j]);
    let values = numbers.chunks_exact(E::SIZE * E::SIZE).map(entry).collect();
    Ok(Csr::new(columns, offsets, indices, values)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use octruss_solver::Entry;

    type Block = [[f64; 3]; 3];

    #[test]
    fn a_matrix_comes_back_bit_for_bit_from_files_that_numpy_reads() {
        let folder = tempfile::tempdir().unwrap();
        let value =
            |k: u32| Block::from_fn(|i, j| f64::from(k * 9 + i as u32 * 3 + j as u32) / 7.0);
        let blocks = (0..3).map(value).collect();
        let matrix = Csr::new(4, vec![0, 2, 2, 3], vec![0, 3, 1], blocks).unwrap();
        write_matrix(folder.path(), "matrix", &matrix).unwrap();
        assert_eq!(read_matrix::<Block>(folder.path(), "matrix", 4).unwrap(), matrix);
        // As numpy.save writes the same array, but for spaces: 128 bytes and the numbers.
        let bytes = std::fs::read(array(folder.path(), "matrix.indices")).unwrap();
        assert!(bytes.starts_with(b"\x93NUMPY\x01\x00\x76\x00{'descr': '<i4', "));
        assert_eq!((bytes[127], bytes.len()), (b'\n', 128 + 3 * 4));
    }
}

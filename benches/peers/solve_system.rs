//! A system from its files, solved by conjugate gradients with a multigrid cycle.

use crate::arrays;
use crate::memory;
use crate::system_files::{Description, array, read_matrix};
use anyhow::{Context, Result};
use octruss_solver::{
    Csr, Multigrid, MultigridOptions, NearNullSpace, Nodal, SolveOptions, SystemEntry, Transfer,
    conjugate_gradients, norm,
};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// Runs of the copy of memory, of which the median counts.
const COPIES: usize = 5;

/// Solves the system in a folder to 1e-8 with the default options; its figures.
pub fn solve(folder: &Path, prolongation: &str) -> Result<Value> {
    let path = folder.join("system.json");
    let text =
        fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
    let description: Description = serde_json::from_str(&text)?;
    match description.block {
        1 => solve_entries::<f64>(folder, &description, prolongation),
        _ => solve_entries::<[[f64; 3]; 3]>(folder, &description, prolongation),
    }
}

fn solve_entries<E: SystemEntry>(
    folder: &Path,
    description: &Description,
    prolongation: &str,
) -> Result<Value> {
    let before = memory::resident()?;
    let rows = &description.rows;
    let matrix: Csr<E> = read_matrix(folder, "matrix", rows[0])?;
    let rhs = arrays::read::<f64>(&array(folder, "rhs"))?;
    let rhs = E::Nodal::from_flat(&rhs);
    let prolongations = rows[1..]
        .iter()
        .enumerate()
        // The files have the finest first.
        .rev()
        .map(|(number, &columns)| read_matrix(folder, &format!("{prolongation}.{number}"), columns))
        .collect::<Result<Vec<Csr<f64>>>>()?;
    let transfers: Vec<_> = prolongations.into_iter().map(Transfer::from).collect();
    let projectors = vec![Vec::new(); transfers.len() + 1];
    let below = near_null_space(folder, E::SIZE)?;
    memory::forget_peak()?;
    let options = MultigridOptions::default();
    let mut multigrid = Multigrid::with_transfers(&matrix, transfers, projectors, below, &options)?;
    let after_setup = memory::peak()?;
    let stop = SolveOptions::default();
    let (x, report) = conjugate_gradients(&matrix, &rhs, &mut multigrid, &stop)?;
    let peak = memory::peak()?;
    Ok(json!({
        "unknowns": rows[0] * E::SIZE,
        "setup_seconds": report.setup_seconds,
        "solve_seconds": report.solve_seconds,
        "iterations": report.iterations,
        "relative_residual": report.relative_residual,
        "solution_norm": norm(&x),
        "peak_bytes": peak - before,
        "setup_peak_bytes": after_setup - before,
        "matrix_bytes": matrix.bytes(),
        "level_bytes": multigrid.bytes(),
        "copy_bytes_per_second": multigrid.traffic(COPIES).copy_bandwidth,
    }))
}

/// What the levels below the coarsest written one carry.
fn near_null_space(folder: &Path, size: usize) -> Result<NearNullSpace> {
    if size == 1 {
        return Ok(NearNullSpace::Constants);
    }
    let numbers = arrays::read::<f64>(&array(folder, "coarsest-points"))?;
    Ok(NearNullSpace::RigidMotions(numbers.as_chunks().0.to_vec()))
}

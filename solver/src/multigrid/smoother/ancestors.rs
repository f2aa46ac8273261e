//! Which coarse unknowns the rows of fine levels come from.

use crate::multigrid::smoother::domains::Domains;
use crate::sparse::csr::Csr;

/// Ancestors are sought down to the coarsest level with so many unknowns.
const ENOUGH: usize = 64;

/// The domains of each smoothed level from the prolongations, all finest first.
pub(crate) fn domains(prolongations: &[&Csr<f64>]) -> Vec<Domains> {
    let end = prolongations.iter().rposition(|p| p.columns() >= ENOUGH).map_or(0, |at| at + 1);
    let domains = |level: usize| {
        let coarser = &prolongations[level..end.max(level)];
        Domains::new(prolongations[level].rows(), |row| path(coarser, row as u32))
    };
    (0..prolongations.len()).map(domains).collect()
}

/// The ancestors of a row from the coarsest to itself; none if it has no parent.
fn path(prolongations: &[&Csr<f64>], row: u32) -> Option<Vec<u32>> {
    let mut path = vec![row];
    for prolongation in prolongations {
        path.push(parent(prolongation.row(path[path.len() - 1] as usize))?);
    }
    path.reverse();
    Some(path)
}

/// The coarse unknown with most weight, the first of equals.
fn parent((columns, weights): (&[u32], &[f64])) -> Option<u32> {
    let heavier = |a: (u32, f64), b: (u32, f64)| if b.1.abs() > a.1.abs() { b } else { a };
    let weighted = columns.iter().copied().zip(weights.iter().copied());
    weighted.reduce(heavier).map(|(column, _)| column)
}

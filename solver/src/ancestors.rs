//! Which coarse unknowns the rows of fine levels come from.

use crate::domains::Domains;
use crate::entry::Entry;
use crate::known::AnyTransfer;
use crate::real::Real;
use crate::weights::Weights;

/// Ancestors are sought down to the coarsest level with so many unknowns.
const ENOUGH: usize = 64;

/// The domains of each smoothed level, finest first.
pub(crate) fn domains<E: Entry, F: Entry>(transfers: &[AnyTransfer<E, F>]) -> Vec<Domains> {
    let is_large = |transfer: &AnyTransfer<E, F>| transfer.size().1 >= ENOUGH;
    let end = transfers.iter().rposition(is_large).map_or(0, |last| last + 1);
    let domains = |level: usize| {
        let coarser = &transfers[level..end.max(level)];
        Domains::new(transfers[level].size().0, |row| path(coarser, row as u32))
    };
    (0..transfers.len()).map(domains).collect()
}

/// The ancestors of a row from the coarsest to itself; none if it has no parent.
fn path<E: Entry, F: Entry>(transfers: &[AnyTransfer<E, F>], row: u32) -> Option<Vec<u32>> {
    let mut path = vec![row];
    for transfer in transfers {
        path.push(parent(transfer, path[path.len() - 1])?);
    }
    path.reverse();
    Some(path)
}

/// The coarse unknown with most weight in a row, the first of equals.
fn parent<E: Entry, F: Entry>(transfer: &AnyTransfer<E, F>, row: u32) -> Option<u32> {
    let row = row as usize;
    match transfer {
        AnyTransfer::New(transfer) => heaviest(transfer.prolongation.row(row)),
        AnyTransfer::Kept(kept) => match &kept.prolongation {
            Weights::Numbers(weights) => heaviest(weights.row(row)),
            Weights::Entries(weights) => weights.row(row).0.first().copied(),
        },
    }
}

fn heaviest<T: Real>((columns, weights): (&[u32], &[T])) -> Option<u32> {
    let weights = weights.iter().map(|weight| weight.to_f64());
    let heavier = |a: (u32, f64), b: (u32, f64)| if b.1 > a.1 { b } else { a };
    columns.iter().copied().zip(weights).reduce(heavier).map(|(column, _)| column)
}

//! What a multigrid is set up from: transfers as they were given, or as an earlier
//! matrix with the same pattern left them.

use crate::coarse::Elimination;
use crate::csr::Csr;
use crate::cycle::Cycle;
use crate::entry::Entry;
use crate::error::Error;
use crate::level::Kept;
use crate::pattern::Pattern;
use crate::projectors::Projectors;
use crate::transfer::Transfer;
use std::sync::Arc;

/// How a level hangs on the next: as it was given, or as it was kept.
pub(crate) enum AnyTransfer<E: Entry, F: Entry> {
    New(Transfer<E>),
    Kept(Kept<F>),
}

impl<E: Entry, F: Entry> AnyTransfer<E, F> {
    /// Whether it depends on the places of a matrix alone.
    pub(crate) fn is_galerkin(&self) -> bool {
        match self {
            Self::New(transfer) => !transfer.smooth && transfer.coarse_matrix.is_none(),
            Self::Kept(_) => true,
        }
    }

    /// Unknowns of the fine and of the coarse level.
    pub(crate) fn size(&self) -> (usize, usize) {
        match self {
            Self::New(Transfer { prolongation, .. }) => {
                (prolongation.rows(), prolongation.columns())
            }
            Self::Kept(Kept { prolongation, .. }) => (prolongation.rows(), prolongation.columns()),
        }
    }
}

/// What does not depend on the numbers of a matrix.
pub(crate) struct Known<E: Entry, F: Entry> {
    pub(crate) transfers: Vec<AnyTransfer<E, F>>,
    pub(crate) projectors: Vec<Projectors<E>>,
    /// Those of all levels, or of the finest alone.
    pub(crate) patterns: Vec<Arc<Pattern>>,
    pub(crate) elimination: Option<Elimination>,
}

impl<E: Entry<Real = f64>, F: Entry> Known<E, F> {
    /// From what a user gives for a matrix; checked.
    pub(crate) fn new(
        matrix: &Csr<E>,
        given: Vec<Transfer<E>>,
        projectors: Vec<Vec<(u32, E)>>,
    ) -> Result<Self, Error> {
        let mut rows = vec![matrix.rows()];
        let mut transfers = Vec::new();
        for transfer in given.into_iter().take_while(|t| t.prolongation.columns() > 0) {
            transfer.check(rows[transfers.len()])?;
            rows.push(transfer.prolongation.columns());
            transfers.push(AnyTransfer::New(transfer));
        }
        let projectors = rows.into_iter().zip(projectors).enumerate();
        let projectors = projectors.map(|(level, (rows, list))| Projectors::new(level, rows, list));
        Ok(Self {
            transfers,
            projectors: projectors.collect::<Result<_, _>>()?,
            patterns: vec![Arc::clone(matrix.pattern())],
            elimination: None,
        })
    }

    /// From a cycle that is used no more.
    pub(crate) fn of(
        cycle: Cycle<F>,
        projectors: Vec<Projectors<E>>,
        patterns: Vec<Arc<Pattern>>,
    ) -> Self {
        let (kept, elimination) = cycle.into_known();
        let transfers = kept.into_iter().map(AnyTransfer::Kept).collect();
        Self { transfers, projectors, patterns, elimination }
    }
}

//! What a multigrid is set up from: transfers as they were given, or as an earlier
//! matrix with the same pattern left them.

use crate::error::Error;
use crate::multigrid::aggregation::near_null_space::NearNullSpace;
use crate::multigrid::coarse::Elimination;
use crate::multigrid::cycle::Cycle;
use crate::multigrid::level::Kept;
use crate::multigrid::options::Smoother;
use crate::multigrid::projectors::Projectors;
use crate::multigrid::smoother::ancestors::domains;
use crate::multigrid::smoother::domains::Domains;
use crate::multigrid::transfer::Transfer;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::pattern::Pattern;
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
}

/// What does not depend on the numbers of a matrix.
pub(crate) struct SetupInput<E: Entry, F: Entry> {
    pub(crate) transfers: Vec<AnyTransfer<E, F>>,
    pub(crate) projectors: Vec<Projectors<E>>,
    /// Those of all levels, or of the finest alone.
    pub(crate) patterns: Vec<Arc<Pattern>>,
    pub(crate) elimination: Option<Elimination>,
    /// Of each smoothed level, if the smoother needs some and they are not kept.
    pub(crate) domains: Vec<Domains>,
    /// What the levels below the given ones are made from.
    pub(crate) below: NearNullSpace,
}

/// What a user gives, finest first.
pub(crate) struct GivenLevels<E> {
    pub(crate) transfers: Vec<Transfer<E>>,
    pub(crate) projectors: Vec<Vec<(u32, E)>>,
    pub(crate) below: NearNullSpace,
}

impl<E: Entry<Real = f64>, F: Entry> SetupInput<E, F> {
    /// From what a user gives for a matrix; checked.
    pub(crate) fn new(
        matrix: &Csr<E>,
        GivenLevels { transfers: given, projectors, below }: GivenLevels<E>,
        smoother: Smoother,
    ) -> Result<Self, Error> {
        let mut rows = vec![matrix.rows()];
        let mut transfers = Vec::new();
        for transfer in given.into_iter().take_while(|t| t.prolongation.columns() > 0) {
            transfer.check(rows[transfers.len()])?;
            rows.push(transfer.prolongation.columns());
            transfers.push(transfer);
        }
        let domains = match smoother {
            Smoother::HybridGaussSeidel => domains(
                &transfers.iter().map(|transfer| &transfer.prolongation).collect::<Vec<_>>(),
            ),
            _ => Vec::new(),
        };
        let levels = (0..rows.len()).rev().zip(rows.iter().zip(projectors));
        let projectors = levels.map(|(level, (&rows, list))| Projectors::new(level, rows, list));
        Ok(Self {
            transfers: transfers.into_iter().map(AnyTransfer::New).collect(),
            projectors: projectors.collect::<Result<_, _>>()?,
            patterns: vec![Arc::clone(matrix.pattern())],
            elimination: None,
            domains,
            below,
        })
    }

    /// From a cycle that is used no more, its algebraic levels left out. `keeps_order` says
    /// whether the last one has the same pattern as before.
    pub(crate) fn of(
        cycle: Cycle<F>,
        keeps_order: bool,
        (projectors, patterns, below): (Vec<Projectors<E>>, Vec<Arc<Pattern>>, NearNullSpace),
    ) -> Self {
        let (kept, elimination) = cycle.into_kept();
        let given = patterns.len() - 1;
        let transfers = kept.into_iter().take(given).map(AnyTransfer::Kept).collect();
        let elimination = elimination.filter(|_| keeps_order);
        Self { transfers, projectors, patterns, elimination, domains: Vec::new(), below }
    }
}

//! The tentative prolongation: on each aggregate an orthonormal basis of the near-null
//! space.

use crate::multigrid::aggregation::aggregates::Aggregates;
use crate::multigrid::aggregation::candidates::Candidates;
use crate::multigrid::aggregation::nodes::Nodes;
use crate::multigrid::aggregation::orthonormal::Orthonormal;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::rows::build_rows;
use octruss_base::chunks::map_heavy_ranges;

/// The prolongation from the aggregates of a level, and what the coarse level needs.
pub(crate) struct Tentative<E> {
    pub(crate) prolongation: Csr<E>,
    pub(crate) nodes: Nodes,
    pub(crate) candidates: Candidates<E>,
    /// The coarse rows that have more places than unknowns, since their aggregate is too
    /// small for all vectors, with the projector onto these unknowns.
    pub(crate) projectors: Vec<(u32, E)>,
}

impl<E: Entry<Real = f64>> Tentative<E> {
    /// From the aggregates of a level's nodes and its near-null space.
    pub(crate) fn new(aggregates: &Aggregates, nodes: &Nodes, candidates: &Candidates<E>) -> Self {
        let bases = bases(aggregates, nodes, candidates);
        let coarse = Nodes::of_sizes(bases.iter().map(|basis| basis.rank().div_ceil(E::SIZE)));
        let prolongation = prolongation(aggregates, nodes, (&bases, &coarse));
        let (mut values, mut projectors) = (Vec::new(), Vec::new());
        for (aggregate, basis) in bases.iter().enumerate() {
            for (first, row) in (0..).step_by(E::SIZE).zip(coarse.rows(aggregate)) {
                let columns = (0..candidates.columns).map(|c| E::SIZE * c);
                let entry = |c| E::from_fn(|i, j| basis.r(first + i, c + j));
                values.extend(columns.map(entry));
                let is_unknown = |i| first + i < basis.rank();
                if !is_unknown(E::SIZE - 1) {
                    let free = |i, j| if i == j && is_unknown(i) { 1.0 } else { 0.0 };
                    projectors.push((row as u32, E::from_fn(free)));
                }
            }
        }
        let candidates = Candidates { columns: candidates.columns, values };
        Self { prolongation, nodes: coarse, candidates, projectors }
    }
}

/// The basis on each aggregate.
fn bases<E: Entry<Real = f64>>(
    aggregates: &Aggregates,
    nodes: &Nodes,
    candidates: &Candidates<E>,
) -> Vec<Orthonormal> {
    let members = aggregates.members();
    let columns = E::SIZE * candidates.columns;
    let chunks = map_heavy_ranges(aggregates.count(), Vec::new, |b: &mut Vec<f64>, range| {
        let basis = |aggregate| {
            let nodes_of = members.of(aggregate).iter();
            let rows = || nodes_of.clone().flat_map(|node| nodes.rows(*node as usize));
            b.clear();
            for column in 0..columns {
                let (block, k) = (column / E::SIZE, column % E::SIZE);
                let numbers = |row| {
                    let entry = &candidates.row(row)[block];
                    (0..E::SIZE).map(move |i| entry.at(i, k))
                };
                b.extend(rows().flat_map(numbers));
            }
            Orthonormal::new(b, columns)
        };
        range.map(basis).collect::<Vec<_>>()
    });
    chunks.into_iter().flatten().collect()
}

/// The rows of Q of each basis, in the columns of its aggregate.
fn prolongation<E: Entry<Real = f64>>(
    aggregates: &Aggregates,
    nodes: &Nodes,
    (bases, coarse): (&[Orthonormal], &Nodes),
) -> Csr<E> {
    let node_of = nodes.of_rows();
    // The place of each row among those of its aggregate.
    let mut ends = vec![0; aggregates.count()];
    let place = |node: &u32| {
        let end = &mut ends[aggregates.of(*node as usize)?];
        *end += 1;
        Some(*end - 1)
    };
    let places: Vec<Option<usize>> = node_of.iter().map(place).collect();
    let columns = |row: usize| {
        let aggregate = aggregates.of(node_of[row] as usize);
        aggregate.map_or(0..0, |aggregate| coarse.rows(aggregate))
    };
    build_rows(
        (nodes.row_count(), coarse.row_count()),
        |row| columns(row).len(),
        |row, indices, entries: &mut [E]| {
            let of_row = aggregates.of(node_of[row] as usize).zip(places[row]);
            let Some((aggregate, place)) = of_row else { return };
            let targets = indices.iter_mut().zip(entries);
            for ((first, column), (index, entry)) in
                (0..).step_by(E::SIZE).zip(columns(row)).zip(targets)
            {
                *index = column as u32;
                *entry = E::from_fn(|i, j| bases[aggregate].q(E::SIZE * place + i, first + j));
            }
        },
    )
}

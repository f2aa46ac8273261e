//! Which nodes are strongly coupled: |a_ij|² > θ² |a_ii| |a_jj|, with Frobenius norms of
//! the blocks between nodes (Vaněk, Mandel and Brezina 1996).
//!
//! Across a jump of the coefficient, or along the wide side of stretched elements, smooth
//! errors do not go on, so aggregates must not.

use crate::multigrid::aggregation::nodes::Nodes;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::real::Real;
use octruss_base::chunks::map_ranges;

/// The strong neighbours of each node.
pub(crate) struct StrongNeighbours {
    offsets: Vec<usize>,
    neighbours: Vec<u32>,
}

impl StrongNeighbours {
    /// Those of the rows of a symmetric matrix, with θ = `threshold`.
    pub(crate) fn new<E: Entry>(matrix: &Csr<E>, nodes: &Nodes, threshold: f64) -> Self {
        let node_of = nodes.of_rows();
        // (neighbour, squared norm of the block), ascending.
        let blocks = |node: usize, row: &mut Vec<(u32, f64)>| {
            row.clear();
            for i in nodes.rows(node) {
                let (columns, values) = matrix.row(i);
                let norms = values.iter().map(squared_norm);
                row.extend(columns.iter().map(|j| node_of[*j as usize]).zip(norms));
            }
            row.sort_by_key(|(neighbour, _)| *neighbour);
            row.dedup_by(|later, kept| {
                let is_same = later.0 == kept.0;
                kept.1 += if is_same { later.1 } else { 0.0 };
                is_same
            });
        };
        let own = |node: usize, row: &[(u32, f64)]| {
            let at = row.binary_search_by_key(&(node as u32), |(neighbour, _)| *neighbour);
            at.map_or(0.0, |at| row[at].1.sqrt())
        };
        let diagonal: Vec<f64> = map_ranges(nodes.count(), |range| {
            let mut row = Vec::new();
            let norm = |node| {
                blocks(node, &mut row);
                own(node, &row)
            };
            range.map(norm).collect::<Vec<f64>>()
        })
        .concat();
        let chunks = map_ranges(nodes.count(), |range| {
            let (mut row, mut lengths, mut all) = (Vec::new(), Vec::new(), Vec::new());
            for node in range {
                blocks(node, &mut row);
                let before = all.len();
                let limit =
                    |other: u32| threshold.powi(2) * diagonal[node] * diagonal[other as usize];
                let strong = row
                    .iter()
                    .filter(|(other, norm)| *other as usize != node && *norm > limit(*other));
                all.extend(strong.map(|(other, _)| *other));
                lengths.push(all.len() - before);
            }
            (lengths, all)
        });
        let mut offsets = vec![0];
        let mut end = 0;
        for length in chunks.iter().flat_map(|(lengths, _)| lengths) {
            end += length;
            offsets.push(end);
        }
        let neighbours: Vec<&[u32]> = chunks.iter().map(|(_, all)| &**all).collect();
        Self { offsets, neighbours: neighbours.concat() }
    }

    /// How many nodes there are.
    pub(crate) fn nodes(&self) -> usize {
        self.offsets.len() - 1
    }

    /// The strong neighbours of a node, itself left out, ascending.
    pub(crate) fn of(&self, node: usize) -> &[u32] {
        &self.neighbours[self.offsets[node]..self.offsets[node + 1]]
    }
}

fn squared_norm<E: Entry>(entry: &E) -> f64 {
    let numbers = E::flat(std::slice::from_ref(entry)).iter();
    numbers.map(|number| number.to_f64().powi(2)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::toy::second_difference;

    #[test]
    fn a_chain_breaks_where_the_coefficient_jumps() {
        // Ends of links of stiffness 1, but 10⁶ behind the third: node 3 belongs to the stiff.
        let a = second_difference(6);
        let stiffness = [1.0, 1.0, 1.0, 1e6, 1e6, 1e6, 1e6];
        let value = |i: usize, j: u32| match i as u32 == j {
            true => stiffness[i] + stiffness[i + 1],
            false => -stiffness[i.max(j as usize)],
        };
        let values = (0..6).flat_map(|i| a.row(i).0.iter().map(move |&j| value(i, j)));
        let a = a.with_values(values.collect());
        let strong = StrongNeighbours::new(&a, &Nodes::single(6), 0.02);
        let all: Vec<&[u32]> = (0..strong.nodes()).map(|node| strong.of(node)).collect();
        assert_eq!(all, [&[1u32][..], &[0], &[3], &[2, 4], &[3, 5], &[4]]);
    }
}

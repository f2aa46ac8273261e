//! The rows of a matrix in one domain, and sweeps through them.
//!
//! With the rows of a domain numbered on their own, the matrix is
//! L + D + Lᵀ + O: D its diagonal, L what is below it within the domain, O what
//! couples to other domains. Lᵀ is not stored: while a row of L is at hand for a sum
//! over the rows above, what the row adds to the rows above is sent there.

use crate::multigrid::smoother::diagonal::Diagonal;
use crate::multigrid::smoother::domains::LIMIT;
use crate::sparse::csr::Csr;
use crate::sparse::entry::{Entry, Nodal};
use std::ops::Range;

/// Rows of L, D and O.
pub(crate) struct DomainRows<E> {
    rows: Vec<Row<E>>,
    /// The entries of L, row by row.
    lower: Vec<Coupling<E>>,
    outer_rows: Vec<OuterRow>,
    /// The columns of O, as rows of the matrix, and its values, row by row.
    outer_columns: Vec<u32>,
    outer_values: Vec<E>,
}

/// The inverse of D, and how many entries of L there are.
#[derive(Clone, Copy)]
struct Row<E> {
    inverse: E,
    length: u32,
}

/// An entry of L; its column as a row of the domain.
#[derive(Clone, Copy)]
struct Coupling<E> {
    value: E,
    place: u16,
}

/// A row of the domain that has entries in O, and how many.
#[derive(Clone, Copy)]
struct OuterRow {
    place: u16,
    length: u32,
}

/// A value for each row of a domain; as long as 16 bits can number, so that no index
/// needs to be checked.
pub(crate) type Local<V> = [V; LIMIT];

/// The norms of D⁻¹ O in a row sum to this at most: at 1 sweeps may leave an error.
const MARGIN: f64 = 0.95;

impl<E: Entry> DomainRows<E> {
    /// The rows in `ranges` of `scale` times a matrix. `places` has the domain of every
    /// row of the matrix and its number therein.
    ///
    /// A sweep reduces every error in the energy norm if M + Mᵀ − A, for M = L + D, is
    /// positive definite: D − O is if in each row the norms of D⁻¹ O sum to less than 1.
    /// Where they do not, D is multiplied by a g for which 2 g − 1 exceeds that sum, and
    /// (1 − g) D goes to O, so that all together stay the matrix.
    pub(crate) fn new<D: Entry<Real = f64>>(
        (matrix, diagonal, scale): (&Csr<D>, &Diagonal<D>, f64),
        (domain, ranges): (u16, &[Range<usize>]),
        places: &[(u16, u16)],
    ) -> Self {
        let entries = |range: &Range<usize>| matrix.offset(range.end) - matrix.offset(range.start);
        let mut all = Self {
            rows: Vec::with_capacity(ranges.iter().map(ExactSizeIterator::len).sum()),
            lower: Vec::with_capacity(ranges.iter().map(entries).sum::<usize>() / 2),
            outer_rows: Vec::new(),
            outer_columns: Vec::new(),
            outer_values: Vec::new(),
        };
        for i in ranges.iter().cloned().flatten() {
            let (here, inverse) = (all.rows.len(), diagonal.inverses[i]);
            let before = (all.lower.len(), all.outer_columns.len());
            let mut outer_norm = 0.0;
            let (columns, values) = matrix.row(i);
            for (&j, value) in columns.iter().zip(values) {
                let (other, place) = places[j as usize];
                if other != domain {
                    outer_norm += inverse.times(*value).norm();
                    all.push_outer(j, value.cast_scaled(scale));
                } else if usize::from(place) < here {
                    all.lower.push(Coupling { value: value.cast_scaled(scale), place });
                }
            }
            let growth = (0.5 * (1.0 + outer_norm / MARGIN)).max(1.0);
            if growth > 1.0 {
                let rest = diagonal.entries[i].cast_scaled(scale * (1.0 - growth));
                all.push_outer(i as u32, rest);
            }
            let length = (all.lower.len() - before.0) as u32;
            all.rows.push(Row { inverse: inverse.cast_scaled(1.0 / (scale * growth)), length });
            let length = (all.outer_columns.len() - before.1) as u32;
            if length > 0 {
                all.outer_rows.push(OuterRow { place: here as u16, length });
            }
        }
        all
    }

    fn push_outer(&mut self, column: u32, value: E) {
        self.outer_columns.push(column);
        self.outer_values.push(value);
    }

    /// x = (L + D)⁻¹ r, then r = −Lᵀ x.
    pub(crate) fn forward(&self, x: &mut Local<E::Nodal>, r: &mut Local<E::Nodal>) {
        let mut lower = &*self.lower;
        for (i, row) in self.rows.iter().enumerate() {
            let entries;
            (entries, lower) = lower.split_at(row.length as usize);
            relax(entries, (i as u16, row.inverse), x, r);
            r[usize::from(i as u16)] = E::Nodal::default();
        }
    }

    /// x = (D + Lᵀ)⁻¹ (r − L x), from the last row to the first; r is spent.
    pub(crate) fn backward(&self, x: &mut Local<E::Nodal>, r: &mut Local<E::Nodal>) {
        let mut lower = &*self.lower;
        for (i, row) in self.rows.iter().enumerate().rev() {
            let entries;
            (lower, entries) = lower.split_at(lower.len() - row.length as usize);
            relax(entries, (i as u16, row.inverse), x, r);
        }
    }

    /// r −= (L + D + Lᵀ) x.
    pub(crate) fn subtract_inner(&self, x: &Local<E::Nodal>, r: &mut Local<E::Nodal>) {
        let mut lower = &*self.lower;
        for (i, row) in self.rows.iter().enumerate() {
            let entries;
            (entries, lower) = lower.split_at(row.length as usize);
            let i = usize::from(i as u16);
            let minus = E::Nodal::default().minus(x[i]);
            // Asked for too rarely to keep D. Inverted again it is the D of the sweeps,
            // which the cycle needs to be symmetric. Where rounding left no positive
            // definite inverse, sweeps fail, too.
            let diagonal = row.inverse.inverse().unwrap_or_default();
            let mut sum = diagonal.add_product(minus, r[i]);
            for Coupling { value, place } in entries {
                let j = usize::from(*place);
                sum = sum.minus(value.add_product(x[j], E::Nodal::default()));
                r[j] = value.transposed().add_product(minus, r[j]);
            }
            r[i] = sum;
        }
    }

    /// r −= O x, for x on the whole level.
    pub(crate) fn subtract_outer(&self, x: &[E::Nodal], r: &mut Local<E::Nodal>) {
        let (mut columns, mut values) = (&*self.outer_columns, &*self.outer_values);
        for row in &self.outer_rows {
            let (row_columns, row_values);
            (row_columns, columns) = columns.split_at(row.length as usize);
            (row_values, values) = values.split_at(row.length as usize);
            let mut sum = E::Nodal::default();
            for (&j, value) in row_columns.iter().zip(row_values) {
                sum = value.add_product(x[j as usize], sum);
            }
            let r = &mut r[usize::from(row.place)];
            *r = r.minus(sum);
        }
    }

    /// The memory of the arrays, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(&*self.rows)
            + size_of_val(&*self.lower)
            + size_of_val(&*self.outer_rows)
            + size_of_val(&*self.outer_columns)
            + size_of_val(&*self.outer_values)
    }
}

/// x_i = (r_i − L_i x) / D_i, then r −= L_iᵀ x_i: all that needs row i of L.
#[inline(always)]
fn relax<E: Entry>(
    lower: &[Coupling<E>],
    (i, inverse): (u16, E),
    x: &mut Local<E::Nodal>,
    r: &mut Local<E::Nodal>,
) {
    let (zero, i) = (E::Nodal::default(), usize::from(i));
    let mut rest = r[i];
    for entry in lower {
        rest = rest.minus(entry.value.add_product(x[usize::from(entry.place)], zero));
    }
    x[i] = inverse.add_product(rest, zero);
    let minus = zero.minus(x[i]);
    for entry in lower {
        let r = &mut r[usize::from(entry.place)];
        *r = entry.value.transposed().add_product(minus, *r);
    }
}

//! An orthonormal basis of a few vectors, as on one aggregate.

/// What is left of a vector beside this share of the largest, after those before it are taken
/// out, is rounding.
const DEPENDENT: f64 = 1e-8;

/// A few vectors, the columns of B, as Q R: the columns of Q orthonormal, as many as B has
/// independent ones.
pub(crate) struct Orthonormal {
    rows: usize,
    columns: usize,
    /// By columns.
    q: Vec<f64>,
    /// By rows.
    r: Vec<f64>,
}

impl Orthonormal {
    /// Gram and Schmidt's method for B of so many columns, given by columns; each is freed
    /// of those before it twice, which is enough (Kahan and Parlett).
    pub(crate) fn new(b: &[f64], columns: usize) -> Self {
        let rows = b.len() / columns;
        debug_assert!(rows > 0, "an aggregate has a row");
        let largest = b.chunks_exact(rows).map(|v| dot(v, v).sqrt()).fold(0.0, f64::max);
        let (mut q, mut r): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
        for (column, vector) in b.chunks_exact(rows).enumerate() {
            let mut rest = vector.to_vec();
            for _ in 0..2 {
                for (rank, direction) in q.chunks_exact(rows).enumerate() {
                    let share = dot(direction, &rest);
                    rest.iter_mut().zip(direction).for_each(|(v, d)| *v -= share * d);
                    r[rank * columns + column] += share;
                }
            }
            let size = dot(&rest, &rest).sqrt();
            if size > DEPENDENT * largest {
                q.extend(rest.iter().map(|v| v / size));
                r.resize(r.len() + columns, 0.0);
                let last = r.len() - columns + column;
                r[last] = size;
            }
        }
        Self { rows, columns, q, r }
    }

    /// How many vectors are independent.
    pub(crate) fn rank(&self) -> usize {
        self.r.len() / self.columns
    }

    /// Q in a row and column; 0 beyond the rank.
    pub(crate) fn q(&self, row: usize, column: usize) -> f64 {
        self.q.get(column * self.rows + row).copied().unwrap_or(0.0)
    }

    /// R in a row and column; 0 beyond the rank.
    pub(crate) fn r(&self, row: usize, column: usize) -> f64 {
        self.r.get(row * self.columns + column).copied().unwrap_or(0.0)
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sparse::noise::noise;

    #[test]
    fn q_r_is_b_also_where_a_column_depends_on_others() {
        // The third column is the sum of the first two, the fourth zero.
        let mut b = noise(5 * 5, 1);
        for i in 0..5 {
            b[10 + i] = b[i] + b[5 + i];
            b[15 + i] = 0.0;
        }
        let made = Orthonormal::new(&b, 5);
        assert_eq!(made.rank(), 3);
        for (i, j) in (0..5).flat_map(|i| (0..5).map(move |j| (i, j))) {
            let product: f64 = (0..5).map(|k| made.q(i, k) * made.r(k, j)).sum();
            assert!((product - b[5 * j + i]).abs() < 1e-14);
            let square: f64 = (0..5).map(|k| made.q(k, i) * made.q(k, j)).sum();
            let expected = if i == j && i < 3 { 1.0 } else { 0.0 };
            assert!((square - expected).abs() < 1e-14);
        }
    }
}

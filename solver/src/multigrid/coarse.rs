//! The direct solver of the coarsest level: faer's sparse Cholesky, tested.
//!
//! The only file that names faer. Its low-level interface is used because the
//! high-level one takes its parallelism from a global setting: results would
//! depend on the number of threads. At these sizes threads gain nothing.
//! A wrong factor has been reported upstream for large supernodes, so every
//! factor must solve a known system before it is trusted; LU is the fallback.
//!
//! A matrix may be ill-conditioned, as where soft springs hold a stiff body, and its factor
//! good all the same. So a factor is judged by the backward error of each row, and a matrix
//! counts as singular only where its smallest eigenvalue, in units of its diagonal, is
//! rounding.

use crate::error::Error;
use crate::krylov::operator::Operator;
use crate::sparse::backward_error::backward_error;
use crate::sparse::csr::Csr;
use crate::sparse::dot::{largest, norm};
use crate::sparse::kernels::residual;
use crate::sparse::noise::noise;
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::sparse::linalg::cholesky::{LltRef, SymbolicCholesky, factorize_symbolic_cholesky};
use faer::sparse::linalg::lu::{LuRef, NumericLu, SymbolicLu, factorize_symbolic_lu};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};

/// The most unknowns accepted: about a second of factoring.
pub(crate) const LARGEST: usize = 20_000;

/// So many are factored in milliseconds.
const SMALL: usize = 1_500;

/// The largest backward error of the test system.
const TOLERANCE: f64 = 1e-10;

/// Eigenvalues of the matrix scaled to ones on the diagonal that are below this are
/// rounding.
const SINGULAR: f64 = 1e-14;

/// Steps of inverse iteration: a zero eigenvalue shows after one.
const INVERSE_STEPS: usize = 3;

impl std::fmt::Debug for CoarseSolver {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "CoarseSolver({} unknowns)", self.matrix.rows())
    }
}

/// Why a factor is not trusted.
struct Untrusted {
    reason: String,
    /// What the matrix sends to zero, if that is why.
    null_vector: Vec<f64>,
}

impl From<String> for Untrusted {
    fn from(reason: String) -> Self {
        Self { reason, null_vector: Vec::new() }
    }
}

/// A factored matrix with all memory that solving needs.
pub(crate) struct CoarseSolver {
    matrix: Csr<f64>,
    factor: Factor,
    workspace: MemBuffer,
    correction: Vec<f64>,
}

/// In which order Cholesky's factorisation eliminates, and where its factor has
/// entries.
pub(crate) type Elimination = SymbolicCholesky<u32>;

/// The elimination order of a matrix if a direct solution is cheap: where there are few
/// unknowns, or the factor has at most `affordable` entries.
pub(crate) fn affordable_elimination(matrix: &Csr<f64>, affordable: usize) -> Option<Elimination> {
    let offsets = offsets(matrix);
    let elimination = analysed(columns(matrix, &offsets).symbolic()).ok()?;
    let is_cheap = matrix.rows() <= SMALL || elimination.len_val() <= affordable;
    is_cheap.then_some(elimination)
}

/// Where rows begin. Fewer than 2^32 entries: 20,000 rows cannot hold more.
fn offsets(matrix: &Csr<f64>) -> Vec<u32> {
    (0..=matrix.rows()).map(|row| matrix.offset(row) as u32).collect()
}

/// Rows of a symmetric matrix are its columns.
fn columns<'a>(matrix: &'a Csr<f64>, offsets: &'a [u32]) -> SparseColMatRef<'a, u32, f64> {
    let (n, indices) = (matrix.rows(), matrix.indices());
    let pattern = SymbolicSparseColMatRef::new_checked(n, n, offsets, None, indices);
    SparseColMatRef::new(pattern, matrix.values())
}

fn analysed(pattern: SymbolicSparseColMatRef<'_, u32>) -> Result<Elimination, String> {
    let (side, ordering) = (Side::Lower, Default::default());
    factorize_symbolic_cholesky(pattern, side, ordering, Default::default())
        .map_err(|error| format!("{error:?}"))
}

enum Factor {
    Cholesky(Elimination, Vec<f64>),
    Lu(SymbolicLu<u32>, NumericLu<u32, f64>),
}

impl CoarseSolver {
    /// Factors a symmetric positive definite matrix. Its elimination order may be
    /// known from another matrix with the same pattern.
    ///
    /// # Errors
    /// [`Error::CoarsestTooLarge`]; [`Error::CoarsestSingular`] if neither
    /// Cholesky nor LU solves the test system.
    pub(crate) fn new(matrix: Csr<f64>, known: Option<Elimination>) -> Result<Self, Error> {
        let unknowns = matrix.rows();
        if unknowns > LARGEST {
            return Err(Error::CoarsestTooLarge { unknowns, limit: LARGEST });
        }
        let offsets = offsets(&matrix);
        let columns = columns(&matrix, &offsets);
        let factored = cholesky(columns, known)
            .map_err(Untrusted::from)
            .and_then(|made| Self::tested(&matrix, made));
        let cholesky = match factored {
            Ok(solver) => return Ok(solver),
            Err(reason) => reason,
        };
        lu(columns).map_err(Untrusted::from).and_then(|made| Self::tested(&matrix, made)).map_err(
            |lu| Error::CoarsestSingular {
                unknowns,
                cholesky: cholesky.reason.into(),
                lu: lu.reason.into(),
                null_vector: if lu.null_vector.is_empty() {
                    cholesky.null_vector
                } else {
                    lu.null_vector
                },
            },
        )
    }

    /// Wraps a factor if it solves a system with known noise on the right, and finds no
    /// vector that the matrix sends to zero.
    fn tested(matrix: &Csr<f64>, (factor, space): (Factor, StackReq)) -> Result<Self, Untrusted> {
        let n = matrix.rows();
        let workspace = MemBuffer::try_new(space).map_err(|error| format!("{error:?}"))?;
        let (matrix, correction) = (matrix.clone(), vec![0.0; n]);
        let mut solver = Self { matrix, factor, workspace, correction };
        let (b, mut x) = (noise(n, 2), vec![0.0; n]);
        solver.solve(&b, &mut x);
        let error = backward_error(&solver.matrix, &x, &b);
        if error > TOLERANCE || error.is_nan() {
            return Err(format!("backward error {error:.1e} on a test system").into());
        }
        let (smallest, null_vector) = solver.smallest_eigenvalue();
        if smallest < SINGULAR || smallest.is_nan() {
            let reason = format!("smallest eigenvalue {smallest:.1e} of its diagonal");
            return Err(Untrusted { reason, null_vector: scaled_to_one(null_vector) });
        }
        Ok(solver)
    }

    /// The smallest absolute eigenvalue of D^(−1/2) A D^(−1/2), D the diagonal, from above,
    /// by inverse iteration, infinite without unknowns; and D^(−1/2) times its eigenvector.
    fn smallest_eigenvalue(&mut self) -> (f64, Vec<f64>) {
        let roots: Vec<f64> = self.matrix.diagonal().iter().map(|d| d.abs().sqrt()).collect();
        let scale = |v: &mut [f64]| v.iter_mut().zip(&roots).for_each(|(v, root)| *v *= root);
        let mut v = noise(roots.len(), 3);
        let (mut smallest, mut x) = (f64::INFINITY, Vec::new());
        for _ in 0..INVERSE_STEPS {
            let size = norm(&v);
            v.iter_mut().for_each(|v| *v /= size);
            scale(&mut v);
            self.apply_factor(&mut v);
            x.clone_from(&v);
            scale(&mut v);
            smallest = 1.0 / norm(&v);
        }
        (if roots.is_empty() { f64::INFINITY } else { smallest }, x)
    }

    /// The elimination order, for another matrix; not that of LU, the fallback.
    pub(crate) fn into_elimination(self) -> Option<Elimination> {
        match self.factor {
            Factor::Cholesky(symbolic, _) => Some(symbolic),
            Factor::Lu(..) => None,
        }
    }

    /// The memory of matrix and factor, in bytes; of an LU factor, whose size
    /// faer does not tell, only that of the matrix.
    pub(crate) fn bytes(&self) -> usize {
        let factor = match &self.factor {
            Factor::Cholesky(_, values) => size_of_val(&**values),
            Factor::Lu(..) => 0,
        };
        self.matrix.bytes() + factor
    }

    /// x = A⁻¹ b, with one step of iterative refinement.
    pub(crate) fn solve(&mut self, b: &[f64], x: &mut [f64]) {
        x.copy_from_slice(b);
        self.apply_factor(x);
        let mut correction = std::mem::take(&mut self.correction);
        residual(&self.matrix, x, b, &mut correction);
        self.apply_factor(&mut correction);
        x.iter_mut().zip(&correction).for_each(|(x, c)| *x += c);
        self.correction = correction;
    }

    fn apply_factor(&mut self, x: &mut [f64]) {
        let rows = x.len();
        let x = MatMut::from_column_major_slice_mut(x, rows, 1);
        let stack = MemStack::new(&mut self.workspace);
        match &self.factor {
            Factor::Cholesky(symbolic, values) => {
                let factor = LltRef::new(symbolic, values);
                factor.solve_in_place_with_conj(Conj::No, x, Par::Seq, stack);
            }
            Factor::Lu(symbolic, numeric) => {
                let factor = LuRef::new_unchecked(symbolic, numeric);
                factor.solve_in_place_with_conj(Conj::No, x, Par::Seq, stack);
            }
        }
    }
}

/// With largest entry 1; nothing of a vector that is not finite.
fn scaled_to_one(mut v: Vec<f64>) -> Vec<f64> {
    let largest = largest(&v);
    if !(largest > 0.0 && largest.is_finite() && v.iter().all(|v| v.is_finite())) {
        return Vec::new();
    }
    v.iter_mut().for_each(|v| *v /= largest);
    v
}

/// A factor and the workspace that solving with it needs, or what went wrong.
type Made = Result<(Factor, StackReq), String>;

fn cholesky(matrix: SparseColMatRef<'_, u32, f64>, known: Option<Elimination>) -> Made {
    let text = |error: &dyn std::fmt::Debug| format!("{error:?}");
    let symbolic = known.map_or_else(|| analysed(matrix.symbolic()), Ok)?;
    let space = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
    let mut memory = MemBuffer::try_new(space).map_err(|error| text(&error))?;
    let mut values = vec![0.0; symbolic.len_val()];
    symbolic
        .factorize_numeric_llt(
            &mut values,
            matrix,
            Side::Lower,
            Default::default(),
            Par::Seq,
            MemStack::new(&mut memory),
            Default::default(),
        )
        .map_err(|error| text(&error))?;
    let space = symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
    Ok((Factor::Cholesky(symbolic, values), space))
}

fn lu(matrix: SparseColMatRef<'_, u32, f64>) -> Made {
    let text = |error: &dyn std::fmt::Debug| format!("{error:?}");
    let symbolic = factorize_symbolic_lu(matrix.symbolic(), Default::default())
        .map_err(|error| text(&error))?;
    let space = symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, Default::default());
    let mut memory = MemBuffer::try_new(space).map_err(|error| text(&error))?;
    let mut numeric = NumericLu::new();
    symbolic
        .factorize_numeric_lu(
            &mut numeric,
            matrix,
            Par::Seq,
            MemStack::new(&mut memory),
            Default::default(),
        )
        .map_err(|error| text(&error))?;
    let space = symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
    Ok((Factor::Lu(symbolic, numeric), space))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::toy::second_difference;

    #[test]
    fn the_second_difference_is_inverted_exactly() {
        // (−1, 2, −1) x = 1 has the solution x_i = i (n + 1 − i) / 2.
        for n in [0usize, 1, 2, 100, 3000] {
            let mut x = vec![0.0; n];
            CoarseSolver::new(second_difference(n), None).unwrap().solve(&vec![1.0; n], &mut x);
            for (i, x) in x.iter().enumerate() {
                let exact = (i + 1) as f64 * (n - i) as f64 / 2.0;
                assert!((x / exact - 1.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn an_ill_conditioned_matrix_is_no_singular_one() {
        // A chain of 200 that a spring of stiffness k holds at one end: condition some 10³ / k.
        let chain = |k: f64| {
            let a = second_difference(200);
            let last = a.nonzeros() - 1;
            let mut values = a.values().to_vec();
            (values[0], values[last]) = (1.0 + k, 1.0);
            a.with_values(values)
        };
        for k in [1e-3, 1e-6, 1e-9] {
            let mut x = vec![0.0; 200];
            let mut pull = vec![0.0; 200];
            pull[199] = 1.0;
            CoarseSolver::new(chain(k), None).unwrap().solve(&pull, &mut x);
            // 1 / k of the spring, 1 of each of 199 links.
            let error = (x[199] / (1.0 / k + 199.0) - 1.0).abs();
            assert!(error < 1e-13 / k, "{k}: {error}");
        }
        assert!(matches!(CoarseSolver::new(chain(0.0), None), Err(Error::CoarsestSingular { .. })));
    }

    #[test]
    fn an_indefinite_matrix_falls_back_to_lu_and_a_singular_one_is_refused() {
        let diagonal = |d: [f64; 2]| Csr::new(2, vec![0, 1, 2], vec![0, 1], d.to_vec()).unwrap();
        let mut solver = CoarseSolver::new(diagonal([2.0, -4.0]), None).unwrap();
        assert!(matches!(solver.factor, Factor::Lu(..)));
        let mut x = [0.0; 2];
        solver.solve(&[1.0, 1.0], &mut x);
        assert_eq!(x, [0.5, -0.25]);
        let ones = Csr::new(2, vec![0, 2, 4], vec![0, 1, 0, 1], vec![1.0; 4]).unwrap();
        assert!(matches!(CoarseSolver::new(ones, None), Err(Error::CoarsestSingular { .. })));
        assert!(matches!(
            CoarseSolver::new(second_difference(LARGEST + 1), None),
            Err(Error::CoarsestTooLarge { limit: LARGEST, .. })
        ));
    }
}

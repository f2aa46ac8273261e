//! Hybrid Gauss–Seidel: row after row within domains, all domains at once with the
//! values of the sweep before from each other (Baker, Falgout, Kolev and Yang 2011).
//!
//! With A = L + D + Lᵀ + O as in `domain_rows`, a sweep and the residual that it leaves
//! take one pass over L, half of the matrix:
//! - before the correction x = (L + D)⁻¹ r and then r = −(Lᵀ + O) x, so that no product
//!   is needed for the residual;
//! - after it x = (D + Lᵀ)⁻¹ (b − (L + O) x), the adjoint.

use crate::multigrid::smoother::diagonal::Diagonal;
use crate::multigrid::smoother::domain_rows::{DomainRows, Local};
use crate::multigrid::smoother::domains::{Domains, LIMIT};
use crate::sparse::csr::Csr;
use crate::sparse::entry::{Entry, Nodal};
use octruss_base::chunks::for_chunks;
use octruss_base::large_array::zeroed;
use octruss_base::workspaces::Workspaces;
use rayon::prelude::*;
use std::ops::Range;

/// The matrix of a level by domains, and what its sweeps work in.
pub(crate) struct HybridGaussSeidel<E: Entry> {
    domains: Domains,
    parts: Vec<DomainRows<E>>,
    /// The correction of a sweep, or the next iterate.
    next: Vec<E::Nodal>,
    workspaces: Workspaces<Workspace<E::Nodal>>,
}

/// Solution and right-hand side, or residual, of a domain.
struct Workspace<V> {
    x: Box<Local<V>>,
    r: Box<Local<V>>,
}

impl<E: Entry> HybridGaussSeidel<E> {
    /// Of `scale` times a matrix.
    pub(crate) fn new<D: Entry<Real = f64>>(
        scaled: (&Csr<D>, &Diagonal<D>, f64),
        domains: Domains,
    ) -> Self {
        let rows = scaled.0.rows();
        assert!(domains.ranges().len() <= LIMIT, "domains are numbered by 16 bits");
        let mut places: Vec<(u16, u16)> = zeroed(rows);
        let pieces = domains.pieces(&mut places).into_par_iter().enumerate();
        pieces.for_each(|(domain, pieces)| {
            let places = pieces.into_iter().flatten().enumerate();
            places.for_each(|(k, place)| *place = (domain as u16, k as u16));
        });
        let parts = domains.ranges().par_iter().enumerate().with_max_len(1);
        let parts = parts.map(|(domain, ranges)| {
            DomainRows::new(scaled, (domain as u16, ranges.as_slice()), &places)
        });
        let (parts, workspaces) = (parts.collect(), Workspaces::default());
        Self { domains, parts, next: zeroed(rows), workspaces }
    }

    pub(crate) fn into_domains(self) -> Domains {
        self.domains
    }

    /// Sweeps before the correction, from `x` or with `from_zero` from zero, and the
    /// residual `r` after them.
    pub(crate) fn before(
        &mut self,
        sweeps: usize,
        (b, x): (&[E::Nodal], &mut [E::Nodal]),
        from_zero: bool,
        r: &mut [E::Nodal],
    ) {
        let mut left = sweeps;
        if from_zero && sweeps > 0 {
            self.correction(Some(b), x, r);
            left -= 1;
        } else if from_zero {
            x.fill(E::Nodal::default());
            r.copy_from_slice(b);
        } else {
            self.residual(b, x, r);
        }
        let mut next = std::mem::take(&mut self.next);
        for _ in 0..left {
            self.correction(None, &mut next, r);
            for_chunks(x, |first, x| {
                x.iter_mut().zip(&next[first..]).for_each(|(x, c)| *x = x.plus(*c));
            });
        }
        self.next = next;
    }

    /// The sweeps after the correction.
    pub(crate) fn after(&mut self, sweeps: usize, b: &[E::Nodal], x: &mut Vec<E::Nodal>) {
        let mut next = std::mem::take(&mut self.next);
        for _ in 0..sweeps {
            self.for_domains(self.domains.pieces(&mut next), |part, ranges, work, mut next| {
                gather(own(ranges, b), &mut work.r);
                gather(own(ranges, x), &mut work.x);
                part.subtract_outer(x, &mut work.r);
                part.backward(&mut work.x, &mut work.r);
                scatter(&work.x, &mut next);
            });
            std::mem::swap(x, &mut next);
        }
        self.next = next;
    }

    /// x = (L + D)⁻¹ b, or without b of what `r` holds, and r = b − A x.
    fn correction(&self, b: Option<&[E::Nodal]>, x: &mut [E::Nodal], r: &mut [E::Nodal]) {
        let pieces = self.domains.pieces(x).into_iter().zip(self.domains.pieces(r)).collect();
        self.for_domains(pieces, |part, ranges, work, (mut x, mut r)| {
            match b {
                Some(b) => gather(own(ranges, b), &mut work.r),
                None => gather(r.iter().map(|piece| &**piece), &mut work.r),
            }
            part.forward(&mut work.x, &mut work.r);
            scatter(&work.x, &mut x);
            scatter(&work.r, &mut r);
        });
        if self.parts.len() > 1 {
            self.for_domains(self.domains.pieces(r), |part, _, work, mut r| {
                gather(r.iter().map(|piece| &**piece), &mut work.r);
                part.subtract_outer(x, &mut work.r);
                scatter(&work.r, &mut r);
            });
        }
    }

    /// r = b − A x.
    fn residual(&self, b: &[E::Nodal], x: &[E::Nodal], r: &mut [E::Nodal]) {
        self.for_domains(self.domains.pieces(r), |part, ranges, work, mut r| {
            gather(own(ranges, b), &mut work.r);
            gather(own(ranges, x), &mut work.x);
            part.subtract_inner(&work.x, &mut work.r);
            part.subtract_outer(x, &mut work.r);
            scatter(&work.r, &mut r);
        });
    }

    /// Runs `work` for all domains, each with its rows, a workspace of unknown contents
    /// and its pieces.
    fn for_domains<T: Send>(
        &self,
        pieces: Vec<T>,
        work: impl Fn(&DomainRows<E>, &[Range<usize>], &mut Workspace<E::Nodal>, T) + Sync,
    ) {
        let run = |((part, ranges), pieces): ((&DomainRows<E>, &Vec<Range<usize>>), T)| {
            self.workspaces.lend(Workspace::new, |own| work(part, ranges, own, pieces));
        };
        let ranges = self.domains.ranges();
        if self.parts.len() == 1 {
            // Waking another thread would take longer.
            self.parts.iter().zip(ranges).zip(pieces).for_each(run);
        } else {
            let domains = self.parts.par_iter().zip(ranges).zip(pieces);
            domains.with_max_len(1).for_each(run);
        }
    }

    /// The memory of the matrix and of work vectors, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        self.matrix_bytes() + size_of_val(&*self.next)
    }

    /// The bytes that sweeps before the correction, from zero, and the residual move.
    pub(crate) fn before_bytes(&self, sweeps: usize) -> usize {
        let vector = size_of_val(&*self.next);
        // Reads b, writes x and r; adds to r what other domains contribute.
        let sweep = 3 + if self.parts.len() > 1 { 2 } else { 0 };
        match sweeps {
            // Copies b, clears x.
            0 => 3 * vector,
            // All but the first also add to x.
            _ => sweeps * (self.matrix_bytes() + sweep * vector) + (sweeps - 1) * 3 * vector,
        }
    }

    /// The bytes that sweeps after the correction move.
    pub(crate) fn after_bytes(&self, sweeps: usize) -> usize {
        sweeps * (self.matrix_bytes() + 3 * size_of_val(&*self.next))
    }

    fn matrix_bytes(&self) -> usize {
        self.domains.bytes() + self.parts.iter().map(DomainRows::bytes).sum::<usize>()
    }
}

impl<V: Nodal> Workspace<V> {
    fn new() -> Self {
        let zeroed = || {
            let all: Box<[V]> = zeroed(LIMIT).into_boxed_slice();
            all.try_into().expect("just as long")
        };
        Self { x: zeroed(), r: zeroed() }
    }
}

/// The pieces of a vector in a domain.
fn own<'v, V>(ranges: &[Range<usize>], vector: &'v [V]) -> impl Iterator<Item = &'v [V]> {
    ranges.iter().map(|range| &vector[range.clone()])
}

/// The rows of a domain from their pieces.
fn gather<'v, V: Nodal>(from: impl Iterator<Item = &'v [V]>, to: &mut Local<V>) {
    let mut rest = &mut to[..];
    for piece in from {
        let part;
        (part, rest) = rest.split_at_mut(piece.len());
        part.copy_from_slice(piece);
    }
}

/// The rows of a domain into their pieces.
fn scatter<V: Nodal>(from: &Local<V>, to: &mut [&mut [V]]) {
    let mut rest = &from[..];
    for piece in to {
        let part;
        (part, rest) = rest.split_at(piece.len());
        piece.copy_from_slice(part);
    }
}

#[cfg(test)]
mod tests;

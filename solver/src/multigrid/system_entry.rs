//! The entries of systems that are solved, and where what solves them is compiled.

use crate::error::Error;
use crate::multigrid::aggregation::near_null_space::NearNullSpace;
use crate::multigrid::figures::traffic::Traffic;
use crate::multigrid::levels::Levels;
use crate::multigrid::options::ResolvedOptions;
use crate::multigrid::transfer::Transfer;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;

/// An entry of a system that is solved: a number, or a 3 × 3 block, row by row, in double
/// precision. There are no others.
///
/// Generic code is compiled anew by each crate that uses it, and there is much of it behind
/// a multigrid. So what takes long hangs on this trait, whose functions are generic no
/// more: this crate compiles them, once for numbers and once for blocks.
pub trait SystemEntry: Entry<Real = f64> {
    /// [`Levels::new`].
    #[doc(hidden)]
    fn build(
        matrix: &Csr<Self>,
        transfers: Vec<Transfer<Self>>,
        projectors: Vec<Vec<(u32, Self)>>,
        below: NearNullSpace,
        options: &ResolvedOptions,
    ) -> Result<Levels<Self>, Error>;
    /// [`Levels::updated`].
    #[doc(hidden)]
    fn rebuild(
        levels: Levels<Self>,
        matrix: &Csr<Self>,
        options: &ResolvedOptions,
    ) -> Result<Levels<Self>, Error>;
    /// [`Levels::apply`].
    #[doc(hidden)]
    fn cycle(levels: &mut Levels<Self>, r: &[f64], z: &mut [f64]);
    /// [`Levels::full`].
    #[doc(hidden)]
    fn full(
        levels: &mut Levels<Self>,
        r: &[f64],
        transfers: &[&Csr<f64>],
        cycles: usize,
        z: &mut [f64],
    );
    /// [`Levels::traffic`].
    #[doc(hidden)]
    fn traffic(levels: &mut Levels<Self>, repeats: usize) -> Traffic;
    /// [`Levels::cycle_bytes`].
    #[doc(hidden)]
    fn cycle_bytes(levels: &Levels<Self>, options: &ResolvedOptions) -> usize;
}

macro_rules! compiled_here {
    ($($entry:ty),*) => {$(
        impl SystemEntry for $entry {
            fn build(
                matrix: &Csr<Self>,
                transfers: Vec<Transfer<Self>>,
                projectors: Vec<Vec<(u32, Self)>>,
                below: NearNullSpace,
                options: &ResolvedOptions,
            ) -> Result<Levels<Self>, Error> {
                Levels::new(matrix, transfers, projectors, below, options)
            }
            fn rebuild(
                levels: Levels<Self>,
                matrix: &Csr<Self>,
                options: &ResolvedOptions,
            ) -> Result<Levels<Self>, Error> {
                levels.updated(matrix, options)
            }
            fn cycle(levels: &mut Levels<Self>, r: &[f64], z: &mut [f64]) {
                levels.apply(r, z);
            }
            fn full(
                levels: &mut Levels<Self>,
                r: &[f64],
                transfers: &[&Csr<f64>],
                cycles: usize,
                z: &mut [f64],
            ) {
                levels.full(r, transfers, cycles, z);
            }
            fn traffic(levels: &mut Levels<Self>, repeats: usize) -> Traffic {
                levels.traffic(repeats)
            }
            fn cycle_bytes(levels: &Levels<Self>, options: &ResolvedOptions) -> usize {
                levels.cycle_bytes(options)
            }
        }
    )*};
}

compiled_here!(f64, [[f64; 3]; 3]);

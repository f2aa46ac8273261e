//! Where a cycle's time goes: bytes and seconds for each kernel on each level,
//! against the copy bandwidth of the machine measured in between.

use crate::multigrid::cycle::Cycle;
use crate::multigrid::level::Level;
use crate::sparse::entry::Entry;
use rayon::prelude::*;
use std::fmt;
use std::time::Instant;

/// Measured traffic of one cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct Traffic {
    /// Bytes a second of copying memory, read and written ones counted.
    pub copy_bandwidth: f64,
    /// The kernels of each level, coarsest first; the coarsest is solved directly and has
    /// none.
    pub kernels: Vec<KernelTraffic>,
    /// All kernels in one cycle with the rounding of its input and output; the
    /// level's number says nothing.
    pub cycle: KernelTraffic,
}

/// One kernel on one level.
#[derive(Debug, Clone, PartialEq)]
pub struct KernelTraffic {
    /// 0 is the coarsest.
    pub level: usize,
    /// What it does.
    pub kernel: &'static str,
    /// What it must read and write, from the sizes of its arrays, each once.
    pub bytes: usize,
    /// The median time of one run.
    pub seconds: f64,
}

impl KernelTraffic {
    /// Bytes a second. Levels that fit a cache may exceed what memory can do.
    pub fn bandwidth(&self) -> f64 {
        self.bytes as f64 / self.seconds.max(f64::MIN_POSITIVE)
    }
}

/// Larger than caches, unless they are very large.
const COPIED: usize = 16 << 20;

type Step<E> = fn(&mut Level<E>, &[<E as Entry>::Nodal], &mut Vec<<E as Entry>::Nodal>);

/// Measures `repeats` runs of everything, interleaved.
pub(crate) fn measure<E: Entry>(cycle: &mut Cycle<E>, unknowns: usize, repeats: usize) -> Traffic {
    let source = vec![1.0f64; COPIED];
    let mut target = vec![0.0f64; COPIED];
    let mut copies = Vec::new();
    let input = crate::noise(unknowns, 31);
    let mut output = vec![0.0; unknowns];
    let mut cycles = Vec::new();
    let mut kernels: Vec<(usize, &'static str, usize, Vec<f64>)> = Vec::new();
    for repeat in 0..repeats.max(1) {
        copies.push(timed(|| copy(&source, &mut target)));
        cycles.push(timed(|| cycle.apply(&input, &mut output)));
        let mut rhs = cycle.rhs.clone();
        let mut at = 0;
        for (number, level) in cycle.levels.iter_mut().enumerate() {
            let mut x = rhs.clone();
            for (name, step, bytes) in steps(level) {
                let seconds = timed(|| step(level, &rhs, &mut x));
                if repeat == 0 {
                    kernels.push((number, name, bytes, Vec::new()));
                }
                kernels[at].3.push(seconds);
                at += 1;
            }
            rhs = level.coarse_rhs.clone();
        }
    }
    let coarsest = cycle.levels.len();
    let mut kernels: Vec<KernelTraffic> = kernels
        .into_iter()
        .map(|(below, kernel, bytes, seconds)| {
            let (level, seconds) = (coarsest - below, median(seconds));
            KernelTraffic { level, kernel, bytes, seconds }
        })
        .collect();
    kernels.sort_by_key(|kernel| kernel.level);
    let bytes =
        kernels.iter().map(|kernel| kernel.bytes).sum::<usize>() + rounding_bytes::<E>(unknowns);
    Traffic {
        copy_bandwidth: (2 * size_of_val(&*source)) as f64 / median(copies),
        cycle: KernelTraffic { level: 0, kernel: "cycle", bytes, seconds: median(cycles) },
        kernels,
    }
}

/// The kernels of a level in the order of a cycle, with the bytes that each moves. A
/// residual that sweeps leave is no kernel.
fn steps<E: Entry>(level: &Level<E>) -> Vec<(&'static str, Step<E>, usize)> {
    let vector = level.prolongation.rows() * size_of::<E::Nodal>();
    let coarse = size_of_val(&*level.coarse_rhs);
    let [before, residual, after] = level.smoothing.cycle_bytes(level.before, level.after);
    let mut steps: Vec<(&'static str, Step<E>, usize)> =
        vec![("smoothing before", |l, b, x| l.smooth_before(b, x, true), before)];
    if residual > 0 {
        steps.push(("residual", |l, b, x| l.compute_residual(b, x), residual));
    }
    let restriction = level.restriction.bytes() + vector + coarse;
    let prolongation = level.prolongation.bytes() + coarse + 2 * vector;
    steps.extend([
        ("restriction", (|l, _, _| l.restrict_residual()) as Step<E>, restriction),
        ("prolongation", |l, _, x| l.correct(x), prolongation),
        ("smoothing after", |l, b, x| l.smooth_after(b, x), after),
    ]);
    steps
}

/// The bytes that a cycle moves which visits level k `visits(k)` times, its input and
/// output included.
pub(crate) fn cycle_bytes<E: Entry>(
    levels: &[Level<E>],
    unknowns: usize,
    visits: impl Fn(usize) -> usize,
) -> usize {
    let kernels = |level: &Level<E>| steps(level).iter().map(|(.., bytes)| bytes).sum::<usize>();
    let levels = levels.iter().enumerate().map(|(k, level)| visits(k) * kernels(level));
    levels.sum::<usize>() + rounding_bytes::<E>(unknowns)
}

/// The bytes of input and output: double precision outside, the cycle's own within.
fn rounding_bytes<E: Entry>(unknowns: usize) -> usize {
    2 * unknowns * (size_of::<f64>() + size_of::<E::Real>())
}

fn copy(source: &[f64], target: &mut [f64]) {
    const PIECE: usize = 1 << 16;
    let pieces = target.par_chunks_mut(PIECE).zip(source.par_chunks(PIECE));
    pieces.for_each(|(target, source)| target.copy_from_slice(source));
}

fn timed(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64()
}

fn median(mut seconds: Vec<f64>) -> f64 {
    seconds.sort_by(f64::total_cmp);
    seconds[seconds.len() / 2]
}

impl fmt::Display for Traffic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{:>5}  {:<16}  {:>10}  {:>9}  {:>6}  {:>7}",
            "level", "kernel", "MB", "ms", "GB/s", "of copy"
        )?;
        for kernel in self.kernels.iter().chain([&self.cycle]) {
            let level = if std::ptr::eq(kernel, &self.cycle) {
                "all".into()
            } else {
                kernel.level.to_string()
            };
            writeln!(
                f,
                "{level:>5}  {:<16}  {:>10.3}  {:>9.3}  {:>6.1}  {:>6.0}%",
                kernel.kernel,
                kernel.bytes as f64 / 1e6,
                kernel.seconds * 1e3,
                kernel.bandwidth() / 1e9,
                100.0 * kernel.bandwidth() / self.copy_bandwidth,
            )?;
        }
        write!(f, "copying memory: {:.1} GB/s, read and written", self.copy_bandwidth / 1e9)
    }
}

//! Bytes, seconds and bandwidth of each kernel of a cycle, as the report tells them.

use octruss_solver::{KernelTraffic, Traffic};
use serde::{Deserialize, Serialize};

use crate::null::null_as_nan;

/// Where the time of a cycle goes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TrafficFigures {
    /// Bytes a second of copying memory in the same run, read and written ones
    /// counted.
    #[serde(deserialize_with = "null_as_nan")]
    pub copy_bytes_per_second: f64,
    /// A whole V-cycle.
    pub cycle: KernelFigures,
    /// Each kernel on each level.
    pub kernels: Vec<KernelFigures>,
}

/// One kernel on one level.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct KernelFigures {
    /// By which expectations call it, such as `level-0-residual`.
    pub name: String,
    /// The level, 0 the finest; none of a whole cycle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub level: Option<usize>,
    /// What it does.
    pub kernel: String,
    /// What it must read and write, from the sizes of its arrays, each once.
    pub bytes: usize,
    /// The median time of one run.
    #[serde(deserialize_with = "null_as_nan")]
    pub seconds: f64,
    /// Those over these; levels that fit a cache exceed what memory can do.
    #[serde(deserialize_with = "null_as_nan")]
    pub bytes_per_second: f64,
    /// As a share of that of copying memory.
    #[serde(deserialize_with = "null_as_nan")]
    pub copy_fraction: f64,
}

impl From<Traffic> for TrafficFigures {
    fn from(traffic: Traffic) -> Self {
        let copy = traffic.copy_bandwidth;
        // Without sweeps on one side of the correction there is no such kernel.
        let mut kernels: Vec<_> = traffic.kernels.iter().filter(|k| k.bytes > 0).collect();
        // The names of the report count from the finest down.
        kernels.sort_by_key(|kernel| std::cmp::Reverse(kernel.level));
        let finest = kernels.first().map_or(0, |kernel| kernel.level);
        let below = |kernel: &KernelTraffic| Some(finest - kernel.level);
        Self {
            copy_bytes_per_second: copy,
            cycle: KernelFigures::new(&traffic.cycle, None, copy),
            kernels: kernels
                .into_iter()
                .map(|kernel| KernelFigures::new(kernel, below(kernel), copy))
                .collect(),
        }
    }
}

impl KernelFigures {
    fn new(traffic: &KernelTraffic, level: Option<usize>, copy: f64) -> Self {
        let &KernelTraffic { kernel, bytes, seconds, .. } = traffic;
        let name = match level {
            Some(level) => format!("level-{level}-{}", kernel.replace(' ', "-")),
            None => kernel.into(),
        };
        let bytes_per_second = traffic.bandwidth();
        let copy_fraction = bytes_per_second / copy;
        Self { name, level, kernel: kernel.into(), bytes, seconds, bytes_per_second, copy_fraction }
    }
}

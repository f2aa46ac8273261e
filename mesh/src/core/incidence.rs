//! Short lists for a few of many keys.

use rayon::prelude::*;

/// Short lists for a few of many keys: strata below the solid are small.
#[derive(Debug, Clone)]
pub(crate) struct Incidence {
    keys: Vec<u32>,
    offsets: Vec<u32>,
    values: Vec<u32>,
}

impl Incidence {
    /// Groups (key, value) pairs; values ascending, without duplicates.
    pub fn new(mut pairs: Vec<[u32; 2]>) -> Self {
        pairs.par_sort_unstable();
        pairs.dedup();
        let mut keys = Vec::new();
        let mut offsets = Vec::new();
        for (at, pair) in pairs.iter().enumerate() {
            if keys.last() != Some(&pair[0]) {
                keys.push(pair[0]);
                offsets.push(at as u32);
            }
        }
        offsets.push(pairs.len() as u32);
        Self { keys, offsets, values: pairs.into_iter().map(|pair| pair[1]).collect() }
    }

    /// Both directions of each pair.
    pub fn symmetric(pairs: impl Iterator<Item = [u32; 2]>) -> Self {
        Self::new(pairs.flat_map(|[a, b]| [[a, b], [b, a]]).collect())
    }

    /// The lists of these keys, numbered by their places; values renamed, not made fewer.
    pub fn picked(&self, keys: &[u32], rename: impl Fn(u32) -> u32) -> Self {
        let mut picked = Self { keys: Vec::new(), offsets: vec![0], values: Vec::new() };
        let lists = (0u32..).zip(keys).map(|(at, &key)| (at, self.of(key)));
        for (at, list) in lists.filter(|(_, list)| !list.is_empty()) {
            picked.keys.push(at);
            let start = picked.values.len();
            picked.values.extend(list.iter().map(|&value| rename(value)));
            picked.values[start..].sort_unstable();
            picked.offsets.push(picked.values.len() as u32);
        }
        picked
    }

    /// Keeps the lists of some keys.
    pub fn retain(&mut self, is_kept: impl Fn(u32) -> bool) {
        let keys: Vec<u32> = self.keys().filter(|&key| is_kept(key)).collect();
        *self = Self { keys: keys.clone(), ..self.picked(&keys, |value| value) };
    }

    pub fn keys(&self) -> impl Iterator<Item = u32> {
        self.keys.iter().copied()
    }

    pub fn of(&self, key: u32) -> &[u32] {
        match self.keys.binary_search(&key) {
            Ok(at) => &self.values[self.offsets[at] as usize..self.offsets[at + 1] as usize],
            Err(_) => &[],
        }
    }
}

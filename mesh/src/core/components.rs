//! The parts that a mesh consists of.

use rayon::prelude::*;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use crate::core::raw_mesh::RawMesh;
use octruss_base::large_array::zeroed;
use octruss_base::ragged::CHUNK;

/// For each vertex the lowest vertex number of its part, where tets that share
/// a vertex belong together. A vertex of no tet is a part of its own. Vertex
/// numbers must be in range.
pub fn part_of_vertices(raw: &RawMesh) -> Vec<u32> {
    let joined = Joined::new(raw.points.len());
    raw.tets.par_iter().with_min_len(CHUNK).for_each(|&[first, rest @ ..]| {
        // Vertices that ever hung on the same one are of one part, whatever others have
        // tied since; once a part has mostly formed, little is left to join.
        let common = joined.parent(first);
        let others = rest.into_iter().filter(|v| joined.parent(*v) != common);
        others.for_each(|v| joined.join(first, v));
    });
    joined.lowest()
}

/// Numbers that are joined in parallel (after Anderson and Woll 1991): only a root is ever
/// tied to another number, and only to a lower one, so in the end every part hangs on its
/// lowest number, in whatever order threads join.
pub(crate) struct Joined {
    parents: Vec<AtomicU32>,
}

impl Joined {
    /// Each number below `count` by itself.
    pub(crate) fn new(count: usize) -> Self {
        Self { parents: (0..count as u32).map(AtomicU32::new).collect() }
    }

    fn parent(&self, number: u32) -> u32 {
        self.parents[number as usize].load(Relaxed)
    }

    /// Makes one part of those of `a` and `b`.
    pub(crate) fn join(&self, a: u32, b: u32) {
        let (mut a, mut b) = (a, b);
        loop {
            (a, b) = (self.root(a), self.root(b));
            let (low, high) = (a.min(b), a.max(b));
            // Fails if another thread has tied the higher root in the meantime.
            if low == high
                || self.parents[high as usize].compare_exchange(high, low, Relaxed, Relaxed).is_ok()
            {
                return;
            }
        }
    }

    /// The representative of a number's part; paths are halved on the way.
    fn root(&self, mut number: u32) -> u32 {
        loop {
            let parent = self.parent(number);
            if parent == number {
                return number;
            }
            let next = self.parent(parent);
            if next != parent {
                self.parents[number as usize].store(next, Relaxed);
            }
            number = next;
        }
    }

    /// The lowest number of each one's part.
    pub(crate) fn lowest(&self) -> Vec<u32> {
        let mut roots = zeroed(self.parents.len());
        let numbered = roots.par_iter_mut().with_min_len(CHUNK).zip(0..self.parents.len() as u32);
        numbered.for_each(|(slot, number)| *slot = self.root(number));
        roots
    }
}

/// The first tet of each part, in order.
pub fn first_tets(raw: &RawMesh) -> Vec<u32> {
    let parts = part_of_vertices(raw);
    let mut seen = vec![false; raw.points.len()];
    let mut first = Vec::new();
    for (t, tet) in (0u32..).zip(&raw.tets) {
        let part = parts[tet[0] as usize] as usize;
        if !std::mem::replace(&mut seen[part], true) {
            first.push(t);
        }
    }
    first
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::shapes::five_tet_cube;

    #[test]
    fn a_second_cube_is_a_second_part() {
        let mut raw = five_tet_cube().into_raw();
        let shifted: Vec<_> = raw.points.iter().map(|p| p.map(|x| x + 5.0)).collect();
        raw.points.extend(shifted);
        raw.tets.extend(five_tet_cube().tets().iter().map(|tet| tet.map(|v| v + 8)));
        raw.points.push([9.0; 3]);
        let parts = part_of_vertices(&raw);
        assert_eq!(parts, [[0; 8].as_slice(), &[8; 8], &[16]].concat());
        assert_eq!(first_tets(&raw), [0, 5]);
    }

    #[test]
    fn parts_of_many_tets_hang_on_their_lowest_vertices_for_any_number_of_threads() {
        // Three interleaved chains of tets, numbered against their order.
        let count = 30_000;
        let mut raw = five_tet_cube().into_raw();
        raw.points = vec![[0.0; 3]; 3 * count + 9];
        let vertex = |chain: usize, k: usize| (3 * (count - k) + chain) as u32;
        raw.tets = (0..3 * (count - 3))
            .map(|t| std::array::from_fn(|i| vertex(t % 3, t / 3 + i)))
            .collect();
        for threads in [1, 2, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let parts = pool.install(|| part_of_vertices(&raw));
            let used = 3..vertex(0, 0);
            // The last tets reach down to vertex 3.
            assert!(used.clone().all(|v| parts[v as usize] == 3 + v % 3), "{threads}");
            assert_eq!(parts[1], 1);
        }
    }
}

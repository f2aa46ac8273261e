//! Which coarse simplex each fine one is a part of.

use std::ops::Range;

use octruss_base::large_array::zeroed;
use octruss_base::ragged::CHUNK;
use rayon::prelude::*;

/// For each simplex of a finer list the one of a coarser list that it is a part
/// of. The parts of a simplex follow one another, in the order of their wholes,
/// and each has at least one: itself, if it was not split.
///
/// ```
/// use octruss_mesh::Lineage;
/// // The first of two tets was bisected.
/// let lineage = Lineage::listed(vec![0, 0, 1]);
/// assert_eq!(lineage.children(0), 0..2);
/// assert_eq!(lineage.inherit(&[7, 8], 1), [7, 7, 8]);
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Lineage(Parts);

#[derive(Debug, Clone, PartialEq, Eq)]
enum Parts {
    /// Each of so many parents has the same number of parts: nothing is stored.
    Uniform { parents: usize, parts: usize },
    /// The parent of each part, ascending.
    Listed(Vec<u32>),
}

impl Lineage {
    /// Every one of `parents` simplices has the same number of parts.
    ///
    /// # Panics
    /// If `parts` is 0.
    pub fn uniform(parents: usize, parts: usize) -> Self {
        assert!(parts > 0, "a simplex has at least one part");
        Self(Parts::Uniform { parents, parts })
    }

    /// The parent of each fine simplex.
    ///
    /// # Panics
    /// If the parents do not ascend from 0 without gaps.
    pub fn listed(parents: Vec<u32>) -> Self {
        let ascend = parents.windows(2).all(|pair| pair[1] == pair[0] || pair[1] == pair[0] + 1);
        let from_zero = parents.first().is_none_or(|&first| first == 0);
        assert!(ascend && from_zero, "the parts of simplices follow one another");
        Self(Parts::Listed(parents))
    }

    /// How many coarse simplices there are.
    pub fn coarse_count(&self) -> usize {
        match &self.0 {
            Parts::Uniform { parents, .. } => *parents,
            Parts::Listed(parents) => parents.last().map_or(0, |&last| last as usize + 1),
        }
    }

    /// How many fine simplices there are.
    pub fn fine_count(&self) -> usize {
        match &self.0 {
            Parts::Uniform { parents, parts } => parents * parts,
            Parts::Listed(parents) => parents.len(),
        }
    }

    /// The coarse simplex that a fine one is a part of.
    ///
    /// # Panics
    /// If there is no such fine simplex.
    pub fn parent(&self, child: u32) -> u32 {
        assert!((child as usize) < self.fine_count(), "no fine simplex {child}");
        match &self.0 {
            Parts::Uniform { parts, .. } => (child as usize / parts) as u32,
            Parts::Listed(parents) => parents[child as usize],
        }
    }

    /// The parts of a coarse simplex.
    ///
    /// # Panics
    /// If there is no such coarse simplex.
    pub fn children(&self, parent: u32) -> Range<u32> {
        assert!((parent as usize) < self.coarse_count(), "no coarse simplex {parent}");
        match &self.0 {
            Parts::Uniform { parts, .. } => {
                let start = parts * parent as usize;
                start as u32..(start + parts) as u32
            }
            Parts::Listed(parents) => {
                let start = parents.partition_point(|&other| other < parent);
                let count = parents[start..].partition_point(|&other| other == parent);
                start as u32..(start + count) as u32
            }
        }
    }

    /// What each fine simplex has from its parent: `components` values each,
    /// tuple after tuple.
    ///
    /// # Panics
    /// If `values` does not have `components` values for each coarse simplex.
    pub fn inherit<T>(&self, values: &[T], components: usize) -> Vec<T>
    where
        T: Copy + Default + Send + Sync,
    {
        assert_eq!(values.len(), components * self.coarse_count(), "one tuple a coarse simplex");
        let mut fine = zeroed(components * self.fine_count());
        if components == 0 {
            return fine;
        }
        match &self.0 {
            Parts::Uniform { parts, .. } => {
                let some = values.par_chunks(CHUNK * components);
                let theirs = fine.par_chunks_mut(CHUNK * components * parts);
                some.zip(theirs).for_each(|(values, fine)| repeat(values, components, fine));
            }
            Parts::Listed(parents) => {
                let tuples = fine.par_chunks_mut(components).with_min_len(CHUNK);
                let from = |parent: u32| &values[components * parent as usize..][..components];
                tuples.zip(parents).for_each(|(own, &parent)| own.copy_from_slice(from(parent)));
            }
        }
        fine
    }
}

/// Repeats each tuple, equally often, until `fine` is full.
fn repeat<T: Copy>(values: &[T], components: usize, fine: &mut [T]) {
    let families = fine.chunks_exact_mut(fine.len() / values.len() * components);
    if components == 1 {
        // By far the most frequent, and several times as fast.
        families.zip(values).for_each(|(family, value)| family.fill(*value));
        return;
    }
    for (family, tuple) in families.zip(values.chunks_exact(components)) {
        family.chunks_exact_mut(components).for_each(|own| own.copy_from_slice(tuple));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_uniform_lineage_is_that_which_lists_its_parents() {
        // The last takes several chunks.
        for (parents, parts) in [(0, 3), (1, 1), (5, 1), (4, 2), (3, 8), (2500, 3)] {
            let list = (0..parents * parts).map(|child| (child / parts) as u32).collect();
            let (uniform, listed) = (Lineage::uniform(parents, parts), Lineage::listed(list));
            for lineage in [&uniform, &listed] {
                assert_eq!(lineage.coarse_count(), parents);
                assert_eq!(lineage.fine_count(), parents * parts);
                for parent in 0..parents as u32 {
                    let mut children = lineage.children(parent);
                    assert_eq!(children.len(), parts);
                    assert!(children.all(|child| lineage.parent(child) == parent));
                }
            }
            for components in 0..4 {
                let values: Vec<i64> = (0..(parents * components) as i64).collect();
                let inherited = uniform.inherit(&values, components);
                assert_eq!(inherited, listed.inherit(&values, components));
                let tuples = values.chunks(components.max(1));
                let slow: Vec<i64> = tuples.flat_map(|tuple| tuple.repeat(parts)).collect();
                assert_eq!(inherited, slow);
            }
        }
    }

    #[test]
    fn parts_of_different_number_are_told_apart() {
        let lineage = Lineage::listed(vec![0, 1, 1, 1, 2, 3, 3]);
        let children = [0..1, 1..4, 4..5, 5..7];
        assert_eq!([0, 1, 2, 3].map(|parent| lineage.children(parent)), children);
        assert_eq!(lineage.inherit(&[9, 8, 7, 6], 1), [9, 8, 8, 8, 7, 6, 6]);
    }

    #[test]
    #[should_panic(expected = "follow one another")]
    fn a_simplex_without_parts_is_refused() {
        Lineage::listed(vec![0, 2]);
    }
}

//! From the tags of a file, which may be sparse and in any order, to indices.

/// A map from tag to index.
#[derive(Debug)]
pub enum TagMap {
    /// Tags close together: a table from `tag - first`.
    Dense {
        /// The smallest tag.
        first: u64,
        /// The index of each tag, or [`ABSENT`].
        indices: Vec<u32>,
    },
    /// Tags far apart: pairs of tag and index, sorted.
    Sparse(Vec<(u64, u32)>),
}

const ABSENT: u32 = u32::MAX;

impl TagMap {
    /// Maps `tags[i]` to i. Of a tag that occurs twice the first place counts;
    /// the second place is returned beside the map.
    pub fn new(tags: &[u64]) -> (Self, Option<usize>) {
        let first = tags.iter().copied().min().unwrap_or(0);
        let last = tags.iter().copied().max().unwrap_or(0);
        let most = 4 * tags.len() as u64 + 1024;
        if last - first < most { Self::dense(tags, first, last) } else { Self::sparse(tags) }
    }

    fn dense(tags: &[u64], first: u64, last: u64) -> (Self, Option<usize>) {
        let mut indices = vec![ABSENT; (last - first) as usize + 1];
        let mut twice = None;
        for (index, &tag) in tags.iter().enumerate() {
            let entry = &mut indices[(tag - first) as usize];
            if *entry == ABSENT {
                *entry = index as u32;
            } else {
                twice = twice.or(Some(index));
            }
        }
        (Self::Dense { first, indices }, twice)
    }

    fn sparse(tags: &[u64]) -> (Self, Option<usize>) {
        let mut pairs: Vec<(u64, u32)> =
            tags.iter().enumerate().map(|(index, &tag)| (tag, index as u32)).collect();
        pairs.sort_unstable();
        let second = |pair: &[(u64, u32)]| (pair[0].0 == pair[1].0).then_some(pair[1].1 as usize);
        let twice = pairs.windows(2).filter_map(second).min();
        pairs.dedup_by_key(|pair| pair.0);
        (Self::Sparse(pairs), twice)
    }

    /// The index of a tag.
    #[inline]
    pub fn index(&self, tag: u64) -> Option<u32> {
        match self {
            Self::Dense { first, indices } => {
                let offset = usize::try_from(tag.checked_sub(*first)?).ok()?;
                indices.get(offset).copied().filter(|&index| index != ABSENT)
            }
            Self::Sparse(pairs) => {
                let at = pairs.binary_search_by_key(&tag, |pair| pair.0).ok()?;
                Some(pairs[at].1)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_forms_find_each_tag_and_the_second_of_two() {
        for spread in [1, 1_000_000_007] {
            let tags = [9, 4, 7, 4, 8].map(|tag| tag * spread);
            let (map, twice) = TagMap::new(&tags);
            assert_eq!(matches!(map, TagMap::Dense { .. }), spread == 1);
            assert_eq!(twice, Some(3));
            let found = [4, 5, 7, 8, 9, 10].map(|tag| map.index(tag * spread));
            assert_eq!(found, [Some(1), None, Some(2), Some(4), Some(0), None]);
            assert_eq!(map.index(u64::MAX), None);
        }
    }

    #[test]
    fn no_tags_and_the_largest() {
        assert_eq!(TagMap::new(&[]).0.index(0), None);
        assert_eq!(TagMap::new(&[0, u64::MAX]).0.index(u64::MAX), Some(1));
    }
}

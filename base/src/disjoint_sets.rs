//! Sets that are joined until what belongs together is one.

/// The numbers from 0 on, each in exactly one set. For a few joins in one thread; the
/// sets are the same whatever the order.
#[derive(Debug, Clone)]
pub struct DisjointSets {
    /// A lower member of the same set; the lowest has itself.
    lower: Vec<u32>,
}

impl DisjointSets {
    /// Each of the numbers below `count` by itself.
    pub fn new(count: usize) -> Self {
        Self { lower: (0..count as u32).collect() }
    }

    /// The lowest member of the set of `member`.
    pub fn lowest(&mut self, mut member: u32) -> u32 {
        while self.lower[member as usize] != member {
            let next = self.lower[member as usize];
            self.lower[member as usize] = self.lower[next as usize];
            member = next;
        }
        member
    }

    /// Makes one set of those of `a` and `b`.
    pub fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.lowest(a), self.lowest(b));
        self.lower[a.max(b) as usize] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_joined_in_any_order_has_one_lowest_member() {
        let mut sets = DisjointSets::new(7);
        [(5, 6), (2, 3), (6, 2), (0, 4)].into_iter().for_each(|(a, b)| sets.join(a, b));
        let lowest: Vec<u32> = (0..7).map(|member| sets.lowest(member)).collect();
        assert_eq!(lowest, [0, 1, 2, 2, 0, 2, 2]);
    }
}

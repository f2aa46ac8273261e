//! The points that the parts of a mesh use, numbered anew.

/// Some of a mesh's points, for a file of a part of it.
pub(super) struct OwnPoints {
    /// Which points of the mesh they are, ascending.
    pub(super) kept: Vec<usize>,
}

impl OwnPoints {
    /// Those among `points` points that are used. The error is a number beyond.
    pub(super) fn used(
        vertices: impl Iterator<Item = u32>,
        points: usize,
        what: &str,
    ) -> Result<Self, String> {
        let mut kept: Vec<usize> = vertices.map(|vertex| vertex as usize).collect();
        kept.sort_unstable();
        kept.dedup();
        match kept.last() {
            Some(&last) if last >= points => {
                Err(format!("{what} has the vertex {last}, but there are {points}"))
            }
            _ => Ok(Self { kept }),
        }
    }

    /// Simplices by the new numbers.
    pub(super) fn renumber<'a, const N: usize>(
        &self,
        simplices: impl Iterator<Item = &'a [u32; N]>,
    ) -> Vec<[u32; N]> {
        let end = self.kept.last().map_or(0, |last| last + 1);
        let mut numbers = vec![0; end];
        for (number, &vertex) in (0u32..).zip(&self.kept) {
            numbers[vertex] = number;
        }
        simplices.map(|simplex| simplex.map(|v| numbers[v as usize])).collect()
    }

    /// The positions.
    pub(super) fn of(&self, points: &[[f64; 3]]) -> Vec<[f64; 3]> {
        self.kept.iter().map(|&vertex| points[vertex]).collect()
    }
}

//! Rows of a matrix by colours: rows of one colour are not coupled.

use crate::sparse::csr::Csr;

/// The rows of each colour, ascending.
pub(crate) struct Colouring {
    colours: Vec<Vec<u32>>,
}

impl Colouring {
    /// Each row in turn gets the first colour that no neighbour has. The pattern
    /// must be symmetric.
    pub(crate) fn greedy<E: Copy>(matrix: &Csr<E>) -> Self {
        const NONE: usize = usize::MAX;
        let mut colour_of = vec![NONE; matrix.rows()];
        let mut colours: Vec<Vec<u32>> = Vec::new();
        // For each colour the last row that has a neighbour of it.
        let mut seen_at = Vec::new();
        for i in 0..matrix.rows() {
            for &j in matrix.row(i).0 {
                if let Some(seen) = seen_at.get_mut(colour_of[j as usize]) {
                    *seen = i;
                }
            }
            let free = seen_at.iter().position(|seen| *seen != i).unwrap_or(colours.len());
            if free == colours.len() {
                colours.push(Vec::new());
                seen_at.push(NONE);
            }
            colour_of[i] = free;
            colours[free].push(i as u32);
        }
        Self { colours }
    }

    /// The rows of each colour.
    pub(crate) fn rows(&self) -> impl DoubleEndedIterator<Item = &[u32]> {
        self.colours.iter().map(Vec::as_slice)
    }

    /// The rows of the most frequent colour.
    pub(crate) fn largest(&self) -> usize {
        self.colours.iter().map(Vec::len).max().unwrap_or(0)
    }

    pub(crate) fn bytes(&self) -> usize {
        self.colours.iter().map(|rows| size_of_val(&**rows)).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::toy::second_difference;

    #[test]
    fn a_chain_takes_two_colours() {
        let colouring = Colouring::greedy(&second_difference(5));
        let rows: Vec<&[u32]> = colouring.rows().collect();
        assert_eq!(rows, [&[0, 2, 4][..], &[1, 3]]);
        assert_eq!((colouring.largest(), colouring.bytes()), (3, 20));
    }
}

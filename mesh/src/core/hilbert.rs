//! A number for each point along a space-filling curve.
//!
//! Hilbert's curve visits every cell of a grid, each next to the one before;
//! points with close numbers are close in space. Morton's order is as cheap and
//! jumps across the grid at every power of two.

use rayon::prelude::*;

/// Bits a coordinate; three of them fill 63 bits.
const BITS: u32 = 21;

/// The place of each point on the curve through the cube round all of them.
///
/// Coordinates must be finite. The same number for points closer than about
/// 2⁻²¹ of the cube's side.
pub(crate) fn places(points: &[[f64; 3]]) -> Vec<u64> {
    // Halved, so that no difference overflows.
    let halves = |p: [f64; 3]| p.map(|x| 0.5 * x);
    let mut low = [f64::INFINITY; 3];
    let mut high = [f64::NEG_INFINITY; 3];
    for point in points.iter().copied().map(halves) {
        for k in 0..3 {
            low[k] = low[k].min(point[k]);
            high[k] = high[k].max(point[k]);
        }
    }
    // One scale for all directions: the cells are cubes.
    let side = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
    let cells = f64::from((1u32 << BITS) - 1);
    let place = |&point: &[f64; 3]| {
        let point = halves(point);
        // A cast saturates, and makes 0 of the 0 / 0 of coinciding points.
        place(std::array::from_fn(|k| ((point[k] - low[k]) / side * cells) as u32), BITS)
    };
    points.par_iter().map(place).collect()
}

/// The place of a cell on the curve through a grid of 2^`bits` cells a
/// direction: the transposed index of [Skilling 2004], its bits in a row.
///
/// [Skilling 2004]: https://doi.org/10.1063/1.1751381
fn place(mut cell: [u32; 3], bits: u32) -> u64 {
    let powers = || (1..bits).rev().map(|bit| 1u32 << bit);
    for power in powers() {
        let below = power - 1;
        for k in 0..3 {
            if cell[k] & power != 0 {
                cell[0] ^= below;
            } else {
                let swapped = (cell[0] ^ cell[k]) & below;
                cell[0] ^= swapped;
                cell[k] ^= swapped;
            }
        }
    }
    cell[1] ^= cell[0];
    cell[2] ^= cell[1];
    let flipped = powers()
        .filter(|power| cell[2] & power != 0)
        .fold(0, |flipped, power| flipped ^ (power - 1));
    let digit = |bit: u32| {
        cell.iter().fold(0, |digit, &index| digit << 1 | u64::from((index ^ flipped) >> bit & 1))
    };
    (0..bits).rev().fold(0, |place, bit| place << 3 | digit(bit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_visits_every_cell_and_each_next_to_the_one_before() {
        for bits in 1..=4 {
            let n = 1u32 << bits;
            let mut cells: Vec<[u32; 3]> = Vec::new();
            for i in 0..n {
                cells.extend((0..n * n).map(|jk| [i, jk / n, jk % n]));
            }
            cells.sort_by_key(|&cell| place(cell, bits));
            for (at, &cell) in cells.iter().enumerate() {
                assert_eq!(place(cell, bits), at as u64);
            }
            for pair in cells.windows(2) {
                let steps: u32 = (0..3).map(|k| pair[0][k].abs_diff(pair[1][k])).sum();
                assert_eq!(steps, 1, "{pair:?}");
            }
        }
    }

    #[test]
    fn coinciding_and_enormous_coordinates_have_places() {
        assert_eq!(places(&[]), []);
        assert_eq!(places(&[[3.0; 3]; 2]), [0, 0]);
        let far = places(&[[f64::MAX; 3], [-f64::MAX; 3], [0.0; 3]]);
        assert!(far[1] == 0 && far[0] != far[2] && far[2] != 0, "{far:?}");
    }
}

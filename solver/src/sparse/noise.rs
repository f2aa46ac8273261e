//! Reproducible noise: start vectors whose bits depend on the seed alone.

use octruss_base::chunks::for_chunks;
use octruss_base::large_array::zeroed;

/// `n` numbers spread evenly over [−1, 1), entry i being a hash of (seed, i)
/// by the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
pub fn noise(n: usize, seed: u64) -> Vec<f64> {
    let number = |i: u64| {
        let mut z = seed.wrapping_add((i + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15));
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        // The top 53 bits fill the mantissa of a number in [0, 2).
        (z >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    let mut numbers = zeroed(n);
    for_chunks(&mut numbers, |first, chunk| {
        (first as u64..).zip(chunk).for_each(|(i, slot)| *slot = number(i));
    });
    numbers
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_numbers_are_those_of_splitmix64() {
        // SplitMix64 with seed 0 begins with 0xE220A8397B1DCDAF.
        let first = (0xE220_A839_7B1D_CDAF_u64 >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
        assert_eq!(noise(1, 0)[0], first);
        assert!(noise(1000, 7).iter().sum::<f64>().abs() < 60.0, "mean near zero");
    }
}

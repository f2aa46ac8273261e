//! Quadrature rules on tets and triangles: barycentric points, weights that sum
//! to one (multiply by volume or area).

/// A rule on a tet: points and weights.
pub type TetRule = &'static [([f64; 4], f64)];

/// Exact for polynomials of degree 2: four points (5 ± √5 …)/20 on the medians.
pub const DEGREE_2: TetRule = {
    const A: f64 = 0.585_410_196_624_968_5;
    const B: f64 = 0.138_196_601_125_010_5;
    &[([A, B, B, B], 0.25), ([B, A, B, B], 0.25), ([B, B, A, B], 0.25), ([B, B, B, A], 0.25)]
};

/// Exact for polynomials of degree 5: the 14 points of Walkington, "Quadrature
/// on simplices of arbitrary dimension" (2000); all weights positive.
pub const DEGREE_5: TetRule = {
    const A: f64 = 0.310_885_919_263_300_6;
    const B: f64 = 0.067_342_242_210_098_2;
    const U: f64 = 0.112_687_925_718_015_85;
    const C: f64 = 0.092_735_250_310_891_23;
    const D: f64 = 0.721_794_249_067_326_3;
    const V: f64 = 0.073_493_043_116_361_95;
    const E: f64 = 0.045_503_704_125_649_65;
    const F: f64 = 0.454_496_295_874_350_35;
    const W: f64 = 0.042_546_020_777_081_47;
    &[
        ([B, A, A, A], U),
        ([A, B, A, A], U),
        ([A, A, B, A], U),
        ([A, A, A, B], U),
        ([D, C, C, C], V),
        ([C, D, C, C], V),
        ([C, C, D, C], V),
        ([C, C, C, D], V),
        ([E, E, F, F], W),
        ([E, F, E, F], W),
        ([E, F, F, E], W),
        ([F, E, E, F], W),
        ([F, E, F, E], W),
        ([F, F, E, E], W),
    ]
};

/// Exact for polynomials of degree 2 on a triangle: the midpoints of its edges.
pub const TRIANGLE_DEGREE_2: &[([f64; 3], f64)] = {
    const W: f64 = 1.0 / 3.0;
    &[([0.5, 0.5, 0.0], W), ([0.0, 0.5, 0.5], W), ([0.5, 0.0, 0.5], W)]
};

/// The position with these barycentric coordinates.
#[inline]
pub fn position<const N: usize>(corners: &[[f64; 3]; N], barycentric: &[f64; N]) -> [f64; 3] {
    std::array::from_fn(|k| (0..N).map(|i| barycentric[i] * corners[i][k]).sum())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn factorial(n: i32) -> f64 {
        (1..=n).map(f64::from).product()
    }

    /// On the unit tet, ∫ xᵃ yᵇ zᶜ = a! b! c! / (a + b + c + 3)!, volume 1/6.
    fn worst_error(rule: TetRule, degree: i32) -> f64 {
        let mut worst: f64 = 0.0;
        for a in 0..=degree {
            for b in 0..=degree - a {
                for c in 0..=degree - a - b {
                    let exact =
                        factorial(a) * factorial(b) * factorial(c) / factorial(a + b + c + 3) * 6.0;
                    let value: f64 = rule
                        .iter()
                        .map(|(l, w)| w * l[1].powi(a) * l[2].powi(b) * l[3].powi(c))
                        .sum();
                    worst = worst.max((value - exact).abs());
                }
            }
        }
        worst
    }

    #[test]
    fn the_rules_are_exact_to_their_degree_and_no_further() {
        assert!(worst_error(DEGREE_2, 2) < 1e-15);
        assert!(worst_error(DEGREE_2, 3) > 1e-4);
        assert!(worst_error(DEGREE_5, 5) < 1e-15);
        assert!(worst_error(DEGREE_5, 6) > 1e-6);
    }
}

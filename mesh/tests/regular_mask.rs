//! On the Kuhn lattice the box-spline rules are the box spline's mask, exactly.

use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, shapes};

/// The product of polynomials in z1, z2, z3 over exponents 0 to 4.
type Polynomial = [[[f64; 5]; 5]; 5];

/// Multiplies by 1 + z^shift.
fn times_one_plus(polynomial: &Polynomial, shift: [usize; 3]) -> Polynomial {
    let mut product = *polynomial;
    for i in shift[0]..5 {
        for j in shift[1]..5 {
            for k in shift[2]..5 {
                product[i][j][k] += polynomial[i - shift[0]][j - shift[1]][k - shift[2]];
            }
        }
    }
    product
}

/// (1 + z1)² (1 + z2)² (1 + z3)² (1 + z1 z2 z3)² / 32.
fn generating_function() -> Polynomial {
    let mut polynomial = [[[0.0; 5]; 5]; 5];
    polynomial[0][0][0] = 1.0 / 32.0;
    for shift in [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]] {
        polynomial = times_one_plus(&times_one_plus(&polynomial, shift), shift);
    }
    polynomial
}

#[test]
fn the_column_of_an_interior_vertex_is_the_generating_function() {
    let n = 4;
    let mut hierarchy = Hierarchy::new(shapes::kuhn_cube(n), &FeatureOptions::default());
    hierarchy.subdivide(Scheme::BoxSpline).unwrap();
    let centre =
        hierarchy.coarsest().mesh.points().iter().position(|p| *p == [0.5; 3]).unwrap() as u32;
    let mask = generating_function();
    let mut nonzeros = 0;
    for (row, point) in hierarchy.finest().mesh.points().iter().enumerate() {
        let (columns, weights) = hierarchy.refinement(0).matrix.row(row);
        let weight = columns.binary_search(&centre).map_or(0.0, |at| weights[at]);
        // Doubled lattice coordinates about the centre, shifted to exponents.
        let [i, j, k] = point.map(|x| ((x - 0.5) * 2.0 * f64::from(n)).round() as i32 + 2);
        let inside = [i, j, k].iter().all(|e| (0..5).contains(e));
        let expected = if inside { mask[i as usize][j as usize][k as usize] } else { 0.0 };
        assert_eq!(weight, expected, "at exponent ({i}, {j}, {k})");
        nonzeros += usize::from(weight != 0.0);
    }
    assert_eq!(nonzeros, 65);
}

#[test]
fn the_mask_has_its_known_coefficients() {
    // How often each coefficient, times 32, occurs; they sum to 8.
    let all: Vec<f64> =
        generating_function().as_flattened().as_flattened().iter().map(|c| 32.0 * c).collect();
    for (value, count) in [(18.0, 1), (10.0, 8), (8.0, 6), (4.0, 12), (2.0, 24), (1.0, 14)] {
        assert_eq!(all.iter().filter(|&&c| c == value).count(), count);
    }
    assert_eq!(all.iter().sum::<f64>(), 256.0);
}

#[test]
fn a_creased_kuhn_block_is_reproduced_exactly() {
    let mut levels = [Scheme::Linear, Scheme::BoxSpline].map(|scheme| {
        let mut hierarchy = Hierarchy::new(shapes::kuhn_cube(4), &FeatureOptions::default());
        hierarchy.subdivide(scheme).unwrap();
        hierarchy.subdivide(scheme).unwrap();
        hierarchy
    });
    let [linear, box_spline] = &mut levels;
    // In all but that one of them could have moved vertices.
    let [linear_mesh, box_spline_mesh] = [&*linear, &*box_spline].map(|levels| {
        let mut raw = levels.finest().mesh.clone().into_raw();
        raw.features.as_mut().unwrap().smoothed = false;
        raw
    });
    assert!(linear_mesh == box_spline_mesh);
    assert_eq!(linear.coarsest().mesh.features().unwrap().creases.len(), 12 * 4);
}

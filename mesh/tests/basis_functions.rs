//! Basis functions of the schemes and their values along lines.

use octruss_mesh::analysis::{AnalysisError, basis_function, sample_line};
use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, shapes};

/// A block of n³ unit Kuhn cells with some levels of a scheme, and its middle vertex.
fn block(n: u32, scheme: Scheme, levels: usize) -> (Hierarchy, u32) {
    let mesh = shapes::kuhn_box([n; 3], [f64::from(n); 3]);
    let middle = [f64::from(n) / 2.0; 3];
    let vertex = mesh.points().iter().position(|p| *p == middle).unwrap() as u32;
    let mut hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
    (0..levels).for_each(|_| hierarchy.subdivide(scheme).unwrap());
    (hierarchy, vertex)
}

#[test]
fn basis_functions_add_up_to_one() {
    for scheme in Scheme::ALL {
        let mut hierarchy = Hierarchy::new(shapes::five_tet_cube(), &FeatureOptions::default());
        (0..2).for_each(|_| hierarchy.subdivide(scheme).unwrap());
        let all = (0..8).map(|vertex| basis_function(&hierarchy, 0, vertex).unwrap());
        let mut sums = vec![0.0; hierarchy.finest().mesh.points().len()];
        all.for_each(|values| sums.iter_mut().zip(values).for_each(|(sum, v)| *sum += v));
        assert!(sums.iter().all(|sum| (sum - 1.0).abs() < 1e-14), "{scheme:?}");
    }
}

#[test]
fn the_box_spline_falls_to_its_limit_value() {
    // It falls from 1 to the 2/5 of the limit.
    let (hierarchy, vertex) = block(4, Scheme::BoxSpline, 3);
    // Vertices keep their numbers on finer levels.
    let at_vertex =
        |steps: usize| basis_function(&hierarchy, 3 - steps, vertex).unwrap()[vertex as usize];
    assert_eq!(at_vertex(0), 1.0);
    assert_eq!(at_vertex(1), 9.0 / 16.0);
    // (9/16)² + 1/32 · (8 · 5/16 + 6 · 1/4).
    assert!((at_vertex(2) - (81.0 / 256.0 + (2.5 + 1.5) / 32.0)).abs() < 1e-15);
    let three = at_vertex(3);
    assert!((0.4..at_vertex(2)).contains(&three), "{three}");
}

#[test]
fn the_interpolatory_function_is_one_at_its_vertex_and_zero_at_the_others() {
    let (hierarchy, vertex) = block(4, Scheme::INTERPOLATORY, 2);
    let values = basis_function(&hierarchy, 0, vertex).unwrap();
    for v in 0..hierarchy.coarsest().mesh.points().len() {
        assert_eq!(values[v], f64::from(u8::from(v == vertex as usize)));
    }
    // It overshoots: the mask has weights −1/16.
    assert!(values.iter().copied().fold(0.0, f64::min) < -0.05);
}

#[test]
fn second_differences_of_the_interpolatory_function_decay_as_known() {
    // 2^L max |second difference| along the axes of the lattice tends to 0 for a
    // continuously differentiable function; computed twice.
    for (level, expected) in [(1, 2.0), (2, 1.34375), (3, 0.77148)] {
        let (hierarchy, vertex) = block(6, Scheme::INTERPOLATORY, level);
        let values = basis_function(&hierarchy, 0, vertex).unwrap();
        let steps = 1usize << level;
        let side = 6 * steps + 1;
        let mut lattice = vec![0.0; side.pow(3)];
        let number = |p: [usize; 3]| (p[0] * side + p[1]) * side + p[2];
        for (point, value) in hierarchy.finest().mesh.points().iter().zip(values) {
            lattice[number(point.map(|x| (x * steps as f64).round() as usize))] = value;
        }
        let mut largest = 0.0f64;
        for middle in 0..side.pow(3) {
            for stride in [1, side, side * side] {
                let place = middle / stride % side;
                if (1..side - 1).contains(&place) {
                    let difference =
                        lattice[middle - stride] - 2.0 * lattice[middle] + lattice[middle + stride];
                    largest = largest.max(difference.abs());
                }
            }
        }
        let scaled = steps as f64 * largest;
        assert!((scaled - expected).abs() < 6e-6, "level {level}: {scaled}");
    }
}

#[test]
fn a_line_through_the_vertex_shows_the_hat_function() {
    let (hierarchy, vertex) = block(4, Scheme::Linear, 2);
    let values = basis_function(&hierarchy, 0, vertex).unwrap();
    let through = hierarchy.finest().mesh.points()[vertex as usize];
    let line = sample_line(&hierarchy.finest().mesh, &values, through, [0.0, 2.0, 0.0], 100);
    assert!(line.is_sorted_by(|a, b| a.distance < b.distance));
    for sample in &line {
        let expected = (1.0 - sample.distance.abs()).max(0.0);
        assert!((sample.value - expected).abs() < 1e-12, "{sample:?}");
        assert_eq!(sample.point, [2.0, 2.0 + sample.distance, 2.0]);
    }
    // The block ends at distance 2; its far corners are √12 away.
    let inside = (2.0 / 12.0f64.sqrt() * 100.0) as usize;
    assert_eq!(line.len(), 2 * inside + 1);
    assert_eq!(sample_line(&hierarchy.finest().mesh, &values, through, [0.0; 3], 9).len(), 1);
}

#[test]
fn what_does_not_exist_is_named() {
    let (hierarchy, _) = block(2, Scheme::Linear, 1);
    assert_eq!(
        basis_function(&hierarchy, 2, 0),
        Err(AnalysisError::NoLevel { level: 2, finest: 1 })
    );
    let missing = basis_function(&hierarchy, 0, 27).unwrap_err();
    assert_eq!(missing.to_string(), "there is no vertex 27: the mesh has 27, numbered from 0");
}

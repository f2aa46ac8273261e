//! The eigenvalues of appendix B of Chang's thesis, as far as they are those of
//! the rules of its chapter 4.

mod common;

use common::{as_ordered, assert_spectrum, at_vertex, on_edge};
use nalgebra::DMatrix;
use octruss_mesh::Scheme;
use octruss_mesh::analysis::stars::{Marks, bipyramid, edge_ring};
use octruss_mesh::analysis::{LocalMatrix, at_midpoint};

fn has(local: &LocalMatrix, value: f64) -> bool {
    let eigenvalues = local.spectrum().unwrap().eigenvalues;
    eigenvalues.iter().any(|[re, im]| (re - value).abs() < 1e-7 && im.abs() < 1e-7)
}

#[test]
fn valence_five_has_the_values_of_b1() {
    // B.1: 1, 5/16, (15 + √70)/80, 3/20, 1/8, 1/8. The 6×6 block has all but
    // 3/20, which belongs to the two-ring block, and (15 − √70)/80.
    let block = at_vertex(&bipyramid(3), 0, Scheme::BoxSpline);
    let root = 70.0f64.sqrt();
    let expected =
        [1.0, 5.0 / 16.0, (15.0 + root) / 80.0, 1.0 / 8.0, 1.0 / 8.0, (15.0 - root) / 80.0];
    assert_spectrum(&block, &expected, 1e-12, "one ring");
    assert!(!has(&block, 3.0 / 20.0));
    // It depends on the marking: upper tets mark the upper spoke, lower ones in turn.
    let mesh = bipyramid(3);
    let [upper, lower] = [1, 2];
    let tets = (0..3).flat_map(|i| {
        let (c, d) = (3 + i, 3 + (i + 1) % 3);
        [[0, c, upper, d], [0, lower, c, d]]
    });
    let marked = as_ordered(mesh.points().to_vec(), tets.collect());
    let two = LocalMatrix::with_rings(&marked, 0, Scheme::BoxSpline, 2).unwrap();
    for value in expected {
        assert!(has(&two, value), "{value}");
    }
    assert!(has(&two, 3.0 / 20.0));
}

#[test]
fn a_twisted_edge_of_four_has_the_values_of_b2a() {
    // The dominant pair (45 ± √985)/160 and 19/80; the smaller of the pair is not
    // printed, the 1/8 printed instead is no eigenvalue of the 11×11 block.
    let block = on_edge(&edge_ring(4, Marks::Twist), Scheme::BoxSpline);
    assert_eq!(block.matrix.nrows(), 11);
    let root = 985.0f64.sqrt();
    for value in [1.0, (45.0 + root) / 160.0, 19.0 / 80.0, (45.0 - root) / 160.0] {
        assert!(has(&block, value), "{value}");
    }
    assert!(!has(&block, 1.0 / 8.0));
    let (mesh, midpoint) = at_midpoint(&edge_ring(4, Marks::Twist), [0, 1]).unwrap();
    assert!(has(&LocalMatrix::with_rings(&mesh, midpoint, Scheme::BoxSpline, 2).unwrap(), 0.125));
}

#[test]
fn a_regular_edge_has_the_values_of_b2b_if_vertices_ignore_diagonals() {
    // By the rule (4.24), with 14 neighbours, the spectrum is the regular one.
    let local = on_edge(&edge_ring(4, Marks::All), Scheme::BoxSpline);
    let regular = [1.0, 0.5, 0.5, 0.5, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.125];
    assert_spectrum(&local, &regular, 1e-7, "14 neighbours");
    // The matrix of the appendix leaves out the four octahedra's diagonals in the
    // vertex row, and only there; they come last among the neighbours.
    let mut matrix: DMatrix<f64> = local.matrix.clone();
    for neighbour in 1..15 {
        matrix[(0, neighbour)] = if neighbour <= 10 { 7.0 / 160.0 } else { 0.0 };
    }
    let printed = LocalMatrix { matrix, rings: 1 };
    let root = 385.0f64.sqrt();
    let expected = [1.0, 0.5, 0.5, 0.5, (25.0 + root) / 160.0, 0.25, 0.25, 0.25, 0.25, 0.25, 0.125];
    assert_spectrum(&printed, &expected, 1e-7, "10 neighbours");
}

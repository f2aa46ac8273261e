//! Eigenvalues of local box-spline matrices against published values.

mod common;

use common::{assert_spectrum, at_vertex, on_edge, smooth};
use octruss_mesh::analysis::stars::{Marks, edge_ring, stack};
use octruss_mesh::{FeatureOptions, Scheme, prepare, shapes};

#[test]
fn extraordinary_vertices_have_the_published_spectra() {
    // Chang's thesis, table 4.2, all 22 rows, from the one-ring block. The
    // sixth value .15 printed for valences 5, 6, 7 and 8(b) is left out: it
    // belongs to the two-ring block and depends on the marking. Rounding noise
    // of the print: .312499 is 5/16, .249998 and .250002 are 1/4, .480204 and
    // .480206 are .480205; 8(b) has .270180 for the printed .270178.
    let rows: [(&str, u32, u32, &[f64]); 22] = [
        ("5", 3, 1, &[1.0, 0.3125, 0.292083]),
        ("6", 4, 1, &[1.0, 0.312499, 0.25, 0.25, 0.25]),
        ("7", 5, 1, &[1.0, 0.327254, 0.327254, 0.3125, 0.275888]),
        ("8(a)", 3, 2, &[1.0, 0.480205, 0.3125, 0.3125, 0.249998, 0.2375]),
        ("8(b)", 6, 1, &[1.0, 0.375, 0.375, 0.3125, 0.270178]),
        ("9", 7, 1, &[1.0, 0.405872, 0.405872, 0.3125, 0.26545, 0.19437]),
        ("10(a)", 4, 2, &[1.0, 0.477404, 0.418566, 0.418566, 0.2375, 0.206434]),
        ("10(b)", 8, 1, &[1.0, 0.426777, 0.426777, 0.3125, 0.261451, 0.25]),
        ("11", 9, 1, &[1.0, 0.441511, 0.441511, 0.3125, 0.293412, 0.293412]),
        ("12", 5, 2, &[1.0, 0.480205, 0.480205, 0.480205, 0.250002, 0.2375]),
        ("13", 11, 1, &[1.0, 0.460313, 0.460313, 0.353854, 0.353854, 0.3125]),
        ("14(a)", 4, 3, &[1.0, 0.577132, 0.449431, 0.449431, 0.34832, 0.3125]),
        ("14(b)", 6, 2, &[1.0, 0.517404, 0.517404, 0.480205, 0.3125, 0.3125]),
        ("15", 13, 1, &[1.0, 0.471364, 0.471364, 0.392016, 0.392016, 0.3125]),
        ("16", 7, 2, &[1.0, 0.541169, 0.541169, 0.480204, 0.372645, 0.372645]),
        ("17", 5, 3, &[1.0, 0.571212, 0.511703, 0.511703, 0.371472, 0.358853]),
        ("18(a)", 4, 4, &[1.0, 0.623289, 0.463128, 0.463128, 0.457191, 0.374739]),
        ("18(b)", 8, 2, &[1.0, 0.557148, 0.557148, 0.480205, 0.418566, 0.418566]),
        ("20(a)", 6, 3, &[1.0, 0.571212, 0.549072, 0.549072, 0.3875, 0.3875]),
        ("20(b)", 9, 2, &[1.0, 0.568361, 0.568361, 0.480206, 0.453454, 0.453454]),
        ("22(a)", 5, 4, &[1.0, 0.616629, 0.525774, 0.525774, 0.4625, 0.427853]),
        ("22(b)", 10, 2, &[1.0, 0.576511, 0.576511, 0.480205, 0.480205, 0.480205]),
    ];
    for (row, n, layers, expected) in rows {
        let local = at_vertex(&stack(n, layers), 0, Scheme::BoxSpline);
        assert_eq!(local.rings, 1);
        assert_eq!(local.matrix.nrows() as u32, 3 + n * layers);
        assert_spectrum(&local, expected, 3e-6, row);
    }
}

#[test]
fn twisted_edges_have_the_published_spectra() {
    // Chang's thesis, table 4.3: k tets round an edge, marked with a twist,
    // which conflicts on every face. Their one-ring block is that of two
    // stacked rings of k, so rows 8(a) to 20(b) of table 4.2 return.
    let rows: [(u32, &[f64]); 6] = [
        (4, &[1.0, 0.477404, 0.418566, 0.418566, 0.2375, 0.206434]),
        (5, &[1.0, 0.480205, 0.480205, 0.480205, 0.25, 0.2375]),
        (6, &[1.0, 0.517404, 0.517404, 0.480205, 0.3125, 0.3125]),
        (7, &[1.0, 0.541169, 0.541169, 0.480205, 0.372645, 0.372645]),
        (8, &[1.0, 0.557148, 0.557148, 0.480205, 0.418566, 0.418566]),
        (9, &[1.0, 0.568361, 0.568361, 0.480205, 0.453454, 0.453454]),
    ];
    for (k, expected) in rows {
        let local = on_edge(&edge_ring(k, Marks::Twist), Scheme::BoxSpline);
        assert_eq!(local.matrix.nrows() as u32, 2 * k + 3);
        assert_spectrum(&local, expected, 3e-6, &format!("edge of {k} tets"));
    }
}

#[test]
fn edges_without_conflicts_have_their_reference_spectra() {
    // Two independent computations, ours and a prototype in Python. "Toward the
    // centre" of the thesis is the row of nine tets that all mark the edge.
    let all: [(u32, &[f64]); 8] = [
        (3, &[1.0, 0.5, 0.410097, 0.410097, 0.307464]),
        (4, &[1.0, 0.5, 0.5, 0.5, 0.25]),
        (5, &[1.0, 0.549988, 0.549988, 0.5, 0.340107, 0.340107]),
        (6, &[1.0, 0.579682, 0.579682, 0.5, 0.410097, 0.410097]),
        (7, &[1.0, 0.598510, 0.598510, 0.5, 0.461864, 0.461864]),
        (8, &[1.0, 0.611117, 0.611117, 0.5, 0.5, 0.5]),
        (9, &[1.0, 0.619939, 0.619939, 0.528431, 0.528431, 0.5]),
        (10, &[1.0, 0.626341, 0.626341, 0.549988, 0.549988, 0.5]),
    ];
    for (k, expected) in all {
        let local = on_edge(&edge_ring(k, Marks::All), Scheme::BoxSpline);
        assert_eq!(local.matrix.nrows() as u32, 3 * k + 3);
        assert_spectrum(&local, expected, 1e-6, &format!("{k} tets, all mark"));
    }
    let alternate: [(u32, &[f64]); 4] = [
        (4, &[1.0, 0.5, 0.375, 0.375, 0.2356, 0.2356]),
        (6, &[1.0, 0.5, 0.5, 0.5, 0.25]),
        (8, &[1.0, 0.551777, 0.551777, 0.5, 0.375, 0.375]),
        (10, &[1.0, 0.577254, 0.577254, 0.5, 0.452254, 0.452254]),
    ];
    for (k, expected) in alternate {
        let local = on_edge(&edge_ring(k, Marks::Alternate), Scheme::BoxSpline);
        assert_eq!(local.matrix.nrows() as u32, 2 * k + 3);
        let tolerance = if k == 4 { 1e-4 } else { 1e-6 };
        assert_spectrum(&local, expected, tolerance, &format!("{k} tets, alternate"));
    }
    let local = on_edge(&edge_ring(4, Marks::Alternate), Scheme::BoxSpline);
    let [re, im] = local.spectrum().unwrap().eigenvalues[4];
    assert!((re - 0.2333).abs() < 5e-5 && (im - 0.0328).abs() < 5e-5, "{re} {im}");
}

#[test]
fn a_regular_vertex_has_the_regular_spectrum() {
    let local = at_vertex(&shapes::kuhn_cube(2), 13, Scheme::BoxSpline);
    assert_eq!((local.rings, local.matrix.nrows()), (1, 15));
    let expected = [1.0, 0.5, 0.5, 0.5, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.125];
    assert_spectrum(&local, &expected, 1e-7, "regular");
}

#[test]
fn the_limit_of_a_regular_vertex_is_the_known_mask() {
    // The left eigenvector of 1: 2/5 itself, 1/20 across edges of six tets, 1/30
    // across those of four. Its weights are those of repeated subdivision.
    let mut power = at_vertex(&shapes::kuhn_cube(2), 13, Scheme::BoxSpline).matrix;
    for _ in 0..7 {
        power = &power * &power;
    }
    let row = power.row(0);
    let count = |value: f64| row.iter().filter(|&&weight| (weight - value).abs() < 1e-14).count();
    assert!((row[0] - 2.0 / 5.0).abs() < 1e-14);
    assert_eq!((count(1.0 / 20.0), count(1.0 / 30.0)), (8, 6));
}

#[test]
fn boundary_vertices_of_a_smooth_block_have_their_reference_spectra() {
    let mesh = smooth(shapes::kuhn_cube(2));
    let at = |p: [f64; 3]| mesh.points().iter().position(|q| *q == p).unwrap() as u32;
    let rows: [(&str, [f64; 3], &[f64]); 4] = [
        ("flat face", [0.5, 0.5, 0.0], &[1.0, 0.5, 0.5, 0.5, 0.25]),
        ("cube edge, eight tets", [0.5, 0.0, 0.0], &[1.0, 0.5, 0.5, 0.375, 0.25]),
        ("corner with six tets", [0.0, 0.0, 0.0], &[1.0, 0.5, 0.5, 0.3125, 0.25]),
        ("corner with two tets", [1.0, 0.0, 0.0], &[1.0, 0.375, 0.375, 0.25]),
    ];
    for (what, point, expected) in rows {
        assert_spectrum(&at_vertex(&mesh, at(point), Scheme::BoxSpline), expected, 1e-7, what);
    }
    // Warren's weights at valence 3: the symmetric modes have 5/8 − 3 · 3/16 = 1/16,
    // beside 1/8 of the two rings that the single tet's face needs.
    let single = at_vertex(&smooth(shapes::regular_tet()), 0, Scheme::BoxSpline);
    assert_spectrum(&single, &[1.0, 0.25, 0.25, 0.0625], 1e-7, "single tet");
}

#[test]
fn creases_and_corners_of_a_block_keep_the_linear_spectrum() {
    // A creased Kuhn block is reproduced exactly, so linear functions are
    // eigenvectors of 1/2 at every vertex that moves; a corner is fixed.
    let mesh = prepare(shapes::kuhn_cube(2), &FeatureOptions::default());
    for (vertex, point) in mesh.points().iter().enumerate() {
        for scheme in [Scheme::BoxSpline, Scheme::INTERPOLATORY, Scheme::LOOP_SOLID] {
            let spectrum = at_vertex(&mesh, vertex as u32, scheme).spectrum().unwrap();
            let half = |z: &&[f64; 2]| (z[0] - 0.5).abs() < 1e-9 && z[1].abs() < 1e-9;
            assert!(spectrum.is_convergent(), "{scheme:?} {point:?}");
            assert!(spectrum.eigenvalues.iter().filter(half).count() >= 3, "{scheme:?} {point:?}");
        }
    }
}

//! Eigenvalues of the local box-spline matrices against published values.

mod common;

use common::{Marks, assert_spectrum, edge_ring, midpoint_block, one_ring_block, smooth, stack};
use octruss_mesh::{Scheme, shapes};

#[test]
fn extraordinary_vertices_have_the_published_spectra() {
    // Chang's thesis, table 4.2, one-ring blocks. The printed 0.15 belongs to
    // the two-ring block and is left out; .312499, .249998 and .250002 are
    // rounding noise of 5/16 and 1/4.
    let rows: [(&str, u32, u32, &[f64]); 9] = [
        ("5", 3, 1, &[1.0, 0.3125, 0.292083]),
        ("6", 4, 1, &[1.0, 0.3125, 0.25, 0.25, 0.25]),
        ("7", 5, 1, &[1.0, 0.327254, 0.327254, 0.3125, 0.275888]),
        ("8a", 3, 2, &[1.0, 0.480205, 0.3125, 0.3125, 0.25, 0.2375]),
        ("8b", 6, 1, &[1.0, 0.375, 0.375, 0.3125, 0.270180]),
        ("9", 7, 1, &[1.0, 0.405872, 0.405872, 0.3125, 0.26545, 0.19437]),
        ("12", 5, 2, &[1.0, 0.480205, 0.480205, 0.480205, 0.25, 0.2375]),
        ("14a", 4, 3, &[1.0, 0.577132, 0.449431, 0.449431, 0.34832, 0.3125]),
        ("14b", 6, 2, &[1.0, 0.517404, 0.517404, 0.480205, 0.3125, 0.3125]),
    ];
    for (row, n, layers, expected) in rows {
        let block = one_ring_block(&stack(n, layers), 0, Scheme::BoxSpline);
        assert_spectrum(&block, expected, 3e-6, row);
    }
}

#[test]
fn extraordinary_edges_have_their_reference_spectra() {
    let rows: [(u32, Marks, &[f64]); 7] = [
        (4, Marks::All, &[1.0, 0.5, 0.5, 0.5, 0.25]),
        (5, Marks::All, &[1.0, 0.549988, 0.549988, 0.5, 0.340107, 0.340107]),
        (6, Marks::All, &[1.0, 0.579682, 0.579682, 0.5, 0.410097, 0.410097]),
        (6, Marks::Alternate, &[1.0, 0.5, 0.5, 0.5, 0.25]),
        // Table 4.3 of the thesis: the twisted marking, which conflicts on every
        // face, has the spectrum of two stacked rings.
        (5, Marks::Twist, &[1.0, 0.480205, 0.480205, 0.480205, 0.25, 0.2375]),
        (6, Marks::Twist, &[1.0, 0.517404, 0.517404, 0.480205, 0.3125, 0.3125]),
        // "Toward the centre", nine tets.
        (9, Marks::All, &[1.0, 0.619939, 0.619939, 0.528431, 0.528431, 0.5]),
    ];
    for (k, marks, expected) in rows {
        let block = midpoint_block(edge_ring(k, marks), Scheme::BoxSpline);
        assert_spectrum(&block, expected, 3e-6, &format!("edge of {k} tets"));
    }
}

#[test]
fn a_regular_vertex_has_the_regular_spectrum() {
    let mesh = shapes::kuhn_cube(2);
    let centre = mesh.points().iter().position(|p| *p == [0.5; 3]).unwrap() as u32;
    let block = one_ring_block(&mesh, centre, Scheme::BoxSpline);
    assert_eq!(block.nrows(), 15);
    assert_spectrum(
        &block,
        &[1.0, 0.5, 0.5, 0.5, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.125],
        1e-7,
        "regular",
    );
}

#[test]
fn boundary_vertices_of_a_smooth_block_have_their_reference_spectra() {
    let mesh = smooth(shapes::kuhn_cube(2));
    let at = |p: [f64; 3]| mesh.points().iter().position(|q| *q == p).unwrap() as u32;
    let rows: [(&str, [f64; 3], &[f64]); 3] = [
        ("flat face", [0.5, 0.5, 0.0], &[1.0, 0.5, 0.5, 0.5, 0.25]),
        ("corner with six tets", [0.0, 0.0, 0.0], &[1.0, 0.5, 0.5, 0.3125, 0.25]),
        ("corner with two tets", [1.0, 0.0, 0.0], &[1.0, 0.375, 0.375, 0.25]),
    ];
    for (what, point, expected) in rows {
        assert_spectrum(&one_ring_block(&mesh, at(point), Scheme::BoxSpline), expected, 1e-7, what);
    }
    // Warren's weights at valence 3: the symmetric modes have 5/8 − 3 · 3/16 = 1/16.
    let single = one_ring_block(&smooth(shapes::regular_tet()), 0, Scheme::BoxSpline);
    assert_spectrum(&single, &[1.0, 0.25, 0.25, 0.0625], 1e-7, "single tet");
}

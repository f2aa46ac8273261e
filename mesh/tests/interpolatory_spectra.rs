//! Eigenvalues of the interpolatory scheme.

mod common;

use common::{as_ordered, assert_spectrum, at_vertex, on_edge};
use octruss_mesh::analysis::stars::{Marks, edge_ring};
use octruss_mesh::{MarkedRule, Scheme, shapes};

/// The vertex in the middle of a block of 2³ Kuhn cells.
const CENTRE: u32 = 13;

#[test]
fn a_regular_vertex_has_a_simple_regular_spectrum() {
    let local = at_vertex(&shapes::kuhn_cube(2), CENTRE, Scheme::INTERPOLATORY);
    assert_spectrum(&local, &[1.0, 0.5, 0.5, 0.5, 0.2527, 0.2527, 0.25], 5e-5, "plane butterfly");
}

#[test]
fn the_published_rule_is_not_smooth_for_any_tension() {
    // A double eigenvalue above 1/2 at a regular vertex: equation 5.9 of Chang's
    // thesis gives no continuous derivative.
    let rows = [
        (1.0 / 64.0, 0.5311),
        (1.0 / 32.0, 0.5617),
        (1.0 / 20.0, 0.5970),
        (1.0 / 16.0, 0.6196),
        (1.0 / 12.0, 0.6552),
        (1.0 / 8.0, 0.7180),
    ];
    for (tension, double) in rows {
        let scheme = Scheme::Interpolatory { tension, marked: MarkedRule::Literal };
        let local = at_vertex(&shapes::kuhn_cube(2), CENTRE, scheme);
        assert_spectrum(&local, &[1.0, double, double], 6e-5, &format!("w = {tension}"));
    }
}

#[test]
fn extraordinary_edges_have_their_reference_spectra() {
    // Computed twice, by a prototype in Python and here.
    let all: [(u32, &[f64]); 6] = [
        (3, &[1.0, 0.524973, 0.524973, 0.493674, 0.4664]),
        (4, &[1.0, 0.5, 0.5, 0.5]),
        (5, &[1.0, 0.544277, 0.544277, 0.486992, 0.431879, 0.431879]),
        (6, &[1.0, 0.524973, 0.524973, 0.482065, 0.481772, 0.481772]),
        (7, &[1.0, 0.580265, 0.580265, 0.474791]),
        (8, &[1.0, 0.588070, 0.588070, 0.459591]),
    ];
    let alternate: [(u32, &[f64]); 3] = [
        (4, &[1.0, 0.498886, 0.414852, 0.414852]),
        (6, &[1.0, 0.5, 0.5, 0.5]),
        (8, &[1.0, 0.481464, 0.476391, 0.476391, 0.463298, 0.463298]),
    ];
    for (marks, rows) in [(Marks::All, &all[..]), (Marks::Alternate, &alternate[..])] {
        for &(k, expected) in rows {
            let local = on_edge(&edge_ring(k, marks), Scheme::INTERPOLATORY);
            let what = format!("{k} tets, {marks:?}");
            assert_spectrum(&local, &expected[..4], 1e-6, &what);
            assert_spectrum(&local, expected, 5e-5, &what);
        }
    }
}

#[test]
fn a_face_with_conflicting_marks_converges() {
    // Two tets that mark different edges of their common face; the face's centre
    // vertices at the second level are not on any of its edges.
    let points =
        vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    let mesh = as_ordered(points, vec![[0, 1, 2, 3], [0, 2, 1, 4]]);
    let mut levels = common::hierarchy(mesh);
    (0..2).for_each(|_| levels.subdivide(Scheme::Linear).unwrap());
    let inside = |p: &[f64; 3]| *p == [0.25, 0.25, 0.0];
    let vertex = levels.finest().mesh.points().iter().position(inside).unwrap() as u32;
    let local = at_vertex(&levels.finest().mesh, vertex, Scheme::INTERPOLATORY);
    assert_spectrum(&local, &[1.0, 0.48657, 0.47026, 0.47026, 0.46641], 6e-6, "conflict");
    assert!(local.spectrum().unwrap().is_convergent());
}

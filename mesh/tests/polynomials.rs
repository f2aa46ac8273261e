//! Which polynomials the schemes reproduce, on the lattice and up to a boundary.

mod common;

use common::{hierarchy, smooth};
use octruss_mesh::{
    FeatureOptions, Hierarchy, Level, MarkedRule, Scheme, TetMesh, shapes, subdivision_matrix,
};

/// The highest degree, up to 4, whose monomials a step reproduces at the new
/// vertices in the middle cells of a Kuhn block.
fn degree(scheme: Scheme) -> usize {
    let mut levels = hierarchy(smooth(shapes::kuhn_box([6; 3], [6.0; 3])));
    let matrix = subdivision_matrix(&levels.coarsest().mesh, &levels.coarsest().topology, scheme);
    levels.subdivide(Scheme::Linear).unwrap();
    let [coarse, fine] = [0, 1].map(|level| levels.levels()[level].mesh.points());
    // Odd powers about the middle vanish there by symmetry: shifted a little.
    let monomial = |[i, j, k]: [i32; 3], p: &[f64; 3]| {
        (p[0] - 2.7).powi(i) * (p[1] - 3.1).powi(j) * (p[2] - 3.4).powi(k)
    };
    let is_reproduced = |powers: [i32; 3]| {
        let values: Vec<f64> = coarse.iter().map(|p| monomial(powers, p)).collect();
        let refined = matrix.apply_field(&values, 1);
        let inside = |p: &[f64; 3]| p.iter().all(|x| (2.0..=4.0).contains(x));
        let mut places = fine.iter().zip(refined).filter(|(p, _)| inside(p));
        places.all(|(p, value)| (value - monomial(powers, p)).abs() < 1e-12)
    };
    let monomials = |degree: i32| {
        (0..=degree).flat_map(move |i| (0..=degree - i).map(move |j| [i, j, degree - i - j]))
    };
    (1..=4).take_while(|&degree| monomials(degree).all(is_reproduced)).count()
}

#[test]
fn the_degrees_on_the_lattice_are_the_known_ones() {
    let interpolatory = |tension, marked| degree(Scheme::Interpolatory { tension, marked });
    assert_eq!(degree(Scheme::Linear), 1);
    assert_eq!(degree(Scheme::BoxSpline), 1);
    assert_eq!(degree(Scheme::LOOP_SOLID), 1);
    assert_eq!(degree(Scheme::INTERPOLATORY), 3);
    for tension in [1.0 / 32.0, 1.0 / 20.0, 1.0 / 8.0] {
        assert_eq!(interpolatory(tension, MarkedRule::PlaneButterfly), 1, "w = {tension}");
    }
    for tension in [1.0 / 32.0, 1.0 / 16.0] {
        assert_eq!(interpolatory(tension, MarkedRule::Literal), 1, "w = {tension}");
    }
}

/// Max distance between a step of the scheme and the linear one on the same mesh.
fn defect(mesh: TetMesh, scheme: Scheme) -> f64 {
    let mut levels = Hierarchy::new(mesh, &FeatureOptions::default());
    levels.subdivide(Scheme::Linear).unwrap();
    let matrix = subdivision_matrix(&levels.coarsest().mesh, &levels.coarsest().topology, scheme);
    levels.affine_defect(0, &matrix)
}

#[test]
fn the_interpolatory_scheme_is_linearly_exact_up_to_creased_boundaries() {
    for marked in [MarkedRule::PlaneButterfly, MarkedRule::Literal] {
        let scheme = Scheme::Interpolatory { tension: 1.0 / 16.0, marked };
        let block = shapes::kuhn_box([4; 3], [4.0; 3]);
        assert!(defect(block, scheme) < 1e-14, "{marked:?}");
    }
    // On the mesh that the step makes, too: it is a block again.
    let mut levels = Hierarchy::new(shapes::kuhn_box([4; 3], [4.0; 3]), &FeatureOptions::default());
    levels.subdivide(Scheme::INTERPOLATORY).unwrap();
    assert!(defect(levels.finest().mesh.clone(), Scheme::INTERPOLATORY) < 1e-14);
}

#[test]
fn ghosts_keep_linear_functions_beside_a_smooth_boundary() {
    // Without creases the boundary rounds off; rows of interior edges stay exact.
    let mut levels = hierarchy(smooth(shapes::kuhn_box([4; 3], [4.0; 3])));
    let Level { mesh, topology, .. } = levels.coarsest();
    let matrix = subdivision_matrix(mesh, topology, Scheme::INTERPOLATORY);
    let points = matrix.apply(mesh.points());
    let (n, edges) = (mesh.points().len(), topology.edges().to_vec());
    let on_boundary: Vec<bool> = boundary_edges(topology);
    levels.subdivide(Scheme::Linear).unwrap();
    let mut interior = 0;
    for edge in (0..edges.len()).filter(|&edge| !on_boundary[edge]) {
        let (found, expected) = (points[n + edge], levels.finest().mesh.points()[n + edge]);
        assert!((0..3).all(|k| (found[k] - expected[k]).abs() < 1e-14), "edge {:?}", edges[edge]);
        interior += 1;
    }
    assert_eq!(interior, 316);
}

fn boundary_edges(topology: &octruss_mesh::Topology) -> Vec<bool> {
    let mut on_boundary = vec![false; topology.edges().len()];
    for face in (0..topology.faces().len()).filter(|&face| topology.is_boundary(face)) {
        topology.face_edges()[face].iter().for_each(|&edge| on_boundary[edge as usize] = true);
    }
    on_boundary
}

#[test]
fn every_scheme_reproduces_a_creased_block_where_its_stencils_are_symmetric() {
    for scheme in [Scheme::BoxSpline, Scheme::LOOP_SOLID] {
        assert!(defect(shapes::kuhn_box([4; 3], [4.0; 3]), scheme) < 1e-15, "{scheme:?}");
    }
}

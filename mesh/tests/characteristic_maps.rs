//! Verdicts on schemes at vertices, and sampled characteristic maps.

mod common;

use octruss_mesh::analysis::stars::{Marks, edge_ring, icosahedron, stack};
use octruss_mesh::analysis::{
    CharacteristicMap, LocalMatrix, MapVerdict, NoMap, Verdict, at_midpoint,
};
use octruss_mesh::{Scheme, TetMesh, shapes};

fn verdict(mesh: &TetMesh, vertex: u32, scheme: Scheme) -> Verdict {
    let spectrum = LocalMatrix::new(mesh, vertex, scheme).unwrap().spectrum().unwrap();
    Verdict::new(&spectrum, &CharacteristicMap::new(mesh, vertex, scheme).unwrap())
}

fn on_edge(k: u32, marks: Marks, scheme: Scheme) -> Verdict {
    let (mesh, midpoint) = at_midpoint(&edge_ring(k, marks), [0, 1]).unwrap();
    verdict(&mesh, midpoint, scheme)
}

fn good(star_tets: usize) -> Verdict {
    let map = MapVerdict::Sampled { regular: true, injective: true, tets: 512 * star_tets };
    Verdict { convergent: true, separated: true, map }
}

#[test]
fn at_a_regular_vertex_the_map_is_linear() {
    let mesh = shapes::kuhn_cube(2);
    for scheme in [Scheme::BoxSpline, Scheme::INTERPOLATORY] {
        assert_eq!(verdict(&mesh, 13, scheme), good(24), "{scheme:?}");
        let map = CharacteristicMap::new(&mesh, 13, scheme).unwrap().unwrap();
        assert!(map.eigenvalues.iter().all(|value| (value - 0.5).abs() < 1e-12));
        // Every edge's image is the sum of the images of unit steps.
        let unit = |axis: usize| {
            let at = |p: &[f64; 3]| {
                (0..3).all(|k| (p[k] - if k == axis { 0.5625 } else { 0.5 }).abs() < 1e-12)
            };
            map.image.points[map.preimage.iter().position(at).unwrap()]
        };
        let units = [unit(0), unit(1), unit(2)];
        for (image, preimage) in map.image.points.iter().zip(&map.preimage) {
            let steps = preimage.map(|x| (x - 0.5) / 0.0625);
            for k in 0..3 {
                let expected: f64 = (0..3).map(|axis| steps[axis] * units[axis][k]).sum();
                assert!((image[k] - expected).abs() < 1e-9, "{image:?} {expected}");
            }
        }
    }
}

#[test]
fn common_extraordinary_places_are_smooth() {
    assert_eq!(verdict(&icosahedron(), 0, Scheme::BoxSpline), good(20));
    assert_eq!(verdict(&icosahedron(), 0, Scheme::Averaged), good(20));
    assert_eq!(verdict(&stack(6, 2), 0, Scheme::BoxSpline), good(24));
    for k in [5, 6, 7] {
        assert_eq!(on_edge(k, Marks::All, Scheme::BoxSpline), good(6 * k as usize));
        assert_eq!(on_edge(k, Marks::Twist, Scheme::Averaged), good(4 * k as usize));
    }
}

#[test]
fn a_map_that_is_not_defined_is_said_to_be_so() {
    // Eight tets that all mark their edge: λ3 = λ4 = λ5 = 1/2.
    let eight = on_edge(8, Marks::All, Scheme::BoxSpline);
    assert!(eight.convergent && !eight.separated);
    assert_eq!(eight.map, MapVerdict::NotApplicable(NoMap::NotSeparated));
    // Table 4.2, row 10(a): separated, but λ1 > λ2 = λ3.
    let ten = verdict(&stack(4, 2), 0, Scheme::BoxSpline);
    assert!(ten.separated, "{ten:?}");
    // A sharp corner's block has four rows, all fixed by the corner.
    let corner =
        verdict(&common::hierarchy(shapes::kuhn_cube(1)).coarsest().mesh, 1, Scheme::BoxSpline);
    assert!(corner.convergent, "{corner:?}");
}

#[test]
fn folded_and_doubled_maps_are_told_apart_from_sound_ones() {
    let map = CharacteristicMap::new(&stack(8, 1), 0, Scheme::BoxSpline).unwrap().unwrap();
    assert!(map.is_regular() && map.is_injective());
    let mut folded = map.clone();
    // The innermost neighbour is pushed through the centre.
    let inner = map.layers.iter().position(|&layer| layer == 1).unwrap();
    folded.image.points[inner] = folded.image.points[inner].map(|x| -x);
    assert!(!folded.is_regular() && !folded.is_injective());
    // Twice round the axis: every tet sound, each place covered twice.
    let mut doubled = map;
    for [x, y, _] in &mut doubled.image.points {
        let (radius, turn) = (x.hypot(*y), 2.0 * y.atan2(*x));
        [*x, *y] = [radius * turn.cos(), radius * turn.sin()];
    }
    assert!(doubled.is_regular());
    assert!(!doubled.is_injective());
}

#[test]
fn places_that_do_not_exist_are_named() {
    let mesh = shapes::five_tet_cube();
    let at = |vertex| LocalMatrix::new(&mesh, vertex, Scheme::BoxSpline).unwrap_err().to_string();
    assert_eq!(at(8), "there is no vertex 8: the mesh has 8, numbered from 0");
    let none = at_midpoint(&mesh, [1, 2]).unwrap_err().to_string();
    assert_eq!(none, "vertices 1 and 2 share no edge");
    let few = LocalMatrix::with_rings(&mesh, 0, Scheme::BoxSpline, 5).unwrap_err().to_string();
    assert_eq!(few, "5 rings were asked for; the scheme needs at least 1, and 4 are at hand");
}

#[test]
fn the_interpolatory_map_overlaps_itself_round_edges_of_six_to_eight_tets() {
    // All tets mark the edge. From six tets on the largest pair of eigenvalues
    // is no longer that of one turn round the edge: for six it is .524973, the
    // pair of three tets, which belongs to two turns. Each tet is sound, but
    // places are covered more than once.
    for (k, injective) in [(3, true), (4, true), (5, true), (6, false), (7, false), (8, false)] {
        let map = MapVerdict::Sampled { regular: true, injective, tets: 512 * 6 * k as usize };
        assert_eq!(on_edge(k, Marks::All, Scheme::INTERPOLATORY).map, map, "{k} tets");
    }
}

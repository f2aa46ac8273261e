//! Sorting a mesh along a space-filling curve renames, and changes nothing else.

mod common;

use common::random_block::{Random, blocks};
use octruss_mesh::{
    CellState, ExtraFeatures, FeatureOptions, Hierarchy, RawMesh, Renumbering, Scheme, TetMesh,
    Topology, prepare, shapes, sort_along_curve,
};
use proptest::prelude::*;

/// Each number below the length once.
fn is_bijection(numbers: &[u32]) -> bool {
    let mut seen = vec![false; numbers.len()];
    numbers.iter().all(|&v| seen.get_mut(v as usize).is_some_and(|s| !std::mem::replace(s, true)))
}

/// The old mesh, made from the new one by undoing the renumbering.
fn undone(new: &TetMesh, from: &Renumbering) -> RawMesh {
    let old = |v: u32| from.vertices[v as usize];
    let mut raw = new.raw().clone();
    for (at, &v) in from.vertices.iter().enumerate() {
        raw.points[v as usize] = new.points()[at];
    }
    let features = raw.features.as_mut().unwrap();
    for (at, &tet) in from.tets.iter().enumerate() {
        raw.tets[tet as usize] = new.tets()[at].map(old);
        raw.regions[tet as usize] = new.regions()[at];
        features.cell_states[tet as usize] = new.features().unwrap().cell_states[at];
    }
    for ends in &mut features.creases {
        *ends = ends.map(old);
        ends.sort();
    }
    features.creases.sort();
    features.corners = features.corners.iter().map(|&v| old(v)).collect();
    features.corners.sort();
    let rest = raw.triangles.simplices.as_flattened_mut().iter_mut();
    let rest = rest.chain(raw.edges.simplices.as_flattened_mut());
    rest.chain(raw.vertices.simplices.as_flattened_mut()).for_each(|v| *v = old(*v));
    raw
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn sorting_renames_and_a_second_time_does_nothing(mesh in blocks(), seed in any::<u64>()) {
        let mut raw = prepare(mesh, &FeatureOptions::default()).into_raw();
        let mut random = Random::new(seed);
        let states = [CellState::Tetrahedron, CellState::QuarterRoundX1X3];
        let features = raw.features.as_mut().unwrap();
        features.cell_states = raw.tets.iter().map(|_| states[random.below(2)]).collect();
        let mesh = octruss_mesh::check(raw, &Default::default()).unwrap().mesh;
        let (sorted, from) = sort_along_curve(mesh.clone());
        prop_assert_eq!(sorted.points().len(), mesh.points().len());
        prop_assert!(is_bijection(&from.vertices) && is_bijection(&from.tets));
        let undone = undone(&sorted, &from);
        prop_assert_eq!(&undone, mesh.raw());
        for (new, &old) in from.new_vertices().iter().zip(mesh.points()) {
            prop_assert_eq!(sorted.points()[*new as usize], old);
        }

        let (again, from) = sort_along_curve(sorted.clone());
        prop_assert_eq!(again, sorted);
        prop_assert!(from.vertices.is_sorted() && from.tets.is_sorted());
    }

    /// Every point of the finer mesh is made by the same rule.
    #[test]
    fn a_sorted_mesh_refines_to_the_same_shape(mesh in blocks()) {
        let prepared = prepare(mesh, &FeatureOptions::default());
        let refined = |mesh: TetMesh| {
            let mut hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
            hierarchy.subdivide(Scheme::BoxSpline).map(|()| hierarchy)
        };
        let (sorted, from) = sort_along_curve(prepared.clone());
        let (Ok(plain), Ok(sorted)) = (refined(prepared), refined(sorted)) else {
            return Ok(()); // both or none: rounding cannot tell, tets may fold
        };
        let children = |levels: &Hierarchy, tet: u32| levels.refinement(0).children(tet);
        for (tet, &old) in (0u32..).zip(&from.tets) {
            for (child, old) in children(&sorted, tet).zip(children(&plain, old)) {
                let ends = [(&sorted, child), (&plain, old)].map(|(levels, child)| {
                    let mesh = &levels.finest().mesh;
                    mesh.tets()[child as usize].map(|v| mesh.points()[v as usize])
                });
                for (p, q) in ends[0].iter().zip(&ends[1]) {
                    prop_assert!((0..3).all(|k| (p[k] - q[k]).abs() < 1e-12), "{:?} {:?}", p, q);
                }
            }
        }
    }
}

#[test]
fn neighbours_of_a_shuffled_mesh_come_close_in_memory() {
    let mut random = Random::new(7);
    let mut raw = shapes::kuhn_cube(15).into_raw();
    random.renumber(&mut raw);
    let shuffled = octruss_mesh::check(raw, &Default::default()).unwrap().mesh;
    let distance = |mesh: &TetMesh| {
        let mut spans: Vec<u32> =
            Topology::new(mesh.raw()).edges().iter().map(|[a, b]| b - a).collect();
        spans.sort_unstable();
        spans[spans.len() / 2]
    };
    // Of two random numbers below n the median distance is (1 − 1/√2) n.
    let random = 0.293 * shuffled.points().len() as f64;
    assert!((f64::from(distance(&shuffled)) / random - 1.0).abs() < 0.05);
    // The curve visits each of 4 × 4 × 4 bricks in one go. In one lie 4³ of the 16³
    // vertices, and of the edges along axes 12/15, of those across faces (12/15)²,
    // across cells (12/15)³: more than half of all.
    assert!(distance(&sort_along_curve(shuffled).0) < 64);
}

#[test]
fn the_same_for_any_number_of_threads() {
    let mesh = shapes::kuhn_cube(12);
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| sort_along_curve(mesh.clone()))
    };
    let one = with(1);
    assert!(with(2) == one && with(5) == one);
}

#[test]
fn creases_and_corners_asked_for_follow_their_vertices() {
    let mesh = shapes::kuhn_cube(2);
    let extra = ExtraFeatures::new(&mesh, &[[13, 0], [0, 1]], &[26, 4]).unwrap();
    let new: Vec<u32> = (0..27).rev().collect();
    let turned = ExtraFeatures::new(&mesh, &[[13, 26], [25, 26]], &[0, 22]).unwrap();
    assert_eq!(extra.renumbered(&new), turned);
}

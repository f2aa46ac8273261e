//! Red-green refinement: conforming after any rounds, and of few shapes.

mod common;

use std::collections::BTreeSet;

use common::random_block::{Random, blocks};
use common::random_marks::random_marks;
use octruss_mesh::{
    Diagonal, FeatureOptions, Hierarchy, Level, MarkedEdges, Scheme, TetMesh, Topology, check,
    quality, shapes, split_marked,
};
use proptest::prelude::*;

/// For each tet of a level whether it is a part of a bisected or quartered one.
fn greens(levels: &Hierarchy, level: usize) -> Vec<bool> {
    let mut green = vec![false; levels.coarsest().mesh.tets().len()];
    for refinement in levels.refinements().take(level) {
        let parts = |whole: usize| refinement.children(whole as u32).len();
        green = (green.iter().enumerate())
            .flat_map(|(whole, &was)| {
                let is = match parts(whole) {
                    1 => was,
                    8 => false,
                    _ => true,
                };
                std::iter::repeat_n(is, parts(whole))
            })
            .collect();
    }
    green
}

fn no_green_tet_is_split(levels: &Hierarchy) {
    for (level, refinement) in levels.refinements().enumerate() {
        for (tet, green) in greens(levels, level).into_iter().enumerate() {
            assert!(!green || refinement.children(tet as u32).len() == 1);
        }
    }
}

/// Regions, volumes and faces: each face of two tets, or of one where the coarsest mesh ends.
fn is_sound(levels: &Hierarchy) {
    let area = |level: &Level| -> f64 {
        let faces = level.topology.faces().iter().enumerate();
        let outer = faces.filter(|(face, _)| level.topology.is_boundary(*face));
        outer
            .map(|(_, face)| {
                let [a, b, c] = face.map(|v| level.mesh.points()[v as usize]);
                let (u, v) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
                let cross = [0, 1, 2].map(|k| {
                    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                    u[i] * v[j] - u[j] * v[i]
                });
                0.5 * common::bodies::norm(cross)
            })
            .sum()
    };
    let (coarsest, finest) = (levels.coarsest(), levels.finest());
    assert!((area(coarsest) - area(finest)).abs() < 1e-9);
    let volume = common::bodies::volume;
    assert!((volume(&coarsest.mesh) - volume(&finest.mesh)).abs() < 1e-9);
    check(finest.mesh.raw().clone(), &Default::default()).expect("a sound mesh");
    let mut regions = coarsest.mesh.regions().to_vec();
    for refinement in levels.refinements() {
        regions = refinement.inherit(&regions, 1);
    }
    assert_eq!(regions, finest.mesh.regions());
}

/// The ends of marked edges where they stand.
fn places(level: &Level, marks: &MarkedEdges) -> Vec<[[u64; 3]; 2]> {
    let place = |v: u32| level.mesh.points()[v as usize].map(f64::to_bits);
    let ends = |edge: u32| {
        let mut ends = level.topology.edges()[edge as usize].map(place);
        ends.sort_unstable();
        ends
    };
    marks.edges().map(ends).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn any_rounds_leave_sound_meshes_and_split_no_green_tet(mesh in blocks(), seeds: [u64; 4]) {
        let mut levels = Hierarchy::new(mesh, &FeatureOptions::default());
        for (round, seed) in seeds.into_iter().enumerate() {
            let before = levels.clone();
            let finest = levels.finest();
            let marks = random_marks(&finest.topology, seed);
            let asked = places(finest, &marks);
            let first = levels.split_red_green(&marks, Diagonal::Inherit).expect("midpoints invert nothing");
            prop_assert_eq!(levels.levels().len(), round + 2);
            for (old, new) in before.levels().iter().zip(levels.levels()).take(first) {
                prop_assert!(std::sync::Arc::ptr_eq(old, new));
            }
            let finest = levels.finest();
            let left: BTreeSet<_> = places(finest, &MarkedEdges::all(&finest.topology)).into_iter().collect();
            prop_assert!(asked.iter().all(|ends| !left.contains(ends)), "marked edges are gone");
            prop_assert!(finest.topology == Topology::new(finest.mesh.raw()));
            is_sound(&levels);
            no_green_tet_is_split(&levels);
        }
    }

    #[test]
    fn results_are_the_same_bits_for_any_number_of_threads(mesh in blocks(), seeds: [u64; 3]) {
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let mut levels = Hierarchy::new(mesh.clone(), &FeatureOptions::default());
                for seed in seeds {
                    let marks = random_marks(&levels.finest().topology, seed);
                    levels.split_red_green(&marks, Diagonal::Inherit).unwrap();
                }
                levels.into_finest().mesh
            })
        };
        prop_assert!(run(1) == run(3));
    }
}

/// Marks the same share of random tets in each round.
fn random_rounds(
    mesh: TetMesh,
    rounds: usize,
    split: fn(&mut Hierarchy, &MarkedEdges),
) -> Hierarchy {
    let mut levels = Hierarchy::new(mesh, &FeatureOptions::default());
    let mut random = Random::new(77);
    for _ in 0..rounds {
        let topology = &levels.finest().topology;
        let mut marks = MarkedEdges::new(topology);
        let tets = 0..topology.tet_edges().len() as u32;
        marks.mark_tets(topology, tets.filter(|_| random.below(30) == 0));
        split(&mut levels, &marks);
    }
    levels
}

/// The mean ratios of all tets, which tell shapes apart.
fn shapes_of(mesh: &TetMesh) -> BTreeSet<i64> {
    let ratios = quality::mean_ratios(mesh.raw());
    ratios.into_iter().map(|ratio| (ratio * 1e9).round() as i64).collect()
}

/// The shapes of a tet of the Kuhn lattice, and of its parts for all marks and all
/// numberings of its vertices, which decide between edges of equal length.
fn shapes_of_one_split() -> BTreeSet<i64> {
    let path = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0; 3]];
    let mut shapes = BTreeSet::new();
    for code in 0..256usize {
        let order = [0, 1, 2, 3].map(|place| code >> (2 * place) & 3);
        if BTreeSet::from(order).len() < 4 {
            continue;
        }
        let tet = common::as_ordered(order.map(|v| path[v]).to_vec(), vec![[0, 1, 2, 3]]);
        let topology = Topology::new(tet.raw());
        for bits in 0..64u32 {
            let mut marks = MarkedEdges::new(&topology);
            marks.mark_edges((0..6).filter(|edge| bits >> edge & 1 == 1));
            let made = split_marked(&tet, &topology, &marks, Diagonal::ShortestEachLevel, 1);
            shapes.extend(shapes_of(&made.unwrap().0));
        }
    }
    shapes
}

/// Children of the red split of a Kuhn tet are Kuhn tets. So red-green refinement makes
/// no other shapes than one split of one tet does; patterns alone make ever more.
#[test]
fn shapes_are_those_of_one_split_however_many_rounds() {
    let few = shapes_of_one_split();
    let red_green = random_rounds(shapes::kuhn_cube(2), 6, |levels, marks| {
        levels.split_red_green(marks, Diagonal::Inherit).unwrap();
    });
    let found = shapes_of(&red_green.finest().mesh);
    assert!(found.len() > 10 && found.is_subset(&few), "{} of {}", found.len(), few.len());
    let patterns = random_rounds(shapes::kuhn_cube(2), 6, |levels, marks| {
        levels.split_marked(marks, Diagonal::Inherit).unwrap();
    });
    let found = shapes_of(&patterns.finest().mesh);
    assert!(found.len() > 2 * few.len(), "{} beside {}", found.len(), few.len());
}

/// After a uniform step, what is green is green no more, and that step is not undone.
#[test]
fn uniform_steps_are_not_undone() {
    let mut levels = Hierarchy::new(shapes::five_tet_cube(), &FeatureOptions::default());
    let mark = |levels: &Hierarchy| {
        let mut marks = MarkedEdges::new(&levels.finest().topology);
        marks.mark_edges([0, 3]);
        marks
    };
    levels.split_red_green(&mark(&levels), Diagonal::Inherit).unwrap();
    levels.subdivide(Scheme::Linear).unwrap();
    let before = levels.clone();
    assert_eq!(levels.split_red_green(&mark(&levels), Diagonal::Inherit), Ok(3));
    assert!(before.levels().iter().zip(levels.levels()).all(|(p, q)| std::sync::Arc::ptr_eq(p, q)));
    assert_eq!(levels.split_red_green(&mark(&levels), Diagonal::Inherit), Ok(3));
}

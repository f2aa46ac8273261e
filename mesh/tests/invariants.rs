//! What must hold on any mesh: random blocks with holes, regions, tags,
//! orders and numberings.

mod common;

use common::random_block::blocks;
use octruss_mesh::{
    CheckOptions, FeatureOptions, GroupBorders, Hierarchy, Level, Scheme, SubdivideError, TetMesh,
    Topology, check, shapes, subdivision_matrix,
};
use proptest::prelude::*;
use proptest::sample::select;

fn boundary_vertices(topology: &Topology) -> Vec<bool> {
    let mut on_boundary = vec![false; topology.vertex_count()];
    for face in (0..topology.faces().len()).filter(|&f| topology.is_boundary(f)) {
        for v in topology.faces()[face] {
            on_boundary[v as usize] = true;
        }
    }
    on_boundary
}

/// Subdivides unless random shapes invert: then there is nothing to look at.
fn subdivided(mesh: &TetMesh, schemes: &[Scheme]) -> Option<Hierarchy> {
    let mut levels = Hierarchy::new(mesh.clone(), &FeatureOptions::default());
    for &scheme in schemes {
        match levels.subdivide(scheme) {
            Ok(()) => {}
            Err(SubdivideError::Inverted { .. }) => return None,
            Err(other) => panic!("{other}"),
        }
    }
    Some(levels)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn topology_from_the_parents_equals_topology_from_scratch(mesh in blocks()) {
        let levels = subdivided(&mesh, &[Scheme::Linear, Scheme::Linear]).expect("midpoints invert nothing");
        for level in levels.levels() {
            let Level { mesh, topology, .. } = &**level;
            prop_assert!(*topology == Topology::new(mesh.raw()));
        }
    }

    #[test]
    fn rows_sum_to_one_and_boundary_rows_read_boundary_only(mesh in blocks(), group_curves: bool, group_borders in select(&GroupBorders::ALL[..])) {
        let options = FeatureOptions { group_curves, group_borders, ..FeatureOptions::default() };
        let levels = Hierarchy::new(mesh, &options);
        let Level { mesh, topology, .. } = levels.coarsest();
        let on_boundary = boundary_vertices(topology);
        let mut boundary_edges = vec![false; topology.edges().len()];
        for face in (0..topology.faces().len()).filter(|&f| topology.is_boundary(f)) {
            topology.face_edges()[face].iter().for_each(|&e| boundary_edges[e as usize] = true);
        }
        let n = mesh.points().len();
        for scheme in Scheme::ALL {
            let matrix = subdivision_matrix(mesh, topology, scheme);
            prop_assert_eq!((matrix.rows(), matrix.columns()), (n + topology.edges().len(), n));
            for row in 0..matrix.rows() {
                let (columns, weights) = matrix.row(row);
                prop_assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-13, "{scheme:?}");
                prop_assert!(scheme.overshoots() || weights.iter().all(|&w| w > 0.0), "{scheme:?}");
                prop_assert!(columns.is_sorted_by(|a, b| a < b));
                let is_boundary = if row < n { on_boundary[row] } else { boundary_edges[row - n] };
                if is_boundary {
                    prop_assert!(columns.iter().all(|&c| on_boundary[c as usize]), "{scheme:?} row {row}");
                }
            }
        }
    }

    #[test]
    fn tags_regions_and_volume_survive_a_linear_split(mesh in blocks()) {
        let levels = subdivided(&mesh, &[Scheme::Linear]).expect("midpoints invert nothing");
        let (coarse, fine) = (&levels.coarsest().mesh, &levels.finest().mesh);
        let topology = &levels.levels()[1].topology;
        prop_assert_eq!(fine.groups(), coarse.groups());
        let refinement = levels.refinement(0);
        prop_assert_eq!(fine.regions(), refinement.inherit(coarse.regions(), 1));
        for t in 0..fine.tets().len() {
            let parent = refinement.parent(t as u32) as usize;
            prop_assert!((8.0 * fine.volume(t) - coarse.volume(parent)).abs() < 1e-12);
        }
        for id in coarse.triangles().ids() {
            let count = |m: &TetMesh| m.triangles().tags.iter().filter(|&&tag| tag == id).count();
            prop_assert_eq!(count(fine), 4 * count(coarse));
        }
        let part_of = |part| refinement.ancestry.triangles.parent(part as u32) as usize;
        // Each part of a tagged triangle is a face of the fine mesh, with the
        // parent's normal; each part of a tagged edge is an edge.
        for (part, (fine_triangle, _)) in fine.triangles().iter().enumerate() {
            prop_assert!(topology.face_of(fine_triangle).is_some());
            let coarse_triangle = coarse.triangles().simplices[part_of(part)];
            let (p, q) = (normal(fine, fine_triangle), normal(coarse, coarse_triangle));
            prop_assert!((0..3).all(|k| (4.0 * p[k] - q[k]).abs() < 1e-12));
        }
        for &[a, b] in &fine.edges().simplices {
            prop_assert!(topology.edge_between(a, b).is_some());
        }
    }

    #[test]
    fn results_are_the_same_bits_for_any_number_of_threads(mesh in blocks()) {
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| subdivided(&mesh, &[Scheme::BoxSpline, Scheme::Linear]).map(|levels| {
                (levels.finest().mesh.clone(), levels.levels()[2].topology.clone(), levels.refinement(0).matrix.clone())
            }))
        };
        let one = run(1);
        prop_assert!(one == run(2) && one == run(3));
    }
}

#[test]
fn many_chunks_are_the_same_bits_for_any_number_of_threads() {
    let mut raw = shapes::kuhn_cube(12).into_raw();
    for (i, x) in raw.points.as_flattened_mut().iter_mut().enumerate() {
        *x += 0.01 * (i as f64).sin();
    }
    let mesh = check(raw, &CheckOptions::default()).unwrap().mesh;
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let levels = subdivided(&mesh, &[Scheme::BoxSpline]).expect("little displaced");
            let topology = Topology::new(levels.finest().mesh.raw());
            (levels.finest().mesh.clone(), topology, levels.refinement(0).matrix.clone())
        })
    };
    let one = run(1);
    assert!(one == run(2) && one == run(3));
}

fn normal(mesh: &TetMesh, triangle: [u32; 3]) -> [f64; 3] {
    let [a, b, c] = triangle.map(|v| nalgebra::Vector3::from(mesh.points()[v as usize]));
    (b - a).cross(&(c - a)).into()
}

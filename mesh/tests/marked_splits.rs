//! What must hold whatever edges of whatever mesh are marked, over several rounds: no
//! hanging nodes, the same volume, positive tets, tags where they were.

mod common;

use std::collections::BTreeMap;

use common::random_block::blocks;
use common::random_marks::random_marks;
use octruss_mesh::topology::NONE;
use octruss_mesh::{
    Ancestor, CheckOptions, Diagonal, FeatureOptions, Hierarchy, Level, Overshoot, Refinement,
    Scheme, TetMesh, Topology, check,
};
use proptest::prelude::*;

fn rounds(mesh: &TetMesh, seeds: &[u64]) -> Hierarchy {
    let mut levels = Hierarchy::new(mesh.clone(), &FeatureOptions::default());
    for &seed in seeds {
        let marks = random_marks(&levels.finest().topology, seed);
        let diagonal = Diagonal::ALL[(seed >> 60) as usize % 2];
        levels.split_marked(&marks, diagonal).expect("midpoints invert nothing");
        for edge in marks.edges() {
            let ancestry = &levels.refinement(levels.transfers() - 1).ancestry;
            assert!(ancestry.midpoint(edge).is_some(), "what is marked is split");
        }
    }
    levels
}

struct Pair<'a> {
    coarse: &'a Level,
    fine: &'a Level,
    refinement: &'a Refinement,
}

impl Pair<'_> {
    fn check(&self) {
        self.no_edge_ends_in_the_middle_of_another();
        self.faces_are_shared_or_on_the_boundary();
        self.volumes_add_up();
        self.tagged_triangles_cover_their_wholes();
        self.tagged_edges_and_creases_stay_edges();
        let plain = self.fine.mesh.raw().clone();
        check(plain, &CheckOptions::default()).expect("a sound mesh");
    }

    fn no_edge_ends_in_the_middle_of_another(&self) {
        for (edge, &[a, b]) in (0u32..).zip(self.coarse.topology.edges()) {
            let is_split = self.refinement.ancestry.midpoint(edge).is_some();
            assert_eq!(self.fine.topology.edge_between(a, b).is_none(), is_split);
        }
    }

    /// A face has one tet only if it lies in a face that had one.
    fn faces_are_shared_or_on_the_boundary(&self) {
        let Self { coarse, fine, refinement } = self;
        let mut tets_of: BTreeMap<[u32; 3], usize> = BTreeMap::new();
        for tet in fine.mesh.tets() {
            for without in 0..4 {
                let mut face: Vec<u32> =
                    tet.iter().copied().filter(|&v| v != tet[without]).collect();
                face.sort_unstable();
                *tets_of.entry(face.try_into().unwrap()).or_default() += 1;
            }
        }
        let ancestors = refinement.ancestry.of_faces(&coarse.topology, &fine.topology);
        for (face, ancestor) in fine.topology.faces().iter().zip(ancestors) {
            let before = match ancestor {
                Ancestor::Face(face) => {
                    let tets = coarse.topology.face_tets()[face as usize];
                    tets.iter().filter(|&&tet| tet != NONE).count()
                }
                _ => 2,
            };
            assert_eq!(tets_of.get(face).copied().unwrap_or(0), before);
        }
    }

    fn volumes_add_up(&self) {
        let Self { coarse, fine, refinement } = self;
        for tet in 0..coarse.mesh.tets().len() {
            let parts = refinement.children(tet as u32);
            let volume: f64 = parts.map(|part| fine.mesh.volume(part as usize)).sum();
            assert!((volume - coarse.mesh.volume(tet)).abs() < 1e-12);
        }
        assert!((0..fine.mesh.tets().len()).all(|tet| fine.mesh.volume(tet) > 0.0));
        assert_eq!(fine.mesh.regions(), refinement.inherit(coarse.mesh.regions(), 1));
    }

    /// Their normals add up, and they are faces of as many tets.
    fn tagged_triangles_cover_their_wholes(&self) {
        let Self { coarse, fine, refinement } = self;
        let lineage = &refinement.ancestry.triangles;
        for (whole, (triangle, tag)) in (0u32..).zip(coarse.mesh.triangles().iter()) {
            let mut sum = [0.0; 3];
            let tets = |level: &Level, triangle| {
                let face = level.topology.face_of(triangle).expect("its own face");
                level.topology.face_tets()[face as usize].map(|tet| tet != NONE)
            };
            for part in lineage.children(whole) {
                let own = fine.mesh.triangles().simplices[part as usize];
                assert_eq!(fine.mesh.triangles().tags[part as usize], tag);
                let normal = normal(&fine.mesh, own);
                let size = |n: [f64; 3]| n.iter().map(|x| x * x).sum::<f64>();
                assert!(size(normal) > 0.0);
                sum = [0, 1, 2].map(|k| sum[k] + normal[k]);
                assert_eq!(tets(fine, own), tets(coarse, triangle));
            }
            let expected = normal(&coarse.mesh, triangle);
            assert!((0..3).all(|k| (sum[k] - expected[k]).abs() < 1e-12));
        }
    }

    fn tagged_edges_and_creases_stay_edges(&self) {
        let Self { coarse, fine, refinement } = self;
        let halves = |level: &Level, edge| refinement.ancestry.midpoint(edge_of(level, edge));
        let edges = &refinement.ancestry.edges;
        for (whole, (ends, tag)) in (0u32..).zip(coarse.mesh.edges().iter()) {
            let parts: Vec<_> = edges.children(whole).collect();
            assert_eq!(parts.len(), 1 + usize::from(halves(coarse, ends).is_some()));
            assert!(parts.iter().all(|&part| fine.mesh.edges().tags[part as usize] == tag));
            let first = fine.mesh.edges().simplices[parts[0] as usize];
            let last = fine.mesh.edges().simplices[parts[parts.len() - 1] as usize];
            assert_eq!([first[0], last[1]], ends);
        }
        let features = [coarse, fine].map(|level| level.mesh.features().unwrap());
        let mut expected: Vec<[u32; 2]> = Vec::new();
        for &[a, b] in &features[0].creases {
            match halves(coarse, [a, b]) {
                Some(middle) => expected.extend([[a, middle], [b, middle]]),
                None => expected.push([a, b]),
            }
        }
        expected.sort_unstable();
        assert_eq!(features[1].creases, expected);
        let mut of_tets = vec![false; fine.topology.edges().len()];
        fine.topology.tet_edges().as_flattened().iter().for_each(|&e| of_tets[e as usize] = true);
        let free = |edge: &[u32; 2]| !of_tets[edge_of(fine, *edge) as usize];
        let free_before = {
            let mut of_tets = vec![false; coarse.topology.edges().len()];
            let edges = coarse.topology.tet_edges().as_flattened().iter();
            edges.for_each(|&e| of_tets[e as usize] = true);
            move |edge: &[u32; 2]| !of_tets[edge_of(coarse, *edge) as usize]
        };
        if !features[0].creases.iter().any(free_before) {
            assert!(!features[1].creases.iter().any(free));
        }
        assert_eq!(features[1].corners, features[0].corners);
        assert_eq!(features[1].surfaces, features[0].surfaces);
        assert_eq!(features[1].initial_quality, features[0].initial_quality);
        assert_eq!(fine.mesh.groups(), coarse.mesh.groups());
        assert_eq!(fine.mesh.vertices(), coarse.mesh.vertices());
    }
}

fn edge_of(level: &Level, [a, b]: [u32; 2]) -> u32 {
    level.topology.edge_between(a, b).expect("it is an edge")
}

fn normal(mesh: &TetMesh, triangle: [u32; 3]) -> [f64; 3] {
    let [a, b, c] = triangle.map(|v| mesh.points()[v as usize]);
    let (u, v) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_marks_leave_a_conforming_mesh(mesh in blocks(), seeds: [u64; 3]) {
        let levels = rounds(&mesh, &seeds);
        for transfer in 0..levels.transfers() {
            let [coarse, fine] = [transfer, transfer + 1].map(|level| &*levels.levels()[level]);
            Pair { coarse, fine, refinement: levels.refinement(transfer) }.check();
            prop_assert!(fine.topology == Topology::new(fine.mesh.raw()));
        }
    }

    /// Marks between uniform steps: fields that are linear stay so, on the linear matrix
    /// whatever the scheme asked for.
    #[test]
    fn linear_fields_are_carried_and_prolonged(mesh in blocks(), seed: u64) {
        let mut levels = rounds(&mesh, &[seed]);
        levels.subdivide(Scheme::Linear).expect("midpoints invert nothing");
        let value = |p: &[f64; 3]| 3.0 * p[0] - 2.0 * p[1] + p[2];
        let mut field: Vec<f64> = levels.coarsest().mesh.points().iter().map(value).collect();
        for refinement in levels.refinements() {
            field = refinement.carry_point_field(&field, 1, Overshoot::Clamp).values;
        }
        let exact = levels.finest().mesh.points().iter().map(value);
        prop_assert!(field.iter().zip(exact).all(|(found, value)| (found - value).abs() < 1e-12));
        for scheme in Scheme::ALL {
            let prolongation = levels.prolongation(0, scheme);
            prop_assert_eq!(&*prolongation.matrix, &levels.refinement(0).matrix);
            prop_assert!(levels.affine_defect(0, &prolongation.matrix) < 1e-14);
        }
    }

    #[test]
    fn results_are_the_same_bits_for_any_number_of_threads(mesh in blocks(), seeds: [u64; 2]) {
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| rounds(&mesh, &seeds).into_finest())
        };
        let (one, three) = (run(1), run(3));
        prop_assert!(one.mesh == three.mesh && one.topology == three.topology);
        prop_assert!(one.refinement == three.refinement);
    }
}

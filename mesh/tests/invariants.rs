//! What must hold on any mesh: random blocks with holes, regions, tags,
//! orders and numberings.

use octruss_mesh::{
    CheckOptions, FeatureOptions, Hierarchy, RawMesh, Scheme, SubdivideError, TetMesh, Topology,
    check, reference_tet::MARKING_PERMUTATIONS, shapes, subdivision_matrix,
};
use proptest::prelude::*;

/// A block of Kuhn cells that lost some tets, with random regions, marked
/// pairs, vertex numbers, displaced vertices, and free-standing simplices.
fn meshes() -> impl Strategy<Value = TetMesh> {
    let cells = prop::array::uniform3(1u32..4);
    (cells, any::<u64>()).prop_map(|(cells, seed)| {
        let mut random = Random(seed | 1);
        let mut raw = shapes::kuhn_box(cells, cells.map(f64::from)).into_raw();
        for point in raw.points.as_flattened_mut() {
            *point += 0.05 * (random.below(1000) as f64 / 500.0 - 1.0);
        }
        let keep: Vec<bool> = raw.tets.iter().map(|_| random.below(10) > 0).collect();
        let mut kept = keep.iter();
        raw.tets.retain(|_| *kept.next().unwrap());
        raw.regions = raw.tets.iter().map(|_| random.below(2) as i32).collect();
        raw.triangles.simplices.retain(|_| random.below(2) == 0);
        raw.triangles.tags.truncate(raw.triangles.simplices.len());
        renumber(&mut raw, &mut random);
        for tet in &mut raw.tets {
            let order = MARKING_PERMUTATIONS[random.below(3)];
            *tet = order.map(|v| tet[v]);
        }
        add_free_simplices(&mut raw);
        check(raw, &CheckOptions::default()).expect("a valid mesh").mesh
    })
}

struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        // xorshift64
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % n
    }
}

fn renumber(raw: &mut RawMesh, random: &mut Random) {
    let n = raw.points.len();
    let mut new: Vec<u32> = (0..n as u32).collect();
    for i in (1..n).rev() {
        new.swap(i, random.below(i + 1));
    }
    let old = raw.points.clone();
    for (v, point) in old.into_iter().enumerate() {
        raw.points[new[v] as usize] = point;
    }
    for v in
        raw.tets.as_flattened_mut().iter_mut().chain(raw.triangles.simplices.as_flattened_mut())
    {
        *v = new[*v as usize];
    }
}

/// A fin of one triangle that hangs on vertex 0, and a curve to nowhere.
fn add_free_simplices(raw: &mut RawMesh) {
    let n = raw.points.len() as u32;
    raw.points.extend([[-9.0, 0.0, 0.0], [-9.0, 1.0, 0.0], [-8.0, 0.0, 5.0]]);
    raw.triangles.push([n, 0, n + 1], 77);
    raw.edges.push([n + 2, 0], 78);
}

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
    fn topology_from_the_parents_equals_topology_from_scratch(mesh in meshes()) {
        let levels = subdivided(&mesh, &[Scheme::Linear, Scheme::Linear]).expect("midpoints invert nothing");
        for (mesh, topology) in levels.meshes.iter().zip(&levels.topologies) {
            prop_assert!(*topology == Topology::new(mesh.raw()));
        }
    }

    #[test]
    fn rows_sum_to_one_and_boundary_rows_read_boundary_only(mesh in meshes(), group_curves: bool, group_borders: bool) {
        let options = FeatureOptions { group_curves, group_borders, ..FeatureOptions::default() };
        let levels = Hierarchy::new(mesh, &options);
        let (mesh, topology) = (&levels.meshes[0], &levels.topologies[0]);
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
    fn tags_regions_and_volume_survive_a_linear_split(mesh in meshes()) {
        let levels = subdivided(&mesh, &[Scheme::Linear]).expect("midpoints invert nothing");
        let (coarse, fine) = (&levels.meshes[0], levels.finest());
        let topology = &levels.topologies[1];
        prop_assert_eq!(fine.groups(), coarse.groups());
        for (t, &region) in fine.regions().iter().enumerate() {
            prop_assert_eq!(region, coarse.regions()[levels.refinements[0].parent(t)]);
            prop_assert!((8.0 * fine.volume(t) - coarse.volume(t / 8)).abs() < 1e-12);
        }
        for id in coarse.triangles().ids() {
            let count = |m: &TetMesh| m.triangles().tags.iter().filter(|&&tag| tag == id).count();
            prop_assert_eq!(count(fine), 4 * count(coarse));
        }
        // Each part of a tagged triangle is a face of the fine mesh, with the
        // parent's normal; each part of a tagged edge is an edge.
        for (part, (fine_triangle, _)) in fine.triangles().iter().enumerate() {
            prop_assert!(topology.face_of(fine_triangle).is_some());
            let coarse_triangle = coarse.triangles().simplices[part / 4];
            let (p, q) = (normal(fine, fine_triangle), normal(coarse, coarse_triangle));
            prop_assert!((0..3).all(|k| (4.0 * p[k] - q[k]).abs() < 1e-12));
        }
        for &[a, b] in &fine.edges().simplices {
            prop_assert!(topology.edge_between(a, b).is_some());
        }
    }

    #[test]
    fn results_are_the_same_bits_for_any_number_of_threads(mesh in meshes()) {
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| subdivided(&mesh, &[Scheme::BoxSpline, Scheme::Linear]).map(|levels| {
                (levels.finest().clone(), levels.topologies[2].clone(), levels.refinements[0].matrix.clone())
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
            let topology = Topology::new(levels.finest().raw());
            (levels.finest().clone(), topology, levels.refinements[0].matrix.clone())
        })
    };
    let one = run(1);
    assert!(one == run(2) && one == run(3));
}

fn normal(mesh: &TetMesh, triangle: [u32; 3]) -> [f64; 3] {
    let [a, b, c] = triangle.map(|v| nalgebra::Vector3::from(mesh.points()[v as usize]));
    (b - a).cross(&(c - a)).into()
}

//! What splitting at marked edges makes of single tets, lattices and triangles, by
//! closed forms and beside the uniform split.

mod common;

use common::{as_ordered, hierarchy};
use octruss_mesh::reference_tet::{EDGES, MARKED, MARKING_PERMUTATIONS};
use octruss_mesh::{
    CellState, Diagonal, FeatureOptions, Hierarchy, MarkedEdges, RawMesh, Scheme, Step, TetMesh,
    Topology, check, prepare, quality, shapes, split_marked,
};

fn split(mesh: &TetMesh, edges: impl IntoIterator<Item = [u32; 2]>) -> TetMesh {
    let topology = Topology::new(mesh.raw());
    let mut marks = MarkedEdges::new(&topology);
    marks.mark_edges(edges.into_iter().map(|[a, b]| topology.edge_between(a, b).unwrap()));
    split_marked(mesh, &topology, &marks, Diagonal::Inherit, 1).unwrap().0
}

/// The edges of local vertices whose bits are set.
fn edges_of(bits: u8) -> Vec<[u32; 2]> {
    let set = (0..6).filter(|edge| bits >> edge & 1 == 1);
    set.map(|edge: usize| EDGES[edge].map(|v| v as u32)).collect()
}

/// The tets of a regular tet for each of the 64 sets of marked edges 01, 02, 03, 12, 13,
/// 23 (bit 0 to 5). All edges are equally long, so those of smaller vertices go first.
#[test]
fn a_regular_tet_has_these_numbers_of_parts() {
    #[rustfmt::skip]
    const PARTS: [usize; 64] = [
        1, 2, 2, 3, 2, 3, 3, 4, // none, and edges at vertex 0
        2, 3, 3, 4, 4, 4, 4, 8, // with 12
        2, 3, 4, 4, 3, 4, 5, 8, // with 13
        3, 4, 5, 8, 5, 8, 8, 8, // with 12 and 13
        2, 4, 3, 5, 3, 5, 4, 8, // with 23
        3, 5, 4, 8, 5, 8, 8, 8, // with 12 and 23
        3, 5, 5, 8, 4, 8, 8, 8, // with 13 and 23
        4, 8, 8, 8, 8, 8, 8, 8, // with 12, 13 and 23
    ];
    let tet = shapes::regular_tet();
    let found: Vec<usize> = (0..64).map(|bits| split(&tet, edges_of(bits)).tets().len()).collect();
    assert_eq!(found, PARTS);
}

/// The same from what the edges have in common.
#[test]
fn the_number_of_parts_follows_from_how_marked_edges_meet() {
    let tet = shapes::regular_tet();
    for bits in 0..64 {
        let edges = edges_of(bits);
        let shared = |p: &[u32; 2], q: &[u32; 2]| p.iter().any(|v| q.contains(v));
        let at = |v: u32| edges.iter().filter(|ends| ends.contains(&v)).count();
        let expected = match edges.len() {
            count @ (0 | 1) => count + 1,
            2 if shared(&edges[0], &edges[1]) => 3,
            2 => 4,
            // All in a face, or all at a vertex.
            3 if (0..4).any(|v| at(v) == 0 || at(v) == 3) => 4,
            // A path: both parts of a bisection at its middle edge have one other edge;
            // at an end, one part has the middle edge and the other end, one that end.
            3 => {
                let is_middle = edges[1..].iter().all(|other| shared(&edges[0], other));
                if is_middle { 4 } else { 5 }
            }
            _ => 8,
        };
        assert_eq!(split(&tet, edges).tets().len(), expected, "{bits:06b}");
    }
}

/// A tet with the edge 23 the longest by far, then 13, then 12.
#[test]
fn longer_edges_are_bisected_first() {
    let points = vec![[0.0, 0.0, 1.0], [0.0, 3.0, 0.0], [-4.0, 0.0, 0.0], [9.0, 0.0, 0.0]];
    let tet = as_ordered(points, vec![[0, 1, 2, 3]]);
    // 12 is 5 long, 13 is √90, and 23 is 13: 23 goes first, and its middle is joined to 1.
    let fine = split(&tet, [[1, 3], [2, 3]]);
    let topology = Topology::new(fine.raw());
    // The midpoint of 13 is vertex 4, that of 23 is 5.
    assert!(topology.edge_between(1, 5).is_some() && topology.edge_between(2, 4).is_none());
    let fine = split(&tet, [[1, 2], [1, 3]]);
    let topology = Topology::new(fine.raw());
    assert!(topology.edge_between(2, 5).is_some() && topology.edge_between(3, 4).is_none());
}

#[test]
fn all_edges_marked_give_the_uniform_split() {
    let mut random = common::random_block::Random::new(5);
    let mut rough = shapes::kuhn_cube(3).into_raw();
    rough.points.as_flattened_mut().iter_mut().for_each(|x| *x += 1e-4 * random.below(500) as f64);
    rough.points.extend([[5.0, 0.0, 0.0], [5.0, 1.0, 0.0]]);
    rough.triangles.push([65, 3, 64], 8);
    rough.edges.push([9, 64], 8);
    let rough = check(rough, &Default::default()).unwrap().mesh;
    for mesh in [shapes::five_tet_cube(), rough] {
        for diagonal in Diagonal::ALL {
            let mut uniform = Hierarchy::new(mesh.clone(), &FeatureOptions::default());
            let mut marked = uniform.clone();
            for _ in 0..2 {
                let step = Step { diagonal, ..Scheme::Linear.into() };
                uniform.subdivide(step).unwrap();
                let all = MarkedEdges::all(&marked.finest().topology);
                marked.split_marked(&all, diagonal).unwrap();
            }
            assert_eq!(marked.finest().mesh, uniform.finest().mesh);
            assert!(marked.finest().topology == uniform.finest().topology);
            assert_eq!(marked.refinement(1).matrix, uniform.refinement(1).matrix);
        }
    }
}

#[test]
fn no_marks_leave_the_mesh_as_it_is() {
    let mesh = prepare(shapes::kuhn_cube(2), &FeatureOptions::default());
    let topology = Topology::new(mesh.raw());
    let none = MarkedEdges::new(&topology);
    let (fine, fine_topology, refinement) =
        split_marked(&mesh, &topology, &none, Diagonal::ShortestEachLevel, 1).unwrap();
    assert_eq!(fine, mesh);
    assert!(fine_topology == topology);
    assert_eq!(refinement.matrix.nonzeros(), mesh.points().len());
}

/// Free triangles are bisected, or quartered from two marked edges on; as faces of tets
/// they follow these, which may be bisected twice.
#[test]
fn triangles_are_bisected_or_quartered() {
    let mut raw = shapes::regular_tet().into_raw();
    raw.points.extend([[9.0, 0.0, 0.0], [9.0, 1.0, 0.0], [9.0, 0.0, 1.0]]);
    raw.triangles.push([4, 6, 5], 7);
    raw.triangles.push([0, 1, 2], 8);
    let mesh = check(raw, &Default::default()).unwrap().mesh;
    let parts = |edges: &[[u32; 2]], tag| {
        let fine = split(&mesh, edges.iter().copied());
        fine.triangles().tags.iter().filter(|&&own| own == tag).count()
    };
    let edges = [[4, 5], [4, 6], [5, 6]];
    assert_eq!([0, 1, 2, 3].map(|count| parts(&edges[..count], 7)), [1, 2, 4, 4]);
    let edges = [[0, 1], [0, 2], [1, 2]];
    assert_eq!([0, 1, 2, 3].map(|count| parts(&edges[..count], 8)), [1, 2, 3, 4]);
}

/// A closed form for a lattice: a marked tet inside splits into 8, the 4 across its faces
/// into 4 each, and the others round its edges into 2 each.
#[test]
fn one_tet_of_a_lattice_splits_itself_its_neighbours_and_those_round_its_edges() {
    let levels = hierarchy(prepare(shapes::kuhn_cube(5), &FeatureOptions::default()));
    let topology = &levels.coarsest().topology;
    let inner = |tet: &[u32; 4]| {
        let points = tet.map(|v| levels.coarsest().mesh.points()[v as usize]);
        points.as_flattened().iter().all(|x| (0.3..0.7).contains(x))
    };
    let tets = levels.coarsest().mesh.tets();
    let marked = tets.iter().position(inner).expect("a tet of the middle cell") as u32;
    let mut finer = levels.clone();
    let mut marks = MarkedEdges::new(topology);
    marks.mark_tets(topology, [marked]);
    finer.split_marked(&marks, Diagonal::Inherit).unwrap();
    let count = |parts| {
        let has = |&tet: &u32| finer.refinement(0).children(tet).len() == parts;
        (0..tets.len() as u32).filter(has).count()
    };
    // Round its edges there are 4 · 6 + 2 · 4 tets: it is six of them, and each of its 4
    // neighbours three. Nobody else has two of its edges.
    assert_eq!([8, 4, 2].map(count), [1, 4, 4 * 6 + 2 * 4 - 6 - 4 * 3]);
}

/// A ball of marked tets in a rough box. If what has no pattern in the sources were split into
/// eight, that would spread; bisections hold it off.
#[test]
fn a_marked_ball_does_not_flood_the_mesh() {
    let mut random = common::random_block::Random::new(11);
    let mut raw = shapes::kuhn_box([7, 7, 8], [7.0, 7.0, 8.0]).into_raw();
    let mut shift = || 0.4 * (random.below(1000) as f64 / 1000.0 - 0.5);
    raw.points.as_flattened_mut().iter_mut().for_each(|x| *x += shift());
    let mesh = check(raw, &Default::default()).unwrap().mesh;
    let topology = Topology::new(mesh.raw());
    let centre = |tet: &[u32; 4]| {
        let sum = tet.map(|v| mesh.points()[v as usize]);
        [0, 1, 2].map(|k| sum.iter().map(|p| p[k]).sum::<f64>() / 4.0)
    };
    let is_inside = |tet: &[u32; 4]| {
        let [x, y, z] = centre(tet);
        (x - 3.5).hypot(y - 3.5).hypot(z - 4.0) < 2.4
    };
    let ball: Vec<u32> =
        (0u32..).zip(mesh.tets()).filter(|(_, tet)| is_inside(tet)).map(|(t, _)| t).collect();
    assert!((300..400).contains(&ball.len()), "{} tets", ball.len());
    let mut marks = MarkedEdges::new(&topology);
    marks.mark_tets(&topology, ball.iter().copied());
    let (fine, _, refinement) =
        split_marked(&mesh, &topology, &marks, Diagonal::Inherit, 1).unwrap();
    let red =
        (0..mesh.tets().len() as u32).filter(|&tet| refinement.children(tet).len() == 8).count();
    assert!(ball.len() <= red && red < 500, "{red} red for {} marked", ball.len());
    assert!(fine.tets().len() < 6500, "{} tets", fine.tets().len());
    let flooded = red_where_no_pattern_of_the_sources_fits(&topology, &marks);
    assert!(flooded > 2 * red, "{flooded} beside {red}");
}

/// How many tets would be split into eight if only one edge, and the three of a face, had
/// patterns of their own.
fn red_where_no_pattern_of_the_sources_fits(topology: &Topology, marks: &MarkedEdges) -> usize {
    let mut marks = marks.clone();
    let marked = |marks: &MarkedEdges, edges: &[u32]| {
        edges.iter().filter(|&&edge| marks.contains(edge)).count()
    };
    loop {
        let before = marks.count();
        for (edges, faces) in topology.tet_edges().iter().zip(topology.tet_faces()) {
            let has_face = || {
                let edges = faces.map(|face| topology.face_edges()[face as usize]);
                edges.iter().any(|edges| marked(&marks, edges) == 3)
            };
            match marked(&marks, edges) {
                0 | 1 => {}
                3 if has_face() => {}
                _ => marks.mark_edges(*edges),
            }
        }
        if marks.count() == before {
            return topology.tet_edges().iter().filter(|edges| marked(&marks, *edges) == 6).count();
        }
    }
}

/// Parts of bisected and quartered tets mark the pair with the shortest diagonal.
#[test]
fn parts_mark_their_shortest_pair() {
    let points = vec![[0.0; 3], [5.0, 0.0, 0.0], [1.0, 3.0, 0.0], [2.0, 1.0, 1.0]];
    let tet = as_ordered(points, vec![[0, 1, 2, 3]]);
    for bits in 1..64 {
        let fine = split(&tet, edges_of(bits));
        if fine.tets().len() == 8 {
            continue;
        }
        for t in 0..fine.tets().len() {
            let diagonal = |order: [usize; 4]| {
                let corners = fine.corners(t);
                let ends = MARKED.map(|e| EDGES[e].map(|v| corners[order[v]]));
                let middle = |ends: [[f64; 3]; 2], k: usize| ends[0][k] + ends[1][k];
                (0..3).map(|k| (middle(ends[0], k) - middle(ends[1], k)).powi(2)).sum::<f64>()
            };
            let [marked, others @ ..] = MARKING_PERMUTATIONS.map(diagonal);
            assert!(others.iter().all(|other| marked <= other * (1.0 + 1e-8)));
        }
    }
}

/// The worst part of each pattern: that has the mean ratio 6 v^(2/3) / s, where v is its
/// share of the volume and s the sum of its squared edges over that of one edge of the whole.
#[test]
fn a_regular_tet_is_left_with_these_qualities() {
    let tet = shapes::regular_tet();
    let worst = |edges: &[[u32; 2]]| {
        let fine = split(&tet, edges.iter().copied());
        (fine.tets().len(), quality::smallest_mean_ratio(fine.raw()))
    };
    const ALL: [[u32; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
    let rows: [(&[[u32; 2]], usize, f64, f64); 8] = [
        (&[[0, 1]], 2, 0.5, 4.75),
        // Two at a vertex, opposite to each other.
        (&[[0, 1], [0, 2]], 3, 0.25, 3.75),
        (&[[0, 1], [2, 3]], 4, 0.25, 3.5),
        // Three at a vertex, in a row with the middle one or an end first, of a face.
        (&[[0, 1], [0, 2], [0, 3]], 4, 0.125, 2.5),
        (&[[0, 1], [1, 2], [0, 3]], 4, 0.25, 3.75),
        (&[[0, 1], [1, 2], [2, 3]], 5, 0.125, 2.75),
        (&[[0, 1], [0, 2], [1, 2]], 4, 0.25, 3.25),
        (&ALL, 8, 0.125, 1.75),
    ];
    for (edges, parts, share, sum) in rows {
        let (found, worst) = worst(edges);
        assert_eq!(found, parts);
        assert!((worst - 6.0 * f64::powf(share, 2.0 / 3.0) / sum).abs() < 1e-12, "{edges:?}");
    }
}

/// In a lattice that was split once: an octahedron of which one quarter is split is none
/// any more, all others stay.
#[test]
fn octahedra_stay_or_go_as_wholes() {
    let mut levels = hierarchy(prepare(shapes::kuhn_cube(3), &FeatureOptions::default()));
    levels.subdivide(Scheme::Linear).unwrap();
    let states = |mesh: &TetMesh| {
        let all = mesh.features().unwrap().cell_states.clone();
        assert_eq!(all.len(), mesh.tets().len());
        all
    };
    let before = states(&levels.finest().mesh);
    let quarter = before.iter().position(|&state| state != CellState::Tetrahedron).unwrap();
    let topology = levels.finest().topology.clone();
    // The edge opposite the diagonal is in this one quarter of its octahedron only.
    let diagonal = before[quarter].diagonal().unwrap();
    let mut marks = MarkedEdges::new(&topology);
    marks.mark_edges([topology.tet_edges()[quarter][5 - diagonal]]);
    levels.split_marked(&marks, Diagonal::Inherit).unwrap();
    let refinement = levels.refinement(1);
    let after = states(&levels.finest().mesh);
    // Whose diagonal a split tet has.
    let mut broken = vec![false; topology.edges().len()];
    let own = |tet: usize| before[tet].diagonal().map(|local| topology.tet_edges()[tet][local]);
    let parts = |tet: usize| refinement.children(tet as u32);
    for tet in (0..before.len()).filter(|&tet| parts(tet).len() > 1) {
        own(tet).into_iter().for_each(|edge| broken[edge as usize] = true);
    }
    assert!(broken.contains(&true));
    for tet in 0..before.len() {
        let stays = parts(tet).len() == 1 && own(tet).is_none_or(|edge| !broken[edge as usize]);
        let expected = if stays { before[tet] } else { CellState::Tetrahedron };
        assert!(parts(tet).all(|part| after[part as usize] == expected));
    }
    // A scheme that looks at octahedra goes on from there.
    levels.subdivide(Scheme::Averaged).unwrap();
    let plain = RawMesh { features: None, ..levels.finest().mesh.raw().clone() };
    check(plain, &Default::default()).unwrap();
}

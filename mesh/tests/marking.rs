//! Marked pairs: agreement across faces, and the edges that follow from it.

mod common;

use std::array::from_fn;

use octruss_base::choice::Named;
use octruss_mesh::analysis::stars::{Marks, edge_ring};
use octruss_mesh::marking::mark;
use octruss_mesh::reference_tet::{EDGES, MARKED, MARKING_PERMUTATIONS, six_volumes};
use octruss_mesh::{
    CheckOptions, Diagonal, FeatureOptions, Hierarchy, Marking, MarkingReport, RawMesh, Scheme,
    Step, TetMesh, Topology, check, marking_report, prepare, shapes,
};

/// A number for a place and a purpose, as good as random (the end of splitmix64).
fn scatter(place: usize, purpose: u64) -> u64 {
    let mut bits = (place as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (purpose << 32);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// The mesh with vertices and tets in another order, and each tet marked at random.
fn shuffled(mesh: TetMesh, seed: u64) -> RawMesh {
    let mut old: Vec<usize> = (0..mesh.points().len()).collect();
    old.sort_by_key(|&v| scatter(v, seed));
    let mut new = vec![0; old.len()];
    old.iter().enumerate().for_each(|(place, &v)| new[v] = place as u32);
    let mut tets: Vec<[u32; 4]> =
        mesh.tets().iter().map(|tet| tet.map(|v| new[v as usize])).collect();
    tets.sort_by_key(|tet| scatter(tet[0] as usize + 1000 * tet[1] as usize, seed + 1));
    RawMesh {
        points: old.iter().map(|&v| mesh.points()[v]).collect(),
        regions: vec![0; tets.len()],
        tets: tets.iter().enumerate().map(|(t, tet)| marked_at_random(t, tet)).collect(),
        ..RawMesh::default()
    }
}

fn marked_at_random(t: usize, tet: &[u32; 4]) -> [u32; 4] {
    MARKING_PERMUTATIONS[scatter(t, 77) as usize % 3].map(|v| tet[v])
}

/// A block without any lattice: displaced vertices, and two tets on a face
/// replaced by three round a new edge wherever that is possible, three times.
fn irregular() -> RawMesh {
    let mut raw = shapes::kuhn_cube(6).into_raw();
    raw.triangles = Default::default();
    for (v, point) in raw.points.iter_mut().enumerate() {
        for (k, x) in point.iter_mut().enumerate() {
            let inside = *x > 0.0 && *x < 1.0;
            let shift = (scatter(3 * v + k, 5) % 1000) as f64 / 999.0 - 0.5;
            *x += if inside { 0.08 * shift } else { 0.0 };
        }
    }
    for round in 0..3 {
        flip_faces(&mut raw, round);
    }
    raw.tets = raw.tets.iter().enumerate().map(|(t, tet)| marked_at_random(t, tet)).collect();
    raw
}

fn flip_faces(raw: &mut RawMesh, seed: u64) {
    let topology = Topology::new(raw);
    let mut faces: Vec<usize> =
        (0..topology.faces().len()).filter(|&f| !topology.is_boundary(f)).collect();
    faces.sort_by_key(|&face| scatter(face, seed));
    let mut gone = vec![false; raw.tets.len()];
    for face in faces {
        let [p, q] = topology.face_tets()[face].map(|t| t as usize);
        let [a, b, c] = topology.faces()[face];
        let apex = |t: usize| raw.tets[t].iter().find(|v| ![a, b, c].contains(v));
        let (Some(&d), Some(&e)) = (apex(p), apex(q)) else { continue };
        let [d, e] = if volume(raw, [a, b, c, d]) > 0.0 { [d, e] } else { [e, d] };
        let three = [[a, b, e, d], [b, c, e, d], [c, a, e, d]];
        if !gone[p] && !gone[q] && three.iter().all(|&tet| volume(raw, tet) > 2e-4) {
            raw.tets[p] = three[0];
            raw.tets[q] = three[1];
            raw.tets.push(three[2]);
            raw.regions.push(0);
            gone[p] = true;
            gone[q] = true;
        }
    }
}

fn volume(raw: &RawMesh, tet: [u32; 4]) -> f64 {
    six_volumes(tet.map(|v| raw.points[v as usize]))
}

fn report_after(raw: &RawMesh, marking: Marking) -> MarkingReport {
    let mut raw = raw.clone();
    let topology = Topology::new(&raw);
    mark(&mut raw, &topology, marking);
    marking_report(&Topology::new(&raw))
}

#[test]
fn a_shuffled_kuhn_cube_is_marked_without_conflicts() {
    for seed in 0..12 {
        let raw = shuffled(shapes::kuhn_cube(3), seed);
        for marking in [Marking::Agree, Marking::Shortest] {
            let report = report_after(&raw, marking);
            assert_eq!((report.conflicting_faces, report.interior_faces), (0, 270), "{marking:?}");
        }
        // Random marks agree on about a third of the faces.
        assert!((160..200).contains(&report_after(&raw, Marking::AsOrdered).conflicting_faces));
    }
}

#[test]
fn a_kuhn_cube_keeps_its_agreeing_marks() {
    let cube = shapes::kuhn_cube(3);
    for marking in Marking::ALL {
        let options = FeatureOptions { marking, ..FeatureOptions::default() };
        assert_eq!(prepare(cube.clone(), &options).tets(), cube.tets(), "{marking:?}");
    }
}

#[test]
fn round_an_odd_edge_all_must_mark_it() {
    // Of the 3^k markings one has no conflict for odd k: all mark the edge.
    for k in [3, 5, 7] {
        let mut raw = edge_ring(k, Marks::Twist).into_raw();
        let topology = Topology::new(&raw);
        assert_eq!(marking_report(&topology).conflicting_faces, k as usize);
        mark(&mut raw, &topology, Marking::Agree);
        for tet in &raw.tets {
            assert!(MARKED.iter().any(|&e| EDGES[e].iter().all(|&v| tet[v] < 2)), "{tet:?}");
        }
        let report = marking_report(&Topology::new(&raw));
        assert_eq!((report.conflicting_faces, report.interior_faces), (0, k as usize));
        assert_eq!(report.edge_valences, [(k, 1)]);
    }
}

#[test]
fn agreement_beats_breadth_first_beats_chance_on_an_irregular_mesh() {
    let raw = irregular();
    let count = |marking| report_after(&raw, marking).conflicting_faces;
    // Of 3556 interior faces; at random two thirds conflict.
    assert_eq!(report_after(&raw, Marking::AsOrdered).interior_faces, 3556);
    assert!((2250..2450).contains(&count(Marking::AsOrdered)));
    assert!((850..1000).contains(&count(Marking::BreadthFirst)));
    assert!((1..720).contains(&count(Marking::Agree)));
}

#[test]
fn marking_permutes_evenly_and_the_shortest_has_no_shorter_diagonal() {
    let raw = irregular();
    let topology = Topology::new(&raw);
    for marking in Marking::ALL {
        let mut marked = raw.clone();
        mark(&mut marked, &topology, marking);
        for (before, after) in raw.tets.iter().zip(&marked.tets) {
            assert!(MARKING_PERMUTATIONS.iter().any(|order| order.map(|v| before[v]) == *after));
            if marking == Marking::Shortest {
                let lengths = MARKING_PERMUTATIONS.map(|order| {
                    let [a, b, c, d] = order.map(|v| raw.points[after[v] as usize]);
                    (0..3).map(|k| (a[k] + c[k] - b[k] - d[k]).powi(2)).sum::<f64>()
                });
                assert!(lengths.iter().all(|&other| lengths[0] <= other * (1.0 + 1e-8)));
            }
        }
        assert_eq!(RawMesh { tets: raw.tets.clone(), ..marked }, raw, "nothing else changes");
    }
}

#[test]
fn reports_foretell_the_edges_of_the_split_mesh() {
    for marking in [Marking::Agree, Marking::AsOrdered] {
        let mesh = check(irregular(), &CheckOptions::default()).unwrap().mesh;
        let options = FeatureOptions { marking, ..FeatureOptions::default() };
        let mut levels = Hierarchy::new(mesh, &options);
        levels.subdivide(Scheme::Linear).unwrap();
        let [before, after] = [0, 1].map(|level| marking_report(&levels.levels()[level].topology));
        assert_eq!(before.split_edge_valences, after.edge_valences);
        // A conflict in a face is handed on to its four parts; inside the tets
        // nothing conflicts.
        assert_eq!(after.conflicting_faces, 4 * before.conflicting_faces);
    }
}

/// How many tets surround the edges in the common face of two tets, apart from
/// those on its border, as (k, count), after each of three splits.
fn valences_in_a_face(second: [u32; 4]) -> Vec<Vec<(usize, usize)>> {
    let points =
        vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.3, 0.3, 1.0], [0.3, 0.3, -1.0]];
    let mesh = common::as_ordered(points, vec![[0, 1, 2, 3], second]);
    let mut levels = common::hierarchy(mesh);
    let mut found = Vec::new();
    for level in 1..=3 {
        levels.subdivide(Scheme::Linear).unwrap();
        let (mesh, topology) = (&levels.finest().mesh, &levels.levels()[level].topology);
        let in_face = |v: u32| mesh.points()[v as usize][2] == 0.0;
        let on_border = |v: u32| {
            let [x, y, _] = mesh.points()[v as usize];
            [x == 0.0, y == 0.0, x + y == 1.0]
        };
        let mut counts = [0; 8];
        for (edge, &[a, b]) in topology.edges().iter().enumerate() {
            let sides: [[bool; 3]; 2] = [on_border(a), on_border(b)];
            if in_face(a) && in_face(b) && !(0..3).any(|side| sides[0][side] && sides[1][side]) {
                let round = topology.tet_edges().as_flattened().iter();
                counts[round.filter(|&&e| e as usize == edge).count()] += 1;
            }
        }
        found.push((0..8).map(|k| (k, counts[k])).filter(|&(_, count)| count > 0).collect());
    }
    found
}

#[test]
fn an_agreeing_face_has_edges_of_four_and_six_tets_and_a_conflict_stays() {
    // The first tet marks 0-2 of the face; the second does, too, or marks 0-1.
    assert_eq!(
        valences_in_a_face([0, 1, 2, 4]),
        [[(4, 1), (6, 2)], [(4, 6), (6, 12)], [(4, 28), (6, 56)]]
    );
    assert_eq!(
        valences_in_a_face([0, 2, 1, 4]),
        [[(5, 2), (6, 1)], [(5, 12), (6, 6)], [(5, 56), (6, 28)]]
    );
}

#[test]
fn names_lead_back_to_their_choices() {
    for marking in Marking::ALL {
        assert_eq!(marking.name().parse(), Ok(Named(marking)));
    }
    for diagonal in Diagonal::ALL {
        assert_eq!(diagonal.name().parse(), Ok(Named(diagonal)));
    }
    assert!("longest".parse::<Named<Marking>>().is_err());
    let names: [&str; 4] = from_fn(|i| Marking::ALL[i].name());
    assert_eq!(names, ["shortest", "agree", "breadth-first", "as-ordered"]);
    assert_eq!(Step::from(Scheme::Linear).diagonal, Diagonal::default());
}

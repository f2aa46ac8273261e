//! Bodies that hang together by edges or single vertices: what can still move is named.

mod bodies;

use bodies::checked;
use octruss_fem::*;
use octruss_mesh::shapes::kuhn_cube;
use octruss_mesh::{FeatureOptions, Hierarchy, RawMesh, Scheme, TetMesh, Topology};

/// Unit cubes at these places, joined at equal points; the sides of cube k are tagged
/// 10 k + 1 to 10 k + 6: x = 0, x = 1, y = 0, …
fn cubes(places: &[[f64; 3]]) -> TetMesh {
    let mut raw = RawMesh::default();
    for (k, place) in places.iter().enumerate() {
        let cube = kuhn_cube(1);
        let mut number = |p: &[f64; 3]| {
            let moved = [p[0] + place[0], p[1] + place[1], p[2] + place[2]];
            let known = raw.points.iter().position(|q| *q == moved);
            known.unwrap_or_else(|| {
                raw.points.push(moved);
                raw.points.len() - 1
            }) as u32
        };
        let numbers: Vec<u32> = cube.points().iter().map(&mut number).collect();
        raw.tets.extend(cube.tets().iter().map(|tet| tet.map(|v| numbers[v as usize])));
        for (triangle, tag) in cube.triangles().iter() {
            raw.triangles.push(triangle.map(|v| numbers[v as usize]), 10 * k as i32 + tag);
        }
    }
    raw.regions = vec![0; raw.tets.len()];
    checked(raw)
}

fn clamp(surface: i32) -> Support {
    Support { surface, held: Held::displacement([0.0; 3]) }
}

fn held(surface: i32, axes: &[usize]) -> Support {
    let component = |k: usize| axes.contains(&k).then(|| 0.0.into());
    Support { surface, held: Held::Components([0, 1, 2].map(component)) }
}

fn body(supports: Vec<Support>) -> Elasticity {
    Elasticity { supports, ..Elasticity::new(Material::new(1.0, 0.3)) }
}

fn assembled(mesh: &TetMesh, problem: &Elasticity) -> Result<VectorSystem, Error> {
    assemble_elasticity(mesh, &Topology::new(mesh.raw()), problem)
}

/// The example and the motions of the body that is refused as hinged.
fn hinged(mesh: &TetMesh, problem: &Elasticity) -> (u32, Vec<String>) {
    match assembled(mesh, problem) {
        Err(Error::Hinged { example, modes, .. }) => {
            (example, modes.iter().map(RigidMode::to_string).collect())
        }
        other => panic!("{:?}", other.map(|_| "it passes")),
    }
}

#[test]
fn a_cube_on_an_edge_turns_about_it() {
    let mesh = cubes(&[[0.0; 3], [1.0, 1.0, 0.0]]);
    let (example, modes) = hinged(&mesh, &body(vec![clamp(1)]));
    assert_eq!(modes, ["rotation about z through (1.0000, 1.0000, 0.5000)"]);
    assert_eq!(example, mesh.tets()[6..].iter().flatten().copied().min().unwrap());
    let text = assembled(&mesh, &body(vec![clamp(1)])).unwrap_err().to_string();
    assert!(
        text.starts_with("a body of the mesh with 8 vertices, among them vertex ")
            && text.contains("hangs on the rest by edges or single vertices only"),
        "{text}"
    );
    // Held from the other side, the first turns.
    assert_eq!(hinged(&mesh, &body(vec![clamp(12)])).0, 0);
    // A side that slides stops it, one across z does not.
    assert!(assembled(&mesh, &body(vec![clamp(1), held(12, &[0])])).is_ok());
    let (_, modes) = hinged(&mesh, &body(vec![clamp(1), held(16, &[2])]));
    assert_eq!(modes.len(), 1);
    // So do springs.
    let springs = vec![(14, Stiffness::Normal(1.0.into()))];
    assert!(assembled(&mesh, &Elasticity { springs, ..body(vec![clamp(1)]) }).is_ok());
    // A body that nothing holds is refused as a whole, as ever.
    let nothing = assembled(&mesh, &body(vec![]));
    assert!(
        matches!(nothing, Err(Error::RigidModes { vertices: 14, ref modes, .. }) if modes.len() == 6)
    );
}

#[test]
fn a_cube_on_a_vertex_turns_in_three_ways_unless_it_is_held_elsewhere() {
    let mesh = cubes(&[[0.0; 3], [1.0; 3]]);
    let (_, modes) = hinged(&mesh, &body(vec![clamp(1)]));
    let about = |axis: &str| format!("rotation about {axis} through (1.0000, 1.0000, 1.0000)");
    assert_eq!(modes, ["x", "y", "z"].map(about));
    // A side x = 2 held along x: it turns about x alone.
    let (_, modes) = hinged(&mesh, &body(vec![clamp(1), held(12, &[0])]));
    assert_eq!(modes.len(), 1);
    assert!(
        modes[0].starts_with("rotation about x") && modes[0].ends_with(", 1.0000, 1.0000)"),
        "{modes:?}"
    );
    assert!(assembled(&mesh, &body(vec![clamp(1), held(12, &[0, 1])])).is_ok());
}

#[test]
fn bodies_may_hold_one_another() {
    // Three cubes round the edge of a fourth place: first and last are clamped, the middle
    // one hangs between them on two edges.
    let places = [[0.0; 3], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]];
    let mesh = cubes(&places);
    assert!(assembled(&mesh, &body(vec![clamp(1), clamp(22)])).is_ok());
    // Of two cubes on an edge the first slides along y only, the second along x only: neither
    // is held, but together they are.
    let two = cubes(&[[0.0; 3], [1.0, 1.0, 0.0]]);
    assert!(assembled(&two, &body(vec![held(1, &[0, 2]), held(14, &[1, 2])])).is_ok());
    // If both slide along y, the whole does.
    let sliding = assembled(&two, &body(vec![held(1, &[0, 2]), held(12, &[0, 2])]));
    assert!(matches!(sliding, Err(Error::RigidModes { .. })));
    // A chain of two on a clamped one: the first of them turns about one edge, the last in
    // more ways; the plainest is told.
    let chain = cubes(&[[0.0; 3], [1.0, 1.0, 0.0], [2.0, 2.0, 0.0]]);
    let (_, modes) = hinged(&chain, &body(vec![clamp(1)]));
    assert_eq!(modes, ["rotation about z through (1.0000, 1.0000, 0.5000)"]);
}

#[test]
fn a_mechanism_of_bodies_none_of_which_is_held_alone_is_solved_together() {
    // Four cubes in a ring, each on an edge along z of the next.
    let ring = cubes(&[[1.0, 0.0, 0.0], [2.0, 1.0, 0.0], [1.0, 2.0, 0.0], [0.0, 1.0, 0.0]]);
    // With one cube clamped it is a four-bar linkage: one motion is left.
    let (_, modes) = hinged(&ring, &body(vec![clamp(3)]));
    assert_eq!(modes, ["rotation about z through (2.0000, 1.0000, 0.5000)"]);
    // Another one kept from turning: the rest is held by what it hangs on.
    assert!(assembled(&ring, &body(vec![clamp(3), held(24, &[0, 1])])).is_ok());
}

#[test]
fn a_chain_of_very_many_bodies_is_left_to_the_solve() {
    // Clamped at both ends, so that no body is loose by itself but all are together.
    let chain = |loose: usize| {
        let places: Vec<[f64; 3]> = (0..loose + 2).map(|k| [k as f64, k as f64, 0.0]).collect();
        let mesh = cubes(&places);
        assembled(&mesh, &body(vec![clamp(1), clamp(10 * (loose as i32 + 1) + 2)]))
    };
    let Err(Error::Hinged { modes, .. }) = chain(100) else { panic!("a hundred are looked at") };
    assert_eq!(modes.len(), 1);
    assert!(chain(101).is_ok());
}

#[test]
fn hinges_are_seen_after_refinement_and_heat_passes_them() {
    let coarse = cubes(&[[0.0; 3], [1.0, 1.0, 0.0]]);
    for scheme in [Scheme::Linear, Scheme::BoxSpline] {
        let mut hierarchy = Hierarchy::new(coarse.clone(), &FeatureOptions::default());
        hierarchy.subdivide(scheme).unwrap();
        let problem =
            Elasticity { traction: vec![(12, vector([1.0, 0.0, 0.0]))], ..body(vec![clamp(1)]) };
        let refused = Discretisation::new(&hierarchy, &problem, &Options::default());
        assert!(matches!(refused, Err(Error::Hinged { ref modes, .. }) if modes.len() == 1));
        let held = Elasticity { supports: vec![clamp(1), held(12, &[1])], ..problem };
        let options = Options::default();
        let discrete = Discretisation::new(&hierarchy, &held, &options).unwrap();
        assert!(discrete.solve(&options).is_ok());
        let fixed = vec![(1, 0.0.into()), (12, 1.0.into())];
        let heat = Poisson { fixed, ..Poisson::default() };
        let discrete = Discretisation::new(&hierarchy, &heat, &options).unwrap();
        let solved = discrete.solve(&options).unwrap();
        // Turned half round, the body is itself, with 1 − u: the mean on the hinge is 1/2.
        let points = hierarchy.finest().mesh.points().iter();
        let is_on_hinge = |p: &[f64; 3]| (p[0] - 1.0).hypot(p[1] - 1.0) < 1e-9;
        let on_hinge: Vec<f64> =
            points.zip(&solved.values).filter(|(p, _)| is_on_hinge(p)).map(|(_, u)| *u).collect();
        assert_eq!(on_hinge.len(), 3);
        assert!((on_hinge.iter().sum::<f64>() / 3.0 - 0.5).abs() < 1e-6, "{on_hinge:?}");
    }
}

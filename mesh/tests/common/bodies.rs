//! Round bodies in known shapes, their vertices on the exact surface.

use octruss_mesh::{CheckOptions, Hierarchy, RawMesh, Scheme, TetMesh, check, shapes};

/// A box of Kuhn cells with its vertices moved; what is then at one place becomes one
/// vertex.
pub fn bent(cells: [u32; 3], to: impl Fn([f64; 3]) -> [f64; 3]) -> TetMesh {
    let flat = shapes::kuhn_box(cells, cells.map(f64::from)).into_raw();
    let mut points: Vec<[f64; 3]> = Vec::new();
    let number = |&point: &[f64; 3]| {
        let point = to(point);
        let is_same = |other: &[f64; 3]| (0..3).all(|k| (point[k] - other[k]).abs() < 1e-9);
        points.iter().position(is_same).unwrap_or_else(|| {
            points.push(point);
            points.len() - 1
        }) as u32
    };
    let numbers: Vec<u32> = flat.points.iter().map(number).collect();
    let tets = flat.tets.iter().map(|tet| tet.map(|v| numbers[v as usize])).collect();
    sound(points, tets)
}

/// A mesh of one region without tags, its tets turned to positive volumes.
fn sound(points: Vec<[f64; 3]>, mut tets: Vec<[u32; 4]>) -> TetMesh {
    for tet in &mut tets {
        if octruss_mesh::reference_tet::six_volumes(tet.map(|v| points[v as usize])) < 0.0 {
            tet.swap(0, 2);
        }
    }
    let regions = vec![0; tets.len()];
    let raw = RawMesh { points, tets, regions, ..RawMesh::default() };
    check(raw, &CheckOptions::default()).expect("a sound mesh").mesh
}

/// The point at a share of a full turn.
pub fn turned(turn: f64, radius: f64, z: f64) -> [f64; 3] {
    let angle = std::f64::consts::TAU * turn;
    [radius * angle.cos(), radius * angle.sin(), z]
}

/// A pipe along z: cells round it, across its wall, along it.
pub fn pipe(cells: [u32; 3], [inner, outer]: [f64; 2], length: f64) -> TetMesh {
    let [round, across, along] = cells.map(f64::from);
    bent(cells, |[x, y, z]| {
        turned(x / round, inner + (outer - inner) * y / across, length * z / along)
    })
}

/// A square plate of side 4 about a hole of radius 1; cells round the hole (a multiple
/// of 8), across, and through the thickness of 1.
pub fn plate_with_hole(cells: [u32; 3]) -> TetMesh {
    let [round, across, through] = cells.map(f64::from);
    bent(cells, |[x, y, z]| {
        let [c, s, _] = turned(x / round, 1.0, 0.0);
        let to_side = 2.0 / c.abs().max(s.abs());
        let radius = 1.0 + (to_side - 1.0) * y / across;
        [radius * c, radius * s, z / through]
    })
}

/// A ball of radius 1: an octahedron in eight tets, split some times, with its octahedral
/// shells made round.
pub fn ball(splits: usize) -> TetMesh {
    let mut points = vec![[0.0; 3]];
    points.extend((0..6).map(|i| {
        let mut point = [0.0; 3];
        point[i / 2] = if i % 2 == 0 { 1.0 } else { -1.0 };
        point
    }));
    let tet = |i: u32| [0, 1 + (i & 1), 3 + (i >> 1 & 1), 5 + (i >> 2)];
    let mut levels = Hierarchy::new(sound(points, (0..8).map(tet).collect()), &Default::default());
    for _ in 0..splits {
        levels.subdivide(Scheme::Linear).unwrap();
    }
    let split = levels.into_finest().mesh.into_raw();
    let round = |&p: &[f64; 3]| {
        let [sum, norm] = [p.iter().map(|x| x.abs()).sum::<f64>(), norm(p)];
        if norm > 0.0 { p.map(|x| x * sum / norm) } else { p }
    };
    sound(split.points.iter().map(round).collect(), split.tets)
}

pub fn norm(p: [f64; 3]) -> f64 {
    p.iter().map(|x| x * x).sum::<f64>().sqrt()
}

pub fn distance(p: [f64; 3], q: [f64; 3]) -> f64 {
    norm(std::array::from_fn(|k| p[k] - q[k]))
}

/// The distance from the z axis.
pub fn radius([x, y, _]: [f64; 3]) -> f64 {
    x.hypot(y)
}

pub fn volume(mesh: &TetMesh) -> f64 {
    (0..mesh.tets().len()).map(|tet| mesh.volume(tet)).sum()
}

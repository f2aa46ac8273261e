//! Supports along normals: the same whatever groups a surface is made of, and whatever noise
//! is in its coordinates.

mod bodies;

use bodies::{checked, sliding, solve};
use octruss_fem::*;
use octruss_mesh::shapes::kuhn_box;
use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, TetMesh, Topology};

/// A shaft of radius 1 and length 4 along z, 40 facets round it in four groups, 1 to 4; its
/// ends are 5 and 6.
fn shaft() -> TetMesh {
    let mut raw = kuhn_box([10, 10, 32], [2.0, 2.0, 4.0]).into_raw();
    for point in &mut raw.points {
        let [x, y] = [point[0] - 1.0, point[1] - 1.0];
        // A square of half width w becomes a polygon of radius w, its points evenly spread.
        let (w, quarter) = (x.abs().max(y.abs()), std::f64::consts::FRAC_PI_4);
        let angle = match (x.abs() >= y.abs(), x >= 0.0, y >= 0.0) {
            _ if w == 0.0 => 0.0,
            (true, true, _) => quarter * y / w,
            (true, false, _) => 4.0 * quarter - quarter * y / w,
            (false, _, true) => 2.0 * quarter - quarter * x / w,
            (false, _, false) => 6.0 * quarter + quarter * x / w,
        };
        [point[0], point[1]] = [w * angle.cos(), w * angle.sin()];
    }
    checked(raw)
}

/// The same mesh with another tag for each of its tagged triangles.
fn retagged(mesh: &TetMesh, tag: impl Fn(i32, [[f64; 3]; 3]) -> i32) -> TetMesh {
    let mut raw = mesh.raw().clone();
    for (triangle, of) in raw.triangles.simplices.iter().zip(&mut raw.triangles.tags) {
        *of = tag(*of, triangle.map(|v| raw.points[v as usize]));
    }
    checked(raw)
}

fn constraints(mesh: &TetMesh, supports: &[Support]) -> Constraints {
    Constraints::new(mesh, &Topology::new(mesh.raw()), supports).unwrap()
}

/// In how many directions a vertex is held.
fn directions(held: &HeldVertex) -> usize {
    3 - (0..3).map(|k| held.projector[k][k]).sum::<f64>().round() as usize
}

#[test]
fn a_shaft_turns_in_its_bearing_whether_this_is_one_group_or_four() {
    let four = shaft();
    let one = retagged(&four, |tag, _| tag.max(4));
    let turned = |mesh: &TetMesh, bearing: Vec<Support>| {
        let mut supports = vec![Support { surface: 5, held: Held::displacement([0.0; 3]) }];
        supports.extend(bearing);
        let [x, y] = [|[_, y, _]: [f64; 3]| -0.01 * y, |[x, _, _]: [f64; 3]| 0.01 * x];
        let traction = vec![(6, [Scalar::function(x), Scalar::function(y), 0.0.into()])];
        // The shear modulus is 1.
        let material = Material::new(2.6, 0.3);
        let problem = Elasticity { supports, traction, ..Elasticity::new(material) };
        let u = solve(mesh, &problem);
        u.iter().map(|u| u[0].hypot(u[1])).fold(0.0, f64::max)
    };
    let [free, whole, parts] =
        [turned(&one, vec![]), turned(&one, sliding(&[4])), turned(&four, sliding(&[1, 2, 3, 4]))];
    // A twist of 0.01 a unit of length, for which linear tets are too stiff.
    assert!((free / 0.04 - 1.0).abs() < 0.06, "{free}");
    assert!((whole / free - 1.0).abs() < 0.02, "{whole} for {free}");
    assert!((parts / whole - 1.0).abs() < 1e-6, "{parts} for {whole}");
}

/// A bar 10 × 4 × 4 whose plane y = 0 has noise and, where x > 5, a slope; its triangles
/// there are 3 for x < 5 and 7 for x > 5.
fn noisy_bar(noise: f64, slope: f64) -> TetMesh {
    let mut raw = kuhn_box([10, 4, 4], [10.0, 4.0, 4.0]).into_raw();
    for (n, point) in raw.points.iter_mut().enumerate().filter(|(_, p)| p[1] == 0.0) {
        point[1] = noise * (7.0 * n as f64).sin() - slope * (point[0] - 5.0).max(0.0);
    }
    let half = |tag, corners: [[f64; 3]; 3]| {
        if tag == 3 && corners.iter().any(|p| p[0] > 5.0) { 7 } else { tag }
    };
    retagged(&checked(raw), half)
}

fn component(surface: i32, axis: usize) -> Support {
    let held = std::array::from_fn(|k| (k == axis).then(|| 0.0.into()));
    Support { surface, held: Held::Components(held) }
}

/// The most directions in which a vertex of the seam x = 5, away from other sides, is held.
fn at_seam(mesh: &TetMesh, supports: &[Support]) -> usize {
    let is_inner = |p: [f64; 3]| p[0] == 5.0 && p[2] > 0.0 && p[2] < 4.0;
    let constraints = constraints(mesh, supports);
    let held = constraints.held().iter();
    let held: Vec<_> = held.filter(|held| is_inner(mesh.points()[held.vertex as usize])).collect();
    assert_eq!(held.len(), 3);
    held.into_iter().map(directions).max().unwrap()
}

#[test]
fn a_noisy_plane_of_symmetry_in_two_groups_does_not_hold_sideways() {
    let coarse = noisy_bar(0.004, 0.0);
    let mut hierarchy = Hierarchy::new(coarse, &FeatureOptions::default());
    hierarchy.subdivide(Scheme::Linear).unwrap();
    let finest = hierarchy.finest();
    let pulled = |plane: [Support; 2]| {
        let mut supports = vec![component(1, 0), component(5, 2)];
        supports.extend(plane);
        let traction = vec![(2, vector([1.0, 0.0, 0.0]))];
        let material = Material::new(1000.0, 0.3);
        let problem = Elasticity { supports, traction, ..Elasticity::new(material) };
        let options = Options::default();
        let discrete = Discretisation::new(&hierarchy, &problem, &options).unwrap();
        let u = discrete.solve(&options).unwrap().values;
        let strain = strains(&finest.mesh, &u).unwrap();
        let stress = stresses(&finest.mesh, &problem, &strain).unwrap();
        let largest = stress.iter().map(von_mises).fold(0.0, f64::max);
        let far = |(p, _): &(&[f64; 3], &[f64; 3])| p[0] > 10.0 - 1e-9;
        let at_end = finest.mesh.points().iter().zip(&u).filter(far);
        (at_end.map(|(_, u)| u[0]).fold(0.0, f64::max), largest)
    };
    let normal = |surface| Support { surface, held: Held::Normal(0.0.into()) };
    // Both ways, both orders, and by halves.
    for plane in [
        [normal(3), normal(7)],
        [normal(7), normal(3)],
        [component(3, 1), normal(7)],
        [normal(3), component(7, 1)],
    ] {
        let (far, largest) = pulled(plane);
        assert!((far / 0.01 - 1.0).abs() < 0.02, "{far}");
        assert!(largest < 1.15, "{largest}");
    }
}

#[test]
fn noise_holds_one_direction_and_a_real_taper_two() {
    let normal = |surface| Support { surface, held: Held::Normal(0.0.into()) };
    for noise in [0.0, 1e-6, 0.004, 0.02] {
        let flat = noisy_bar(noise, 0.0);
        for plane in [
            vec![normal(3), normal(7)],
            vec![component(3, 1), normal(7)],
            vec![normal(7), component(3, 1)],
        ] {
            assert_eq!(at_seam(&flat, &plane), 1, "{noise}, {plane:?}");
        }
    }
    for noise in [0.0, 1e-6, 0.004] {
        let taper = noisy_bar(noise, 1_f64.to_radians().tan());
        for plane in [vec![component(3, 1), normal(7)], vec![normal(7), component(3, 1)]] {
            assert_eq!(at_seam(&taper, &plane), 2, "{noise}, {plane:?}");
        }
        // Held along its normals all over it is one surface with a bend of 1°.
        assert_eq!(at_seam(&taper, &sliding(&[3, 7])), 1);
    }
}

#[test]
fn where_groups_meet_the_last_listed_value_holds() {
    let mesh = noisy_bar(0.0, 0.0);
    let moved = |surface, by: f64| Support { surface, held: Held::Normal(by.into()) };
    let at_seam = |supports: &[Support]| {
        let constraints = constraints(&mesh, supports);
        let held = constraints.held().iter();
        let mut values = held.filter(|held| mesh.points()[held.vertex as usize][0] == 5.0);
        let first = values.next().unwrap().value;
        assert!(values.all(|held| held.value == first));
        first
    };
    // Outward is −y.
    assert_eq!(at_seam(&[moved(3, 0.1), moved(7, 0.2)]), [0.0, -0.2, 0.0]);
    assert_eq!(at_seam(&[moved(7, 0.2), moved(3, 0.1)]), [0.0, -0.1, 0.0]);
}

#[test]
fn the_order_of_triangles_and_groups_listed_twice_change_nothing() {
    let mesh = shaft();
    let mut raw = mesh.raw().clone();
    let order = |n: usize| (n * 89) % 4001;
    let mut shuffled: Vec<_> = mesh.triangles().iter().enumerate().collect();
    shuffled.sort_by_key(|(n, _)| order(*n));
    (raw.triangles.simplices, raw.triangles.tags) = shuffled.into_iter().map(|(_, t)| t).unzip();
    // All of group 1 is in a group 9, too.
    let also: Vec<_> = mesh.triangles().iter().filter(|(_, tag)| *tag == 1).collect();
    also.into_iter().for_each(|(triangle, _)| raw.triangles.push(triangle, 9));
    let shuffled = checked(raw);
    let bearing = sliding(&[1, 2, 3, 4]);
    assert_eq!(constraints(&shuffled, &bearing), constraints(&mesh, &bearing));
    let twice = constraints(&shuffled, &sliding(&[9, 1, 2, 3, 4, 1]));
    let once = constraints(&mesh, &bearing);
    for (a, b) in twice.held().iter().zip(once.held()) {
        assert_eq!((a.vertex, a.projector, a.value), (b.vertex, b.projector, b.value));
    }
}

#[test]
fn curved_surfaces_are_told_from_noisy_planes() {
    let curved = |mesh: &TetMesh, supports: &[Support]| {
        curved_supports(mesh, &Topology::new(mesh.raw()), supports).unwrap()
    };
    assert_eq!(curved(&shaft(), &sliding(&[1, 2, 6])), [1, 2]);
    assert_eq!(curved(&shaft(), &sliding(&[5, 6])), [0; 0]);
    assert_eq!(curved(&noisy_bar(0.004, 0.0), &sliding(&[1, 3, 5, 7])), [0; 0]);
    // What is not held along normals does not matter.
    assert_eq!(curved(&shaft(), &[component(1, 0)]), [0; 0]);
}

//! A part of a symmetric body with mirror planes, against the body.

mod common;

use common::bodies::{bent, distance, radius, turned};
use common::parts::{Part, X0, Y0, Z0, octant, sector};
use common::random_block::Random;
use common::reflected::{Pair, Plane, reflected};
use octruss_mesh::{
    CheckOptions, CurveEnds, Diagonal, FeatureOptions, Hierarchy, Marking, Mirrors, Overshoot,
    Placement, Scheme, Sides, Step, Strata, SubdivisionMatrix, check, limit_matrix,
    limit_positions,
};

const SCHEMES: [Scheme; 4] =
    [Scheme::BoxSpline, Scheme::Averaged, Scheme::LOOP_SOLID, Scheme::INTERPOLATORY];

fn parts() -> Vec<Part> {
    vec![
        Part::new("half plate", sector(0.5, [8, 2, 2]), &[Y0]).shaken(0.03),
        Part::new("quarter plate", sector(0.25, [4, 2, 2]), &[X0, Y0]).shaken(0.03),
        Part::new("thin quarter", sector(0.25, [6, 1, 1]), &[X0, Y0]),
        Part::new("eighth of a plate", sector(0.25, [4, 2, 1]), &[X0, Y0, Z0]),
        Part::new("octant", octant(1), &[X0, Y0, Z0]).shaken(0.02),
    ]
}

fn steps() -> impl Iterator<Item = Step> {
    let schemes = SCHEMES.into_iter();
    schemes
        .flat_map(|scheme| [false, true].map(|interpolate| Step { interpolate, ..scheme.into() }))
}

/// Rows of a matrix of the body, for the vertices of the part and by them.
fn folded(matrix: &SubdivisionMatrix, rows: &[u32], of: &[u32], columns: usize) -> Vec<Vec<f64>> {
    let row = |&row: &u32| {
        let mut folded = vec![0.0; columns];
        let (columns, weights) = matrix.row(row as usize);
        columns.iter().zip(weights).for_each(|(&v, w)| folded[of[v as usize] as usize] += w);
        folded
    };
    rows.iter().map(row).collect()
}

fn dense(matrix: &SubdivisionMatrix) -> Vec<Vec<f64>> {
    let all: Vec<u32> = (0..matrix.rows().max(matrix.columns()) as u32).collect();
    folded(matrix, &all[..matrix.rows()], &all, matrix.columns())
}

fn largest_difference(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    assert_eq!(a.len(), b.len());
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Asserts that positions, strata, limits, rows and fields of the part are the body's.
fn assert_alike(pair: &Pair, step: Step, within: f64, name: &str) {
    assert_in_place(pair, step, within, name);
    assert_carried_alike(pair, within, &format!("{name}, {step:?}"));
}

fn assert_in_place(pair: &Pair, step: Step, within: f64, name: &str) {
    let name = &format!("{name}, {step:?}");
    for level in 0..pair.part.levels().len() {
        let [part, body] = [&pair.part, &pair.body].map(|levels| &*levels.levels()[level]);
        let (in_body, in_part) = (&pair.in_body[level], &pair.in_part[level]);
        let apart = |part: &[[f64; 3]], body: &[[f64; 3]]| {
            let pairs = part.iter().zip(in_body);
            pairs.map(|(p, &v)| distance(*p, body[v as usize])).fold(0.0, f64::max)
        };
        let miss = apart(part.mesh.points(), body.mesh.points());
        assert!(miss < within, "{name}: level {level} is {miss:e} apart");
        let strata = [part, body].map(|level| {
            Strata::new(level.mesh.raw(), &level.topology, level.mesh.features().unwrap())
        });
        for (v, &there) in in_body.iter().enumerate() {
            let dimensions =
                [(0, v), (1, there as usize)].map(|(i, v)| strata[i].vertex_dimensions[v]);
            assert_eq!(dimensions[0], dimensions[1], "{name}: level {level}, vertex {v}");
        }
        for (e, ends) in part.topology.edges().iter().enumerate() {
            let [a, b] = ends.map(|v| in_body[v as usize]);
            let there = body.topology.edge_between(a, b).unwrap();
            let found = strata[0].edge_dimensions[e];
            assert_eq!(found, strata[1].edge_dimensions[there as usize], "{name}: edge {ends:?}");
        }
        let ends = step.resolved_curve_ends();
        let limits = [part, body].map(|level| {
            limit_positions(&level.mesh, &level.topology, (step.scheme, ends), level.mesh.points())
        });
        let miss = apart(&limits[0], &limits[1]);
        assert!(miss < within, "{name}: limits of level {level} are {miss:e} apart");
        if level == 0 {
            let limits = [part, body]
                .map(|level| limit_matrix(&level.mesh, &level.topology, step.scheme, ends));
            let n = part.mesh.points().len();
            let expected = folded(&limits[1], in_body, in_part, n);
            assert!(largest_difference(&dense(&limits[0]), &expected) < 1e-14, "{name}");
        }
    }
}

fn assert_carried_alike(pair: &Pair, within: f64, name: &str) {
    for transfer in 0..pair.part.transfers() {
        let [part, body] = [&pair.part, &pair.body].map(|levels| levels.refinement(transfer));
        let (in_body, in_part) = (&pair.in_body[transfer + 1], &pair.in_part[transfer]);
        let expected = folded(body.field_matrix(), in_body, in_part, part.matrix.columns());
        let miss = largest_difference(&dense(part.field_matrix()), &expected);
        assert!(miss < 10.0 * within, "{name}: rows of transfer {transfer} are {miss:e} apart");
        let defect = pair.part.affine_defect(transfer, &part.matrix);
        assert!(defect < 1e-11, "{name}: positions are missed by {defect:e}");
        let field: Vec<f64> = (0..2 * part.matrix.columns()).map(|i| (i as f64).sin()).collect();
        let of_body: Vec<f64> =
            in_part.iter().flat_map(|&v| [0, 1].map(|k| field[2 * v as usize + k])).collect();
        let carried = [(part, &field), (body, &of_body)]
            .map(|(step, field)| step.carry_point_field(field, 2, Overshoot::Allow).values);
        for (v, &there) in in_body.iter().enumerate() {
            for k in 0..2 {
                let miss = (carried[0][2 * v + k] - carried[1][2 * there as usize + k]).abs();
                assert!(miss < 20.0 * within, "{name}: fields of {v} are {miss:e} apart");
            }
        }
    }
}

#[test]
fn a_part_is_refined_as_the_body() {
    for part in parts() {
        for step in steps() {
            let pair = part.pair(&FeatureOptions::default(), step, 2);
            // What is solved for is solved to 1e-10 edges.
            let within = if step.interpolate { 1e-9 } else { 1e-13 };
            assert_alike(&pair, step, within, part.name);
        }
    }
}

#[test]
fn without_mirrors_a_part_is_another_body() {
    let part = &parts()[1];
    for step in steps() {
        let named = part.pair(&FeatureOptions::default(), step, 1).part;
        let mesh = check(part.raw.clone(), &CheckOptions::default()).unwrap().mesh;
        let options = FeatureOptions { marking: Marking::AsOrdered, ..Default::default() };
        let mut alone = Hierarchy::new(mesh, &options);
        alone.subdivide(step).unwrap();
        let pairs = named.finest().mesh.points().iter().zip(alone.finest().mesh.points());
        let apart = pairs.map(|(p, q)| distance(*p, *q)).fold(0.0, f64::max);
        assert!(apart > 1e-3, "{step:?}: {apart}");
    }
}

#[test]
fn smooth_bodies_diagonals_ends_and_guards_are_alike_too() {
    let smooth = FeatureOptions { crease_angle: 180.0, ..Default::default() };
    for part in parts() {
        let spline = Step::from(Scheme::BoxSpline);
        let through = Step { interpolate: true, ..spline };
        for (options, step) in [
            (&FeatureOptions::default(), Step { curve_ends: Some(CurveEnds::Parabola), ..spline }),
            (&FeatureOptions::default(), Step { min_quality: Some(0.5), ..spline }),
            (&FeatureOptions::default(), Step { min_quality: Some(0.5), ..through }),
            (&smooth, spline),
            (&smooth, Scheme::Averaged.into()),
            (&smooth, Step { diagonal: Diagonal::ShortestEachLevel, ..Scheme::LOOP_SOLID.into() }),
        ] {
            let pair = part.pair(options, step, 2);
            let within = if step.interpolate { 1e-9 } else { 1e-13 };
            assert_alike(&pair, step, within, part.name);
            let distances =
                [&pair.part, &pair.body].map(|levels| levels.limit_distances(2, step).largest);
            assert!((distances[0] - distances[1]).abs() < within, "{distances:?}");
        }
    }
}

#[test]
fn guards_pull_back_as_in_the_body() {
    let part = Part::new("octant", octant(1), &[X0, Y0, Z0]).shaken(0.02);
    let options = FeatureOptions { crease_angle: 180.0, ..Default::default() };
    let step = Step { min_quality: Some(0.9), ..Scheme::BoxSpline.into() };
    let pair = part.pair(&options, step, 1);
    let pulled = [&pair.part, &pair.body].map(|all| all.refinement(0).guard.unwrap().pulled_back);
    assert!(pulled[0] > 10 && pulled[1] > pulled[0], "{pulled:?}");
    assert_alike(&pair, step, 1e-13, part.name);
}

#[test]
fn thin_walls_go_to_the_limit_as_in_the_body() {
    let mesh = bent([3, 2, 6], |[x, y, z]| turned(x / 12.0, 1.75 + 0.125 * y, z));
    let part = Part::new("thin pipe", mesh, &[X0, Y0, Z0]);
    let step = Step { min_quality: Some(0.1), interpolate: true, ..Scheme::BoxSpline.into() };
    let pair = part.pair(&FeatureOptions::default(), step, 2);
    for levels in [&pair.part, &pair.body] {
        let report = levels.refinement(0).interpolation.unwrap();
        assert_eq!(report.placement, Placement::AtLimit);
    }
    // The harmonic extension of displacements of about 0.1 is solved to 1e-6 of its data.
    assert_in_place(&pair, step, 1e-6, part.name);
    let sums = pair.part.refinements().map(|step| {
        let matrix = step.field_matrix();
        (0..matrix.rows())
            .map(|row| (matrix.row(row).1.iter().sum::<f64>() - 1.0).abs())
            .fold(0.0, f64::max)
    });
    assert!(sums.into_iter().all(|off| off < 1e-12));
}

/// A quarter plate of two regions, with an embedded surface, a curve round the rim of
/// the hole, and a corner on it.
fn with_features() -> Part {
    let mut part = Part::new("features", sector(0.25, [4, 3, 2]), &[X0, Y0]);
    let raw = &mut part.raw;
    let topology = octruss_mesh::Topology::new(raw);
    let inner = |v: &u32| radius(raw.points[*v as usize]) < 1.0 + 1e-9;
    let flat = |v: &u32, z: f64| raw.points[*v as usize][2] == z;
    let touches = |tet: &&[u32; 4]| tet.iter().filter(|v| inner(v)).count() > 0;
    raw.regions = raw.tets.iter().map(|tet| i32::from(touches(&tet))).collect();
    for &face in topology.faces().iter().filter(|f| f.iter().all(|v| flat(v, 0.5))) {
        raw.triangles.push(face, 12);
    }
    for &ends in topology.edges().iter().filter(|e| e.iter().all(|v| inner(v) && flat(v, 0.0))) {
        raw.edges.push(ends, 4);
    }
    let middle = raw.points.iter().position(|p| (p[0] - p[1]).abs() < 1e-9).unwrap();
    raw.vertices.push([middle as u32], 6);
    part.shaken(0.02)
}

#[test]
fn regions_surfaces_curves_and_corners_go_on_across() {
    let part = with_features();
    for (crease_angle, levels) in [(40.0, 2), (180.0, 1)] {
        let options = FeatureOptions { crease_angle, surfaces: vec![12], ..Default::default() };
        for step in steps() {
            let pair = part.pair(&options, step, levels);
            let within = if step.interpolate { 1e-9 } else { 1e-13 };
            assert_alike(&pair, step, within, part.name);
            sided_fields_are_alike(&pair, within);
        }
    }
}

/// On each side of the interface one value, carried by the part and by the body.
fn sided_fields_are_alike(pair: &Pair, within: f64) {
    let sides = [&pair.part, &pair.body]
        .map(|all| [0, 1].map(|level| Sides::new(&all.levels()[level].mesh)));
    let value = |v: u32, region: i32| f64::from(v).sin() + 7.0 * f64::from(region);
    let [part, body] = &sides;
    let of = |sides: &Sides, rename: &dyn Fn(u32) -> u32| -> Vec<f64> {
        let each = (0..sides.len()).map(|side| (sides.vertices()[side], sides.regions()[side]));
        each.map(|(v, region)| value(rename(v), region)).collect()
    };
    let start = [of(&part[0], &|v| v), of(&body[0], &|v| pair.in_part[0][v as usize])];
    let carried: Vec<Vec<f64>> = [&pair.part, &pair.body]
        .iter()
        .zip(&sides)
        .zip(&start)
        .map(|((all, sides), start)| {
            let step = (&all.coarsest().topology, all.refinement(0));
            sides[0].carry(step, &sides[1], start, 1, Overshoot::Allow).values
        })
        .collect();
    for (side, (&v, &region)) in part[1].vertices().iter().zip(part[1].regions()).enumerate() {
        let there = body[1].find(pair.in_body[1][v as usize], region).unwrap();
        let miss = (carried[0][side] - carried[1][there]).abs();
        assert!(miss < 20.0 * within, "a side of {v} is {miss:e} apart");
    }
}

#[test]
fn planes_may_lie_in_any_direction() {
    // A turn about (1, 2, 2)/3 by the angle with cosine 3/5 and sine 4/5, and a shift.
    let turn = |p: [f64; 3]| {
        let n = [1.0, 2.0, 2.0].map(|x| x / 3.0);
        let along: f64 = (0..3).map(|k| n[k] * p[k]).sum();
        let cross = |k: usize| n[(k + 1) % 3] * p[(k + 2) % 3] - n[(k + 2) % 3] * p[(k + 1) % 3];
        std::array::from_fn(|k| 0.6 * p[k] + 0.8 * cross(k) + 0.4 * along * n[k] + 3.0)
    };
    for part in parts() {
        for step in steps() {
            let pair = part.turned_pair(&FeatureOptions::default(), step, 2, turn);
            // Flat faces that are not parallel to the axes are flat to within what is
            // solved for, which decides how rows are corrected.
            match step.interpolate {
                true => assert_in_place(&pair, step, 1e-9, part.name),
                false => assert_alike(&pair, step, 3e-13, part.name),
            }
        }
    }
}

#[test]
fn between_parallel_planes_a_slab_goes_on_for_ever() {
    let wave = |cells| {
        bent(cells, |[x, y, z]| {
            [x, y * (1.0 + 0.03 * (1.0 + y) * x * x), z + 0.1 * x * (y - x) + 0.1 * y * y]
        })
    };
    let low = Plane { axis: 0, place: 0.0, group: 1 };
    let high = Plane { axis: 0, place: 1.0, group: 2 };
    let part = Part::new("slab", wave([1, 3, 2]), &[low, high]);
    for scheme in SCHEMES {
        let options = FeatureOptions { marking: Marking::AsOrdered, ..Default::default() };
        // The part, in the middle of eight.
        let images = [high, low, Plane { place: 2.0, group: 1, ..low }];
        let last = Plane { place: -2.0, group: 1, ..low };
        let (body, of) = reflected(&part.raw, &[&images[..], &[last]].concat());
        let mut body = Hierarchy::new(body, &options);
        let mesh = check(part.raw.clone(), &CheckOptions::default()).unwrap().mesh;
        let mirrors = Mirrors::new(&mesh, &[1, 2]).unwrap();
        let mut mesh = Hierarchy::new(mesh, &FeatureOptions { mirrors, ..options });
        mesh.subdivide(scheme).unwrap();
        body.subdivide(scheme).unwrap();
        let pair = Pair::new(mesh, body, of);
        let [mesh, body] = [&pair.part, &pair.body].map(|all| all.finest().mesh.points());
        let miss = mesh.iter().zip(&pair.in_body[1]).map(|(p, &v)| distance(*p, body[v as usize]));
        let miss = miss.fold(0.0, f64::max);
        assert!(miss < 1e-13, "{scheme:?}: {miss:e}");
    }
}

#[test]
fn a_hole_stays_round_up_to_its_planes() {
    let part = Part::new("quarter plate", sector(0.25, [6, 2, 2]), &[X0, Y0]);
    let step = Step { interpolate: true, ..Scheme::BoxSpline.into() };
    let levels = part.pair(&FeatureOptions::default(), step, 3).part;
    let rim = levels.finest().mesh.points().iter().map(|p| radius(*p)).filter(|r| *r < 1.02);
    let miss = rim.map(|r| (r - 1.0).abs()).fold(0.0, f64::max);
    // A facet of the input is 8.6e-3 off.
    assert!(miss < 2e-5, "{miss:e}");
    for (axis, on) in [(0, 1), (1, 0)] {
        let [nearest, next] = first_two_on_the_rim(levels.finest().mesh.points(), axis);
        // The tangent at the plane is perpendicular to it, to the second order.
        assert!((nearest[on] - 1.0).abs() < 2e-5 && nearest[axis].abs() < 1e-14);
        let angle = next[axis].atan2(next[on]);
        assert!((next[on] - angle.cos()).abs() < 2e-5);
    }
}

/// Of the rim of the hole at the bottom, the vertex in a plane and the next.
fn first_two_on_the_rim(points: &[[f64; 3]], axis: usize) -> [[f64; 3]; 2] {
    let rim = points.iter().copied().filter(|p| p[2] == 0.0 && radius(*p) < 1.02);
    let mut rim: Vec<[f64; 3]> = rim.collect();
    rim.sort_by(|p, q| p[axis].total_cmp(&q[axis]));
    [rim[0], rim[1]]
}

#[test]
fn planes_stay_planes_and_are_handed_on() {
    for part in parts() {
        for step in steps() {
            let pair = part.pair(&FeatureOptions::default(), step, 1).part;
            let once = pair.clone().into_finest().mesh;
            let groups: Vec<i32> = part.planes.iter().map(|plane| plane.group).collect();
            assert_eq!(once.features().unwrap().mirrors, groups);
            for (triangle, group) in once.triangles().iter().filter(|(_, tag)| *tag != 9) {
                let Plane { axis, place, .. } =
                    part.planes.iter().find(|p| p.group == group).unwrap();
                assert!(triangle.iter().all(|&v| once.points()[v as usize][*axis] == *place));
            }
            assert_eq!(Mirrors::new(&once, &groups).unwrap().groups(), groups);
            let mut twice = Hierarchy::new(once, &FeatureOptions::default());
            twice.subdivide(step).unwrap();
            let mut both = pair;
            both.subdivide(step).unwrap();
            assert!(twice.finest().mesh == both.finest().mesh, "{}, {step:?}", part.name);
        }
    }
}

#[test]
fn coordinates_of_single_precision_will_do() {
    let mut part = Part::new("quarter plate", sector(0.25, [4, 2, 2]), &[X0, Y0]);
    let mut random = Random::new(7);
    let noise = || 1e-7 * (random.below(1000) as f64 / 500.0 - 1.0);
    let coordinates = part.raw.points.as_flattened_mut().iter_mut();
    coordinates.zip(std::iter::repeat_with(noise)).for_each(|(x, noise)| *x += noise);
    let mesh = check(part.raw, &CheckOptions::default()).unwrap().mesh;
    let mirrors = Mirrors::new(&mesh, &[1, 2]).unwrap();
    for step in steps() {
        let options = FeatureOptions { mirrors: mirrors.clone(), ..Default::default() };
        let mut levels = Hierarchy::new(mesh.clone(), &options);
        levels.subdivide(step).unwrap();
        let report = levels.refinement(0).interpolation.unwrap_or_default();
        assert!(
            report.residual < 1e-10 && report.iterations.iter().all(|&n| n <= 25),
            "{report:?}"
        );
        let fine = &levels.finest().mesh;
        for (triangle, group) in fine.triangles().iter().filter(|(_, tag)| *tag != 9) {
            let axis = group as usize - 1;
            let off = triangle.map(|v| fine.points()[v as usize][axis].abs());
            assert!(off.iter().all(|&off| off < 3e-7), "{step:?}: {off:?}");
        }
    }
}

#[test]
fn numbers_of_threads_do_not_matter() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let step = Step { interpolate: true, ..Scheme::Averaged.into() };
        pool.install(|| {
            let levels = parts()[4].pair(&FeatureOptions::default(), step, 2).part;
            let rows = levels.refinement(1).clone();
            (levels.into_finest().mesh, rows)
        })
    };
    assert!(run(1) == run(3));
}

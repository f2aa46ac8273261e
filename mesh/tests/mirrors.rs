//! A part of a symmetric body with mirror planes, against the body.

mod common;

use std::f64::consts::TAU;

use common::bodies::{ball, bent, distance, radius, turned};
use common::random_block::Random;
use common::reflected::{Pair, Plane, reflected};
use octruss_mesh::{
    CurveEnds, FeatureOptions, Hierarchy, Marking, Mirrors, Overshoot, RawMesh, Scheme, Step,
    Strata, SubdivisionMatrix, TetMesh, check, limit_matrix, limit_positions, shapes,
};

const SCHEMES: [Scheme; 4] =
    [Scheme::BoxSpline, Scheme::Averaged, Scheme::LOOP_SOLID, Scheme::INTERPOLATORY];

const X0: Plane = Plane { axis: 0, place: 0.0, group: 1 };
const Y0: Plane = Plane { axis: 1, place: 0.0, group: 2 };
const Z0: Plane = Plane { axis: 2, place: 0.0, group: 3 };

/// A part of a body with the planes it lies between.
struct Part {
    name: &'static str,
    raw: RawMesh,
    planes: Vec<Plane>,
}

impl Part {
    /// Tags what lies in the planes, and the rest as one surface.
    fn new(name: &'static str, mesh: TetMesh, planes: &[Plane]) -> Self {
        let mut raw = mesh.into_raw();
        let topology = octruss_mesh::Topology::new(&raw);
        raw.triangles = Default::default();
        for (face, &triangle) in topology.faces().iter().enumerate() {
            let lies_in = |plane: &&Plane| {
                let off = |v: &u32| (raw.points[*v as usize][plane.axis] - plane.place).abs();
                triangle.iter().all(|v| off(v) < 1e-9)
            };
            if topology.is_boundary(face) {
                raw.triangles.push(triangle, planes.iter().find(lies_in).map_or(9, |p| p.group));
            }
        }
        Self { name, raw, planes: planes.to_vec() }
    }

    /// With its vertices moved at random, those on planes within them.
    fn shaken(mut self, most: f64) -> Self {
        let mut random = Random::new(5);
        for point in &mut self.raw.points {
            for axis in 0..3 {
                let stays = |p: &Plane| p.axis == axis && (point[axis] - p.place).abs() < 1e-9;
                if !self.planes.iter().any(stays) {
                    point[axis] += most * (random.below(1000) as f64 / 500.0 - 1.0);
                }
            }
        }
        self
    }

    fn pair(&self, options: &FeatureOptions, step: Step, levels: usize) -> Pair {
        self.turned_pair(options, step, levels, |p| p)
    }

    /// Both turned alike.
    fn turned_pair(
        &self,
        options: &FeatureOptions,
        step: Step,
        levels: usize,
        turn: impl Fn([f64; 3]) -> [f64; 3],
    ) -> Pair {
        let (body, of) = reflected(&self.raw, &self.planes);
        let [part, body] = [self.raw.clone(), body.into_raw()].map(|mut raw| {
            raw.points.iter_mut().for_each(|point| *point = turn(*point));
            check(raw, &Default::default()).unwrap().mesh
        });
        let groups: Vec<i32> = self.planes.iter().map(|plane| plane.group).collect();
        let options = FeatureOptions { marking: Marking::AsOrdered, ..options.clone() };
        let mirrors = Mirrors::new(&part, &groups).unwrap();
        let mut part = Hierarchy::new(part, &FeatureOptions { mirrors, ..options.clone() });
        let mut body = Hierarchy::new(body, &options);
        for _ in 0..levels {
            part.subdivide(step).unwrap();
            body.subdivide(step).unwrap();
        }
        Pair::new(part, body, of)
    }
}

/// A sector of a square plate about a hole, in so many cells round the hole.
fn sector(turns: f64, cells: [u32; 3]) -> TetMesh {
    let [round, across, through] = cells.map(f64::from);
    bent(cells, |[x, y, z]| {
        let [c, s, _] = turned(turns * x / round, 1.0, 0.0);
        let radius = 1.0 + (2.0 / c.abs().max(s.abs()) - 1.0) * y / across;
        [radius * c, radius * s, z / through]
    })
}

/// The tets of a ball with positive coordinates.
fn octant(splits: usize) -> TetMesh {
    let mut raw = ball(splits).into_raw();
    let is_kept =
        |tet: &[u32; 4]| tet.iter().all(|&v| raw.points[v as usize].iter().all(|x| *x > -1e-9));
    raw.tets.retain(is_kept);
    raw.regions = vec![0; raw.tets.len()];
    check(raw, &octruss_mesh::CheckOptions::default()).unwrap().mesh
}

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

/// Asserts that positions, strata, rows, fields and limits of the part are the body's.
fn assert_alike(pair: &Pair, step: Step, within: f64, name: &str) {
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

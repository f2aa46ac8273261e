//! Parts of symmetric bodies, to be refined with mirror planes beside the bodies.

use octruss_mesh::{
    CheckOptions, FeatureOptions, Hierarchy, Marking, Mirrors, RawMesh, Step, TetMesh, check,
};

use super::bodies::{ball, bent, turned};
use super::random_block::Random;
use super::reflected::{Pair, Plane, reflected};

pub const X0: Plane = Plane { axis: 0, place: 0.0, group: 1 };
pub const Y0: Plane = Plane { axis: 1, place: 0.0, group: 2 };
pub const Z0: Plane = Plane { axis: 2, place: 0.0, group: 3 };

/// A part of a body with the planes it lies between.
pub struct Part {
    pub name: &'static str,
    pub raw: RawMesh,
    pub planes: Vec<Plane>,
}

impl Part {
    /// Tags what lies in the planes, and the rest as one surface.
    pub fn new(name: &'static str, mesh: TetMesh, planes: &[Plane]) -> Self {
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
    pub fn shaken(mut self, most: f64) -> Self {
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

    pub fn pair(&self, options: &FeatureOptions, step: Step, levels: usize) -> Pair {
        self.turned_pair(options, step, levels, |p| p)
    }

    /// Both turned alike.
    pub fn turned_pair(
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
pub fn sector(turns: f64, cells: [u32; 3]) -> TetMesh {
    let [round, across, through] = cells.map(f64::from);
    bent(cells, |[x, y, z]| {
        let [c, s, _] = turned(turns * x / round, 1.0, 0.0);
        let radius = 1.0 + (2.0 / c.abs().max(s.abs()) - 1.0) * y / across;
        let exact = |x: f64| if x.abs() < 1e-12 { 0.0 } else { x };
        [exact(radius * c), exact(radius * s), z / through]
    })
}

/// The tets of a ball with positive coordinates.
pub fn octant(splits: usize) -> TetMesh {
    let mut raw = ball(splits).into_raw();
    let is_kept =
        |tet: &[u32; 4]| tet.iter().all(|&v| raw.points[v as usize].iter().all(|x| *x > -1e-9));
    raw.tets.retain(is_kept);
    raw.regions = vec![0; raw.tets.len()];
    check(raw, &CheckOptions::default()).unwrap().mesh
}

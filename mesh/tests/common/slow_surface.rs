//! Loop's rules with creases on one triangle's surroundings, the slow, obvious
//! way: triangles and creases in sets, everything looked up anew.

use std::collections::{BTreeMap, BTreeSet};

use octruss_mesh::{Strata, Topology};

pub type Point = [f64; 3];

/// One triangle with what touches it; a part of a surface of some level.
#[derive(Debug, Clone)]
pub struct SlowSurface {
    points: Vec<Point>,
    triangles: Vec<[usize; 3]>,
    creases: BTreeSet<[usize; 2]>,
    fixed: BTreeSet<usize>,
    /// The triangle that is followed.
    pub followed: [usize; 3],
}

impl SlowSurface {
    pub fn new(topology: &Topology, strata: &Strata, points: &[Point], face: u32) -> Self {
        let faces = topology.faces().iter().zip(&strata.is_surface).filter(|face| *face.1);
        let edges =
            topology.edges().iter().zip(&strata.edge_dimensions).filter(|edge| *edge.1 == 1);
        let vertices = strata.vertex_dimensions.iter().enumerate().filter(|v| *v.1 == 0);
        Self {
            points: points.to_vec(),
            triangles: faces.map(|face| face.0.map(|v| v as usize)).collect(),
            creases: edges.map(|edge| edge.0.map(|v| v as usize)).collect(),
            fixed: vertices.map(|v| v.0).collect(),
            followed: topology.faces()[face as usize].map(|v| v as usize),
        }
    }

    /// The position of a corner of the triangle that is followed.
    pub fn corner(&self, i: usize) -> Point {
        self.points[self.followed[i]]
    }

    /// Subdivides what touches the triangle and goes to a child: at corner 0, 1
    /// or 2, or 3 in the middle. What cannot be known is not a number.
    pub fn step(&mut self, child: usize) {
        let near = |vertices: &[usize]| vertices.iter().any(|v| self.followed.contains(v));
        let triangles: Vec<[usize; 3]> =
            self.triangles.iter().copied().filter(|t| near(t)).collect();
        let creases: BTreeSet<[usize; 2]> =
            self.creases.iter().copied().filter(|e| near(e)).collect();
        let mut thirds: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        for &[a, b, c] in &triangles {
            for (edge, third) in [([a, b], c), ([b, c], a), ([a, c], b)] {
                thirds.entry(sorted(edge)).or_default().push(third);
            }
        }
        for &edge in &creases {
            thirds.entry(edge).or_default();
        }
        let mut points: Vec<Point> = vec![[f64::NAN; 3]; self.points.len()];
        for v in self.followed {
            points[v] = self.moved(v, &thirds, &creases);
        }
        let mut middle = BTreeMap::new();
        for (&edge, thirds) in &thirds {
            middle.insert(edge, points.len());
            points.push(self.new_vertex(edge, thirds, creases.contains(&edge)));
        }
        let at = |a: usize, b: usize| middle[&sorted([a, b])];
        let split = |[a, b, c]: [usize; 3]| {
            let (ab, bc, ca) = (at(a, b), at(b, c), at(c, a));
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [bc, ca, ab]]
        };
        let followed = split(self.followed)[child];
        let halves =
            creases.iter().flat_map(|&[a, b]| [sorted([a, at(a, b)]), sorted([b, at(a, b)])]);
        self.creases = halves.collect();
        self.triangles = triangles.into_iter().flat_map(split).collect();
        self.followed = followed;
        self.points = points;
    }

    fn moved(
        &self,
        v: usize,
        thirds: &BTreeMap<[usize; 2], Vec<usize>>,
        creases: &BTreeSet<[usize; 2]>,
    ) -> Point {
        let other = |edge: &[usize; 2]| edge[0] + edge[1] - v;
        let along: Vec<usize> = creases.iter().filter(|e| e.contains(&v)).map(other).collect();
        if self.fixed.contains(&v) || along.len() > 2 {
            return self.points[v];
        }
        if along.len() == 2 {
            return self.combined(&[(v, 0.75), (along[0], 0.125), (along[1], 0.125)]);
        }
        // A crease without triangles, which leaves the surface, is no neighbour.
        let on_surface =
            thirds.iter().filter(|(edge, thirds)| edge.contains(&v) && !thirds.is_empty());
        let ring: Vec<usize> = on_surface.map(|(edge, _)| other(edge)).collect();
        let n = ring.len() as f64;
        let beta = if ring.len() == 3 { 3.0 / 16.0 } else { 3.0 / (8.0 * n) };
        let mut weights = vec![(v, 1.0 - n * beta)];
        weights.extend(ring.into_iter().map(|w| (w, beta)));
        self.combined(&weights)
    }

    fn new_vertex(&self, [a, b]: [usize; 2], thirds: &[usize], is_crease: bool) -> Point {
        match *thirds {
            _ if is_crease => self.combined(&[(a, 0.5), (b, 0.5)]),
            [c, d] => self.combined(&[(a, 0.375), (b, 0.375), (c, 0.125), (d, 0.125)]),
            _ => [f64::NAN; 3],
        }
    }

    fn combined(&self, weights: &[(usize, f64)]) -> Point {
        let mut sum = [0.0; 3];
        for &(v, weight) in weights {
            (0..3).for_each(|k| sum[k] += weight * self.points[v][k]);
        }
        sum
    }
}

fn sorted([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

//! The box-spline rules written down the slow, obvious way, beside the fast ones.

use std::collections::{BTreeMap, BTreeSet};

use octruss_mesh::analysis::stars::{Marks, edge_ring, stack};
use octruss_mesh::{
    FeatureOptions, Hierarchy, Level, Scheme, TetMesh, prepare, shapes, subdivision_matrix,
};

type Edge = [u32; 2];

fn edge(a: u32, b: u32) -> Edge {
    [a.min(b), a.max(b)]
}

/// Everything that the rules ask about, collected by brute force.
struct Slow {
    edges: BTreeSet<Edge>,
    surface_faces: Vec<[u32; 3]>,
    creases: BTreeSet<Edge>,
}

impl Slow {
    fn new(mesh: &TetMesh) -> Self {
        let mut faces: BTreeMap<[u32; 3], Vec<i32>> = BTreeMap::new();
        let mut edges = BTreeSet::new();
        for (tet, &region) in mesh.tets().iter().zip(mesh.regions()) {
            for skip in 0..4 {
                let mut face: Vec<u32> = (0..4).filter(|&v| v != skip).map(|v| tet[v]).collect();
                face.sort();
                faces.entry([face[0], face[1], face[2]]).or_default().push(region);
                edges.extend((0..3).map(|i| edge(face[i], face[(i + 1) % 3])));
            }
        }
        let is_surface = |regions: &Vec<i32>| regions.len() == 1 || regions[0] != regions[1];
        let surface_faces =
            faces.into_iter().filter(|(_, r)| is_surface(r)).map(|(f, _)| f).collect();
        let creases = mesh.features().unwrap().creases.iter().copied().collect();
        Self { edges, surface_faces, creases }
    }

    fn is_surface_edge(&self, [a, b]: Edge) -> bool {
        self.surface_faces.iter().any(|face| face.contains(&a) && face.contains(&b))
    }

    fn neighbours(&self, v: u32, wanted: impl Fn(Edge) -> bool) -> Vec<u32> {
        let at = self.edges.iter().filter(|&&e| e.contains(&v) && wanted(e));
        at.map(|[a, b]| a ^ b ^ v).collect()
    }

    fn vertex_row(&self, v: u32) -> BTreeMap<u32, f64> {
        let along_creases = self.neighbours(v, |e| self.creases.contains(&e));
        let on_surface = self.neighbours(v, |e| self.is_surface_edge(e));
        let all = self.neighbours(v, |_| true);
        let (own, each, list) = match along_creases.len() {
            3.. => (1.0, 0.0, vec![]),
            2 => (3.0 / 4.0, 1.0 / 8.0, along_creases),
            _ if !on_surface.is_empty() => {
                let n = on_surface.len() as f64;
                let each = if n == 3.0 { 3.0 / 16.0 } else { 3.0 / (8.0 * n) };
                (1.0 - n * each, each, on_surface)
            }
            _ => (9.0 / 16.0, 7.0 / (16.0 * all.len() as f64), all),
        };
        let mut row = BTreeMap::from([(v, own)]);
        row.extend(list.into_iter().map(|neighbour| (neighbour, each)));
        row
    }

    fn edge_row(&self, mesh: &TetMesh, [a, b]: Edge) -> BTreeMap<u32, f64> {
        let others = |simplices: &mut dyn Iterator<Item = &[u32]>| -> BTreeSet<u32> {
            simplices
                .filter(|s| s.contains(&a) && s.contains(&b))
                .flatten()
                .copied()
                .filter(|&v| v != a && v != b)
                .collect()
        };
        let (own, each, list) = if self.creases.contains(&[a, b]) {
            (1.0 / 2.0, 0.0, BTreeSet::new())
        } else if self.is_surface_edge([a, b]) {
            (3.0 / 8.0, 1.0 / 8.0, others(&mut self.surface_faces.iter().map(|f| &f[..])))
        } else {
            let link = others(&mut mesh.tets().iter().map(|t| &t[..]));
            let k = link.len() as f64;
            if k == 4.0 {
                (1.0 / 4.0, 1.0 / 8.0, link)
            } else {
                (5.0 / 16.0, 3.0 / (8.0 * k), link)
            }
        };
        let mut row = BTreeMap::from([(a, own), (b, own)]);
        row.extend(list.into_iter().map(|neighbour| (neighbour, each)));
        row
    }
}

fn two_regions(n: u32) -> TetMesh {
    let mut raw = shapes::kuhn_cube(n).into_raw();
    for (tet, region) in raw.tets.iter().zip(&mut raw.regions) {
        let centre: f64 = tet.iter().map(|&v| raw.points[v as usize][0]).sum::<f64>() / 4.0;
        *region = if centre < 0.5 { 1 } else { 2 };
    }
    octruss_mesh::check(raw, &Default::default()).unwrap().mesh
}

#[test]
fn every_weight_equals_the_slow_reference() {
    let smooth = FeatureOptions { crease_angle: 180.0, ..FeatureOptions::default() };
    let sharp = FeatureOptions::default();
    let meshes = [
        prepare(shapes::five_tet_cube(), &sharp),
        prepare(shapes::five_tet_cube(), &smooth),
        prepare(two_regions(2), &sharp),
        prepare(two_regions(2), &smooth),
        stack(5, 2),
        edge_ring(5, Marks::Twist),
    ];
    for coarse in meshes {
        let mut levels = Hierarchy::new(coarse, &sharp);
        levels.subdivide(Scheme::BoxSpline).unwrap();
        for level in levels.levels() {
            let Level { mesh, topology, .. } = &**level;
            let slow = Slow::new(mesh);
            let matrix = subdivision_matrix(mesh, topology, Scheme::BoxSpline);
            let n = mesh.points().len();
            assert_eq!(slow.edges.len(), topology.edges().len());
            for row in 0..matrix.rows() {
                let (columns, weights) = matrix.row(row);
                let fast: BTreeMap<u32, f64> =
                    columns.iter().copied().zip(weights.iter().copied()).collect();
                let expected = match row.checked_sub(n) {
                    None => slow.vertex_row(row as u32),
                    Some(e) => slow.edge_row(mesh, topology.edges()[e]),
                };
                assert_eq!(fast, expected, "row {row}");
            }
        }
    }
}

//! Edges and faces of a mesh from scratch, by grouping and tiny sorts.
//!
//! Only distinct edges and faces are made by sorting; the tets then look their
//! own up in the short lists of their vertices and edges.

use rayon::prelude::*;

use super::edges_and_faces::{NONE, Topology, ascending, find_edge};
use crate::core::raw_mesh::RawMesh;
use crate::core::reference_tet::edge_between;
use octruss_base::groups::Groups;
use octruss_base::large_array::zeroed;
use octruss_base::ragged::{self, CHUNK};

impl Topology {
    /// Finds edges and faces by sorting. Vertex numbers must be in range.
    pub fn new(mesh: &RawMesh) -> Self {
        let (edges, first_edges) = distinct_edges(mesh);
        let mut topology = Self {
            edges,
            first_edges,
            faces: Vec::new(),
            first_faces: Vec::new(),
            face_edges: Vec::new(),
            face_tets: Vec::new(),
            tet_edges: Vec::new(),
            tet_faces: Vec::new(),
        };
        topology.tet_edges = per_tet(mesh, |_, tet| topology.edges_of(tet));
        topology.add_faces(mesh);
        topology.tet_faces = per_tet(mesh, |t, tet| topology.faces_of(t, tet));
        topology
    }

    /// The edges of a tet, which has them.
    fn edges_of(&self, tet: &Ordered) -> [u32; 6] {
        let mut edges = [0; 6];
        for (i, &low) in tet.vertices[..3].iter().enumerate() {
            let mut edge = self.first_edges[low as usize];
            for j in i + 1..4 {
                while self.edges[edge as usize][1] != tet.vertices[j] {
                    edge += 1;
                }
                edges[edge_between(tet.local[i], tet.local[j])] = edge;
            }
        }
        edges
    }

    /// The faces of tet number `t`, which has them.
    fn faces_of(&self, t: usize, tet: &Ordered) -> [u32; 4] {
        let mut faces = [0; 4];
        for ((first, last), opposite) in
            self.first_edges_of_faces(t, tet).into_iter().zip(tet.local)
        {
            let mut face = self.first_faces[first as usize];
            while self.faces[face as usize][2] != last {
                face += 1;
            }
            faces[opposite] = face;
        }
        faces
    }

    /// First edge and last vertex of the faces of tet number `t`, each opposite
    /// to one of its ascending vertices.
    fn first_edges_of_faces(&self, t: usize, tet: &Ordered) -> [(u32, u32); 4] {
        let edge = |i: usize, j: usize| self.tet_edges[t][edge_between(tet.local[i], tet.local[j])];
        let [_, _, c, d] = tet.vertices;
        [(edge(1, 2), d), (edge(0, 2), d), (edge(0, 1), d), (edge(0, 1), c)]
    }

    /// A face goes to its first edge, with its last vertex: since edges are
    /// sorted, that is the lexicographic order of faces.
    fn add_faces(&mut self, mesh: &RawMesh) {
        let (tets, triangles) = (mesh.tets.len(), &mesh.triangles.simplices);
        let edge = |a, b| self.edge_between(a, b).expect("a triangle has its edges");
        let emit = |source: usize| {
            let mut faces = [(0, (0, NONE)); 4];
            let count = if let Some(&tet) = mesh.tets.get(source) {
                faces = self
                    .first_edges_of_faces(source, &Ordered::new(tet))
                    .map(|(first, last)| (first, (last, source as u32)));
                4
            } else {
                let [a, b, c] = ascending(triangles[source - tets]);
                faces[0] = (edge(a, b), (c, NONE));
                1
            };
            faces.into_iter().take(count)
        };
        // (last vertex, tet) pairs at each first edge.
        let groups = Groups::new(self.edges.len(), tets + triangles.len(), emit).sort();
        let runs = |edge| groups.runs(edge, |p: &(u32, u32), q| p.0 == q.0);
        self.first_faces = ragged::offsets(groups.keys(), |edge| runs(edge).count());
        let count = self.first_faces[self.edges.len()] as usize;
        (self.faces, self.face_edges, self.face_tets) =
            (zeroed(count), zeroed(count), zeroed(count));
        let (edges, first_edges) = (&self.edges, &self.first_edges);
        let number =
            |a: u32, b: u32| find_edge(edges, first_edges, a, b).expect("faces have edges");
        let arrays = (&mut self.faces[..], &mut self.face_edges[..], &mut self.face_tets[..]);
        ragged::for_each(&self.first_faces, arrays, |first, last, (vertices, sides, tets)| {
            let runs = (first..last).flat_map(|edge| runs(edge).map(move |run| (edge, run)));
            for (at, (edge, run)) in runs.enumerate() {
                let ([a, b], c) = (edges[edge], run[0].0);
                vertices[at] = [a, b, c];
                sides[at] = [edge as u32, number(a, c), number(b, c)];
                // Entries of one face are sorted by tet.
                tets[at] = [0, 1].map(|i| run.get(i).map_or(NONE, |&(_, tet)| tet));
            }
        });
    }
}

/// A tet's vertices in ascending order, and their local numbers.
struct Ordered {
    vertices: [u32; 4],
    local: [usize; 4],
}

impl Ordered {
    fn new(tet: [u32; 4]) -> Self {
        let mut local = [0, 1, 2, 3];
        let mut sort = |i: usize, j: usize| {
            if tet[local[i]] > tet[local[j]] {
                local.swap(i, j);
            }
        };
        // A sorting network.
        [(0, 1), (2, 3), (0, 2), (1, 3), (1, 2)].into_iter().for_each(|(i, j)| sort(i, j));
        Self { vertices: local.map(|i| tet[i]), local }
    }
}

fn per_tet<T: Copy + Default + Send>(
    mesh: &RawMesh,
    value: impl Fn(usize, &Ordered) -> T + Sync,
) -> Vec<T> {
    let mut values = zeroed(mesh.tets.len());
    let each = values.par_iter_mut().zip(&mesh.tets).with_min_len(CHUNK).enumerate();
    each.for_each(|(t, (slot, &tet))| *slot = value(t, &Ordered::new(tet)));
    values
}

/// All edges, and where those of each lower end begin.
fn distinct_edges(mesh: &RawMesh) -> (Vec<[u32; 2]>, Vec<u32>) {
    let (tets, triangles) = (&mesh.tets, &mesh.triangles.simplices);
    let emit = |source: usize| {
        let mut edges = [(0, 0); 6];
        let count = if let Some(&tet) = tets.get(source) {
            let [a, b, c, d] = ascending(tet);
            edges = [(a, b), (a, c), (a, d), (b, c), (b, d), (c, d)];
            6
        } else if let Some(&triangle) = triangles.get(source - tets.len()) {
            let [a, b, c] = ascending(triangle);
            edges[..3].copy_from_slice(&[(a, b), (a, c), (b, c)]);
            3
        } else {
            let [a, b] = ascending(mesh.edges.simplices[source - tets.len() - triangles.len()]);
            edges[0] = (a, b);
            1
        };
        edges.into_iter().take(count)
    };
    let sources = tets.len() + triangles.len() + mesh.edges.len();
    let groups = Groups::new(mesh.points.len(), sources, emit).sort();
    let runs = |vertex| groups.runs(vertex, |p, q| p == q);
    let first_edges = ragged::offsets(groups.keys(), |vertex| runs(vertex).count());
    let mut edges = zeroed(first_edges[groups.keys()] as usize);
    ragged::for_each(&first_edges, &mut edges[..], |first, last, edges| {
        let ends = (first..last).flat_map(|low| runs(low).map(move |run| [low as u32, run[0]]));
        edges.iter_mut().zip(ends).for_each(|(edge, ends)| *edge = ends);
    });
    (edges, first_edges)
}

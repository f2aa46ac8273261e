//! Edges and faces of a mesh, and who touches whom.

use rayon::prelude::*;

use crate::buckets::{Counting, Entry};
use crate::chunks::{self, CHUNK};
use crate::raw_mesh::RawMesh;
use crate::reference_tet::{EDGES, FACES, edge_between};

/// Stands for "no tet" in [`Topology::face_tets`].
pub const NONE: u32 = u32::MAX;

/// Edges and faces, numbered lexicographically by their ascending vertex
/// numbers, and their incidences with the tets.
///
/// Edges are those of tets, tagged triangles and tagged edges; faces those of
/// tets and tagged triangles. Derived from a mesh by sorting, never stored in
/// it; the same bits for any number of threads.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Topology {
    pub(crate) edges: Vec<[u32; 2]>,
    pub(crate) first_edges: Vec<u32>,
    pub(crate) faces: Vec<[u32; 3]>,
    pub(crate) face_edges: Vec<[u32; 3]>,
    pub(crate) face_tets: Vec<[u32; 2]>,
    pub(crate) tet_edges: Vec<[u32; 6]>,
    pub(crate) tet_faces: Vec<[u32; 4]>,
}

impl Topology {
    /// Finds edges and faces by sorting. Vertex numbers must be in range.
    pub fn new(mesh: &RawMesh) -> Self {
        let edges = EdgeTable::new(mesh);
        let faces = FaceTable::new(mesh, &edges);
        Self {
            edges: edges.edges,
            first_edges: edges.first_edges,
            faces: faces.faces,
            face_edges: faces.face_edges,
            face_tets: faces.face_tets,
            tet_edges: edges.tet_edges,
            tet_faces: faces.tet_faces,
        }
    }

    /// How many vertices the numbering covers.
    pub fn vertex_count(&self) -> usize {
        self.first_edges.len() - 1
    }

    /// The ends of each edge, ascending; edges sorted.
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// The vertices of each face, ascending; faces sorted.
    pub fn faces(&self) -> &[[u32; 3]] {
        &self.faces
    }

    /// For each face a < b < c its edges ab, ac, bc.
    pub fn face_edges(&self) -> &[[u32; 3]] {
        &self.face_edges
    }

    /// The tets on each face, the smaller number first; [`NONE`] where there is
    /// none. Meaningful only where no face has more than two.
    pub fn face_tets(&self) -> &[[u32; 2]] {
        &self.face_tets
    }

    /// The edges of each tet, in the order of [`crate::reference_tet::EDGES`].
    pub fn tet_edges(&self) -> &[[u32; 6]] {
        &self.tet_edges
    }

    /// The faces of each tet, face i opposite its vertex i.
    pub fn tet_faces(&self) -> &[[u32; 4]] {
        &self.tet_faces
    }

    /// The number of the edge between two vertices, if there is one.
    pub fn edge_between(&self, a: u32, b: u32) -> Option<u32> {
        let (low, high) = (a.min(b), a.max(b));
        let start = *self.first_edges.get(low as usize)? as usize;
        let end = *self.first_edges.get(low as usize + 1)? as usize;
        let found = self.edges[start..end].binary_search_by_key(&high, |edge| edge[1]).ok()?;
        Some((start + found) as u32)
    }

    /// The number of the face with these three vertices, in any order.
    pub fn face_of(&self, triangle: [u32; 3]) -> Option<u32> {
        let face = ascending(triangle);
        self.faces.binary_search(&face).ok().map(|found| found as u32)
    }

    /// Whether a face belongs to exactly one tet.
    pub fn is_boundary(&self, face: usize) -> bool {
        let [first, second] = self.face_tets[face];
        first != NONE && second == NONE
    }
}

pub(crate) fn ascending<const N: usize>(mut vertices: [u32; N]) -> [u32; N] {
    vertices.sort_unstable();
    vertices
}

struct EdgeTable {
    edges: Vec<[u32; 2]>,
    first_edges: Vec<u32>,
    tet_edges: Vec<[u32; 6]>,
    triangle_edges: Vec<[u32; 3]>,
}

impl EdgeTable {
    fn new(mesh: &RawMesh) -> Self {
        let tets = &mesh.tets;
        let triangles = &mesh.triangles.simplices;
        let free = &mesh.edges.simplices;
        let tet_slots = 6 * tets.len();
        let triangle_slots = 3 * triangles.len();
        let tet_entries =
            |t: usize| std::array::from_fn(|e| edge_entry(EDGES[e].map(|v| tets[t][v]), 6 * t + e));
        let triangle_entries = |t: usize| {
            let [a, b, c] = ascending(triangles[t]);
            let edges = [[a, b], [a, c], [b, c]];
            std::array::from_fn(|e| edge_entry(edges[e], tet_slots + 3 * t + e))
        };
        let free_entries = |e: usize| [edge_entry(free[e], tet_slots + triangle_slots + e)];
        let buckets = Counting::new(mesh.points.len())
            .count::<6>(tets.len(), |t| tet_entries(t).map(|entry| entry.bucket))
            .count::<3>(triangles.len(), |t| triangle_entries(t).map(|entry| entry.bucket))
            .count(free.len(), |e| free_entries(e).map(|entry| entry.bucket))
            .place()
            .place(tets.len(), tet_entries)
            .place(triangles.len(), triangle_entries)
            .place(free.len(), free_entries)
            .sort();
        let first_edges = buckets.distinct_offsets();
        let edges = buckets.map_distinct(&first_edges, |low, run| [low, run[0].key]);
        let slots = tet_slots + triangle_slots + free.len();
        let mut numbers = buckets.number_payloads(&first_edges, slots);
        numbers.truncate(tet_slots + triangle_slots);
        let triangle_edges = numbers[tet_slots..].as_chunks::<3>().0.to_vec();
        let tet_edges = numbers[..tet_slots].as_chunks::<6>().0.to_vec();
        Self { edges, first_edges, tet_edges, triangle_edges }
    }
}

fn edge_entry(ends: [u32; 2], slot: usize) -> Entry {
    let [low, high] = ascending(ends);
    Entry { bucket: low, key: high, payload: slot as u32 }
}

struct FaceTable {
    faces: Vec<[u32; 3]>,
    face_edges: Vec<[u32; 3]>,
    face_tets: Vec<[u32; 2]>,
    tet_faces: Vec<[u32; 4]>,
}

impl FaceTable {
    /// A face goes to the bucket of its first edge, with its last vertex as key:
    /// since edges are sorted, that is the lexicographic order of faces.
    fn new(mesh: &RawMesh, edges: &EdgeTable) -> Self {
        let tets = &mesh.tets;
        let triangles = &mesh.triangles.simplices;
        let tet_slots = 4 * tets.len();
        let tet_face_edges = |t: usize, f: usize| {
            let local = FACES[f];
            let mut order = [0, 1, 2];
            order.sort_unstable_by_key(|&i| tets[t][local[i]]);
            let [a, b, c] = order.map(|i| local[i]);
            let number = |p, q| edges.tet_edges[t][edge_between(p, q)];
            ([number(a, b), number(a, c), number(b, c)], tets[t][c])
        };
        let tet_entries = |t: usize| {
            std::array::from_fn(|f| {
                let (face_edges, last) = tet_face_edges(t, f);
                Entry { bucket: face_edges[0], key: last, payload: (4 * t + f) as u32 }
            })
        };
        let triangle_entries = |t: usize| {
            let last = ascending(triangles[t])[2];
            [Entry {
                bucket: edges.triangle_edges[t][0],
                key: last,
                payload: (tet_slots + t) as u32,
            }]
        };
        let buckets = Counting::new(edges.edges.len())
            .count::<4>(tets.len(), |t| tet_entries(t).map(|entry| entry.bucket))
            .count(triangles.len(), |t| [edges.triangle_edges[t][0]])
            .place()
            .place(tets.len(), tet_entries)
            .place(triangles.len(), triangle_entries)
            .sort();
        let first_faces = buckets.distinct_offsets();
        let faces = buckets.map_distinct(&first_faces, |edge, run| {
            let [a, b] = edges.edges[edge as usize];
            [a, b, run[0].key]
        });
        let face_edges = buckets.map_distinct(&first_faces, |_, run| {
            let slot = run[0].payload as usize;
            if slot < tet_slots {
                tet_face_edges(slot / 4, slot % 4).0
            } else {
                edges.triangle_edges[slot - tet_slots]
            }
        });
        let face_tets = buckets.map_distinct(&first_faces, |_, run| {
            let tet = |i: usize| match run.get(i) {
                Some(pair) if (pair.payload as usize) < tet_slots => pair.payload / 4,
                _ => NONE,
            };
            [tet(0), tet(1)]
        });
        let mut numbers = buckets.number_payloads(&first_faces, tet_slots + triangles.len());
        numbers.truncate(tet_slots);
        Self { faces, face_edges, face_tets, tet_faces: numbers.as_chunks::<4>().0.to_vec() }
    }
}

/// The edges at each vertex, ascending.
///
/// The place of edge e in the list of vertex v, counted over all lists, is also
/// the number of the half edge (v, midpoint of e) in the red-refined mesh.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct VertexEdges {
    offsets: Vec<u32>,
    edges: Vec<u32>,
}

impl VertexEdges {
    /// Lists the edges at every vertex.
    pub fn new(topology: &Topology) -> Self {
        let edges = topology.edges();
        let entry = |e: usize| edges[e].map(|v| Entry { bucket: v, key: e as u32, payload: 0 });
        let buckets = Counting::new(topology.vertex_count())
            .count(edges.len(), |e| edges[e])
            .place()
            .place(edges.len(), entry)
            .sort();
        let offsets = buckets.offsets().to_vec();
        let edges = buckets.map_distinct(&offsets, |_, run| run[0].key);
        Self { offsets, edges }
    }

    /// The edges at one vertex, ascending.
    pub fn of(&self, vertex: usize) -> &[u32] {
        &self.edges[self.offsets[vertex] as usize..self.offsets[vertex + 1] as usize]
    }

    /// Where the list of each vertex starts; one more offset than vertices.
    pub(crate) fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// The half edges (v, first_midpoint + e) in the order of the lists.
    pub(crate) fn half_edges(&self, first_midpoint: u32) -> Vec<[u32; 2]> {
        let mut halves = vec![[0; 2]; self.edges.len()];
        chunks::for_each(&self.offsets, &mut halves, |first, last, chunk| {
            let ends = (first..last)
                .flat_map(|v| self.of(v).iter().map(move |&e| [v as u32, first_midpoint + e]));
            for (half, ends) in chunk.iter_mut().zip(ends) {
                *half = ends;
            }
        });
        halves
    }

    /// For each edge, its places in the lists of its lower and its higher end.
    pub fn places(&self, topology: &Topology) -> Vec<[u32; 2]> {
        let place = |vertex: u32, edge: u32| {
            let at = self
                .of(vertex as usize)
                .binary_search(&edge)
                .expect("an edge is listed at its ends");
            self.offsets[vertex as usize] + at as u32
        };
        topology
            .edges()
            .par_iter()
            .with_min_len(CHUNK)
            .enumerate()
            .map(|(edge, ends)| ends.map(|vertex| place(vertex, edge as u32)))
            .collect()
    }
}

/// The tets round each edge, as slots 6 · tet + local edge, ascending.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EdgeTets {
    offsets: Vec<u32>,
    slots: Vec<u32>,
}

impl EdgeTets {
    /// Lists the tets round every edge.
    pub fn new(topology: &Topology) -> Self {
        let tet_edges = topology.tet_edges();
        let entries = |t: usize| {
            std::array::from_fn(|e| Entry {
                bucket: tet_edges[t][e],
                key: (6 * t + e) as u32,
                payload: 0,
            })
        };
        let buckets = Counting::new(topology.edges().len())
            .count(tet_edges.len(), |t| tet_edges[t])
            .place()
            .place::<6>(tet_edges.len(), entries)
            .sort();
        let offsets = buckets.offsets().to_vec();
        let slots = buckets.map_distinct(&offsets, |_, run| run[0].key);
        Self { offsets, slots }
    }

    /// The slots 6 · tet + local edge round one edge, ascending.
    pub fn of(&self, edge: usize) -> &[u32] {
        &self.slots[self.offsets[edge] as usize..self.offsets[edge + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{five_tet_cube, kuhn_cube, regular_tet};

    /// Edges and faces collected the slow, obvious way.
    fn slow(mesh: &RawMesh) -> (Vec<[u32; 2]>, Vec<[u32; 3]>) {
        let mut edges = std::collections::BTreeSet::new();
        let mut faces = std::collections::BTreeSet::new();
        for tet in &mesh.tets {
            edges.extend(EDGES.map(|e| ascending(e.map(|v| tet[v]))));
            faces.extend(FACES.map(|f| ascending(f.map(|v| tet[v]))));
        }
        for &[a, b, c] in &mesh.triangles.simplices {
            edges.extend([[a, b], [a, c], [b, c]].map(ascending));
            faces.insert(ascending([a, b, c]));
        }
        edges.extend(mesh.edges.simplices.iter().map(|&e| ascending(e)));
        (edges.into_iter().collect(), faces.into_iter().collect())
    }

    #[test]
    fn edges_and_faces_are_sorted_and_complete() {
        let mut free = kuhn_cube(2).into_raw();
        free.points.extend([[5.0, 0.0, 0.0], [6.0, 0.0, 0.0], [5.0, 1.0, 0.0], [9.0, 0.0, 0.0]]);
        free.triangles.push([29, 27, 28], 8);
        free.edges.push([30, 0], 9);
        for mesh in [regular_tet().into_raw(), five_tet_cube().into_raw(), free] {
            let topology = Topology::new(&mesh);
            let (edges, faces) = slow(&mesh);
            assert_eq!(topology.edges(), edges);
            assert_eq!(topology.faces(), faces);
            for (t, tet) in mesh.tets.iter().enumerate() {
                for e in 0..6 {
                    let edge = topology.tet_edges()[t][e] as usize;
                    assert_eq!(topology.edges()[edge], ascending(EDGES[e].map(|v| tet[v])));
                }
                for f in 0..4 {
                    let face = topology.tet_faces()[t][f] as usize;
                    assert_eq!(topology.faces()[face], ascending(FACES[f].map(|v| tet[v])));
                    assert!(topology.face_tets()[face].contains(&(t as u32)));
                }
            }
            for (f, &[a, b, c]) in topology.faces().iter().enumerate() {
                let edges = topology.face_edges()[f].map(|e| topology.edges()[e as usize]);
                assert_eq!(edges, [[a, b], [a, c], [b, c]]);
                assert_eq!(topology.face_of([c, a, b]), Some(f as u32));
            }
            for (e, &[a, b]) in topology.edges().iter().enumerate() {
                assert_eq!(topology.edge_between(b, a), Some(e as u32));
            }
        }
    }

    #[test]
    fn a_free_triangle_has_no_tets_and_a_cube_has_its_boundary() {
        let mut mesh = kuhn_cube(3).into_raw();
        let n = mesh.points.len() as u32;
        mesh.points.extend([[5.0, 0.0, 0.0], [6.0, 0.0, 0.0], [5.0, 1.0, 0.0]]);
        mesh.triangles.push([n, n + 1, n + 2], 8);
        let topology = Topology::new(&mesh);
        let free = topology.face_of([n, n + 1, n + 2]).unwrap() as usize;
        assert_eq!(topology.face_tets()[free], [NONE, NONE]);
        let boundary = (0..topology.faces().len()).filter(|&f| topology.is_boundary(f)).count();
        assert_eq!(boundary, 6 * 2 * 9);
        // Euler: V − E + F − T = 1 for the cube, 1 for the triangle.
        let count = mesh.points.len() as i64 - topology.edges().len() as i64
            + topology.faces().len() as i64;
        assert_eq!(count - mesh.tets.len() as i64, 2);
    }

    #[test]
    fn incidences_list_every_edge_at_its_ends_and_tets() {
        let mesh = five_tet_cube().into_raw();
        let topology = Topology::new(&mesh);
        let vertex_edges = VertexEdges::new(&topology);
        for v in 0..mesh.points.len() {
            let slow: Vec<u32> = (0..topology.edges().len() as u32)
                .filter(|&e| topology.edges()[e as usize].contains(&(v as u32)))
                .collect();
            assert_eq!(vertex_edges.of(v), slow);
        }
        let round = EdgeTets::new(&topology);
        for e in 0..topology.edges().len() {
            for &slot in round.of(e) {
                assert_eq!(topology.tet_edges()[slot as usize / 6][slot as usize % 6], e as u32);
            }
        }
        assert_eq!((0..topology.edges().len()).map(|e| round.of(e).len()).sum::<usize>(), 30);
    }
}

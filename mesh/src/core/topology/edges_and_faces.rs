//! The edges and faces of a mesh, with their incidences.

use octruss_base::groups::Groups;

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
    /// The first edge of each lower end; one more than vertices.
    pub(crate) first_edges: Vec<u32>,
    pub(crate) faces: Vec<[u32; 3]>,
    /// The first face of each first edge; one more than edges.
    pub(crate) first_faces: Vec<u32>,
    pub(crate) face_edges: Vec<[u32; 3]>,
    pub(crate) face_tets: Vec<[u32; 2]>,
    pub(crate) tet_edges: Vec<[u32; 6]>,
    pub(crate) tet_faces: Vec<[u32; 4]>,
}

impl Topology {
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

    /// The edges of each tet, in the order of [`crate::core::reference_tet::EDGES`].
    pub fn tet_edges(&self) -> &[[u32; 6]] {
        &self.tet_edges
    }

    /// The faces of each tet, face i opposite its vertex i.
    pub fn tet_faces(&self) -> &[[u32; 4]] {
        &self.tet_faces
    }

    /// The edges whose lower end is a vertex; ascending, as are their higher ends.
    ///
    /// # Panics
    /// If there is no such vertex.
    pub fn edges_from(&self, vertex: usize) -> std::ops::Range<u32> {
        self.first_edges[vertex]..self.first_edges[vertex + 1]
    }

    /// The edges by their higher end, ascending, as are their lower ends.
    ///
    /// Edges are sorted by their lower end: those that end in a vertex come before those
    /// of [`Self::edges_from`].
    pub fn edges_to(&self) -> Groups<u32> {
        let edges = &self.edges;
        Groups::new(self.vertex_count(), edges.len(), |e| [(edges[e][1], e as u32)])
    }

    /// The number of the edge between two vertices, if there is one.
    pub fn edge_between(&self, a: u32, b: u32) -> Option<u32> {
        find_edge(&self.edges, &self.first_edges, a, b)
    }

    /// The number of the face with these three vertices, in any order.
    pub fn face_of(&self, triangle: [u32; 3]) -> Option<u32> {
        let [a, b, c] = ascending(triangle);
        let mut range = self.faces_from(self.edge_between(a, b)?);
        range.find(|&face| self.faces[face as usize][2] == c)
    }

    /// The faces whose two smallest vertices are the ends of an edge; ascending,
    /// as are their third vertices.
    pub(crate) fn faces_from(&self, edge: u32) -> std::ops::Range<u32> {
        self.first_faces[edge as usize]..self.first_faces[edge as usize + 1]
    }

    /// Whether a face belongs to exactly one tet.
    pub fn is_boundary(&self, face: usize) -> bool {
        let [first, second] = self.face_tets[face];
        first != NONE && second == NONE
    }
}

pub(super) fn find_edge(edges: &[[u32; 2]], first_edges: &[u32], a: u32, b: u32) -> Option<u32> {
    let (low, high) = (a.min(b), a.max(b));
    let start = *first_edges.get(low as usize)? as usize;
    let end = *first_edges.get(low as usize + 1)? as usize;
    let found = edges[start..end].binary_search_by_key(&high, |edge| edge[1]).ok()?;
    Some((start + found) as u32)
}

pub(crate) fn ascending<const N: usize>(mut vertices: [u32; N]) -> [u32; N] {
    vertices.sort_unstable();
    vertices
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::raw_mesh::RawMesh;
    use crate::core::reference_tet::{EDGES, FACES};
    use crate::core::shapes::{five_tet_cube, kuhn_cube, regular_tet};
    use crate::core::topology::{EdgeTets, VertexEdges};

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

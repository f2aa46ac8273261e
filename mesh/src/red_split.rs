//! The red split of a whole mesh: every tet into eight, with the fine mesh's
//! edges and faces taken over from the parents', in the order that sorting
//! from scratch would give.
//!
//! Fine vertices are the coarse ones, then the midpoint n + e of each edge e.
//! So the fine edges are, in lexicographic order,
//!
//! * the halves (v, n + e), in the order of [`VertexEdges`], then
//! * the inner edges (n + e, n + e'), three a face (each cuts off one corner)
//!   and one a tet (its diagonal), grouped by e < e';
//!
//! and the fine faces follow their first edge: three corner faces and a middle
//! face from each coarse face, eight inner faces from each tet.

use std::sync::LazyLock;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use rayon::prelude::*;

use crate::buckets::{Counting, Entry};
use crate::chunks::CHUNK;
use crate::reference_tet::{CHILDREN, EDGES, FACES, MARKING_PERMUTATIONS, PAIRS, edge_between};
use crate::topology::{NONE, Topology, VertexEdges, ascending};

/// Fine tets, with their edges and faces.
pub(crate) struct RedSplit {
    pub tets: Vec<[u32; 4]>,
    pub topology: Topology,
}

/// The coarse tets, and the pair of each whose diagonal splits it.
pub(crate) struct Parents<'a> {
    pub tets: &'a [[u32; 4]],
    pub topology: &'a Topology,
    /// As in [`MARKING_PERMUTATIONS`]; without them, all split their marked pair.
    pub pairs: Option<&'a [u8]>,
}

/// Splits every tet; child k of tet t is tet 8 t + k.
pub(crate) fn red_split(coarse: &Parents, vertex_edges: &VertexEdges) -> RedSplit {
    let fine_edges = FineEdges::new(coarse, vertex_edges);
    let fine_faces = FineFaces::new(coarse, &fine_edges);
    let parents =
        || (0..coarse.tets.len()).into_par_iter().with_min_len(CHUNK).map(|t| coarse.parent(t));
    let fine_tets: Vec<[[u32; 4]; 8]> =
        parents().map(|parent| CHILDREN.map(|nodes| nodes.map(|node| parent.node(node)))).collect();
    let tet_edges: Vec<[[u32; 6]; 8]> = parents()
        .map(|parent| SLOTS.edges.map(|slots| slots.map(|slot| parent.edge(slot, &fine_edges))))
        .collect();
    let tet_faces: Vec<[[u32; 4]; 8]> = parents()
        .map(|parent| SLOTS.faces.map(|slots| slots.map(|slot| parent.face(slot, &fine_faces))))
        .collect();
    let tet_faces = tet_faces.into_flattened();
    let face_tets = face_tets(&tet_faces, fine_faces.faces.len());
    let topology = Topology {
        edges: fine_edges.edges,
        first_edges: fine_edges.first_edges,
        faces: fine_faces.faces,
        face_edges: fine_faces.face_edges,
        face_tets,
        tet_edges: tet_edges.into_flattened(),
        tet_faces,
    };
    RedSplit { tets: fine_tets.into_flattened(), topology }
}

/// Where an edge of a child comes from.
#[derive(Clone, Copy)]
enum EdgeSlot {
    /// The half of the parent's edge at one of its ends (a local vertex).
    Half { edge: usize, end: usize },
    /// In a face of the parent, the edge that cuts off a local vertex.
    Cut { face: usize, corner: usize },
    /// The inner diagonal.
    Diagonal,
}

/// Where a face of a child comes from.
#[derive(Clone, Copy)]
enum FaceSlot {
    /// The part of a parent's face at a local vertex.
    Corner { face: usize, corner: usize },
    /// The middle part of a parent's face.
    Middle { face: usize },
    /// One of the eight faces inside the parent.
    Inner { index: usize },
}

struct Slots {
    edges: [[EdgeSlot; 6]; 8],
    faces: [[FaceSlot; 4]; 8],
    /// Each inner face as the three parent's edges whose midpoints it joins.
    inner: [[usize; 3]; 8],
    /// The edge between the midpoints of two edges of the parent.
    between: [[EdgeSlot; 6]; 6],
}

static SLOTS: LazyLock<Slots> = LazyLock::new(Slots::new);

impl Slots {
    fn new() -> Self {
        let mut inner: Vec<[usize; 3]> = Vec::new();
        let edges = CHILDREN.map(|child| EDGES.map(|ends| edge_slot(ends.map(|v| child[v]))));
        let faces =
            CHILDREN.map(|child| FACES.map(|face| face_slot(face.map(|v| child[v]), &mut inner)));
        let inner = inner.try_into().expect("eight faces lie inside a split tet");
        // No child has an edge from a midpoint to itself; that entry is never read.
        let slot = |a, b| if a == b { EdgeSlot::Diagonal } else { edge_slot([4 + a, 4 + b]) };
        let between = std::array::from_fn(|a| std::array::from_fn(|b| slot(a, b)));
        Self { edges, faces, inner, between }
    }
}

/// The local face that holds two edges meeting in `corner`, given their other ends.
fn face_with(corner: usize, others: [usize; 2]) -> usize {
    6 - corner - others[0] - others[1]
}

fn edge_slot(nodes: [usize; 2]) -> EdgeSlot {
    let [low, high] = if nodes[0] < nodes[1] { nodes } else { [nodes[1], nodes[0]] };
    if low < 4 {
        return EdgeSlot::Half { edge: high - 4, end: low };
    }
    let [[a, b], [c, d]] = [low, high].map(|node| EDGES[node - 4]);
    match (a == c, b == c, a == d, b == d) {
        (true, ..) => EdgeSlot::Cut { face: face_with(a, [b, d]), corner: a },
        (_, true, ..) => EdgeSlot::Cut { face: face_with(b, [a, d]), corner: b },
        (_, _, true, _) => EdgeSlot::Cut { face: face_with(a, [b, c]), corner: a },
        (.., true) => EdgeSlot::Cut { face: face_with(b, [a, c]), corner: b },
        _ => EdgeSlot::Diagonal,
    }
}

fn face_slot(nodes: [usize; 3], inner: &mut Vec<[usize; 3]>) -> FaceSlot {
    let mut nodes = nodes;
    nodes.sort_unstable();
    if nodes[0] < 4 {
        let others = [nodes[1], nodes[2]].map(|node| {
            let [a, b] = EDGES[node - 4];
            if a == nodes[0] { b } else { a }
        });
        return FaceSlot::Corner { face: face_with(nodes[0], others), corner: nodes[0] };
    }
    let edges = nodes.map(|node| node - 4);
    for (face, vertices) in FACES.iter().enumerate() {
        let [a, b, c] = *vertices;
        let mut round = [edge_between(a, b), edge_between(a, c), edge_between(b, c)];
        round.sort_unstable();
        if round == edges {
            return FaceSlot::Middle { face };
        }
    }
    let index = inner.iter().position(|&known| known == edges).unwrap_or_else(|| {
        inner.push(edges);
        inner.len() - 1
    });
    FaceSlot::Inner { index }
}

impl Parents<'_> {
    fn pair(&self, tet: usize) -> usize {
        self.pairs.map_or(0, |pairs| usize::from(pairs[tet]))
    }

    /// The vertices of one tet, in the order that it is split in.
    pub fn vertices(&self, tet: usize) -> [u32; 4] {
        MARKING_PERMUTATIONS[self.pair(tet)].map(|v| self.tets[tet][v])
    }

    /// One tet, reordered if it is to be split along another diagonal.
    fn parent(&self, tet: usize) -> Parent {
        let (vertices, edges) = (self.tets[tet], self.topology.tet_edges[tet]);
        let faces = self.topology.tet_faces[tet];
        let midpoints = self.topology.vertex_count() as u32;
        let pair = self.pair(tet);
        if pair == 0 {
            return Parent { tet, vertices, edges, faces, midpoints };
        }
        let order = MARKING_PERMUTATIONS[pair];
        Parent {
            tet,
            vertices: self.vertices(tet),
            edges: EDGES.map(|[a, b]| edges[edge_between(order[a], order[b])]),
            faces: order.map(|v| faces[v]),
            midpoints,
        }
    }

    /// The edges whose midpoints the inner diagonal of a tet joins.
    fn split_pair(&self, tet: usize) -> [u32; 2] {
        PAIRS[self.pair(tet)].map(|edge| self.topology.tet_edges[tet][edge])
    }
}

/// A coarse tet with what its children's numbers are looked up from.
struct Parent {
    tet: usize,
    vertices: [u32; 4],
    edges: [u32; 6],
    faces: [u32; 4],
    midpoints: u32,
}

impl Parent {
    fn node(&self, node: usize) -> u32 {
        if node < 4 { self.vertices[node] } else { self.midpoints + self.edges[node - 4] }
    }

    /// The place of a local vertex among the ascending vertices of a local face.
    fn rank(&self, face: usize, corner: usize) -> usize {
        let corner_vertex = self.vertices[corner];
        FACES[face].iter().filter(|&&v| self.vertices[v] < corner_vertex).count()
    }

    fn edge(&self, slot: EdgeSlot, fine: &FineEdges) -> u32 {
        match slot {
            EdgeSlot::Half { edge, end } => {
                let [a, b] = EDGES[edge];
                let other = if a == end { b } else { a };
                let higher = usize::from(self.vertices[end] > self.vertices[other]);
                fine.halves[self.edges[edge] as usize][higher]
            }
            EdgeSlot::Cut { face, corner } => {
                fine.cuts[self.faces[face] as usize][self.rank(face, corner)]
            }
            EdgeSlot::Diagonal => fine.diagonals[self.tet],
        }
    }

    fn face(&self, slot: FaceSlot, fine: &FineFaces) -> u32 {
        match slot {
            FaceSlot::Corner { face, corner } => {
                fine.parts[self.faces[face] as usize][self.rank(face, corner)]
            }
            FaceSlot::Middle { face } => fine.parts[self.faces[face] as usize][3],
            FaceSlot::Inner { index } => fine.inner[self.tet][index],
        }
    }
}

/// The fine edges, and where each coarse edge, face and tet finds its own.
struct FineEdges {
    edges: Vec<[u32; 2]>,
    first_edges: Vec<u32>,
    /// For each coarse edge the halves at its lower and higher end.
    halves: Vec<[u32; 2]>,
    /// For each coarse face a < b < c the edges that cut off a, b and c.
    cuts: Vec<[u32; 3]>,
    /// For each tet its inner diagonal.
    diagonals: Vec<u32>,
}

impl FineEdges {
    fn new(parents: &Parents, vertex_edges: &VertexEdges) -> Self {
        let (coarse, tets) = (parents.topology, parents.tets.len());
        let n = coarse.vertex_count() as u32;
        let half_count = 2 * coarse.edges.len() as u32;
        let faces = &coarse.face_edges;
        let cut_entries = |f: usize| {
            let [ab, ac, bc] = faces[f];
            let cuts = [[ab, ac], [ab, bc], [ac, bc]];
            std::array::from_fn(|i| inner_entry(cuts[i], 3 * f + i))
        };
        let diagonal_entry = |t: usize| [inner_entry(parents.split_pair(t), 3 * faces.len() + t)];
        let buckets = Counting::new(coarse.edges.len())
            .count::<3>(faces.len(), |f| cut_entries(f).map(|entry| entry.bucket))
            .count(tets, |t| diagonal_entry(t).map(|entry| entry.bucket))
            .place()
            .place(faces.len(), cut_entries)
            .place(tets, diagonal_entry)
            .sort();
        let first_inner = buckets.offsets().to_vec();
        let inner = buckets.map_distinct(&first_inner, |low, run| [n + low, n + run[0].key]);
        let mut numbers = buckets.number_payloads(&first_inner, 3 * faces.len() + tets);
        numbers.par_iter_mut().for_each(|number| *number += half_count);
        let diagonals = numbers.split_off(3 * faces.len());
        let first_halves = vertex_edges.offsets();
        let mut edges = vertex_edges.half_edges(n);
        edges.extend_from_slice(&inner);
        let mut first_edges = first_halves[..n as usize].to_vec();
        first_edges.extend(first_inner.iter().map(|first| half_count + first));
        Self {
            edges,
            first_edges,
            halves: vertex_edges.places(coarse),
            cuts: numbers.as_chunks::<3>().0.to_vec(),
            diagonals,
        }
    }
}

fn inner_entry(edges: [u32; 2], payload: usize) -> Entry {
    let [low, high] = ascending(edges);
    Entry { bucket: low, key: high, payload: payload as u32 }
}

/// The fine faces, and where each coarse face and tet finds its own.
struct FineFaces {
    faces: Vec<[u32; 3]>,
    face_edges: Vec<[u32; 3]>,
    /// For each coarse face its parts at the ascending corners, then the middle.
    parts: Vec<[u32; 4]>,
    /// For each tet the faces inside it.
    inner: Vec<[u32; 8]>,
}

impl FineFaces {
    fn new(parents: &Parents, fine: &FineEdges) -> Self {
        let (coarse, tets) = (parents.topology, parents.tets.len());
        let faces = coarse.faces.len();
        // A fine face is its three edges in the order ab, ac, bc of ascending
        // vertices; its last vertex is the higher end of the second.
        let part_edges = |f: usize| -> [[u32; 3]; 4] {
            let [ab, ac, bc] = coarse.face_edges[f].map(|e| fine.halves[e as usize]);
            let [cut_a, cut_b, cut_c] = fine.cuts[f];
            [
                [ab[0], ac[0], cut_a],
                [ab[1], bc[0], cut_b],
                [ac[1], bc[1], cut_c],
                [cut_a, cut_b, cut_c],
            ]
        };
        let inner_edges = |t: usize| {
            let parent = parents.parent(t);
            SLOTS.inner.map(|mut edges| {
                edges.sort_unstable_by_key(|&e| parent.edges[e]);
                let [p, q, r] = edges;
                [[p, q], [p, r], [q, r]].map(|[a, b]| parent.edge(SLOTS.between[a][b], fine))
            })
        };
        let last = |edges: [u32; 3]| fine.edges[edges[1] as usize][1];
        let entry = |edges: [u32; 3], payload: usize| Entry {
            bucket: edges[0],
            key: last(edges),
            payload: payload as u32,
        };
        let part_entries = |f: usize| {
            let edges = part_edges(f);
            std::array::from_fn(|i| entry(edges[i], 4 * f + i))
        };
        let inner_entries = |t: usize| {
            let edges = inner_edges(t);
            std::array::from_fn(|i| entry(edges[i], 4 * faces + 8 * t + i))
        };
        let buckets = Counting::new(fine.edges.len())
            .count::<4>(faces, |f| part_edges(f).map(|edges| edges[0]))
            .count::<8>(tets, |t| inner_edges(t).map(|edges| edges[0]))
            .place()
            .place::<4>(faces, part_entries)
            .place::<8>(tets, inner_entries)
            .sort();
        let first = buckets.offsets().to_vec();
        let face_edges = buckets.map_distinct(&first, |_, run| {
            let payload = run[0].payload as usize;
            match payload.checked_sub(4 * faces) {
                None => part_edges(payload / 4)[payload % 4],
                Some(inner) => inner_edges(inner / 8)[inner % 8],
            }
        });
        let vertices = buckets.map_distinct(&first, |edge, run| {
            let [a, b] = fine.edges[edge as usize];
            [a, b, run[0].key]
        });
        let mut numbers = buckets.number_payloads(&first, 4 * faces + 8 * tets);
        let inner = numbers.split_off(4 * faces);
        Self {
            faces: vertices,
            face_edges,
            parts: numbers.as_chunks::<4>().0.to_vec(),
            inner: inner.as_chunks::<8>().0.to_vec(),
        }
    }
}

/// The tets on each face, the smaller first: lowest and highest of those that name it.
fn face_tets(tet_faces: &[[u32; 4]], faces: usize) -> Vec<[u32; 2]> {
    let ends: Vec<[AtomicU32; 2]> =
        (0..faces).into_par_iter().map(|_| [AtomicU32::new(NONE), AtomicU32::new(0)]).collect();
    tet_faces.par_iter().with_min_len(CHUNK).enumerate().for_each(|(tet, faces)| {
        for &face in faces {
            let [low, high] = &ends[face as usize];
            low.fetch_min(tet as u32, Relaxed);
            high.fetch_max(tet as u32, Relaxed);
        }
    });
    ends.into_par_iter()
        .map(|[low, high]| {
            let (low, high) = (low.into_inner(), high.into_inner());
            [low, if high > low && low != NONE { high } else { NONE }]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raw_mesh::RawMesh;
    use crate::shapes::{five_tet_cube, kuhn_box, regular_tet};

    /// Twice split, the topology from the parents equals that from scratch;
    /// along the marked diagonals or along any others.
    fn compare(mesh: RawMesh) {
        let mesh = RawMesh { triangles: Default::default(), ..mesh };
        compare_along(mesh.clone(), |_| None);
        compare_along(mesh, |tets| Some((0..tets).map(|t| (t * t % 7 % 3) as u8).collect()));
    }

    fn compare_along(mut mesh: RawMesh, pairs: fn(usize) -> Option<Vec<u8>>) {
        let mut topology = Topology::new(&mesh);
        for _ in 0..2 {
            let pairs = pairs(mesh.tets.len());
            let parents =
                Parents { tets: &mesh.tets, topology: &topology, pairs: pairs.as_deref() };
            let split = red_split(&parents, &VertexEdges::new(&topology));
            mesh.points.resize(mesh.points.len() + topology.edges.len(), [0.0; 3]);
            mesh.tets = split.tets;
            topology = Topology::new(&mesh);
            assert!(split.topology == topology);
        }
    }

    #[test]
    fn topology_from_the_parents_equals_topology_from_scratch() {
        for mesh in [regular_tet(), five_tet_cube(), kuhn_box([2, 1, 3], [1.0; 3])] {
            compare(mesh.into_raw());
        }
    }

    #[test]
    fn vertex_numbers_and_orders_in_any_arrangement_are_handled() {
        // The five-tet cube under each rotation of vertex numbers, with each
        // tet's vertices permuted evenly in a way that differs from tet to tet.
        for shift in 0..8 {
            let mut raw = five_tet_cube().into_raw();
            raw.points.rotate_right(shift);
            for (t, tet) in raw.tets.iter_mut().enumerate() {
                let moved = tet.map(|v| (v + shift as u32) % 8);
                *tet =
                    crate::reference_tet::MARKING_PERMUTATIONS[(t + shift) % 3].map(|v| moved[v]);
            }
            compare(raw);
        }
    }
}

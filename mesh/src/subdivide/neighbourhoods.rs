//! What the rules ask about the surroundings of a vertex or an edge.

use std::sync::OnceLock;

use smallvec::{SmallVec, smallvec};

use crate::core::raw_mesh::{Features, RawMesh};
use crate::core::reference_tet::{EDGES, MARKED, opposite_ends};
use crate::core::strata::Strata;
use crate::core::topology::{EdgeFaces, EdgeTets, NONE, Topology, VertexEdges, ascending};

/// A vertex, or a combination of vertices that stands for a missing one; the
/// weights sum to one.
pub(crate) type Combination = SmallVec<[(u32, f64); 4]>;

/// A list that is short except round extraordinary edges.
pub(crate) type Short<T> = SmallVec<[T; 12]>;

/// A mesh with the incidences and strata that rows are made from.
pub(crate) struct Neighbourhoods<'a> {
    mesh: &'a RawMesh,
    topology: &'a Topology,
    vertex_edges: &'a VertexEdges,
    edge_faces: &'a EdgeFaces<'a>,
    /// Only two of the schemes ask for it.
    edge_tets: OnceLock<EdgeTets>,
    pub strata: Strata,
}

impl<'a> Neighbourhoods<'a> {
    pub fn new(
        mesh: &'a RawMesh,
        topology: &'a Topology,
        (vertex_edges, edge_faces): (&'a VertexEdges, &'a EdgeFaces<'a>),
    ) -> Self {
        let smooth = Features::default();
        let strata = Strata::new(mesh, topology, mesh.features.as_ref().unwrap_or(&smooth));
        let edge_tets = OnceLock::new();
        Self { mesh, topology, vertex_edges, edge_faces, edge_tets, strata }
    }

    pub fn ends(&self, edge: u32) -> [u32; 2] {
        self.topology.edges()[edge as usize]
    }

    /// The edges at a vertex, ascending.
    pub fn edges_at(&self, vertex: u32) -> &[u32] {
        self.vertex_edges.of(vertex as usize)
    }

    pub fn other_end(&self, edge: u32, vertex: u32) -> u32 {
        let [a, b] = self.ends(edge);
        a ^ b ^ vertex
    }

    /// The edges of tets at a vertex of the solid, ascending. (A free curve may
    /// end there, too; no face holds its edges.)
    pub fn solid_edges_at(&self, vertex: u32) -> impl Iterator<Item = u32> + Clone {
        let all = self.edges_at(vertex).iter().copied();
        all.filter(|&edge| !self.strata.has_free_edges || self.edge_faces.count(edge) > 0)
    }

    /// The vertices that share an edge of a tet with one of the solid, diagonals
    /// included; ascending.
    pub fn neighbours(&self, vertex: u32) -> impl Iterator<Item = u32> + Clone {
        self.solid_edges_at(vertex).map(move |edge| self.other_end(edge, vertex))
    }

    /// The tets round an edge, as slots 6 · tet + local edge.
    pub fn round(&self, edge: u32) -> &[u32] {
        self.edge_tets.get_or_init(|| EdgeTets::new(self.topology)).of(edge as usize)
    }

    /// How many tets are round an edge inside the solid, as many as faces.
    pub fn valence(&self, edge: u32) -> usize {
        self.edge_faces.count(edge)
    }

    /// The ends (true) and link vertices (false) of an edge inside the solid,
    /// ascending.
    pub fn ends_and_link(&self, edge: u32) -> impl Iterator<Item = (u32, bool)> {
        let ([low, high], faces) = (self.ends(edge), self.edge_faces);
        let link = |vertex| (vertex, false);
        let below = faces.below(edge).map(link).chain([(low, true)]);
        let between = faces.between(edge).map(link).chain([(high, true)]);
        below.chain(between).chain(faces.above(edge).map(link))
    }

    /// The link vertices of an edge inside the solid, ascending.
    pub fn link(&self, edge: u32) -> impl Iterator<Item = u32> {
        self.edge_faces.thirds(edge)
    }

    /// The two vertices of a tet opposite to one of its edges.
    pub fn link_edge(&self, slot: u32) -> [u32; 2] {
        let tet = self.mesh.tets[slot as usize / 6];
        opposite_ends(slot as usize % 6).map(|v| tet[v])
    }

    /// The link vertices of an interior edge in cyclic order, from `first` on.
    pub fn cyclic_link(&self, edge: u32, first: u32) -> Short<u32> {
        ring(self.round(edge).iter().map(|&slot| self.link_edge(slot)).collect(), first)
    }

    /// Whether four tets surround an edge and all mark it.
    pub fn is_marked_by_four(&self, edge: u32) -> bool {
        let round = self.round(edge);
        round.len() == 4 && round.iter().all(|&slot| MARKED.contains(&(slot as usize % 6)))
    }

    /// The neighbours on the surface round a vertex in cyclic order, from
    /// `first` on, if there are other than six and no curve cuts the ring.
    pub fn extraordinary_ring(&self, centre: u32, first: u32) -> Option<Short<u32>> {
        let neighbours = self.strata.surface_neighbours(centre);
        let smooth = self.strata.vertex_dimensions[centre as usize] == 2;
        if !smooth || neighbours.len() == 6 || neighbours.len() < 3 {
            return None;
        }
        let opposite = |&neighbour: &u32| {
            let edge =
                self.topology.edge_between(centre, neighbour).expect("neighbours share an edge");
            self.strata.opposite_vertices(edge).iter().map(move |&c| ascending([neighbour, c]))
        };
        let mut links: Short<[u32; 2]> = neighbours.iter().flat_map(opposite).collect();
        links.sort_unstable();
        links.dedup();
        Some(ring(links, first))
    }

    /// The surface vertex across an edge from `other`; reflected if the edge is
    /// a curve, across which no rule reads.
    pub fn surface_wing(&self, [a, c]: [u32; 2], other: u32) -> impl Iterator<Item = (u32, f64)> {
        let edge = self.topology.edge_between(a, c).expect("two vertices of a face share an edge");
        let across = self.strata.opposite_vertices(edge).iter().copied().find(|&v| v != other);
        let smooth = self.strata.edge_dimensions[edge as usize] == 2;
        match across.filter(|_| smooth) {
            Some(vertex) => smallvec![(vertex, 1.0)],
            None => ghost([a, c], other),
        }
        .into_iter()
    }

    /// The vertex opposite to `other` in the link of an edge: the mean of two
    /// where their number is odd, reflected where the edge lies on a surface.
    pub fn solid_wing(&self, [a, c]: [u32; 2], other: u32) -> Combination {
        let edge = self.topology.edge_between(a, c).expect("two vertices of a tet share an edge");
        if self.strata.edge_dimensions[edge as usize] < 3 {
            return ghost([a, c], other);
        }
        let link = self.cyclic_link(edge, other);
        let k = link.len();
        if k.is_multiple_of(2) {
            smallvec![(link[k / 2], 1.0)]
        } else {
            smallvec![(link[k / 2], 0.5), (link[k / 2 + 1], 0.5)]
        }
    }

    /// The distinct vertices across the faces, opposite either end, of the tets
    /// round an edge.
    ///
    /// Behind a face on a surface stands the vertex that the regular lattice
    /// has there: x(i−1) + x(i+1) − x(i) for the face opposite x(i). Ghosts of
    /// the same marked edge and vertex count once.
    pub fn apexes(&self, edge: u32) -> Short<Combination> {
        let mut keys: Short<[u32; 3]> = Short::new();
        for &slot in self.round(edge) {
            let (tet, local) = (slot as usize / 6, slot as usize % 6);
            for end in EDGES[local] {
                let key = self.apex_across(tet, end);
                if !keys.contains(&key) {
                    keys.push(key);
                }
            }
        }
        keys.into_iter()
            .map(|[a, c, x]| if c == NONE { smallvec![(a, 1.0)] } else { ghost([a, c], x) })
            .collect()
    }

    /// [vertex, NONE, NONE], or the parts [x(i−1), x(i+1), x(i)] of a ghost.
    fn apex_across(&self, tet: usize, end: usize) -> [u32; 3] {
        let face = self.topology.tet_faces()[tet][end] as usize;
        let vertices = self.mesh.tets[tet];
        if self.strata.is_surface[face] {
            let [a, c] = ascending([vertices[(end + 3) % 4], vertices[(end + 1) % 4]]);
            return [a, c, vertices[end]];
        }
        let [first, second] = self.topology.face_tets()[face];
        let across = if first == tet as u32 { second } else { first };
        let outside = |v: &u32| !self.topology.faces()[face].contains(v);
        let apex = self.mesh.tets[across as usize].into_iter().find(outside);
        [apex.expect("a tet has a vertex off each face"), NONE, NONE]
    }
}

/// The reflection of a vertex in the midpoint of an edge: a + c − other.
fn ghost([a, c]: [u32; 2], other: u32) -> Combination {
    smallvec![(a, 1.0), (c, 1.0), (other, -1.0)]
}

/// The vertices of closed link edges in cyclic order from `first` on, the
/// direction fixed by the first listed edge at it.
fn ring(mut links: Short<[u32; 2]>, first: u32) -> Short<u32> {
    let mut ring: Short<u32> = smallvec![first];
    let mut at = first;
    while let Some(found) = links.iter().position(|link| link.contains(&at)) {
        let [a, b] = links.swap_remove(found);
        at ^= a ^ b;
        if at == first {
            break;
        }
        ring.push(at);
    }
    ring
}

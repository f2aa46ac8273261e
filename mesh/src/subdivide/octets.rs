//! Tetrahedral and octahedral cells of the octet truss behind a refined mesh.

use crate::core::incidence::Incidence;
use crate::core::raw_mesh::RawMesh;
use crate::core::topology::{NONE, Topology};
use crate::subdivide::neighbourhoods::{Neighbourhoods, Short};

/// The octahedra: groups of four tets round a common diagonal.
pub(crate) struct Octets {
    octahedra: Vec<Octahedron>,
    /// The octahedron that each tet is a quarter of, or [`NONE`].
    of_tet: Vec<u32>,
    is_diagonal: Vec<bool>,
    at_vertex: Incidence,
}

struct Octahedron {
    poles: [u32; 2],
    cycle: [u32; 4],
}

/// The vertices round an edge of the truss.
pub(crate) struct Ring {
    /// Joined to both ends by edges of the truss inside a common cell; distinct.
    pub hard: Short<u32>,
    /// Opposite to an end across an octahedron: two for each octahedron.
    pub soft: Short<u32>,
}

impl Octets {
    pub fn new(near: &Neighbourhoods, mesh: &RawMesh, topology: &Topology) -> Self {
        let states = mesh.features.as_ref().map_or(&[][..], |features| &features.cell_states);
        let mut of_tet = vec![NONE; mesh.tets.len()];
        let mut is_diagonal = vec![false; topology.edges().len()];
        let mut octahedra = Vec::new();
        for (tet, (edges, state)) in topology.tet_edges().iter().zip(states).enumerate() {
            let Some(diagonal) = state.diagonal().map(|local| edges[local]) else { continue };
            let quarters = near.round(diagonal);
            if quarters[0] as usize / 6 != tet {
                continue;
            }
            // Where a mesh was cut through an octahedron, what is left of it
            // counts as tetrahedral cells.
            if let Some(octahedron) = Octahedron::new(near, diagonal) {
                is_diagonal[diagonal as usize] = true;
                quarters
                    .iter()
                    .for_each(|&slot| of_tet[slot as usize / 6] = octahedra.len() as u32);
                octahedra.push(octahedron);
            }
        }
        let corners = (0u32..).zip(&octahedra).flat_map(|(number, octahedron)| {
            octahedron.vertices().map(move |vertex| [vertex, number])
        });
        let at_vertex = Incidence::new(corners.collect());
        Self { octahedra, of_tet, is_diagonal, at_vertex }
    }

    pub fn is_diagonal(&self, edge: u32) -> bool {
        self.is_diagonal[edge as usize]
    }

    /// The vertices joined to one by edges of the truss.
    pub fn hard_neighbours(&self, near: &Neighbourhoods, vertex: u32) -> impl Iterator<Item = u32> {
        let edges = near.solid_edges_at(vertex).filter(|&edge| !self.is_diagonal(edge));
        edges.map(move |edge| near.other_end(edge, vertex))
    }

    /// The vertices opposite to one, an entry for each octahedron at it.
    pub fn opposite_vertices(&self, vertex: u32) -> impl Iterator<Item = u32> {
        let octahedra = self.at_vertex.of(vertex).iter();
        octahedra.map(move |&number| self.octahedra[number as usize].opposite(vertex))
    }

    /// The vertices round an edge of the truss.
    pub fn ring(&self, near: &Neighbourhoods, edge: u32) -> Ring {
        let ends = near.ends(edge);
        let mut octahedra: Short<u32> = Short::new();
        let mut ring = Ring { hard: Short::new(), soft: Short::new() };
        let mut add_hard = |vertex: u32| {
            if !ring.hard.contains(&vertex) {
                ring.hard.push(vertex);
            }
        };
        for &slot in near.round(edge) {
            match self.of_tet[slot as usize / 6] {
                NONE => near.link_edge(slot).into_iter().for_each(&mut add_hard),
                number if !octahedra.contains(&number) => {
                    octahedra.push(number);
                    let octahedron = &self.octahedra[number as usize];
                    let opposite = ends.map(|end| octahedron.opposite(end));
                    let beside = |v: &u32| !ends.contains(v) && !opposite.contains(v);
                    octahedron.vertices().filter(beside).for_each(&mut add_hard);
                    ring.soft.extend(opposite);
                }
                _ => {}
            }
        }
        ring
    }
}

impl Octahedron {
    /// The four tets round an interior edge, if it has four.
    fn new(near: &Neighbourhoods, diagonal: u32) -> Option<Self> {
        let &[first, _, _, _] = near.round(diagonal) else { return None };
        if near.strata.edge_dimensions[diagonal as usize] < 3 {
            return None;
        }
        let cycle = near.cyclic_link(diagonal, near.link_edge(first)[0]);
        Some(Self { poles: near.ends(diagonal), cycle: cycle[..].try_into().ok()? })
    }

    fn vertices(&self) -> impl Iterator<Item = u32> {
        self.poles.into_iter().chain(self.cycle)
    }

    fn opposite(&self, vertex: u32) -> u32 {
        let [p, q] = self.poles;
        match self.cycle.iter().position(|&v| v == vertex) {
            Some(place) => self.cycle[(place + 2) % 4],
            None => p ^ q ^ vertex,
        }
    }
}

//! Which stratum holds each vertex and edge: point, curve, surface or solid.
//!
//! Boundary, crease, corner, dart and material interface are all instances of
//! "the lowest-dimensional stratum that holds it". A row of a subdivision
//! matrix reads neighbours of its own stratum only; so boundary rows read
//! boundary columns only.

use rayon::prelude::*;

use crate::core::incidence::Incidence;
use crate::core::mirrors::Unfolded;
use crate::core::raw_mesh::{Features, RawMesh};
use crate::core::topology::{NONE, Topology};

/// For every vertex and edge the dimension of its stratum, and the neighbours there.
///
/// Strata go on across mirror planes, which belong to none: a neighbour there is listed
/// as the vertex that it is the image of, so that one may be listed twice.
#[derive(Debug, Clone)]
pub struct Strata {
    /// 0 fixed, 1 curve, 2 surface, 3 solid, for each vertex.
    pub vertex_dimensions: Vec<u8>,
    /// 1 curve, 2 surface, 3 solid, for each edge. An edge is in a stratum only
    /// if it is an edge of it, not because its ends are.
    pub edge_dimensions: Vec<u8>,
    /// Whether there are edges that no face holds.
    pub(crate) has_free_edges: bool,
    /// Whether each face belongs to a surface stratum.
    pub is_surface: Vec<bool>,
    /// Neighbours of vertices along edges of surface strata.
    surface: Incidence,
    /// Neighbours of vertices along curve edges.
    curve: Incidence,
    /// For each edge of a surface stratum the opposite vertices of its faces.
    opposite: Incidence,
}

impl Strata {
    /// Sorts vertices and edges into strata, given the features found before.
    pub fn new(mesh: &RawMesh, topology: &Topology, features: &Features) -> Self {
        let unfolded = Unfolded::with_features(mesh, topology, features);
        match unfolded.has_mirrors() {
            false => Self::without_mirrors(mesh, topology, features),
            true => Self::unfolded(&unfolded).folded(topology, &unfolded),
        }
    }

    /// The strata of an unfolded mesh.
    pub(crate) fn unfolded(unfolded: &Unfolded) -> Self {
        let smooth = Features::default();
        let features = unfolded.mesh.features.as_ref().unwrap_or(&smooth);
        Self::without_mirrors(&unfolded.mesh, &unfolded.topology, features)
    }

    /// Those of a mesh that was unfolded.
    fn folded(self, topology: &Topology, unfolded: &Unfolded) -> Self {
        let original = |v: u32| unfolded.original(v);
        let each_edge = || (0..unfolded.edges()).map(|edge| unfolded.edge(edge));
        let vertices: Vec<u32> = (0..unfolded.vertices() as u32).collect();
        let edges: Vec<u32> = each_edge().collect();
        let face = |&face: &[u32; 3]| {
            let face = unfolded.topology.face_of(face).expect("a face stays one");
            self.is_surface[face as usize]
        };
        Self {
            edge_dimensions: each_edge().map(|edge| self.edge_dimensions[edge as usize]).collect(),
            is_surface: topology.faces().par_iter().map(face).collect(),
            surface: self.surface.picked(&vertices, original),
            curve: self.curve.picked(&vertices, original),
            opposite: self.opposite.picked(&edges, original),
            vertex_dimensions: self.vertex_dimensions[..unfolded.vertices()].to_vec(),
            has_free_edges: self.has_free_edges,
        }
    }

    fn without_mirrors(mesh: &RawMesh, topology: &Topology, features: &Features) -> Self {
        let is_surface = surface_faces(mesh, topology, features);
        let opposite = opposite_vertices(topology, &is_surface);
        let ends = |edge: u32| topology.edges()[edge as usize];
        // Whatever the features say, no surface rule holds where a surface ends
        // or branches.
        let branches = opposite.keys().filter(|&edge| opposite.of(edge).len() != 2).map(ends);
        let curves: Vec<[u32; 2]> = features.creases.iter().copied().chain(branches).collect();
        let mut edge_dimensions = vec![3; topology.edges().len()];
        for edge in opposite.keys() {
            edge_dimensions[edge as usize] = 2;
        }
        // A free edge has nothing but its ends to follow: the midpoint, as on a curve.
        let on_curves = curves.iter().filter_map(|&[a, b]| topology.edge_between(a, b));
        let free = free_edges(mesh, topology);
        for edge in on_curves.chain(free.iter().copied()) {
            edge_dimensions[edge as usize] = 1;
        }
        let surface = Incidence::symmetric(opposite.keys().map(ends));
        let curve = Incidence::symmetric(curves.into_iter());
        let vertex_dimensions = vertex_dimensions((mesh, topology), features, &surface, &curve);
        let has_free_edges = !free.is_empty();
        Self {
            vertex_dimensions,
            edge_dimensions,
            has_free_edges,
            is_surface,
            surface,
            curve,
            opposite,
        }
    }

    /// The vertices of all strata below the solid, ascending; with those inside the solid
    /// that curves end in.
    pub(crate) fn listed(&self) -> Vec<u32> {
        let lower = (0u32..).zip(&self.vertex_dimensions);
        let mut listed: Vec<u32> =
            lower.filter(|(_, dimension)| **dimension < 3).map(|(v, _)| v).collect();
        listed.extend(self.curve.keys());
        listed.sort_unstable();
        listed.dedup();
        listed
    }

    /// The vertices that share an edge of a surface stratum with this one, ascending.
    pub fn surface_neighbours(&self, vertex: u32) -> &[u32] {
        self.surface.of(vertex)
    }

    /// The vertices that share a curve edge with this one, ascending.
    pub fn curve_neighbours(&self, vertex: u32) -> &[u32] {
        self.curve.of(vertex)
    }

    /// The vertex that follows `at` on a curve for one who comes from `from`; none at a
    /// corner, where the curve ends, or if the two are no neighbours on it.
    pub fn beyond(&self, from: u32, at: u32) -> Option<u32> {
        let neighbours = self.curve_neighbours(at);
        let goes_on = self.vertex_dimensions[at as usize] == 1 && neighbours.contains(&from);
        neighbours.iter().copied().find(|&next| goes_on && next != from)
    }

    /// The third vertices of the surface faces at an edge, ascending.
    pub fn opposite_vertices(&self, edge: u32) -> &[u32] {
        self.opposite.of(edge)
    }
}

/// Which faces belong to surface strata: the boundary, interfaces between
/// regions, triangles that stand free, and those of the groups asked for.
pub(crate) fn surface_faces(mesh: &RawMesh, topology: &Topology, features: &Features) -> Vec<bool> {
    let mut is_surface: Vec<bool> = topology
        .face_tets()
        .par_iter()
        .map(|&[first, second]| {
            second == NONE || mesh.regions[first as usize] != mesh.regions[second as usize]
        })
        .collect();
    for (triangle, tag) in mesh.triangles.iter() {
        if features.surfaces.binary_search(&tag).is_ok()
            && let Some(face) = topology.face_of(triangle)
        {
            is_surface[face as usize] = true;
        }
    }
    is_surface
}

/// For each edge of a surface face the third vertices of these faces.
pub(crate) fn opposite_vertices(topology: &Topology, is_surface: &[bool]) -> Incidence {
    let pairs = (0..is_surface.len()).filter(|&face| is_surface[face]).flat_map(|face| {
        let [a, b, c] = topology.faces()[face];
        let [ab, ac, bc] = topology.face_edges()[face];
        [[ab, c], [ac, b], [bc, a]]
    });
    Incidence::new(pairs.collect())
}

/// Tagged edges that neither a tet nor a triangle uses.
fn free_edges(mesh: &RawMesh, topology: &Topology) -> Vec<u32> {
    let mut free: Vec<u32> =
        mesh.edges.simplices.iter().filter_map(|&[a, b]| topology.edge_between(a, b)).collect();
    if !free.is_empty() {
        let mut used = vec![false; topology.edges().len()];
        topology.face_edges().as_flattened().iter().for_each(|&edge| used[edge as usize] = true);
        free.retain(|&edge| !used[edge as usize]);
    }
    free
}

fn vertex_dimensions(
    (mesh, topology): (&RawMesh, &Topology),
    features: &Features,
    surface: &Incidence,
    curve: &Incidence,
) -> Vec<u8> {
    let mut dimensions = vec![3; topology.vertex_count()];
    // The end of a free curve, and a point on its own, have nothing to follow.
    if !(mesh.edges.is_empty() && mesh.vertices.is_empty()) {
        dimensions.fill(0);
        mesh.tets.as_flattened().iter().for_each(|&v| dimensions[v as usize] = 3);
    }
    surface.keys().for_each(|v| dimensions[v as usize] = 2);
    for v in curve.keys() {
        match curve.of(v).len() {
            // The end of a crease (a dart): the smooth rule.
            0 | 1 => {}
            2 => dimensions[v as usize] = 1,
            _ => dimensions[v as usize] = 0,
        }
    }
    features.corners.iter().for_each(|&v| dimensions[v as usize] = 0);
    dimensions
}

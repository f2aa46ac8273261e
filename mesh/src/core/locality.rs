//! Numbering a coarsest mesh so that neighbours lie close in memory.
//!
//! Vertices go along a space-filling curve, tets by their vertices. Finer levels
//! inherit that: edges are numbered by their ends, children follow their parent,
//! so that sorting them anew gains nothing more.

use rayon::prelude::*;

use crate::core::control_points::ControlPoints;
use crate::core::hilbert;
use crate::core::raw_mesh::{Features, RawMesh, Tagged};
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::ascending;

/// Where the vertices and tets of a renumbered mesh were before.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Renumbering {
    /// The old number of each vertex; each number once.
    pub vertices: Vec<u32>,
    /// The old number of each tet; each number once.
    pub tets: Vec<u32>,
}

/// Numbers vertices along Hilbert's curve through the mesh, ties by their old
/// number, and tets by their ascending vertex numbers. The order of the vertices
/// within a tet, and with it orientation and marking, stays; so does the order in
/// which tagged simplices and groups are listed. Sorting a sorted mesh changes
/// nothing.
///
/// ```
/// use octruss_mesh::{shapes, sort_along_curve};
/// let cube = shapes::kuhn_cube(4);
/// let (sorted, from) = sort_along_curve(cube.clone());
/// assert_eq!(sorted.points()[7], cube.points()[from.vertices[7] as usize]);
/// ```
pub fn sort_along_curve(mesh: TetMesh) -> (TetMesh, Renumbering) {
    let mut mesh = mesh.into_raw();
    let vertices = order(&hilbert::places(&mesh.points));
    mesh.points = pick(&mesh.points, &vertices);
    renumber_vertices(&mut mesh, &inverse(&vertices));
    let tets = order(&mesh.tets.par_iter().map(|&tet| ascending(tet)).collect::<Vec<_>>());
    mesh.tets = pick(&mesh.tets, &tets);
    mesh.regions = pick(&mesh.regions, &tets);
    if let Some(features) = mesh.features.as_mut().filter(|all| !all.cell_states.is_empty()) {
        features.cell_states = pick(&features.cell_states, &tets);
    }
    (TetMesh::trusted(mesh), Renumbering { vertices, tets })
}

impl Renumbering {
    /// The new number of each vertex by its old one.
    pub fn new_vertices(&self) -> Vec<u32> {
        inverse(&self.vertices)
    }
}

/// The numbers of the keys by ascending key, equal ones by number.
fn order<K: Ord + Copy + Send + Sync>(keys: &[K]) -> Vec<u32> {
    let mut pairs: Vec<(K, u32)> = keys.iter().copied().zip(0..).collect();
    pairs.par_sort_unstable();
    pairs.into_iter().map(|(_, number)| number).collect()
}

fn inverse(order: &[u32]) -> Vec<u32> {
    let mut inverse = vec![0; order.len()];
    for (new, &old) in (0..).zip(order) {
        inverse[old as usize] = new;
    }
    inverse
}

fn pick<T: Copy + Send + Sync>(values: &[T], order: &[u32]) -> Vec<T> {
    order.par_iter().map(|&old| values[old as usize]).collect()
}

/// Renames vertices wherever the mesh names one.
fn renumber_vertices(mesh: &mut RawMesh, new: &[u32]) {
    mesh.tets.par_iter_mut().for_each(|tet| *tet = tet.map(|v| new[v as usize]));
    rename(&mut mesh.triangles, new);
    rename(&mut mesh.edges, new);
    rename(&mut mesh.vertices, new);
    if let Some(Features { creases, corners, control_points, .. }) = &mut mesh.features {
        creases.iter_mut().for_each(|ends| *ends = ascending(ends.map(|v| new[v as usize])));
        creases.sort_unstable();
        corners.iter_mut().for_each(|v| *v = new[*v as usize]);
        corners.sort_unstable();
        if let Some(ControlPoints { vertices, positions, .. }) = control_points {
            let listed = vertices.iter().map(|&v| new[v as usize]).zip(positions.iter().copied());
            let mut listed: Vec<_> = listed.collect();
            listed.par_sort_unstable_by_key(|&(vertex, _)| vertex);
            (*vertices, *positions) = listed.into_iter().unzip();
        }
    }
}

fn rename<const N: usize>(tagged: &mut Tagged<N>, new: &[u32]) {
    tagged.simplices.as_flattened_mut().iter_mut().for_each(|v| *v = new[*v as usize]);
}

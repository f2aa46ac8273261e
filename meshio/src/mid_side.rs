//! Dropping the nodes that second-order elements have besides their corners.

use octruss_mesh::RawMesh;

use crate::cell_kind::{CellKind, Simplex};
use crate::dataset::{Dataset, Values};
use crate::notes;

/// What a reader comes across in second-order cells.
#[derive(Debug, Default)]
pub(crate) struct MidSide {
    /// Nodes that are no corners of their cell, with repetitions.
    nodes: Vec<u32>,
    /// How many tets had such nodes.
    tets: usize,
}

impl MidSide {
    /// Takes in what one cell has besides its corners, if anything.
    pub(crate) fn collect(&mut self, kind: &CellKind, nodes: &[u32]) {
        let mid_side = kind.mid_side(nodes);
        self.nodes.extend_from_slice(mid_side);
        self.tets += usize::from(kind.simplex == Some(Simplex::Tet) && !mid_side.is_empty());
    }

    /// Removes the nodes that are no corner of any simplex, with a note, if there
    /// were second-order cells at all.
    pub(crate) fn drop_from(self, dataset: &mut Dataset) {
        if !self.nodes.is_empty() {
            let dropped = drop_nodes(dataset, &self.nodes);
            dataset.notes.push(notes::mid_side_nodes(self.tets, dropped));
        }
    }
}

/// Removes those of the `mid_side` nodes that are no corner of any simplex, and
/// their values; returns how many. The others keep their order. Numbers beyond
/// the points are left as they are, still beyond.
fn drop_nodes(dataset: &mut Dataset, mid_side: &[u32]) -> usize {
    let mesh = &mut dataset.mesh;
    let mut keep = vec![true; mesh.points.len()];
    mark(&mut keep, mid_side, false);
    for corners in corners(mesh) {
        mark(&mut keep, corners, true);
    }
    let numbers = new_numbers(&keep);
    for corners in corners(mesh) {
        for node in corners {
            *node = numbers.get(*node as usize).copied().unwrap_or(*node);
        }
    }
    let before = mesh.points.len();
    mesh.points = kept_tuples(&mesh.points, 1, &keep);
    for field in &mut dataset.point_fields {
        match &mut field.values {
            Values::Float(values) => *values = kept_tuples(values, field.components, &keep),
            Values::Integer(values) => *values = kept_tuples(values, field.components, &keep),
        }
    }
    before - dataset.mesh.points.len()
}

fn mark(keep: &mut [bool], nodes: &[u32], kept: bool) {
    for &node in nodes {
        if let Some(slot) = keep.get_mut(node as usize) {
            *slot = kept;
        }
    }
}

/// The corners of all simplices, by dimension.
fn corners(mesh: &mut RawMesh) -> [&mut [u32]; 4] {
    [
        mesh.tets.as_flattened_mut(),
        mesh.triangles.simplices.as_flattened_mut(),
        mesh.edges.simplices.as_flattened_mut(),
        mesh.vertices.simplices.as_flattened_mut(),
    ]
}

/// The number of each node among those kept; meaningless for the others.
fn new_numbers(keep: &[bool]) -> Vec<u32> {
    let mut next = 0;
    let mut numbers = Vec::with_capacity(keep.len());
    for &keep in keep {
        numbers.push(next);
        next += u32::from(keep);
    }
    numbers
}

fn kept_tuples<T: Copy>(values: &[T], components: usize, keep: &[bool]) -> Vec<T> {
    let tuples = values.chunks_exact(components).zip(keep);
    tuples.filter(|&(_, &keep)| keep).flat_map(|(tuple, _)| tuple).copied().collect()
}

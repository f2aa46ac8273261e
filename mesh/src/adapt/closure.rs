//! Completing marks until each tet has a pattern.
//!
//! Four or five marked edges of a tet become six; two of a triangle that stands free
//! of tets become three (Wang's thesis, sections 4.3.3 and 4.2.2). Each rule only adds
//! marks, and adds the same ones sooner or later: what it ends with is the smallest
//! closed set, whatever order cells are visited in and by how many threads.

use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use crate::adapt::marked_edges::MarkedEdges;
use crate::core::topology::{NONE, Topology};
use octruss_base::chunks::map_ranges;
use octruss_base::groups::Groups;

/// Marks seldom travel further in as many sweeps over all cells. After them, only
/// neighbours of what changed are visited.
const SWEEPS: usize = 4;

/// The smallest closed set of edges with these.
///
/// # Panics
/// If the marks are not those of a mesh with this topology.
pub(super) fn closed(topology: &Topology, marks: &MarkedEdges) -> MarkedEdges {
    assert_eq!(marks.as_list().len(), topology.edges().len(), "the marks of the mesh");
    let cells = Cells::new(topology, marks);
    let mut changed = Vec::new();
    for _ in 0..SWEEPS {
        changed = cells.sweep();
        if changed.is_empty() {
            return cells.into_marks();
        }
    }
    cells.spread(changed);
    cells.into_marks()
}

/// Tets and free triangles, and which edges are marked so far.
struct Cells<'a> {
    topology: &'a Topology,
    /// Faces of no tet.
    free: Vec<u32>,
    is_marked: Vec<AtomicBool>,
}

impl<'a> Cells<'a> {
    fn new(topology: &'a Topology, marks: &MarkedEdges) -> Self {
        let faces = (0u32..).zip(topology.face_tets());
        let free = faces.filter(|(_, tets)| tets[0] == NONE).map(|(face, _)| face).collect();
        let is_marked = marks.as_list().iter().map(|&mark| mark.into()).collect();
        Self { topology, free, is_marked }
    }

    fn into_marks(self) -> MarkedEdges {
        MarkedEdges::from_list(self.is_marked.into_iter().map(AtomicBool::into_inner).collect())
    }

    fn count(&self) -> usize {
        self.topology.tet_edges().len() + self.free.len()
    }

    /// The edges of a cell: tets first, then free triangles.
    fn edges(&self, cell: usize) -> &[u32] {
        match self.topology.tet_edges().get(cell) {
            Some(edges) => edges,
            None => {
                let face = self.free[cell - self.topology.tet_edges().len()];
                &self.topology.face_edges()[face as usize]
            }
        }
    }

    /// Marks all edges of a cell if more than half of them are marked, but not all;
    /// tells whether it did.
    fn complete(&self, cell: usize) -> bool {
        let edges = self.edges(cell);
        let is_marked = |edge: &&u32| self.is_marked[**edge as usize].load(Relaxed);
        let marked = edges.iter().filter(is_marked).count();
        let is_open = marked > edges.len() / 2 && marked < edges.len();
        if is_open {
            edges.iter().for_each(|&edge| self.is_marked[edge as usize].store(true, Relaxed));
        }
        is_open
    }

    /// Completes each cell once; those that were not complete. Whoever became open
    /// after its visit shares an edge with one of them.
    fn sweep(&self) -> Vec<u32> {
        let open = |cell: &usize| self.complete(*cell);
        let chunk = |cells: std::ops::Range<usize>| {
            cells.filter(open).map(|cell| cell as u32).collect::<Vec<_>>()
        };
        map_ranges(self.count(), chunk).concat()
    }

    /// Completes neighbours of completed cells until there is none left to complete.
    fn spread(&self, mut completed: Vec<u32>) {
        let at_edges = Groups::new(self.is_marked.len(), self.count(), |cell| {
            self.edges(cell).iter().map(move |&edge| (edge, cell as u32))
        });
        while let Some(cell) = completed.pop() {
            for &edge in self.edges(cell as usize) {
                let cells = at_edges.of(edge as usize).iter().copied();
                completed.extend(cells.filter(|&cell| self.complete(cell as usize)));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::raw_mesh::RawMesh;
    use crate::core::shapes::kuhn_cube;

    /// Completes the first open cell, again and again.
    fn slow(topology: &Topology, marks: &MarkedEdges) -> Vec<bool> {
        let mut marked = marks.as_list().to_vec();
        let free = topology.face_tets().iter().zip(topology.face_edges());
        let free = free.filter(|(tets, _)| tets[0] == NONE).map(|(_, edges)| edges.to_vec());
        let tets = topology.tet_edges().iter().map(|edges| edges.to_vec());
        let cells: Vec<Vec<u32>> = tets.chain(free).collect();
        let most = |cell: &[u32]| if cell.len() == 6 { 3 } else { 1 };
        loop {
            let count = |cell: &[u32]| cell.iter().filter(|&&e| marked[e as usize]).count();
            let open =
                cells.iter().find(|cell| (most(cell) + 1..cell.len()).contains(&count(cell)));
            let Some(open) = open else { return marked };
            open.iter().for_each(|&edge| marked[edge as usize] = true);
        }
    }

    #[test]
    fn any_marks_are_completed_as_slowly_one_by_one() {
        let mut mesh = kuhn_cube(3).into_raw();
        mesh.points.extend([[5.0, 0.0, 0.0], [5.0, 1.0, 0.0]]);
        mesh.triangles.push([64, 0, 65], 8);
        mesh.triangles.push([64, 1, 0], 8);
        let topology = Topology::new(&mesh);
        for stride in 2..40 {
            let mut marks = MarkedEdges::new(&topology);
            marks.mark_edges((0..topology.edges().len() as u32).step_by(stride));
            assert_eq!(closed(&topology, &marks).as_list(), slow(&topology, &marks));
        }
    }

    /// A strip of free triangles, each completed by the one before it, numbered against
    /// the way that the marks go: one more triangle a sweep.
    #[test]
    fn a_long_chain_is_followed_to_its_end() {
        let mut strip = RawMesh::default();
        const LAST: u32 = 2000;
        strip.points = (0..=LAST).map(|v| [f64::from(v), f64::from(v % 2), 0.0]).collect();
        (0..=LAST - 2).for_each(|v| strip.triangles.push([v, v + 1, v + 2], 1));
        let topology = Topology::new(&strip);
        let mut marks = MarkedEdges::new(&topology);
        let edge = |a, b| topology.edge_between(a, b).unwrap();
        // All edges on one side, but none across; then one across at the far end.
        marks.mark_edges((0..=LAST - 2).map(|v| edge(v, v + 2)));
        assert_eq!(closed(&topology, &marks), marks);
        marks.mark_edges([edge(LAST - 1, LAST)]);
        assert_eq!(closed(&topology, &marks), MarkedEdges::all(&topology));
    }
}

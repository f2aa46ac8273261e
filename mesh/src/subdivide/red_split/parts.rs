//! How many parts the red split makes of a simplex: what everybody else learns
//! from the [`Ancestry`].

use crate::core::raw_mesh::RawMesh;
use crate::core::reference_tet::CHILDREN;
use crate::core::topology::Topology;
use crate::refinement::ancestry::{Ancestry, SplitEdges};
use crate::refinement::lineage::Lineage;

/// The children of a tet; child k of tet t is number `PARTS` t + k.
pub const PARTS: usize = CHILDREN.len();

/// The quarters of a triangle.
pub const QUARTERS: usize = 4;

/// The halves of an edge.
pub const HALVES: usize = 2;

/// The number of a tet's child.
#[inline]
pub fn child_of(parent: u32, child: u32) -> u32 {
    PARTS as u32 * parent + child
}

/// The tet that a fine one is a child of.
#[inline]
pub fn parent_of(child: u32) -> u32 {
    child / PARTS as u32
}

/// What the children of all tets have, by their parents.
#[inline]
pub fn families<T>(children: &[T]) -> &[[T; PARTS]] {
    children.as_chunks().0
}

/// The same, to write to.
#[inline]
pub fn families_mut<T>(children: &mut [T]) -> &mut [[T; PARTS]] {
    children.as_chunks_mut().0
}

/// Who descends from whom if every simplex of a mesh is split.
pub fn ancestry(coarse: &RawMesh, topology: &Topology) -> Ancestry {
    Ancestry {
        vertices: topology.vertex_count(),
        split_edges: SplitEdges::All(topology.edges().len()),
        tets: Lineage::uniform(coarse.tets.len(), PARTS),
        triangles: Lineage::uniform(coarse.triangles.simplices.len(), QUARTERS),
        edges: Lineage::uniform(coarse.edges.simplices.len(), HALVES),
    }
}

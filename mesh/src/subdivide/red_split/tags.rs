//! Tagged simplices and features, split like the tets.

use rayon::prelude::*;

use super::parts::{HALVES, PARTS, QUARTERS, families_mut};
use crate::core::raw_mesh::{Features, RawMesh, Tagged};
use crate::core::reference_tet::CellState;
use crate::core::topology::{Topology, ascending};
use crate::refinement::ancestry::Ancestry;
use crate::refinement::lineage::Lineage;
use crate::subdivide::step::Diagonal;
use octruss_base::large_array::zeroed;
use octruss_base::ragged::CHUNK;

/// The tagged simplices, names and features of the fine mesh.
pub fn split_tags(
    coarse: &RawMesh,
    topology: &Topology,
    ancestry: &Ancestry,
    diagonal: Diagonal,
) -> RawMesh {
    let midpoint = |a: u32, b: u32| {
        let edge = topology.edge_between(a, b).expect("tagged simplices have their edges numbered");
        ancestry.midpoint(edge).expect("every edge is split")
    };
    let halves = |[a, b]: [u32; 2]| -> [_; HALVES] { [[a, midpoint(a, b)], [midpoint(a, b), b]] };
    let quarters = |[a, b, c]: [u32; 3]| -> [_; QUARTERS] {
        let [ab, ac, bc] = [midpoint(a, b), midpoint(a, c), midpoint(b, c)];
        [[a, ab, ac], [ab, b, bc], [ac, bc, c], [ab, bc, ac]]
    };
    RawMesh {
        triangles: split_each(&coarse.triangles, &ancestry.triangles, quarters),
        edges: split_each(&coarse.edges, &ancestry.edges, halves),
        vertices: coarse.vertices.clone(),
        groups: coarse.groups.clone(),
        features: coarse.features.as_ref().map(|features| {
            let mut creases: Vec<_> =
                features.creases.iter().flat_map(|&edge| halves(edge)).map(ascending).collect();
            creases.sort_unstable();
            let cell_states = match diagonal {
                Diagonal::Inherit => split_states(coarse, features),
                // Octahedra that are not split along their diagonals leave no octet truss.
                Diagonal::ShortestEachLevel => Vec::new(),
            };
            Features {
                creases,
                cell_states,
                corners: features.corners.clone(),
                surfaces: features.surfaces.clone(),
                mirrors: features.mirrors.clone(),
                initial_quality: features.initial_quality,
                smoothed: features.smoothed,
                // Those of the fine mesh are for the step to refine.
                control_points: None,
            }
        }),
        ..RawMesh::default()
    }
}

fn split_each<const N: usize, const PARTS: usize>(
    coarse: &Tagged<N>,
    lineage: &Lineage,
    split: impl Fn([u32; N]) -> [[u32; N]; PARTS] + Sync,
) -> Tagged<N> {
    let parts: Vec<_> = coarse.simplices.par_iter().map(|&simplex| split(simplex)).collect();
    Tagged { simplices: parts.into_flattened(), tags: lineage.inherit(&coarse.tags, 1) }
}

fn split_states(coarse: &RawMesh, features: &Features) -> Vec<CellState> {
    if features.cell_states.is_empty() {
        return to_children(&coarse.tets, |_| CellState::default());
    }
    to_children(&features.cell_states, |state| *state)
}

/// The states of all children, from those of their parents.
fn to_children<P: Sync>(parents: &[P], state: impl Fn(&P) -> CellState + Sync) -> Vec<CellState> {
    let mut children = zeroed(PARTS * parents.len());
    let by_parent = families_mut(&mut children).par_iter_mut().zip(parents);
    by_parent
        .with_min_len(CHUNK)
        .for_each(|(children, parent)| *children = state(parent).children());
    children
}

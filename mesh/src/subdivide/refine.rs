//! One subdivision step: coarse mesh in, fine mesh and its matrix out.

use std::cmp::Ordering::Greater;

use rayon::prelude::*;

use crate::core::raw_mesh::{Features, RawMesh, Tagged};
use crate::core::reference_tet::{CellState, corners, six_volumes};
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::{EdgeFaces, Topology, VertexEdges, ascending};
use crate::marking::shortest_pairs;
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use crate::subdivide::assemble_matrix::matrix_with;
use crate::subdivide::guard::{Guard, GuardReport, keep_above};
use crate::subdivide::red_split::{Parents, red_split};
use crate::subdivide::scheme::Scheme;
use crate::subdivide::step::{Diagonal, Step};
use octruss_base::large_array::zeroed;
use octruss_base::ragged::CHUNK;

/// How a fine mesh came from a coarse one by the red split.
///
/// Fine vertices are the coarse ones, in order, then one per edge, in edge
/// order; the children of tet t are 8 t to 8 t + 7.
#[derive(Debug, Clone, PartialEq)]
pub struct Refinement {
    /// The scheme that made it.
    pub scheme: Scheme,
    /// The scheme's matrix, n_fine × n_coarse: fine positions are matrix ×
    /// coarse positions.
    pub matrix: SubdivisionMatrix,
    /// What the guard did, if the step had one.
    pub guard: Option<GuardReport>,
}

impl Refinement {
    /// The coarse tet that a fine tet is a part of.
    pub fn parent(&self, child: usize) -> usize {
        child / 8
    }
}

/// Why a step was refused; the coarse mesh is untouched.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SubdivideError {
    /// Moving the vertices would turn tets inside out.
    #[error(
        "level {level} would invert {count} of {total} tets (the first: {}); \
         guard the quality, use fewer levels, keep more edges sharp, or improve the worst tets \
         of the input",
        list(examples)
    )]
    Inverted {
        /// The level that was being made; the input is level 0.
        level: usize,
        /// How many tets would have a volume that is not positive.
        count: usize,
        /// How many tets the level would have.
        total: usize,
        /// The first of them, by number.
        examples: Vec<u32>,
    },
    /// The numbers of the fine mesh do not fit 32 bits.
    #[error(
        "level {level} would have {tets} tets, more than the {MAX_TETS} that can be numbered; use fewer levels"
    )]
    TooLarge {
        /// The level that was being made.
        level: usize,
        /// How many tets it would have.
        tets: usize,
    },
}

/// Edge slots of tets are numbered in 32 bits.
pub const MAX_TETS: usize = u32::MAX as usize / 6;

/// How many levels so many tets can be refined, each tet into eight.
pub fn most_levels(tets: usize) -> u32 {
    // The greatest l with tets · 8^l ≤ MAX_TETS.
    (MAX_TETS / tets.max(1)).checked_ilog2().map_or(0, |log| log / 3)
}

fn list(numbers: &[u32]) -> String {
    numbers.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")
}

/// Subdivides a prepared mesh once, by a scheme or a [`Step`]; `level` is that of
/// the result, for messages. The order of the coarse tets stays, whatever the
/// diagonals.
///
/// Regions, tags, names and features are inherited by all children; the fine
/// mesh's topology comes with it.
///
/// # Errors
/// If a tet of the result would not have positive volume, or there would be
/// too many tets.
pub fn subdivide(
    mesh: &TetMesh,
    topology: &Topology,
    step: impl Into<Step>,
    level: usize,
) -> Result<(TetMesh, Topology, Refinement), SubdivideError> {
    let Step { scheme, diagonal, min_quality } = step.into();
    let coarse = mesh.raw();
    if 8 * coarse.tets.len() > MAX_TETS {
        return Err(SubdivideError::TooLarge { level, tets: 8 * coarse.tets.len() });
    }
    let vertex_edges = VertexEdges::new(topology);
    let edge_faces = EdgeFaces::new(topology);
    let mut matrix = matrix_with(coarse, topology, (&vertex_edges, &edge_faces), scheme);
    let mut points = matrix.apply(&coarse.points);
    let parents = match diagonal {
        Diagonal::Inherit => Parents::marked(&coarse.tets, topology),
        Diagonal::ShortestEachLevel => {
            let mut pairs = shortest_pairs(coarse);
            min_quality.iter().for_each(|&floor| keep_above(floor, coarse, &mut pairs));
            Parents::along(&coarse.tets, topology, &pairs)
        }
    };
    let split = red_split(&parents, &vertex_edges, &edge_faces);
    let guard = min_quality.map(|floor| {
        let guard = Guard {
            floor,
            coarse,
            coarse_edges: topology.edges(),
            parents: &parents,
            fine_tets: &split.tets,
        };
        guard.apply(&mut matrix, &mut points)
    });
    refuse_inverted(&points, &split.tets, level)?;
    let fine = RawMesh {
        points,
        regions: to_children(&coarse.regions, |&region| [region; 8]),
        tets: split.tets,
        ..split_tags(coarse, topology, diagonal)
    };
    Ok((TetMesh::trusted(fine), split.topology, Refinement { scheme, matrix, guard }))
}

fn refuse_inverted(
    points: &[[f64; 3]],
    tets: &[[u32; 4]],
    level: usize,
) -> Result<(), SubdivideError> {
    let inverted: Vec<u32> = tets
        .par_iter()
        .with_min_len(CHUNK)
        .enumerate()
        // A volume that is no number is not greater than 0 either.
        .filter(|(_, tet)| six_volumes(corners(points, **tet)).partial_cmp(&0.0) != Some(Greater))
        .map(|(t, _)| t as u32)
        .collect();
    if inverted.is_empty() {
        return Ok(());
    }
    Err(SubdivideError::Inverted {
        level,
        count: inverted.len(),
        total: tets.len(),
        examples: inverted.into_iter().take(5).collect(),
    })
}

/// Tagged simplices, names and features, split like the tets.
fn split_tags(coarse: &RawMesh, topology: &Topology, diagonal: Diagonal) -> RawMesh {
    let midpoint = |a: u32, b: u32| {
        let edge = topology.edge_between(a, b).expect("tagged simplices have their edges numbered");
        topology.vertex_count() as u32 + edge
    };
    let halves = |[a, b]: [u32; 2]| [[a, midpoint(a, b)], [midpoint(a, b), b]];
    let quarters = |[a, b, c]: [u32; 3]| {
        let [ab, ac, bc] = [midpoint(a, b), midpoint(a, c), midpoint(b, c)];
        [[a, ab, ac], [ab, b, bc], [ac, bc, c], [ab, bc, ac]]
    };
    RawMesh {
        triangles: split_each(&coarse.triangles, quarters),
        edges: split_each(&coarse.edges, halves),
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
            Features { creases, cell_states, ..features.clone() }
        }),
        ..RawMesh::default()
    }
}

fn split_states(coarse: &RawMesh, features: &Features) -> Vec<CellState> {
    if features.cell_states.is_empty() {
        return to_children(&coarse.tets, |_| CellState::default().children());
    }
    to_children(&features.cell_states, |state| state.children())
}

/// Eight values a tet, one for each child.
fn to_children<P: Sync, T: Copy + Default + Send>(
    parents: &[P],
    values: impl Fn(&P) -> [T; 8] + Sync,
) -> Vec<T> {
    let mut children = zeroed(8 * parents.len());
    let by_parent = children.as_chunks_mut::<8>().0.par_iter_mut().zip(parents);
    by_parent.with_min_len(CHUNK).for_each(|(children, parent)| *children = values(parent));
    children
}

fn split_each<const N: usize, const PARTS: usize>(
    coarse: &Tagged<N>,
    split: impl Fn([u32; N]) -> [[u32; N]; PARTS] + Sync,
) -> Tagged<N> {
    let parts: Vec<_> = coarse.simplices.par_iter().map(|&simplex| split(simplex)).collect();
    Tagged {
        simplices: parts.into_flattened(),
        tags: coarse.tags.iter().flat_map(|&tag| [tag; PARTS]).collect(),
    }
}

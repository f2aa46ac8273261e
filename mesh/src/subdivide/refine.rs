//! One subdivision step: coarse mesh in, fine mesh and its matrix out.

use std::cmp::Ordering::Greater;

use rayon::prelude::*;

use crate::core::mirrors::Unfolded;
use crate::core::raw_mesh::RawMesh;
use crate::core::reference_tet::{corners, six_volumes};
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::{EdgeFaces, Topology, VertexEdges};
use crate::marking::shortest_pairs;
use crate::refinement::refinement::Refinement;
use crate::scheme::Scheme;
use crate::subdivide::assemble_matrix::{matrix_with, unfolded_matrix};
use crate::subdivide::error::SubdivideError;
use crate::subdivide::guard::{Guard, keep_above, usual_floor};
use crate::subdivide::moved::Moved;
use crate::subdivide::passing_through::pass::Step as Pass;
use crate::subdivide::red_split::parents::Parents;
use crate::subdivide::red_split::parts;
use crate::subdivide::red_split::split::red_split;
use crate::subdivide::red_split::tags::split_tags;
use crate::subdivide::size::MAX_TETS;
use crate::subdivide::step::{Diagonal, Step};
use octruss_base::ragged::CHUNK;

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
    let step = step.into();
    let Step { scheme, diagonal, min_quality, .. } = step;
    let coarse = mesh.raw();
    let ancestry = parts::ancestry(coarse, topology);
    let tets = ancestry.tets.fine_count();
    if tets > MAX_TETS {
        return Err(SubdivideError::TooLarge { level, tets });
    }
    let vertex_edges = VertexEdges::new(topology);
    let edge_faces = EdgeFaces::new(topology);
    let unfolded = match scheme {
        Scheme::Linear => Unfolded::whole(coarse, topology),
        _ => Unfolded::new(coarse, topology),
    };
    let curve_ends = step.curve_ends_on(mesh);
    let rules = (scheme, curve_ends);
    let matrix = match unfolded.has_mirrors() {
        false => matrix_with(&unfolded, (&vertex_edges, &edge_faces), rules),
        true => unfolded_matrix(&unfolded, rules),
    };
    let parents = match diagonal {
        Diagonal::Inherit => Parents::marked(&coarse.tets, topology),
        Diagonal::ShortestEachLevel => {
            let mut pairs = shortest_pairs(coarse);
            min_quality.iter().for_each(|&floor| keep_above(floor, coarse, &mut pairs));
            Parents::along(&coarse.tets, topology, &pairs)
        }
    };
    let split = red_split(&parents, &vertex_edges, &edge_faces);
    let mut fine = RawMesh {
        regions: ancestry.tets.inherit(&coarse.regions, 1),
        tets: split.tets,
        ..split_tags(coarse, topology, &ancestry, diagonal)
    };
    let guard = |floor| Guard {
        floor,
        coarse,
        coarse_edges: topology.edges(),
        parents: &parents,
        fine_tets: &fine.tets,
    };
    let moved = match step.solves_for_control_points() || step.projects() {
        false => Moved::by_rows(&unfolded, matrix, min_quality.map(guard)),
        true => Moved::to_the_limit(&Pass {
            coarse: &unfolded,
            mesh: coarse,
            fine: unfolded.refined(&fine, &split.topology),
            matrix: &matrix,
            curve_ends,
            interpolates: step.solves_for_control_points(),
            projects: step.projects(),
            guard: &guard(min_quality.unwrap_or_else(|| usual_floor(mesh))),
            is_guarded: min_quality.is_some(),
        }),
    };
    let moved = moved.on_the_mesh((coarse, topology), &unfolded);
    let Moved { points, matrix, mirrored, guard, control_points, interpolation } = moved;
    fine.points = points;
    if control_points.is_some() {
        fine.features.get_or_insert_default().control_points = control_points;
    } else if let Some(features) = &mut fine.features {
        features.smoothed |= !scheme.keeps_vertices();
    }
    // A guard that pulled nothing back has seen that all volumes are positive.
    if guard.is_none_or(|guard| guard.pulled_back > 0) {
        refuse_inverted(&fine.points, &fine.tets, level)?;
    }
    let refinement = Refinement { scheme, matrix, mirrored, ancestry, guard, interpolation };
    Ok((TetMesh::trusted(fine), split.topology, refinement))
}

/// Refuses tets without positive volume.
pub(crate) fn refuse_inverted(
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

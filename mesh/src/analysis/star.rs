//! The tets at one vertex.

use super::error::AnalysisError;
use crate::core::raw_mesh::{Features, RawMesh, Tagged};
use crate::core::tet_mesh::TetMesh;

/// The tets at a vertex as a mesh of their own, with the vertex as number 0
/// and the others in their old order.
///
/// Regions, marked pairs and cells stay, and tagged triangles, creases and
/// corners at the vertex, so that it has the same rules as before; a mesh
/// without features counts as smooth. Only the faces opposite the vertex were
/// perhaps no boundary before.
///
/// # Errors
/// If there is no such vertex, or it has no tets.
pub fn star(mesh: &TetMesh, vertex: u32) -> Result<TetMesh, AnalysisError> {
    let vertices = mesh.points().len();
    if vertex as usize >= vertices {
        return Err(AnalysisError::NoVertex { vertex, vertices });
    }
    let chosen: Vec<usize> =
        (0..mesh.tets().len()).filter(|&t| mesh.tets()[t].contains(&vertex)).collect();
    if chosen.is_empty() {
        return Err(AnalysisError::NoTets { vertex });
    }
    let mut others: Vec<u32> =
        chosen.iter().flat_map(|&t| mesh.tets()[t]).filter(|&v| v != vertex).collect();
    others.sort_unstable();
    others.dedup();
    let renumber = |old: u32| match others.binary_search(&old) {
        Ok(at) => at as u32 + 1,
        Err(_) => 0,
    };
    let mut triangles = Tagged::default();
    for (triangle, tag) in mesh.triangles().iter().filter(|(t, _)| t.contains(&vertex)) {
        // A fin that only touches the solid at the vertex is left out.
        if triangle.iter().all(|&v| v == vertex || others.binary_search(&v).is_ok()) {
            triangles.push(triangle.map(renumber), tag);
        }
    }
    let numbers = std::iter::once(&vertex).chain(&others);
    Ok(TetMesh::trusted(RawMesh {
        points: numbers.map(|&v| mesh.points()[v as usize]).collect(),
        tets: chosen.iter().map(|&t| mesh.tets()[t].map(renumber)).collect(),
        regions: chosen.iter().map(|&t| mesh.regions()[t]).collect(),
        triangles,
        features: Some(features_at(mesh, vertex, &chosen, renumber)),
        ..RawMesh::default()
    }))
}

fn features_at(
    mesh: &TetMesh,
    vertex: u32,
    chosen: &[usize],
    renumber: impl Fn(u32) -> u32,
) -> Features {
    let Some(features) = mesh.features() else { return Features::default() };
    let at_vertex = features.creases.iter().filter(|edge| edge.contains(&vertex));
    let ends = at_vertex.map(|&[a, b]| [0, renumber(a).max(renumber(b))]);
    let mut creases: Vec<[u32; 2]> = ends.filter(|edge| edge[1] > 0).collect();
    creases.sort_unstable();
    let is_corner = features.corners.binary_search(&vertex).is_ok();
    let states = &features.cell_states;
    Features {
        creases,
        corners: if is_corner { vec![0] } else { Vec::new() },
        surfaces: features.surfaces.clone(),
        // What lies behind a mirror is no part of the star.
        mirrors: Vec::new(),
        initial_quality: features.initial_quality,
        cell_states: chosen.iter().filter_map(|&t| states.get(t).copied()).collect(),
        smoothed: features.smoothed,
        control_points: None,
    }
}

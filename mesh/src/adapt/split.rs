//! One local step: coarse mesh and marked edges in, fine mesh and its matrix out.

use crate::adapt::cell_states::states_of_parts;
use crate::adapt::closure::closed;
use crate::adapt::marked_edges::MarkedEdges;
use crate::adapt::midpoints::Midpoints;
use crate::adapt::parts::{all_parts, counts};
use crate::adapt::tags::{of_edge, of_triangle, split_creases, split_each};
use crate::adapt::tets::Tets;
use crate::core::raw_mesh::{Features, RawMesh};
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::Topology;
use crate::refinement::ancestry::{Ancestry, SplitEdges};
use crate::refinement::lineage::Lineage;
use crate::refinement::refinement::Refinement;
use crate::refinement::subdivision_matrix::midpoint_matrix;
use crate::scheme::Scheme;
use crate::subdivide::error::SubdivideError;
use crate::subdivide::refine::refuse_inverted;
use crate::subdivide::size::MAX_TETS;
use crate::subdivide::step::Diagonal;

/// Splits a prepared mesh at its marked edges, and at those that it takes to leave no
/// hanging node; `level` is that of the result, for messages.
///
/// New vertices are midpoints. Tets are split as Wang's thesis has it (section 4.3.3):
/// all six edges into eight, along the inherited or the shortest diagonal; the three of
/// a face into four; one, two or other three by bisections, longest edge first; four
/// or five are completed to six. Parts of the last two kinds mark their shortest pair. Triangles free of tets
/// are bisected or quartered (section 4.2.2).
///
/// Regions, tags, names and features are inherited by all parts; tets without marked
/// edges stay what they are. Control points of a surface through the input's vertices
/// are not: they would be those of another surface, and the next step that interpolates
/// solves for new ones. The fine mesh's topology comes with it.
///
/// ```
/// use octruss_mesh::{Diagonal, MarkedEdges, Topology, shapes, split_marked};
/// let mesh = shapes::regular_tet();
/// let topology = Topology::new(mesh.raw());
/// let mut marks = MarkedEdges::new(&topology);
/// marks.mark_faces(&topology, [0]);
/// let (fine, _, refinement) = split_marked(&mesh, &topology, &marks, Diagonal::Inherit, 1)?;
/// assert_eq!(fine.tets().len(), 4);
/// assert_eq!(refinement.children(0), 0..4);
/// # Ok::<(), octruss_mesh::SubdivideError>(())
/// ```
///
/// # Errors
/// If there would be too many tets, or one without positive volume: midpoints turn no
/// tet inside out, but the volume of a very small one may be lost in rounding.
///
/// # Panics
/// If topology or marks are those of another mesh.
pub fn split_marked(
    mesh: &TetMesh,
    topology: &Topology,
    marks: &MarkedEdges,
    diagonal: Diagonal,
    level: usize,
) -> Result<(TetMesh, Topology, Refinement), SubdivideError> {
    let coarse = mesh.raw();
    let split = closed(topology, marks);
    let midpoints = Midpoints::new(&coarse.points, topology, &split);
    let split_edges: Vec<u32> = split.edges().collect();
    let matrix = midpoint_matrix(topology, &split_edges);
    let points = matrix.apply(&coarse.points);
    let tets =
        Tets { tets: &coarse.tets, topology, midpoints: &midpoints, diagonal, points: &points };
    let part_counts = counts(coarse.tets.len(), |tet| tets.count(tet));
    let total = part_counts.iter().map(|&count| usize::from(count)).sum();
    if total > MAX_TETS {
        return Err(SubdivideError::TooLarge { level, tets: total });
    }
    let (fine_tets, parents) = all_parts(&part_counts, |tet| tets.parts(tet));
    refuse_inverted(&points, &fine_tets, level)?;
    let features = coarse.features.as_ref().map(|features| Features {
        creases: split_creases(&features.creases, topology, &midpoints),
        corners: features.corners.clone(),
        surfaces: features.surfaces.clone(),
        mirrors: features.mirrors.clone(),
        smoothed: features.smoothed,
        initial_quality: features.initial_quality,
        cell_states: states_of_parts(&tets, features),
        control_points: None,
    });
    let lineage = Lineage::listed(parents);
    let (triangles, triangle_lineage) =
        split_each(&coarse.triangles, |own| of_triangle(topology, &midpoints, own));
    let (edges, edge_lineage) = split_each(&coarse.edges, |own| of_edge(topology, &midpoints, own));
    let ancestry = Ancestry {
        vertices: topology.vertex_count(),
        split_edges: SplitEdges::Some(split_edges),
        tets: lineage,
        triangles: triangle_lineage,
        edges: edge_lineage,
    };
    let fine = RawMesh {
        regions: ancestry.tets.inherit(&coarse.regions, 1),
        points,
        tets: fine_tets,
        triangles,
        edges,
        vertices: coarse.vertices.clone(),
        groups: coarse.groups.clone(),
        features,
    };
    let topology = Topology::new(&fine);
    let refinement = Refinement {
        scheme: Scheme::Linear,
        matrix,
        mirrored: None,
        ancestry,
        guard: None,
        interpolation: None,
    };
    Ok((TetMesh::trusted(fine), topology, refinement))
}

//! Basis functions of subdivision, and values along a line.

use super::error::AnalysisError;
use super::tet_grid::TetGrid;
use crate::core::tet_mesh::TetMesh;
use crate::hierarchy::Hierarchy;
use octruss_base::vector3::{length, subtract};

/// Points this far outside a tet, in barycentric coordinates, still count as in it.
const ROUNDING: f64 = 1e-9;

/// The values on the finest mesh of the field that is 1 at one vertex of a
/// level and 0 at its others, refined by the hierarchy's own matrices.
///
/// # Errors
/// If there is no such level or vertex.
pub fn basis_function(
    hierarchy: &Hierarchy,
    level: usize,
    vertex: u32,
) -> Result<Vec<f64>, AnalysisError> {
    let finest = hierarchy.transfers();
    let start = hierarchy.levels().get(level).ok_or(AnalysisError::NoLevel { level, finest })?;
    let vertices = start.mesh.points().len();
    let mut values = vec![0.0; vertices];
    *values.get_mut(vertex as usize).ok_or(AnalysisError::NoVertex { vertex, vertices })? = 1.0;
    let finer = hierarchy.refinements().skip(level);
    Ok(finer.fold(values, |values, step| step.matrix.apply_field(&values, 1)))
}

/// The value of a field at a point of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineSample {
    /// Along the line from the point that it was drawn through, in mesh units;
    /// negative behind it.
    pub distance: f64,
    /// Where the sample lies.
    pub point: [f64; 3],
    /// The piecewise linear field there.
    pub value: f64,
}

/// Samples a vertex field, linear in each tet, along the line through a point:
/// at `samples` points on either side, and the point itself, as far as the
/// mesh extends from it; those outside the mesh are left out.
///
/// `direction` need not be of unit length; if it is zero or `samples` is, there
/// is the one sample at the point.
pub fn sample_line(
    mesh: &TetMesh,
    values: &[f64],
    through: [f64; 3],
    direction: [f64; 3],
    samples: u32,
) -> Vec<LineSample> {
    let grid = TetGrid::new(mesh.points(), mesh.tets());
    let size = length(direction);
    let unit = direction.map(|d| if size > 0.0 { d / size } else { 0.0 });
    let distance_to = |p: &[f64; 3]| length(subtract(*p, through));
    let reach = mesh.points().iter().map(distance_to).fold(0.0, f64::max);
    let samples = i64::from(if size > 0.0 { samples } else { 0 });
    let sample = |i: i64| {
        let distance = reach * i as f64 / samples.max(1) as f64;
        let point = [0, 1, 2].map(|k| through[k] + distance * unit[k]);
        let (tet, shares) = grid.containing(point, ROUNDING).next()?;
        let corners = mesh.tets()[tet as usize].map(|v| values[v as usize]);
        let value = corners.iter().zip(shares).map(|(value, share)| value * share).sum();
        Some(LineSample { distance, point, value })
    };
    (-samples..=samples).filter_map(sample).collect()
}

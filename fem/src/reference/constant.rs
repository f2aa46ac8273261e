//! The constant that the values prescribed on each part of a body lie round.

use crate::reference::offset::is_far;
use octruss_mesh::TetMesh;
use octruss_mesh::components::part_of_vertices;
use std::collections::BTreeMap;

/// The mean of the `prescribed` values, each with its vertex, on the part of each vertex;
/// where none is, that of the `surrounding` ones. `None` if they lie far from zero, beside
/// what they vary by, on no part, as where all are 0.
pub(crate) fn constants(
    mesh: &TetMesh,
    prescribed: &[(u32, f64)],
    surrounding: &[(u32, f64)],
) -> Option<Vec<f64>> {
    if prescribed.iter().chain(surrounding).all(|(_, value)| *value == 0.0) {
        return None;
    }
    let parts = part_of_vertices(mesh.raw());
    let by_part = |values: &[(u32, f64)]| {
        let mut all: BTreeMap<u32, Vec<f64>> = BTreeMap::new();
        for (vertex, value) in values {
            all.entry(parts[*vertex as usize]).or_default().push(*value);
        }
        all
    };
    let mut all = by_part(surrounding);
    all.extend(by_part(prescribed));
    let mut constants = vec![0.0; parts.len()];
    for (part, values) in &all {
        constants[*part as usize] = constant(values);
    }
    let is_any = constants.iter().any(|constant| *constant != 0.0);
    is_any.then(|| parts.iter().map(|part| constants[*part as usize]).collect())
}

/// The mean of values far from zero; else 0. Of equal ones exactly what they are.
fn constant(values: &[f64]) -> f64 {
    let sum: f64 = values.iter().map(|value| value - values[0]).sum();
    let mean = values[0] + sum / values.len() as f64;
    let squares = |less: f64| values.iter().map(|value| (value - less).powi(2)).sum::<f64>();
    // What is infinite is refused by whoever assembles.
    if mean.is_finite() && is_far(squares(0.0), squares(mean)) { mean } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mean_far_from_zero_counts_and_one_amid_the_values_does_not() {
        assert_eq!(constant(&[293.15; 7]), 293.15);
        assert_eq!(constant(&[-1e6, -1e6 - 2.0]), -1e6 - 1.0);
        assert_eq!(constant(&[0.0, 1.0]), 0.0);
        assert_eq!(constant(&[20.0, 80.0]), 0.0);
        assert_eq!(constant(&[0.0; 3]), 0.0);
        assert_eq!(constant(&[f64::INFINITY, 1.0]), 0.0);
    }
}

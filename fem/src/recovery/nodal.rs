//! Values at vertices from values on tets.

use crate::assemble::scatter::Scatter;
use crate::error::Error;
use octruss_base::chunks::for_chunks;
use octruss_base::large_array::filled;
use octruss_mesh::TetMesh;
use octruss_solver::check_size;

/// Recovers at each vertex the mean, weighted by volume, of the tets round it.
///
/// Stress and strain jump where the material does, and a mean over the jump is
/// wrong on both sides; so each side is recovered by itself, from the tets of
/// its regions alone.
pub struct Recovery<'a> {
    scatter: Scatter<'a, 4>,
    /// The volume of each tet; 0 outside the regions.
    weights: Vec<f64>,
    /// The sum of the weights round each vertex.
    totals: Vec<[f64; 1]>,
}

impl<'a> Recovery<'a> {
    /// From the tets of the regions for which `takes_part` says so.
    pub fn new(mesh: &'a TetMesh, takes_part: impl Fn(i32) -> bool + Sync) -> Self {
        let mut weights = filled(0.0, mesh.tets().len());
        for_chunks(&mut weights, |first, chunk| {
            for (weight, tet) in chunk.iter_mut().zip(first..) {
                if takes_part(mesh.regions()[tet]) {
                    *weight = mesh.volume(tet);
                }
            }
        });
        let scatter = Scatter::new(mesh.tets(), mesh.points().len());
        let totals =
            scatter.sum_over(|tet| weights[tet] > 0.0, |tet| [[weights[tet]]; 4]).in_order();
        Self { scatter, weights, totals }
    }

    /// The mean at each vertex; NaN at vertices of no tet that takes part.
    ///
    /// # Errors
    /// [`octruss_solver::Error::Size`] unless there is one value for each tet.
    pub fn at_vertices<const K: usize>(&self, values: &[[f64; K]]) -> Result<Vec<[f64; K]>, Error> {
        check_size("values of tets", values.len(), self.weights.len())?;
        let weighted = |tet: usize| [values[tet].map(|value| self.weights[tet] * value); 4];
        let sums = self.scatter.sum_over(|tet| self.weights[tet] > 0.0, weighted);
        let mut means = filled([0.0; K], self.totals.len());
        for_chunks(&mut means, |first, chunk| {
            for (mean, vertex) in chunk.iter_mut().zip(first..) {
                let [total] = self.totals[vertex];
                *mean = if total > 0.0 {
                    sums.at(vertex as u32).map(|value| value / total)
                } else {
                    [f64::NAN; K]
                };
            }
        });
        Ok(means)
    }
}

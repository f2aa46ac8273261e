//! Values at vertices from values on tets.

use crate::assemble::scatter::Scatter;
use crate::error::Error;
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
    pub fn new(mesh: &'a TetMesh, takes_part: impl Fn(i32) -> bool) -> Self {
        let weight = |(tet, &region): (usize, &i32)| {
            if takes_part(region) { mesh.volume(tet) } else { 0.0 }
        };
        let weights: Vec<f64> = mesh.regions().iter().enumerate().map(weight).collect();
        let scatter = Scatter::new(mesh.tets(), mesh.points().len());
        let totals = scatter.sum(|tet| [[weights[tet]]; 4]).in_order();
        Self { scatter, weights, totals }
    }

    /// The mean at each vertex; NaN at vertices of no tet that takes part.
    ///
    /// # Errors
    /// [`octruss_solver::Error::Size`] unless there is one value for each tet.
    pub fn at_vertices<const K: usize>(&self, values: &[[f64; K]]) -> Result<Vec<[f64; K]>, Error> {
        check_size("values of tets", values.len(), self.weights.len())?;
        let weighted = |tet: usize| [values[tet].map(|value| self.weights[tet] * value); 4];
        let mut sums = self.scatter.sum(weighted).in_order();
        for (sum, [total]) in sums.iter_mut().zip(&self.totals) {
            *sum = sum.map(|value| if *total > 0.0 { value / total } else { f64::NAN });
        }
        Ok(sums)
    }
}

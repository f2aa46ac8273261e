//! How far the vertices of a level are from the limit.

use crate::core::mirrors::Unfolded;
use crate::core::strata::Strata;
use crate::hierarchy::{Hierarchy, Level};
use crate::limit::across::Across;
use crate::limit::positions::limit_positions;
use crate::subdivide::step::Step;
use octruss_base::chunks::map_ranges;
use octruss_base::vector3::{Vector3, subtract};

/// How far vertices on curve and surface strata, corners included, are from the limit, in
/// mesh units: from their own limit, along the normal there; on a curve at right angles to
/// it. A vertex that stands elsewhere on the limit surface is not away from it. All are 0
/// where a scheme keeps vertices.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LimitDistances {
    /// The largest among the vertices of the level.
    pub largest: f64,
    /// The mean over them.
    pub mean: f64,
    /// The largest distance of a vertex of the coarsest level, where it is there, from the
    /// limit of what became of it.
    pub input_largest: f64,
    /// The mean over these.
    pub input_mean: f64,
}

impl Hierarchy {
    /// How far the boundary of a level is from the limit of further steps like this one,
    /// and how far the limit passes by the vertices of the coarsest level.
    ///
    /// If the step interpolates, the limits are those of the level's control points; on a
    /// level without any, they would be solved for, and all distances are 0.
    ///
    /// ```
    /// use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, Step, shapes};
    /// let smooth = FeatureOptions { crease_angle: 180.0, ..Default::default() };
    /// let plain = Step::from(Scheme::BoxSpline);
    /// let mut levels = Hierarchy::new(shapes::regular_tet(), &smooth);
    /// levels.subdivide(plain)?;
    /// // Each vertex goes to 2/5 of itself and 1/5 of each neighbour: from √3 to √3/5.
    /// let input = levels.limit_distances(1, plain).input_largest;
    /// assert!((input - 0.8 * 3f64.sqrt()).abs() < 1e-12);
    /// # Ok::<(), octruss_mesh::SubdivideError>(())
    /// ```
    ///
    /// # Panics
    /// If there is no such level.
    pub fn limit_distances(&self, level: usize, step: impl Into<Step>) -> LimitDistances {
        let (step, input) = (step.into(), self.coarsest().mesh.points());
        let level = &*self.levels()[level];
        let points = level.mesh.points();
        let Some(limits) = limits(level, &step) else { return LimitDistances::default() };
        let unfolded = Unfolded::new(level.mesh.raw(), &level.topology);
        let strata = Strata::unfolded(&unfolded);
        let lower = (0..points.len()).filter(|&v| strata.vertex_dimensions[v] < 3);
        let lower: Vec<usize> = lower.collect();
        let input_vertices = lower.partition_point(|&v| v < input.len());
        let unfolded_limits = unfolded.with_images(&limits);
        let across = Across::new(&unfolded.mesh, &unfolded.topology, &strata, &unfolded_limits);
        let away =
            |points: &[Vector3], v: usize| across.distance(v, subtract(points[v], limits[v]));
        let (largest, mean) = largest_and_mean(&lower, |v| away(points, v));
        let (input_largest, input_mean) =
            largest_and_mean(&lower[..input_vertices], |v| away(input, v));
        LimitDistances { largest, mean, input_largest, input_mean }
    }
}

/// The limit of each vertex, of its control point where there is one; `None` if vertices are their own.
fn limits(level: &Level, step: &Step) -> Option<Vec<Vector3>> {
    if step.scheme.keeps_vertices() {
        return None;
    }
    let Level { mesh, topology, .. } = level;
    let rules = (step.scheme, step.curve_ends_on(mesh));
    let recorded = mesh.features().and_then(|features| features.control_points.as_ref());
    let control_points = match recorded {
        Some(recorded) => recorded.of_all(mesh.points()),
        None if step.solves_for_control_points() => return None,
        None => mesh.points().to_vec(),
    };
    Some(limit_positions(mesh, topology, rules, &control_points))
}

fn largest_and_mean(vertices: &[usize], distance: impl Fn(usize) -> f64 + Sync) -> (f64, f64) {
    let sums = map_ranges(vertices.len(), |range| {
        let distances = vertices[range].iter().map(|&v| distance(v));
        distances.fold((0.0, 0.0), |(largest, sum): (f64, f64), d| (largest.max(d), sum + d))
    });
    let (largest, sum) = sums
        .into_iter()
        .fold((0.0, 0.0), |all: (f64, f64), part| (all.0.max(part.0), all.1 + part.1));
    (largest, sum / vertices.len().max(1) as f64)
}

//! The control points whose limits are given vertices.

use rayon::prelude::*;

use super::block::Block;
use crate::core::mirrors::Unfolded;
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use crate::subdivide::rules::limit::LimitRules;
use octruss_base::ragged::CHUNK;
use octruss_base::vector3::{Vector3, add, scale, subtract};

/// The residual that ends the solution, in mean edge lengths.
const SMALL: f64 = 1e-10;

/// Where creases end in a surface, a pass makes the residual this much smaller at least;
/// without such ends one pass is enough.
const PASS: f64 = 0.05;

/// More passes than needed.
const MOST_PASSES: usize = 60;

/// What was solved for.
pub(super) struct Solved {
    /// The control point of every vertex; where there is none, its position.
    pub control_points: Vec<Vector3>,
    /// The iterations of conjugate gradients, on curves and surfaces, over all passes.
    pub iterations: [usize; 2],
    /// The largest component of Λ c − p, in mesh units.
    pub residual: f64,
    /// Whether that is as small as it was to be.
    pub has_converged: bool,
}

/// Solves Λ c = p for the vertices of curves, then for those of surfaces.
///
/// Curves read surfaces only where a crease ends in one. There the equations are not
/// symmetric, either; they are solved with the smooth rule in their place, and again for
/// what that leaves.
pub(super) fn control_points(
    rules: &LimitRules,
    mesh: &Unfolded,
    listed: &[u32],
    edge_length: f64,
) -> Solved {
    let columns = mesh.topology.vertex_count();
    let limit = SubdivisionMatrix::from_rows(listed.len(), columns, |row, entries| {
        rules.row(listed[row], entries);
    });
    let tolerance = SMALL * edge_length;
    let points = &mesh.mesh.points[..mesh.vertices()];
    let system = System { rules, mesh, limit, points, listed };
    let has_darts = listed.iter().any(|&v| rules.is_dart(v));
    let blocks = [1, 2].map(|dimension| system.block(dimension));
    let mut solved = Solved {
        control_points: points.to_vec(),
        iterations: [0; 2],
        residual: f64::INFINITY,
        has_converged: false,
    };
    for _ in 0..MOST_PASSES {
        for (block, iterations) in blocks.iter().zip(&mut solved.iterations) {
            let residuals = system.residuals(&solved.control_points);
            let goal = match has_darts {
                true => tolerance.max(PASS * largest(&residuals)),
                false => tolerance,
            };
            *iterations +=
                system.improve(block, &residuals, 0.5 * goal, &mut solved.control_points);
        }
        solved.residual = largest(&system.residuals(&solved.control_points));
        solved.has_converged = solved.residual <= tolerance;
        if solved.has_converged {
            break;
        }
    }
    solved
}

struct System<'a> {
    rules: &'a LimitRules<'a>,
    mesh: &'a Unfolded<'a>,
    /// Λ, one row for each listed vertex; columns are unfolded vertices.
    limit: SubdivisionMatrix,
    points: &'a [Vector3],
    listed: &'a [u32],
}

impl System<'_> {
    /// The equations of the strata of a dimension, scaled so that they are symmetric.
    fn block(&self, dimension: u8) -> Block<'_> {
        let rules = self.rules;
        let own = |vertex: u32| {
            let is_of = rules.strata.vertex_dimensions[vertex as usize] == dimension;
            rules.own_weight(vertex).filter(|_| is_of)
        };
        let unknowns = self.listed.iter().copied().filter(|&v| own(v).is_some()).collect();
        let own = |vertex| own(vertex).expect("an unknown");
        let neighbours = |vertex| rules.neighbours(vertex).iter().copied();
        Block::new(unknowns, self.mesh, (own, 1.0), neighbours)
    }

    /// p − Λ c, for each listed vertex; across a mirror plane nothing is to be solved.
    fn residuals(&self, control_points: &[Vector3]) -> Vec<Vector3> {
        let limits = self.limit.apply(&self.mesh.with_images(control_points));
        let pairs = limits.par_iter().with_min_len(CHUNK).zip(self.listed);
        let residual = |(&limit, &v): (&Vector3, &u32)| {
            self.mesh.along_planes(v, subtract(self.points[v as usize], limit))
        };
        pairs.map(residual).collect()
    }

    /// Solves a block for what is left, and adds it; the number of iterations.
    fn improve(
        &self,
        block: &Block,
        residuals: &[Vector3],
        goal: f64,
        control_points: &mut [Vector3],
    ) -> usize {
        let totals: Vec<f64> = block.vertices.iter().map(|&v| self.total(v)).collect();
        let residual = |v: &u32| residuals[self.listed.binary_search(v).expect("it is listed")];
        let pairs = block.vertices.par_iter().with_min_len(CHUNK).zip(&totals);
        let rhs = pairs.map(|(vertex, &total)| scale(total, residual(vertex))).collect();
        let is_small = |at: usize, rest: Vector3| rest.iter().all(|x| x.abs() <= goal * totals[at]);
        let (change, iterations) = block.solve(rhs, is_small);
        for (&vertex, change) in block.vertices.iter().zip(change) {
            let place = &mut control_points[vertex as usize];
            *place = add(*place, change);
        }
        iterations
    }

    /// What the row of an unknown was multiplied by.
    fn total(&self, vertex: u32) -> f64 {
        let own = self.rules.own_weight(vertex).expect("an unknown");
        own + self.rules.neighbours(vertex).len() as f64
    }
}

fn largest(vectors: &[Vector3]) -> f64 {
    let sizes = vectors.par_iter().with_min_len(CHUNK);
    sizes.map(|v| v.iter().fold(0.0, |most: f64, x| most.max(x.abs()))).reduce(|| 0.0, f64::max)
}

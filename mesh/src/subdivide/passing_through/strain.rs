//! Where control points are drawn apart.

use rayon::prelude::*;

use crate::subdivide::rules::limit::LimitRules;
use octruss_base::ragged::CHUNK;
use octruss_base::vector3::{Vector3, length, subtract};

/// Beyond this, two neighbours' control points are moved against each other by more than
/// they are apart: the triangles there are too bad for a smooth surface through them.
const LARGE: f64 = 1.0;

/// How many of these vertices have, with some neighbour on their curve or surface, the
/// strain |d_i − d_j| / |p_i − p_j| > 1, where d is from the vertex to its control point.
pub(super) fn count_strained(
    rules: &LimitRules,
    points: &[Vector3],
    listed: &[u32],
    control_points: &[Vector3],
) -> usize {
    let moved = |v: u32| subtract(control_points[v as usize], points[v as usize]);
    let is_strained = |i: u32, j: u32| {
        let apart = length(subtract(points[i as usize], points[j as usize]));
        length(subtract(moved(i), moved(j))) > LARGE * apart
    };
    let listed = listed.par_iter().with_min_len(CHUNK);
    listed.filter(|&&v| rules.neighbours(v).iter().any(|&other| is_strained(v, other))).count()
}

//! The rigid motion that the displacements prescribed on each part of a body lie round.

use crate::boundary::constraints::Constraints;
use crate::boundary::held_vertex::HeldVertex;
use crate::reference::offset::is_far;
use crate::rigid_motion::RigidMotion;
use nalgebra::{Matrix6, SymmetricEigen, Vector6};
use octruss_base::vector3::{Matrix3, Vector3, add, apply, dot3, length, scale, subtract};
use octruss_mesh::TetMesh;
use octruss_mesh::components::part_of_vertices;
use std::collections::BTreeMap;

/// Motions that change the held directions by less than this, relative to what a held
/// motion does, squared, are not told by them.
const UNTOLD: f64 = 1e-12;

/// Differences below this, relative to the largest displacement, are rounding: of what is
/// prescribed, and of the motion.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The rigid motion nearest to the prescribed displacements on the part of each vertex, as a
/// displacement of each vertex, and what is prescribed less it. `None` if they lie far from
/// zero, beside what they differ by from it, on no part, as where all are 0.
pub(crate) fn rigid_motions(
    mesh: &TetMesh,
    constraints: &Constraints,
) -> Option<(Vec<Vector3>, Vec<Vector3>)> {
    if constraints.held().iter().all(|held| held.value == [0.0; 3]) {
        return None;
    }
    let parts = part_of_vertices(mesh.raw());
    let mut by_part: BTreeMap<u32, Vec<&HeldVertex>> = BTreeMap::new();
    for held in constraints.held() {
        by_part.entry(parts[held.vertex as usize]).or_default().push(held);
    }
    let mut motions = BTreeMap::new();
    let mut prescribed = vec![[0.0; 3]; parts.len()];
    for (part, held) in by_part {
        let motion = nearest(mesh, &held);
        for held in &held {
            prescribed[held.vertex as usize] = held.value;
        }
        let squares = |less: &dyn Fn(&HeldVertex) -> Vector3| {
            held.iter().map(|at| subtract(at.value, less(at))).map(|d| dot3(d, d)).sum::<f64>()
        };
        let moved = |at: &HeldVertex| {
            apply(&held_part(&at.projector), motion.at(mesh.points()[at.vertex as usize]))
        };
        if !is_far(squares(&|_| [0.0; 3]), squares(&moved)) {
            continue;
        }
        let largest = held.iter().map(|at| length(at.value)).fold(0.0, f64::max);
        for at in &held {
            let moved = moved(at);
            let is_rounding = |difference: f64| difference.abs() <= ROUNDING * largest;
            prescribed[at.vertex as usize] = subtract(at.value, moved)
                .map(|difference| if is_rounding(difference) { 0.0 } else { difference });
        }
        motions.insert(part, motion);
    }
    let at = |(part, point): (&u32, &Vector3)| {
        motions.get(part).map_or([0.0; 3], |motion| motion.at(*point))
    };
    let reference = || parts.iter().zip(mesh.points()).map(at).collect();
    (!motions.is_empty()).then(|| (reference(), prescribed))
}

/// I − Q, which leaves of a vector what is in held directions.
fn held_part(projector: &Matrix3) -> Matrix3 {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 } - projector[i][j])
    })
}

/// The one with the least sum of squared differences from what is prescribed; of those
/// that differ in what is not held, the smallest.
fn nearest(mesh: &TetMesh, held: &[&HeldVertex]) -> RigidMotion {
    let point = |at: &HeldVertex| mesh.points()[at.vertex as usize];
    let origin = point(held[0]);
    let arms = held.iter().map(|at| subtract(point(at), origin));
    let centre = add(origin, scale(1.0 / held.len() as f64, arms.fold([0.0; 3], add)));
    let size = held.iter().map(|at| length(subtract(point(at), centre))).fold(0.0, f64::max);
    let size = if size > 0.0 { size } else { 1.0 };
    let mut found = RigidMotion { centre, size, motion: [0.0; 6] };
    let gram = held.iter().fold(Matrix6::zeros(), |sum, at| {
        held_part(&at.projector).iter().fold(sum, |sum, row| {
            let row = found.moment(point(at), *row);
            sum + row * row.transpose()
        })
    });
    let eigen = SymmetricEigen::new(gram);
    let told = (0..6).filter(|k| eigen.eigenvalues[*k] > UNTOLD * eigen.eigenvalues.max());
    let told: Vec<usize> = told.collect();
    // Once more for what rounding left of it.
    for _ in 0..2 {
        let rest = held.iter().fold(Vector6::zeros(), |sum, at| {
            let moved = apply(&held_part(&at.projector), found.at(point(at)));
            sum + found.moment(point(at), subtract(at.value, moved))
        });
        for &k in &told {
            let direction = eigen.eigenvectors.column(k);
            let step = direction.dot(&rest) / eigen.eigenvalues[k];
            (0..6).for_each(|i| found.motion[i] += step * direction[i]);
        }
    }
    found
}

//! The forces on a deformed body: what supports, springs and loads do to it.

use crate::assemble::elasticity_load::{for_springs, spring_force};
use crate::assemble::inertia_relief::BalancedLoad;
use crate::boundary::constraints::{ByVertex, Constraints};
use crate::element::p1::{scaled_gradients, triangle_area};
use crate::error::Error;
use crate::problem::elasticity::Elasticity;
use crate::recovery::stress::full;
use octruss_base::chunks::map_ranges;
use octruss_base::vector3::{Vector3, add, apply, length, scale, subtract};
use octruss_mesh::{TetMesh, Topology};
use octruss_solver::check_size;

/// All forces on a body, each summed over what it acts on.
#[derive(Debug, Clone, PartialEq)]
pub struct Forces {
    /// For each support of the problem, the force with which it holds the body.
    /// Where supports hold one vertex in different directions, each has the share
    /// along its own.
    pub supports: Vec<[f64; 3]>,
    /// For each entry of the problem's springs, the force on the body.
    pub springs: Vec<[f64; 3]>,
    /// Body forces, gravity, tractions and pressures.
    pub loads: [f64; 3],
    /// The inertia of parts that nothing holds, if the problem balances their loads.
    pub inertia: [f64; 3],
    /// The sizes of the forces at vertices, summed for supports, springs and loads apart, the
    /// largest: forces that act against each other on one surface do not vanish from it.
    pub size: f64,
}

impl Forces {
    /// The forces at a displacement with these stresses: of a solution, its `values`, and the
    /// stresses from its [`differences`](crate::Solution::differences).
    ///
    /// # Errors
    /// [`octruss_solver::Error::Size`] unless there is a displacement for each vertex and a stress
    /// for each tet; those of the problem's assembly.
    pub fn new(
        (mesh, topology): (&TetMesh, &Topology),
        problem: &Elasticity,
        constraints: &Constraints,
        displacement: &[[f64; 3]],
        stresses: &[[f64; 6]],
    ) -> Result<Self, Error> {
        check_size("displacements", displacement.len(), mesh.points().len())?;
        check_size("stresses", stresses.len(), mesh.tets().len())?;
        let balanced = BalancedLoad::new(mesh, topology, problem, constraints)?;
        let load = balanced.total();
        let held = constraints.by_vertex();
        let mut resistance = internal_forces(mesh, &held, stresses);
        let (mut springs, mut sprung) = (vec![[0.0; 3]; problem.springs.len()], 0.0);
        for_springs(mesh, topology, problem, |index, triangle, corners, stiffness| {
            // The same rule as in the matrix: half of what acts at the midpoint of
            // an edge goes to each end.
            let share = triangle_area(corners) / 3.0;
            for (a, b) in [(0, 1), (0, 2), (1, 2)] {
                let middle = scale(0.5, add(corners[a], corners[b]));
                let [u_a, u_b] = [a, b].map(|v| displacement[triangle[v] as usize]);
                let moved = scale(0.5, add(u_a, u_b));
                let force = spring_force(stiffness(middle), share, moved);
                springs[index] = add(springs[index], force);
                sprung += length(force);
                for place in [a, b].into_iter().filter_map(|end| held.place(triangle[end])) {
                    let at = &mut resistance[place];
                    *at = subtract(*at, scale(0.5, force));
                }
            }
        })?;
        let mut supports = vec![[0.0; 3]; problem.supports.len()];
        let mut held_size = 0.0;
        for (held, resistance) in constraints.held().iter().zip(resistance) {
            let rest = subtract(resistance, load[held.vertex as usize]);
            let held_part = subtract(rest, apply(&held.projector, rest));
            held_size += length(held_part);
            for (support, share) in held.shares(held_part) {
                supports[support] = add(supports[support], share);
            }
        }
        let loaded = balanced.given.iter().map(|force| length(*force)).sum::<f64>();
        let size = loaded.max(sprung).max(held_size);
        let (loads, inertia) = (sum(&balanced.given), sum(&balanced.inertia));
        Ok(Self { supports, springs, loads, inertia, size })
    }

    /// The size of the sum of all forces relative to [`size`](Self::size): 0 in equilibrium,
    /// up to the accuracy of the solve.
    pub fn imbalance(&self) -> f64 {
        let all = [&self.supports[..], &self.springs, &[self.loads, self.inertia]].concat();
        if self.size == 0.0 { 0.0 } else { length(sum(&all)) / self.size }
    }
}

/// ∫ σ ∇φ at each held vertex: the force with which the body resists there. Only the
/// tets there are looked at, in their order.
fn internal_forces(mesh: &TetMesh, held: &ByVertex, stresses: &[[f64; 6]]) -> Vec<Vector3> {
    let of_tets = map_ranges(mesh.tets().len(), |tets| {
        let mut forces = Vec::new();
        for tet in tets {
            let places = mesh.tets()[tet].map(|vertex| held.place(vertex));
            if places.iter().all(Option::is_none) {
                continue;
            }
            let (_, gradients) = scaled_gradients(mesh.corners(tet));
            let stress = full(&stresses[tet]);
            let force = |gradient| scale(1.0 / 6.0, apply(&stress, gradient));
            let there = places.into_iter().zip(gradients);
            forces.extend(there.filter_map(|(place, at)| Some((place?, force(at)))));
        }
        forces
    });
    let mut sums = vec![[0.0; 3]; held.count()];
    for (place, force) in of_tets.into_iter().flatten() {
        sums[place] = add(sums[place], force);
    }
    sums
}

fn sum(forces: &[Vector3]) -> Vector3 {
    forces.iter().fold([0.0; 3], |sum, force| add(sum, *force))
}

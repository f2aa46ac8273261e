//! Loads of elastic bodies that nothing holds: the inertia that balances them.
//!
//! What free motions are left a part, its loads accelerate it in them: by b, a rigid motion,
//! with ∫ ρ b · m = load · m for each free motion m. The force −ρ b in each unit of volume
//! (d'Alembert's) balances the loads, and what is left deforms the part.

use crate::assemble::elasticity_load::{load_vector, spring_directions};
use crate::assemble::load::tet_load;
use crate::assemble::lumped::{lumped, lumped_volumes};
use crate::assemble::regularisation::{shifts, weighted_centre};
use crate::assemble::scatter::Scatter;
use crate::boundary::constraints::Constraints;
use crate::boundary::rigid_modes::check_rigid_modes;
use crate::error::Error;
use crate::free::balance::{Balance, Balancing, share};
use crate::free::free_bodies::FreeBodies;
use crate::free::free_part::{FreePart, free_parts};
use crate::free::null_space::NullSpace;
use crate::problem::elasticity::Elasticity;
use crate::problem::free::Free;
use crate::problem::scalar::Scalar;
use crate::rigid_motion::RigidMotion;
use nalgebra::{DMatrix, DVector};
use octruss_base::vector3::{Vector3, add, dot3, length, scale};
use octruss_mesh::components::first_tets;
use octruss_mesh::{TetMesh, Topology};

/// Numbers of an acceleration below this, relative to the largest, are rounding.
const ROUNDING: f64 = 1e-12;

/// The loads of a body, and what balances them.
pub(crate) struct BalancedLoad {
    /// The given force on each vertex.
    pub(crate) given: Vec<Vector3>,
    /// The force of inertia on each vertex; empty where no part is free.
    pub(crate) inertia: Vec<Vector3>,
    /// The parts that are free.
    pub(crate) parts: Vec<FreePart>,
    /// What was added to each.
    pub(crate) balances: Vec<Balance>,
    /// ∫ ρ m φ at each vertex for each free motion m of its part.
    moved_masses: Vec<Vec<Vector3>>,
}

impl BalancedLoad {
    /// The loads of a problem. Free parts are refused, or balanced, as it says.
    ///
    /// # Errors
    /// [`Error::RigidModes`], also of bodies that hang together by hinges; what
    /// [`load_vector`] has to say.
    pub(crate) fn new(
        mesh: &TetMesh,
        topology: &Topology,
        problem: &Elasticity,
        constraints: &Constraints,
    ) -> Result<Self, Error> {
        let mut springs = spring_directions(mesh, topology, problem)?;
        let parts = match problem.free {
            Free::Refuse => Vec::new(),
            Free::Balance => free_parts(mesh, constraints, &springs),
        };
        if !parts.is_empty() {
            // What is left with one tet of each free part held is no rigid motion of it.
            let part_of = numbered(&parts, mesh.points().len());
            let is_free = |tet: &u32| part_of[mesh.tets()[*tet as usize][0] as usize] < parts.len();
            let tets = first_tets(mesh.raw()).into_iter().filter(is_free);
            springs.extend(tets.flat_map(|tet| FreePart::anchors(mesh, tet)));
        }
        check_rigid_modes(mesh, topology, constraints, &springs)?;
        let given = load_vector(mesh, topology, problem)?;
        let mut all = Self {
            given,
            inertia: Vec::new(),
            balances: Vec::new(),
            moved_masses: Vec::new(),
            parts,
        };
        if !all.parts.is_empty() {
            all.balance(mesh, problem);
        }
        Ok(all)
    }

    /// All forces on each vertex.
    pub(crate) fn total(&self) -> Vec<Vector3> {
        if self.inertia.is_empty() {
            return self.given.clone();
        }
        self.given.iter().zip(&self.inertia).map(|(given, inertia)| add(*given, *inertia)).collect()
    }

    fn balance(&mut self, mesh: &TetMesh, problem: &Elasticity) {
        let density = |region: i32| &problem.material.of(region).density;
        let masses = lumped(mesh, density);
        let part_of = numbered(&self.parts, masses.len());
        let mass = |part: &FreePart| part.vertices.iter().map(|&v| masses[v as usize]).sum::<f64>();
        let is_massless: Vec<bool> = self.parts.iter().map(|part| mass(part) == 0.0).collect();
        let one = Scalar::Constant(1.0);
        let scatter = Scatter::new(mesh.tets(), masses.len());
        let most = self.parts.iter().map(|part| part.motions.len()).max().unwrap_or(0);
        let moved = |k: usize| {
            let sums = scatter.sum(|tet| {
                let number = part_of[mesh.tets()[tet][0] as usize];
                let motion = self.parts.get(number).and_then(|part| part.motions.get(k));
                let Some(motion) = motion else { return [[0.0; 3]; 4] };
                let region = mesh.regions()[tet];
                let density = if is_massless[number] { &one } else { density(region) };
                let at = |p| scale(density.at(p), motion.at(p));
                tet_load(mesh.corners(tet), false, at)
            });
            sums.in_order()
        };
        self.moved_masses = (0..most).map(moved).collect();
        let volumes = lumped_volumes(mesh);
        self.inertia = vec![[0.0; 3]; masses.len()];
        for (number, is_massless) in is_massless.into_iter().enumerate() {
            let shares = self.accelerations(mesh, &self.parts[number]);
            for &vertex in &self.parts[number].vertices {
                let force = &mut self.inertia[vertex as usize];
                for (share, moved) in shares.iter().zip(&self.moved_masses) {
                    *force = add(*force, scale(-share, moved[vertex as usize]));
                }
            }
            let weights = if is_massless { &volumes } else { &masses };
            let balance = self.told(mesh, &self.parts[number], &shares, weights);
            self.balances.push(balance);
        }
    }

    /// How the loads accelerate a part in each of its motions.
    fn accelerations(&self, mesh: &TetMesh, part: &FreePart) -> Vec<f64> {
        let count = part.motions.len();
        // A linear function times what ∫ φ is of another is the integral of both.
        let work = |motion: &RigidMotion, forces: &[Vector3]| {
            let at = |&v: &u32| dot3(motion.at(mesh.points()[v as usize]), forces[v as usize]);
            part.vertices.iter().map(at).sum::<f64>()
        };
        let mass = |i: usize, j: usize| work(&part.motions[i], &self.moved_masses[j]);
        let masses = DMatrix::from_fn(count, count, mass);
        let loads = DVector::from_fn(count, |i, _| work(&part.motions[i], &self.given));
        // Any body with a volume resists any motion.
        masses.lu().solve(&loads).map_or(vec![0.0; count], |shares| shares.as_slice().to_vec())
    }

    fn told(&self, mesh: &TetMesh, part: &FreePart, shares: &[f64], weights: &[f64]) -> Balance {
        let size = |forces: &[Vector3]| -> f64 {
            part.vertices.iter().map(|&v| length(forces[v as usize])).sum()
        };
        let mut sum = [0.0; 6];
        for (motion, share) in part.motions.iter().zip(shares) {
            (0..6).for_each(|k| sum[k] += share * motion.motion[k]);
        }
        let largest = sum.iter().fold(0.0, |largest: f64, number| largest.max(number.abs()));
        let is_rounding = |number: f64| number.abs() <= ROUNDING * largest;
        let told = sum.map(|number| if is_rounding(number) { 0.0 } else { number });
        let acceleration = part.motions[0].with(told);
        let centre = weighted_centre(mesh, &part.vertices, weights);
        Balance {
            vertices: part.vertices.len(),
            example: part.vertices[0],
            share: share(size(&self.inertia), size(&self.given)),
            added: Balancing::Acceleration {
                centre,
                linear: acceleration.at(centre),
                angular: acceleration.turn(),
            },
        }
    }

    /// The free parts as the solver sees them.
    pub(crate) fn free_bodies(
        &self,
        mesh: &TetMesh,
        problem: &Elasticity,
        constraints: &Constraints,
    ) -> Option<FreeBodies<Vector3>> {
        if self.parts.is_empty() {
            return None;
        }
        let vertices = self.parts.iter().map(|part| part.vertices.as_slice());
        let young = |tet: usize, middle| problem.material.of(mesh.regions()[tet]).young.at(middle);
        let shifts = shifts(mesh, vertices, &lumped_volumes(mesh), young);
        let dofs = constraints.dofs();
        let at_unknowns = |all: &Vec<Vector3>| {
            dofs.free().iter().map(|&v| all[v as usize]).collect::<Vec<Vector3>>()
        };
        let vectors = self.parts.iter().map(|part| part.null_vectors(mesh, constraints));
        Some(FreeBodies {
            null_space: NullSpace::new(vectors),
            balances: self.balances.clone(),
            shift: dofs.free().iter().map(|&v| shifts[v as usize]).collect(),
            means: self.moved_masses.iter().map(at_unknowns).collect(),
        })
    }
}

/// The number of the part of each vertex; of those in none a number that no part has.
fn numbered(parts: &[FreePart], vertices: usize) -> Vec<usize> {
    let mut numbers = vec![usize::MAX; vertices];
    for (number, part) in parts.iter().enumerate() {
        part.vertices.iter().for_each(|&vertex| numbers[vertex as usize] = number);
    }
    numbers
}

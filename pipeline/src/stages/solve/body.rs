//! What a deformed body has to show: strains, stresses, forces.

use octruss_fem::Error;
use octruss_fem::{
    Constraints, Elasticity, Forces, Recovery, Solution, equivalent_stresses, strains, stresses,
};
use octruss_mesh::{Level, RawMesh};
use octruss_meshio::{Field, Values};
use toml::Spanned;

use super::elasticity::ElasticityKeys;
use crate::report::{BodyFigures, ForceFigures, SurfaceForce};

/// A body with its displacement found.
pub(super) struct Body<'a> {
    pub(super) keys: &'a ElasticityKeys,
    pub(super) finest: &'a Level,
    pub(super) problem: &'a Elasticity,
    pub(super) constraints: &'a Constraints,
    /// Whether there are parts that nothing holds.
    pub(super) is_free: bool,
}

impl Body<'_> {
    /// The figures, the fields on vertices and those on tets. The displacements are NaN at
    /// vertices of no tet.
    pub(super) fn describe(
        &self,
        solution: Solution<[[f64; 3]; 3]>,
    ) -> Result<(BodyFigures, Vec<Field>, Vec<Field>), Error> {
        let Level { mesh, topology, .. } = self.finest;
        let displacement = &solution.values;
        let strain = strains(mesh, solution.differences())?;
        let stress = stresses(mesh, self.problem, &strain)?;
        let equivalent = equivalent_stresses(&stress);
        let constraints = self.constraints;
        let forces =
            Forces::new((mesh, topology), self.problem, constraints, displacement, &stress)?;
        let figures = BodyFigures {
            greatest_von_mises: equivalent.iter().copied().fold(0.0, f64::max),
            forces: self.force_figures(&forces),
        };
        let mut point_fields = vec![field("displacement", solution.values)];
        for (suffix, regions) in self.sides(mesh.raw()) {
            let recovery = Recovery::new(mesh, |id| regions.binary_search(&id).is_ok());
            let strain = recovery.at_vertices(&strain)?;
            let stress = recovery.at_vertices(&stress)?;
            let equivalent = equivalent_stresses(&stress);
            point_fields.push(field(&format!("strain{suffix}"), strain));
            point_fields.push(field(&format!("stress{suffix}"), stress));
            point_fields.push(Field::scalar(format!("von-mises{suffix}"), equivalent));
        }
        let cell_fields = vec![
            field("strain", strain),
            field("stress", stress),
            Field::scalar("von-mises", equivalent),
        ];
        Ok((figures, point_fields, cell_fields))
    }

    /// The regions that share a material, over whose borders nothing jumps, each
    /// list ascending, and how fields recovered in them are called: plainly if they are all.
    fn sides(&self, mesh: &RawMesh) -> Vec<(String, Vec<i32>)> {
        let material = |id: i32| self.problem.material.of(id);
        let mut sides: Vec<Vec<i32>> = Vec::new();
        for id in mesh.ids(3) {
            match sides.iter_mut().find(|side| material(side[0]) == material(id)) {
                Some(side) => side.push(id),
                None => sides.push(vec![id]),
            }
        }
        if sides.len() == 1 {
            return sides.into_iter().map(|side| (String::new(), side)).collect();
        }
        let name = |side: &[i32]| -> String {
            side.iter().map(|&id| format!("-{}", mesh.group_name(3, id))).collect()
        };
        sides.into_iter().map(|side| (name(&side), side)).collect()
    }

    fn force_figures(&self, forces: &Forces) -> ForceFigures {
        let mesh = self.finest.mesh.raw();
        // Supports and springs of the problem are those of the config, one for
        // each id of the surface called so.
        let supports = self.problem.supports.iter().map(|support| support.surface);
        let springs = self.problem.springs.iter().map(|(surface, _)| *surface);
        let fixed = self.keys.fixed.iter().map(|at| &at.get_ref().surface);
        let sprung = self.keys.springs.iter().map(|at| &at.surface);
        ForceFigures {
            reactions: by_name(mesh, fixed, supports.zip(&forces.supports)),
            springs: by_name(mesh, sprung, springs.zip(&forces.springs)),
            loads: forces.loads.into(),
            inertia: self.is_free.then(|| forces.inertia.into()),
            imbalance: forces.imbalance(),
        }
    }
}

/// The sum of the forces on all surfaces of each name, in the order of the names.
fn by_name<'a>(
    mesh: &RawMesh,
    names: impl Iterator<Item = &'a Spanned<String>>,
    forces: impl Iterator<Item = (i32, &'a [f64; 3])> + Clone,
) -> Vec<SurfaceForce> {
    let mut all: Vec<SurfaceForce> = Vec::new();
    for name in names.map(Spanned::get_ref) {
        if all.iter().any(|known| known.name == *name) {
            continue;
        }
        let ids = mesh.group_ids(2, name);
        let mine = forces.clone().filter(|(surface, _)| ids.contains(surface));
        let sum = mine.fold([0.0; 3], |sum, (_, force)| std::array::from_fn(|k| sum[k] + force[k]));
        all.push(SurfaceForce { name: name.clone(), force: sum.into() });
    }
    all
}

fn field<const K: usize>(name: &str, tuples: Vec<[f64; K]>) -> Field {
    Field::new(name, K, Values::Float(tuples.into_flattened()))
}

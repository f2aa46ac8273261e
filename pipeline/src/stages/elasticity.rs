//! An elastic body from the names that a config uses, and its deformation.

use std::time::Instant;

use octruss_fem::Error as SolverError;
use octruss_fem::{
    ByRegion, Constraints, Elasticity, Held, Material, Stiffness, Support, VectorSystem,
    assemble_elasticity, vector,
};
use octruss_mesh::{Hierarchy, Level, RawMesh};

use super::Context;
use super::body::Body;
use super::fixed::Fixed;
use super::groups::{by_region, on_surfaces};
use super::multigrid::{Discrete, blank_outside, range};
use super::solve::{Outcome, Solve, assembled, solve_in_turn};
use crate::error::Error;
use crate::recipe::{self, PerRegion, ValueOrVector, VectorValue};

/// Solves the problem that a stage describes on the finest mesh.
///
/// # Errors
/// A surface or region that the mesh does not have, a region without material;
/// whatever the solver reports.
pub(super) fn solve(
    options: &Solve,
    hierarchy: &Hierarchy,
    context: &Context,
) -> Result<Outcome, Error> {
    let problem = problem(options, hierarchy.finest().mesh.raw(), context)?;
    let (Assembled { discrete, constraints }, assembly_seconds) =
        assembled(options, context, || {
            assemble_levels(options, hierarchy, &problem)
                .map_err(|source| context.solver("assembly", source))
        })?;
    let expand = |x: &[[f64; 3]]| {
        let mut displacement = constraints.expand(x)?;
        let length = |u: &[f64; 3]| u.iter().map(|u| u * u).sum::<f64>().sqrt();
        let range = range(displacement.iter().map(length));
        blank_outside(&mut displacement, &hierarchy.finest().mesh, [f64::NAN; 3]);
        Ok((displacement, range))
    };
    let (displacement, solves) = solve_in_turn(options, hierarchy, &discrete, expand, context)?;
    let body = Body { options, hierarchy, problem: &problem, constraints: &constraints };
    let (figures, point_fields, cell_fields) = body
        .describe(displacement)
        .map_err(|source| context.solver("stresses and forces", source))?;
    Ok(Outcome { solves, assembly_seconds, point_fields, cell_fields, body: Some(figures) })
}

/// The problem that a stage describes, on the finest mesh.
///
/// # Errors
/// As [`solve`], but of assembling alone.
pub(crate) fn discretise(
    options: &Solve,
    hierarchy: &Hierarchy,
    context: &Context,
) -> Result<Discrete<[[f64; 3]; 3]>, Error> {
    let problem = problem(options, hierarchy.finest().mesh.raw(), context)?;
    let assembled = assemble_levels(options, hierarchy, &problem);
    Ok(assembled.map_err(|source| context.solver("assembly", source))?.discrete)
}

/// The system, and what is held on the finest level.
struct Assembled {
    discrete: Discrete<[[f64; 3]; 3]>,
    constraints: Constraints,
}

impl AsRef<Discrete<[[f64; 3]; 3]>> for Assembled {
    fn as_ref(&self) -> &Discrete<[[f64; 3]; 3]> {
        &self.discrete
    }
}

/// The system on the finest level and the unknowns of all.
fn assemble_levels(
    options: &Solve,
    hierarchy: &Hierarchy,
    problem: &Elasticity,
) -> Result<Assembled, SolverError> {
    let finest = hierarchy.transfers();
    let system_of = |level: usize| {
        let Level { mesh, topology, .. } = &*hierarchy.levels()[level];
        assemble_elasticity(mesh, topology, problem)
    };
    let (mut levels, mut coarse_matrices, mut coarse_seconds) = (Vec::new(), Vec::new(), 0.0);
    for level in 0..finest {
        let Level { mesh, topology, .. } = &*hierarchy.levels()[level];
        levels.push((&Constraints::new(mesh, topology, &problem.supports)?).into());
        if options.reassembles() {
            let start = Instant::now();
            coarse_matrices.push(system_of(level)?.matrix);
            coarse_seconds += start.elapsed().as_secs_f64();
        }
    }
    let VectorSystem { matrix, rhs, constraints } = system_of(finest)?;
    levels.push((&constraints).into());
    let coarsest = options
        .coarsest_solution(&levels, || system_of(0).map(|system| (system.matrix, system.rhs)))?;
    let discrete = Discrete { matrix, rhs, levels, coarse_matrices, coarse_seconds, coarsest };
    Ok(Assembled { discrete, constraints })
}

/// The problem that a stage describes, on this mesh.
fn problem(options: &Solve, mesh: &RawMesh, context: &Context) -> Result<Elasticity, Error> {
    let zero = vector([0.0; 3]);
    let loads = options.traction.iter().map(|at| (&at.surface, at.value.to_vector()));
    let pressures = options.pressure.iter().map(|at| (&at.surface, at.value.to_scalar()));
    let springs = options.springs.iter().map(|at| (&at.surface, stiffness(&at.stiffness)));
    let fixed = options.fixed.iter().map(|entry| entry.get_ref());
    let supports = on_surfaces(fixed.map(|at| (&at.surface, held(at))), mesh, context)?;
    Ok(Elasticity {
        material: materials(options, mesh, context)?,
        body_force: by_region(&options.body_force, VectorValue::to_vector, zero, mesh, context)?,
        gravity: options.gravity.to_vector(),
        traction: on_surfaces(loads, mesh, context)?,
        pressure: on_surfaces(pressures, mesh, context)?,
        springs: on_surfaces(springs, mesh, context)?,
        supports: supports.into_iter().map(|(surface, held)| Support { surface, held }).collect(),
    })
}

/// The material of each region; every region in use must have one.
fn materials(
    options: &Solve,
    mesh: &RawMesh,
    context: &Context,
) -> Result<ByRegion<Material>, Error> {
    let given = options
        .material
        .as_ref()
        .ok_or_else(|| context.request("problem = \"elasticity\" needs `material`".into()))?;
    let convert = |material: &recipe::Material| Material {
        young: material.young.to_scalar(),
        poisson: material.poisson.to_scalar(),
        density: material.density.to_scalar(),
    };
    // Stands where nothing is given, which is refused below.
    let none = Material::new(f64::NAN, f64::NAN);
    let materials = by_region(given, convert, none, mesh, context)?;
    let has_default = match given {
        PerRegion::Uniform(_) => true,
        PerRegion::Named(named) => {
            named.iter().any(|(name, _)| name.get_ref() == PerRegion::<recipe::Material>::DEFAULT)
        }
    };
    let named = |id: &i32| materials.regions.iter().any(|(region, _)| region == id);
    match mesh.ids(3).into_iter().find(|id| !has_default && !named(id)) {
        None => Ok(materials),
        Some(id) => {
            let name = mesh.group_name(3, id);
            Err(context.request(format!(
                "region `{name}` has no material: give it one in `material`, or one for all \
                 others as `default`"
            )))
        }
    }
}

/// What an entry of `fixed` holds; that it says so in one way is checked when
/// the config is read.
fn held(fixed: &Fixed) -> Held {
    let Fixed { value, x, y, z, normal, .. } = fixed;
    match (value, normal) {
        (Some(ValueOrVector::Other(value)), _) => Held::Components(value.to_vector().map(Some)),
        (_, Some(normal)) => Held::Normal(normal.to_scalar()),
        _ => Held::Components([x, y, z].map(|value| value.as_ref().map(recipe::Value::to_scalar))),
    }
}

fn stiffness(given: &ValueOrVector) -> Stiffness {
    match given {
        ValueOrVector::One(value) => Stiffness::Normal(value.to_scalar()),
        ValueOrVector::Other(vector) => Stiffness::Axes(vector.to_vector()),
    }
}

//! The study: every geometry, on every level every variant.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use octruss_fem::Error as SolverError;
use octruss_mesh::{Hierarchy, Scheme};
use octruss_solver::Entry;

use super::Comparison;
use super::carried::{self, Carried};
use super::plan::{Compare, Geometry};
use super::row::{Level, Row};
use super::verdict::verdict;
use crate::error::Error;
use crate::observer::{Event, Observer, StagePlace};
use crate::recipe::{Choice, ConfigError, Named, Place, Recipe};
use crate::run::run_into;
use crate::stages::multigrid::Discrete;
use crate::stages::{Context, Problem, Solve, Stage, Subdivide, biharmonic, elasticity, poisson};

/// Compares what a config's table `[compare]` lists, on the problem of its first stage
/// `solve` and the levels of its first stage `subdivide`; stages between and after
/// these are not run. Nothing is written.
///
/// # Errors
/// A config without these stages, or with levels that they do not make; whatever stops
/// a stage; [`Error::Stopped`] once `stop` is true.
pub fn compare(
    recipe: &Recipe,
    observer: &dyn Observer,
    stop: &AtomicBool,
) -> Result<Comparison, Error> {
    let start = Instant::now();
    let study = Study::new(recipe, observer, stop)?;
    let (mut rows, mut carried) = (Vec::new(), Vec::new());
    for geometry in study.plan.geometries(study.subdivide.scheme.0) {
        let mut hierarchy = study.hierarchy(geometry)?;
        for level in &study.levels {
            while hierarchy.refinements.len() > *level {
                hierarchy.meshes.pop();
                hierarchy.topologies.pop();
                hierarchy.refinements.pop();
            }
            let (more_rows, more_carried) = match study.solve.problem {
                Problem::Poisson => study.level(&hierarchy, geometry, poisson::discretise)?,
                Problem::Biharmonic => study.level(&hierarchy, geometry, biharmonic::discretise)?,
                Problem::Elasticity => study.level(&hierarchy, geometry, elasticity::discretise)?,
            };
            rows.extend(more_rows);
            carried.extend(more_carried);
        }
    }
    let order = |geometry: &str| Geometry::ALL.iter().position(|g| g.name() == geometry);
    rows.sort_by_key(|row: &Row| (order(row.geometry), row.level));
    carried.sort_by_key(|row: &Carried| (order(row.geometry), row.level));
    Ok(Comparison {
        octruss: env!("CARGO_PKG_VERSION"),
        config: recipe.name.clone(),
        threads: rayon::current_num_threads(),
        seconds: start.elapsed().as_secs_f64(),
        verdict: verdict(&rows),
        rows,
        carried,
    })
}

struct Study<'a> {
    recipe: &'a Recipe,
    plan: Compare,
    /// What makes the checked mesh.
    before: Vec<Stage>,
    subdivide: &'a Subdivide,
    solve: &'a Solve,
    /// The body's name.
    body: String,
    /// Finest first.
    levels: Vec<usize>,
    observer: &'a dyn Observer,
    stop: &'a AtomicBool,
}

impl<'a> Study<'a> {
    fn new(
        recipe: &'a Recipe,
        observer: &'a dyn Observer,
        stop: &'a AtomicBool,
    ) -> Result<Self, Error> {
        let refuse = |message: String| {
            let path = || Place::File(recipe.source.path().into());
            let table = recipe.compare.as_ref();
            let place = table.map_or_else(path, |table| recipe.source.place(&table.span()));
            Error::Config(ConfigError { place, message: format!("cannot compare: {message}") })
        };
        let stages = &recipe.stages;
        let found = stages.iter().enumerate().find_map(|(at, stage)| match stage {
            Stage::Subdivide(subdivide) => Some((at, subdivide)),
            _ => None,
        });
        let (at, subdivide) =
            found.ok_or_else(|| refuse("there is no stage `subdivide`".into()))?;
        let solve = stages[at..].iter().find_map(|stage| match stage {
            Stage::Solve(solve) => Some(&**solve),
            _ => None,
        });
        let solve =
            solve.ok_or_else(|| refuse("there is no stage `solve` after `subdivide`".into()))?;
        let body = stages[..at].iter().find_map(|stage| match stage {
            Stage::Import(import) => import.path.file_stem(),
            _ => None,
        });
        let plan = recipe.compare.as_ref().map(|table| table.get_ref().clone()).unwrap_or_default();
        let levels = plan.levels(subdivide.levels).map_err(refuse)?;
        Ok(Self {
            recipe,
            plan,
            before: stages[..at]
                .iter()
                .filter(|stage| matches!(stage, Stage::Import(_) | Stage::Check(_)))
                .cloned()
                .collect(),
            subdivide,
            solve,
            body: body.unwrap_or_default().to_string_lossy().into(),
            levels,
            observer,
            stop,
        })
    }

    /// The levels up to the finest that is asked for.
    fn hierarchy(&self, geometry: Geometry) -> Result<Hierarchy, Error> {
        let scheme = match geometry {
            Geometry::Flat => Named(Scheme::Linear),
            Geometry::Subdivided => self.subdivide.scheme,
        };
        let levels = self.levels.first().map_or(0, |&finest| finest as u8);
        let refined = Subdivide { scheme, levels, ..self.subdivide.clone() };
        let mut stages = self.before.clone();
        stages.push(Stage::Subdivide(refined));
        let folders = [&*self.recipe.folder, Path::new("")];
        let source = Some(&self.recipe.source);
        let who = (self.observer, self.stop);
        let state = run_into(&mut Vec::new(), &stages, source, folders, who)?;
        Ok(state.mesh.into_levels().expect("a stage `subdivide` makes levels"))
    }

    /// All variants on the finest level of a hierarchy, and Chang's test.
    fn level<E: Entry<Real = f64>>(
        &self,
        hierarchy: &Hierarchy,
        geometry: Geometry,
        discretise: impl Fn(&Solve, &Hierarchy, &Context) -> Result<Discrete<E>, Error>,
    ) -> Result<(Vec<Row>, Vec<Carried>), Error> {
        let number = hierarchy.refinements.len();
        let label = format!("{} level {number}", geometry.name());
        let stage = StagePlace { number: 1, of: 1, label: label.clone() };
        let source = Some(&self.recipe.source);
        let folders = [&*self.recipe.folder, Path::new("")];
        let [input_folder, output_folder] = folders;
        let (observer, stop) = (self.observer, self.stop);
        let context = Context { input_folder, output_folder, source, stage, observer, stop };
        context.tell(Event::StageBegan);
        let start = Instant::now();
        let variants = self.plan.variants(self.solve);
        let reassembling = variants.iter().find(|variant| variant.reassembles());
        let problem = discretise(reassembling.unwrap_or(self.solve), hierarchy, &context)?;
        let level = Level {
            problem: self.solve.problem.name(),
            body: &self.body,
            geometry,
            hierarchy,
            discrete: &problem,
            context: &context,
            repeats: self.plan.repeats(),
        };
        let mut rows = Vec::new();
        for (index, variant) in variants.iter().enumerate() {
            if context.asked_to_stop() {
                return Err(Error::Stopped { stage: label });
            }
            let what = format!("{} prolongation", variant.prolongation[0]);
            rows.push(context.step(index + 1, variants.len(), &what, || {
                let row =
                    level.row(variant).map_err(|source| self.failed(source, &what, &context))?;
                let result = row.result();
                Ok::<_, Error>((row, result))
            })?);
        }
        let carried = self.carried(hierarchy, geometry, &problem, (&discretise, &context))?;
        let summary = format!("{} variants", rows.len());
        let seconds = start.elapsed().as_secs_f64();
        context.tell(Event::StageDone { summary, seconds });
        Ok((rows, carried))
    }

    fn failed(&self, source: SolverError, what: &str, context: &Context) -> Error {
        match source {
            SolverError::Solver(octruss_solver::Error::Stopped(_)) => {
                Error::Stopped { stage: context.stage.label.clone() }
            }
            source => context.solver(what, source),
        }
    }

    fn carried<E: Entry<Real = f64>>(
        &self,
        hierarchy: &Hierarchy,
        geometry: Geometry,
        problem: &Discrete<E>,
        (discretise, context): (
            &impl Fn(&Solve, &Hierarchy, &Context) -> Result<Discrete<E>, Error>,
            &Context,
        ),
    ) -> Result<Vec<Carried>, Error> {
        let below = hierarchy.refinements.len() - 1;
        let coarse = Hierarchy {
            meshes: hierarchy.meshes[..=below].to_vec(),
            topologies: hierarchy.topologies[..=below].to_vec(),
            refinements: hierarchy.refinements[..below].to_vec(),
        };
        let coarse_problem = discretise(self.solve, &coarse, context)?;
        let mut schemes = vec![Scheme::Linear, self.subdivide.scheme()];
        schemes.dedup();
        let levels = (hierarchy, geometry);
        let below = (&coarse, &coarse_problem);
        carried::carry(self.solve, &schemes, levels, problem, below, context)
            .map_err(|source| self.failed(source, "a solution to carry up", context))
    }
}

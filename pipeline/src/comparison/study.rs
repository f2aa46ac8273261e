//! The study: every geometry, on every level every variant.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use octruss_base::choice::{Choice, Named};
use octruss_fem::{Discretisation, Error as FemError, Problem};
use octruss_mesh::{Hierarchy, Scheme};

use super::carried;
use super::carried_solution::CarriedSolution;
use super::found::Comparison;
use super::level_study::LevelStudy;
use super::row::Row;
use super::verdict::verdict;
use crate::error::{ConfigError, ConfigPlace, Error};
use crate::observer::{Event, Observer, StagePlace};
use crate::options::{Compare, Geometry};
use crate::recipe::Recipe;
use crate::run::run_stages;
use crate::stages::solve::{biharmonic, elasticity, poisson};
use crate::stages::{Context, ProblemKeys, Solve, Stage, Subdivide, Workplace};

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
            // What is finer is not needed any more.
            hierarchy = hierarchy.truncated(*level + 1);
            let (more_rows, more_carried) = study.on_level(&hierarchy, geometry)?;
            rows.extend(more_rows);
            carried.extend(more_carried);
        }
    }
    let order = |geometry: &str| Geometry::ALL.iter().position(|g| g.name() == geometry);
    rows.sort_by_key(|row: &Row| (order(&row.geometry), row.level));
    carried.sort_by_key(|row: &CarriedSolution| (order(&row.geometry), row.level));
    Ok(Comparison {
        octruss: env!("CARGO_PKG_VERSION").into(),
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
            let path = || ConfigPlace::File(recipe.source.path().into());
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

    fn workplace(&self) -> Workplace<'_> {
        Workplace {
            input_folder: &self.recipe.folder,
            output_folder: Path::new(""),
            source: Some(&self.recipe.source),
            observer: self.observer,
            stop: self.stop,
        }
    }

    /// The levels up to the finest that is asked for.
    fn hierarchy(&self, geometry: Geometry) -> Result<Hierarchy, Error> {
        let scheme = match geometry {
            Geometry::Flat => Named(Scheme::Linear),
            Geometry::Subdivided => self.subdivide.scheme,
        };
        let levels = self.levels.first().map_or(0, |&finest| finest as u8);
        // What is compared are the published schemes, unless a config asks for more.
        let interpolate = self.subdivide.interpolate.or(Some(false));
        let refined = Subdivide { scheme, levels, interpolate, ..self.subdivide.clone() };
        let mut stages = self.before.clone();
        stages.push(Stage::Subdivide(refined));
        let state = run_stages(&stages, self.workplace())?;
        Ok(state.mesh.into_levels().expect("a stage `subdivide` makes levels"))
    }

    /// All variants on the finest level of a hierarchy, and Chang's test.
    fn on_level(
        &self,
        hierarchy: &Hierarchy,
        geometry: Geometry,
    ) -> Result<(Vec<Row>, Vec<CarriedSolution>), Error> {
        let label = format!("{} level {}", geometry.name(), hierarchy.transfers());
        let context =
            Context { work: self.workplace(), stage: StagePlace { number: 1, of: 1, label } };
        let mesh = hierarchy.finest().mesh.raw();
        let levels = (hierarchy, geometry);
        match &self.solve.problem {
            ProblemKeys::Poisson(keys) => {
                self.compare(levels, &poisson::problem(keys, mesh, &context)?, &context)
            }
            ProblemKeys::Biharmonic(keys) => {
                self.compare(levels, &biharmonic::problem(keys, mesh, &context)?, &context)
            }
            ProblemKeys::Elasticity(keys) => {
                self.compare(levels, &elasticity::problem(keys, mesh, &context)?, &context)
            }
        }
    }

    fn compare<P: Problem>(
        &self,
        (hierarchy, geometry): (&Hierarchy, Geometry),
        problem: &P,
        context: &Context,
    ) -> Result<(Vec<Row>, Vec<CarriedSolution>), Error> {
        context.tell(Event::StageBegan);
        let start = Instant::now();
        let variants = self.plan.variants(self.solve);
        let reassembling = variants.iter().find(|variant| variant.options.reassembles());
        let options = &reassembling.unwrap_or(self.solve).options;
        let discretise = |hierarchy, options| {
            Discretisation::new(hierarchy, problem, options)
                .map_err(|source| context.solver("assembly", source))
        };
        let discrete = discretise(hierarchy, options)?;
        if discrete.free.is_some() {
            let message = "cannot compare on bodies that nothing holds: leave out `free`, and hold \
                           the body";
            return Err(context.request(message.into()));
        }
        let level = LevelStudy {
            problem: self.solve.problem.equation().name(),
            body: &self.body,
            geometry,
            discrete: &discrete,
            context,
            repeats: self.plan.repeats(),
        };
        let mut rows = Vec::new();
        for (index, variant) in variants.iter().enumerate() {
            if context.asked_to_stop() {
                return Err(Error::Stopped { stage: context.stage.label.clone() });
            }
            let options = variant.in_turn()[0];
            let prolongations = options.prolongation.unwrap_or(discrete.usual_prolongation);
            let what = format!("{prolongations} prolongation");
            rows.push(context.step(index + 1, variants.len(), &what, || {
                let row = level.row(&options).map_err(|source| failed(source, &what, context))?;
                let result = row.result();
                Ok::<_, Error>((row, result))
            })?);
        }
        let coarse = hierarchy.truncated(hierarchy.transfers());
        let coarse = discretise(&coarse, &self.solve.options)?;
        let mut schemes = vec![Scheme::Linear, self.subdivide.scheme()];
        schemes.dedup();
        let options = self.solve.in_turn()[0];
        let carried = carried::carry(&options, &schemes, geometry, [&coarse, &discrete], context)
            .map_err(|source| failed(source, "a solution to carry up", context))?;
        let summary = format!("{} variants", rows.len());
        let seconds = start.elapsed().as_secs_f64();
        context.tell(Event::StageDone { summary, seconds });
        Ok((rows, carried))
    }
}

fn failed(source: FemError, what: &str, context: &Context) -> Error {
    match source {
        FemError::Solver(octruss_solver::Error::Stopped(_)) => {
            Error::Stopped { stage: context.stage.label.clone() }
        }
        source => context.solver(what, source),
    }
}

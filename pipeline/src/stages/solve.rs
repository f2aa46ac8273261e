//! Solving on the finest mesh, once with each prolongation.

use std::num::NonZeroU8;
use std::ops::Range;
use std::time::Instant;

use octruss_fem::Error as SolverError;
use octruss_mesh::{AffineCorrection, FeatureOptions, Hierarchy, InterfaceRows, Scheme};
use octruss_meshio::{Field, Values};
use octruss_solver::{Entry, Nodal, Precision, Smoother};
use serde::{Deserialize, Serialize};
use toml::Spanned;

use super::body::BodyFigures;
use super::fixed::Fixed;
use super::full::FullTransfer;
use super::method::{Cycle, Method};
use super::multigrid::{Discrete, SolveFigures, solve_with};
use super::on_surface::{OnSurface, Robin, Springs, VectorOnSurface};
use super::transfers::{CoarseOperator, TransferOptions};
use super::unfinished::keep;
use super::{Context, biharmonic, elasticity, poisson, scalar};
use crate::amount::short;
use crate::error::Error;
use crate::recipe::{
    Auto, Material, Named, PerRegion, Positive, Prolongations, Several, Sweeps, Value, VectorValue,
};
use crate::state::State;

/// Solves a problem on the finest mesh by conjugate gradients with a multigrid
/// cycle over all levels, or by cycles alone, in turn with each prolongation. The
/// first solution becomes the field `solution` (of a second such stage `solution-2`),
/// with NaN at vertices of free-standing triangles and edges, which no tet uses. Of
/// elasticity these are `displacement`, and `strain`, `stress` and `von-mises` on
/// tets and recovered at vertices; there one of each material, where there are
/// several, as `stress-REGION`, NaN at vertices without it. Components of tensors
/// come in the order of VTK: xx, yy, zz, xy, yz, xz.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct Solve {
    /// Which equation.
    pub problem: Problem,
    /// What is prescribed on surfaces; on a common edge the last listed counts.
    pub fixed: Vec<Spanned<Fixed>>,
    /// Poisson: k > 0, one value or one a region; 1 where none is given.
    pub coefficient: PerRegion,
    /// Poisson, biharmonic: f per unit of volume, one value or one a region; 0 where none is given.
    pub source: PerRegion,
    /// Poisson: k ∂u/∂n on surfaces, n outward: what flows in per unit of area.
    pub flux: Vec<OnSurface>,
    /// Poisson: k ∂u/∂n = coefficient (value − u) on surfaces.
    pub robin: Vec<Robin>,
    /// Elasticity: one material, or one a region.
    pub material: Option<PerRegion<Material>>,
    /// Elasticity: force per unit of volume, one vector or one a region.
    pub body_force: PerRegion<VectorValue>,
    /// Elasticity: acceleration; times density a force per unit of volume.
    pub gravity: VectorValue,
    /// Elasticity: force per unit of area on surfaces.
    pub traction: Vec<VectorOnSurface>,
    /// Elasticity: force per unit of area against the outward normal: positive
    /// pushes inward.
    pub pressure: Vec<OnSurface>,
    /// Elasticity: force per unit of area and of displacement, against it.
    pub springs: Vec<Springs>,
    /// Which matrices prolong, in turn: those of a scheme or `smoothed-linear`.
    pub prolongation: Several<Prolongations>,
    /// Which rows of them are made exact for linear functions.
    pub affine_correction: Named<AffineCorrection>,
    /// What their rows on interfaces between regions read.
    pub interface_rows: Named<InterfaceRows>,
    /// Where the matrices of coarse levels come from.
    pub coarse_operator: Named<CoarseOperator>,
    /// Stop at this residual, relative to the right-hand side.
    pub tolerance: Positive,
    /// Give up after so many iterations.
    pub max_iterations: usize,
    /// What the cycle is used for; `auto` is conjugate gradients.
    pub method: Auto<Method>,
    /// The shape of the cycle; `auto` is V.
    pub cycle: Auto<Cycle>,
    /// How full multigrid brings solutions to finer levels; `auto` is the scheme
    /// that refined them, if that is smooth, else quadratic.
    pub full_transfer: Auto<FullTransfer>,
    /// What a smoothing sweep is; `auto` is hybrid Gauss–Seidel for elasticity, else
    /// Chebyshev.
    pub smoother: Auto<Smoother>,
    /// The degree of the Chebyshev smoother, which it asks for; 3 if not given.
    pub smoothing_degree: Option<NonZeroU8>,
    /// Smoothing sweeps before and after each coarse correction.
    pub sweeps: Sweeps,
    /// The precision inside the cycle; `auto` is single.
    pub precision: Auto<Precision>,
    /// Measure bytes and bandwidth of each kernel after solving.
    pub account: bool,
}

/// The equations that can be solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Problem {
    /// −div(k grad u) = f.
    Poisson,
    /// Δ²u = f, in mixed form.
    Biharmonic,
    /// −div σ(u) = f, linear and isotropic.
    Elasticity,
}

/// What solving a problem brings.
#[derive(Default)]
pub(super) struct Outcome {
    pub(super) solves: Vec<SolveFigures>,
    pub(super) assembly_seconds: f64,
    pub(super) body: Option<BodyFigures>,
    pub(super) point_fields: Vec<Field>,
    pub(super) cell_fields: Vec<Field>,
}

/// All solves of a stage.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SolveReport {
    /// Which equation.
    pub problem: Problem,
    /// The time to assemble it, once for all solves.
    pub assembly_seconds: f64,
    /// One a prolongation.
    pub solves: Vec<SolveFigures>,
    /// Of an elastic body, what else is of interest.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub body: Option<BodyFigures>,
}

impl Default for Solve {
    fn default() -> Self {
        let options = octruss_solver::SolveOptions::default();
        Self {
            problem: Problem::Poisson,
            fixed: Vec::new(),
            coefficient: PerRegion::Uniform(Value::Number(1.0)),
            source: PerRegion::Uniform(Value::Number(0.0)),
            flux: Vec::new(),
            robin: Vec::new(),
            material: None,
            body_force: PerRegion::Uniform(VectorValue::ZERO),
            gravity: VectorValue::ZERO,
            traction: Vec::new(),
            pressure: Vec::new(),
            springs: Vec::new(),
            prolongation: [Scheme::BoxSpline.into(), Scheme::Linear.into()].into(),
            affine_correction: Named(AffineCorrection::default()),
            interface_rows: Named(InterfaceRows::default()),
            coarse_operator: Named(CoarseOperator::Galerkin),
            tolerance: Positive(options.tolerance),
            max_iterations: options.max_iterations,
            method: Auto(None),
            cycle: Auto(None),
            full_transfer: Auto(None),
            smoother: Auto(None),
            smoothing_degree: None,
            sweeps: Sweeps([1, 1]),
            precision: Auto(None),
            account: false,
        }
    }
}

impl Solve {
    pub(super) fn run(&self, state: &mut State, context: &Context) -> Result<SolveReport, Error> {
        let hierarchy = context.needed(state.levels(&FeatureOptions::default()))?;
        let outcome = match self.problem {
            Problem::Poisson => scalar::solve(self, hierarchy, poisson::discretise, context)?,
            Problem::Biharmonic => scalar::solve(self, hierarchy, biharmonic::discretise, context)?,
            Problem::Elasticity => elasticity::solve(self, hierarchy, context)?,
        };
        let Outcome { solves, assembly_seconds, body, point_fields, cell_fields } = outcome;
        let number = context.stage.label.strip_prefix("solve").unwrap_or_default();
        add_fields(&mut state.point_fields, point_fields, number);
        add_fields(&mut state.cell_fields, cell_fields, number);
        Ok(SolveReport { problem: self.problem, assembly_seconds, solves, body })
    }

    /// What in the options does not go together, if anything, and where.
    pub(super) fn contradiction(&self) -> Option<(Option<Range<usize>>, String)> {
        if self.problem == Problem::Elasticity && self.material.is_none() {
            let message = "problem = \"elasticity\" needs `material`, such as \
                { young = 210e3, poisson = 0.3 }";
            return Some((None, message.into()));
        }
        self.fixed.iter().find_map(|fixed| {
            let message = fixed.get_ref().contradiction(self.problem)?;
            Some((Some(fixed.span()), message))
        })
    }

    /// Whether coarse matrices are assembled on the coarse meshes.
    pub(crate) fn reassembles(&self) -> bool {
        self.coarse_operator.0 == CoarseOperator::Reassembled
    }

    /// How levels hang together with these prolongations.
    pub(crate) fn transfer_options(&self, prolongations: Prolongations) -> TransferOptions {
        let (affine_correction, interface_rows) = (self.affine_correction.0, self.interface_rows.0);
        TransferOptions { prolongations, affine_correction, interface_rows }
    }
}

/// Adds fields under their names and the number of the stage, in place of older
/// ones called so.
fn add_fields(all: &mut Vec<Field>, new: Vec<Field>, number: &str) {
    for mut field in new {
        field.name += number;
        all.retain(|old| old.name != field.name);
        all.push(field);
    }
}

/// Assembles as the first step of a stage; what came of it, and the seconds.
pub(super) fn assembled<E: Entry, T: AsRef<Discrete<E>>>(
    options: &Solve,
    context: &Context,
    assemble: impl FnOnce() -> Result<T, Error>,
) -> Result<(T, f64), Error> {
    let start = Instant::now();
    let steps = options.prolongation.len() + 1;
    let assembled = context.step(1, steps, "assembly", || {
        let assembled = assemble()?;
        let unknowns = format!("{} unknowns", short(assembled.as_ref().unknowns()));
        Ok::<_, Error>((assembled, unknowns))
    })?;
    Ok((assembled, start.elapsed().as_secs_f64()))
}

/// Solves with each prolongation; the first solution, as `expand` makes it of the
/// unknowns, and the figures of all. `expand` also tells the range.
pub(super) fn solve_in_turn<E: Entry<Real = f64>>(
    options: &Solve,
    hierarchy: &Hierarchy,
    discrete: &Discrete<E>,
    expand: impl Fn(&[E::Nodal]) -> Result<(Vec<E::Nodal>, [f64; 2]), SolverError>,
    context: &Context,
) -> Result<(Vec<E::Nodal>, Vec<SolveFigures>), Error> {
    let steps = options.prolongation.len() + 1;
    let (mut first, mut all) = (None, Vec::new());
    for (index, &prolongations) in options.prolongation.iter().enumerate() {
        let what = format!("{prolongations} prolongation");
        let (solution, figures) = context.step(index + 2, steps, &what, || {
            let solved = solve_with(options, prolongations, hierarchy, discrete, context);
            let (x, mut figures) = solved.map_err(|source| {
                let Some(at) = source.unfinished() else { return context.solver(&what, source) };
                match expand(&of_rows(&at.iterate)) {
                    Ok((values, _)) => {
                        let field = options.problem.field_of(Nodal::flat(&values));
                        keep(field, &source, at.report.clone(), hierarchy.finest(), &what, context)
                    }
                    Err(source) => context.solver(&what, source),
                }
            })?;
            let (solution, range) = expand(&x).map_err(|source| context.solver(&what, source))?;
            [figures.minimum, figures.maximum] = range;
            let result = figures.result();
            Ok::<_, Error>(((solution, figures), result))
        })?;
        first.get_or_insert(solution);
        all.push(figures);
    }
    Ok((first.unwrap_or_default(), all))
}

/// A vector from its numbers, row by row.
fn of_rows<V: Nodal<Real = f64>>(numbers: &[f64]) -> Vec<V> {
    numbers.chunks_exact(V::SIZE).map(|row| V::from_fn(|k| row[k])).collect()
}

impl Problem {
    /// The keys of one problem alone.
    const OWN_KEYS: [(Self, &'static [&'static str]); 3] = [
        (Self::Poisson, &["coefficient", "source", "flux", "robin"]),
        (Self::Biharmonic, &["source"]),
        (
            Self::Elasticity,
            &["material", "body-force", "gravity", "traction", "pressure", "springs"],
        ),
    ];

    /// As configs call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Poisson => "poisson",
            Self::Biharmonic => "biharmonic",
            Self::Elasticity => "elasticity",
        }
    }

    /// Its solution at vertices, from the numbers one after the other.
    fn field_of(self, numbers: &[f64]) -> Field {
        match self {
            Self::Poisson | Self::Biharmonic => Field::scalar("solution", numbers.to_vec()),
            Self::Elasticity => Field::new("displacement", 3, Values::Float(numbers.to_vec())),
        }
    }

    /// Why a stage that solves the problem called `given` does not take `key`, if
    /// another would.
    pub(super) fn misplaced(key: &str, given: Option<&str>) -> Option<String> {
        let given = given.unwrap_or(Self::Poisson.name());
        // A name that is none is told when the value is read.
        let (_, mine) = Self::OWN_KEYS.into_iter().find(|(problem, _)| problem.name() == given)?;
        let (owner, _) = Self::OWN_KEYS.into_iter().find(|(_, keys)| keys.contains(&key))?;
        (!mine.contains(&key)).then(|| {
            let owner = owner.name();
            format!(
                "`{key}` belongs to problem = \"{owner}\", but this stage solves \"{given}\" \
                 (keys of its own: {})",
                mine.join(", ")
            )
        })
    }
}

impl SolveReport {
    pub(super) fn summary(&self) -> String {
        let iterations: Vec<String> = self
            .solves
            .iter()
            .map(|solve| format!("{} in {} iterations", solve.prolongation, solve.iterations))
            .collect();
        iterations.join(", ")
    }
}

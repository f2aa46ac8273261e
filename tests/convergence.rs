//! Manufactured solutions: rates of the error, iterations of the solver, and
//! the two prolongations side by side, all asserted.

use std::f64::consts::PI;
use std::path::Path;

use octruss_fem::{
    LevelUnknowns, Poisson, Scalar, System, assemble, h1_seminorm_error, l2_error,
    restrict_to_free, smooth_lift,
};
use octruss_mesh::{
    CheckOptions, FeatureOptions, Hierarchy, Scheme, SubdivisionMatrix, TetMesh, check,
    quadratic_matrix, shapes, subdivision_matrix,
};
use octruss_solver::{
    Csr, Multigrid, MultigridOptions, SolveOptions, conjugate_gradients, kernels, mean_reduction,
    noise,
};

/// A solution with its gradient and the source −Δu that belongs to it.
struct Manufactured {
    solution: fn([f64; 3]) -> f64,
    gradient: fn([f64; 3]) -> [f64; 3],
    source: fn([f64; 3]) -> f64,
}

const SINES: Manufactured = Manufactured {
    solution: |p| p.map(|x| (PI * x).sin()).iter().product(),
    gradient: |p| {
        let [s, c] = [p.map(|x| (PI * x).sin()), p.map(|x| PI * (PI * x).cos())];
        [c[0] * s[1] * s[2], s[0] * c[1] * s[2], s[0] * s[1] * c[2]]
    },
    source: |p| 3.0 * PI * PI * p.map(|x| (PI * x).sin()).iter().product::<f64>(),
};

/// Neither zero on the boundary nor symmetric.
const WAVE: Manufactured = Manufactured {
    solution: |[x, y, z]| x.exp() * (2.0 * y).sin() + z * z,
    gradient: |[x, y, z]| [x.exp() * (2.0 * y).sin(), 2.0 * x.exp() * (2.0 * y).cos(), 2.0 * z],
    source: |[x, y, _]| 3.0 * x.exp() * (2.0 * y).sin() - 2.0,
};

impl Manufactured {
    /// −Δu = f with u prescribed on every tagged surface.
    fn problem(&self, mesh: &TetMesh) -> Poisson {
        let all = mesh.triangles().ids();
        Poisson {
            source: octruss_fem::ByRegion {
                default: Scalar::function(self.source),
                regions: Vec::new(),
            },
            fixed: all.into_iter().map(|id| (id, Scalar::function(self.solution))).collect(),
            ..Poisson::default()
        }
    }
}

/// The discrete problem on every level of a hierarchy.
struct Study {
    hierarchy: Hierarchy,
    systems: Vec<System>,
}

impl Study {
    fn new(coarse: TetMesh, scheme: Scheme, levels: usize, manufactured: &Manufactured) -> Self {
        let mut hierarchy = Hierarchy::new(coarse, &FeatureOptions::default());
        for _ in 0..levels {
            hierarchy.subdivide(scheme).unwrap();
        }
        let problem = manufactured.problem(&hierarchy.coarsest().mesh);
        let levels = hierarchy.levels().iter();
        let systems =
            levels.map(|level| assemble(&level.mesh, &level.topology, &problem).unwrap()).collect();
        Self { hierarchy, systems }
    }

    /// The matrices of a scheme up to a level, coarsest first.
    fn matrices(&self, level: usize, scheme: Scheme) -> Vec<SubdivisionMatrix> {
        let levels = self.hierarchy.levels().iter().take(level);
        levels.map(|level| subdivision_matrix(&level.mesh, &level.topology, scheme)).collect()
    }

    /// Those of quadratic interpolation; the first is linear.
    fn quadratic_matrices(&self, level: usize) -> Vec<SubdivisionMatrix> {
        let pairs = self.hierarchy.levels()[..level].windows(2);
        let quadratic = pairs.map(|p| quadratic_matrix(&p[0].topology, &p[1].topology));
        self.matrices(1, Scheme::Linear).into_iter().chain(quadratic).collect()
    }

    /// What matrices are between free unknowns, coarsest first.
    fn restricted(&self, matrices: &[SubdivisionMatrix]) -> Vec<Csr<f64>> {
        let pairs = matrices.iter().zip(self.systems.windows(2));
        pairs.map(|(m, pair)| restrict_to_free(m, &pair[1].dofs, &pair[0].dofs).unwrap()).collect()
    }

    fn multigrid(&self, level: usize, prolongation: Scheme) -> Multigrid {
        let prolongations = self.restricted(&self.matrices(level, prolongation));
        let options = MultigridOptions::default();
        Multigrid::new(&self.systems[level].matrix, prolongations, &options).unwrap()
    }

    /// Iterations to 1e-8 for the problem itself and for noise as right-hand side.
    fn iterations(&self, level: usize, prolongation: Scheme) -> [usize; 2] {
        let system = &self.systems[level];
        let mut multigrid = self.multigrid(level, prolongation);
        [system.rhs.clone(), noise(system.rhs.len(), 7)].map(|rhs| {
            let options = SolveOptions::default();
            let (_, report) =
                conjugate_gradients(&system.matrix, &rhs, &mut multigrid, &options).unwrap();
            assert!(report.relative_residual <= 1e-8);
            report.iterations
        })
    }

    /// The discrete solution of one level.
    fn solution(&self, level: usize, tolerance: f64) -> Vec<f64> {
        let System { matrix, rhs, .. } = &self.systems[level];
        let mut multigrid = self.multigrid(level, Scheme::Linear);
        let options = SolveOptions { tolerance, ..SolveOptions::default() };
        conjugate_gradients(matrix, rhs, &mut multigrid, &options).unwrap().0
    }

    /// L2 and H1 errors on one level.
    fn errors(&self, level: usize, exact: &Manufactured) -> [f64; 2] {
        let (system, mesh) = (&self.systems[level], &self.hierarchy.levels()[level].mesh);
        let u = system.expand(&self.solution(level, 1e-10)).unwrap();
        [l2_error(mesh, &u, exact.solution), h1_seminorm_error(mesh, &u, exact.gradient)]
    }

    /// A smooth function with the prescribed values.
    fn lift(&self, level: usize, transfers: &[SubdivisionMatrix]) -> Vec<f64> {
        let systems = &self.systems[..=level];
        let levels: Vec<LevelUnknowns<f64>> =
            systems.iter().map(|system| system.dofs.clone().into()).collect();
        smooth_lift(&self.solution(0, 1e-12), transfers, &levels).unwrap()
    }

    /// One pass of full multigrid with box-spline cycles and these transfers, for what
    /// `lift` leaves.
    fn full_multigrid(
        &self,
        level: usize,
        transfers: &[SubdivisionMatrix],
        lift: Vec<f64>,
    ) -> Vec<f64> {
        let System { matrix, rhs, .. } = &self.systems[level];
        let mut rest = rhs.clone();
        kernels::residual(matrix, &lift, rhs, &mut rest);
        let mut multigrid = self.multigrid(level, Scheme::BoxSpline);
        let x = multigrid.full_multigrid(&rest, &self.restricted(transfers), 1).unwrap();
        x.iter().zip(&lift).map(|(x, lift)| x + lift).collect()
    }

    /// The L² error of unknowns over that of the discrete solution.
    fn error_ratio(&self, level: usize, x: &[f64], exact: &Manufactured) -> f64 {
        let [found, best] = [x, &self.solution(level, 1e-10)].map(|x| {
            let u = self.systems[level].expand(x).unwrap();
            l2_error(&self.hierarchy.levels()[level].mesh, &u, exact.solution)
        });
        found / best
    }

    /// Asserts that one pass of full multigrid has at most `bound` times the L² error
    /// of the discrete solution on each level.
    fn assert_full_multigrid(
        &self,
        exact: &Manufactured,
        matrices: impl Fn(usize) -> Vec<SubdivisionMatrix>,
        bound: f64,
    ) {
        let ratio = |level: usize| {
            let transfers = matrices(level);
            let lift = self.lift(level, &transfers);
            self.error_ratio(level, &self.full_multigrid(level, &transfers, lift), exact)
        };
        let ratios: Vec<f64> = (1..self.systems.len()).map(ratio).collect();
        assert!(ratios.iter().all(|ratio| *ratio <= bound), "{ratios:?}");
    }

    /// Asserts the rates over the last two refinements.
    fn assert_rates(&self, exact: &Manufactured) {
        let finest = self.systems.len() - 1;
        let errors: Vec<[f64; 2]> =
            (finest - 2..=finest).map(|level| self.errors(level, exact)).collect();
        for pair in errors.windows(2) {
            let rates = [0, 1].map(|norm: usize| (pair[0][norm] / pair[1][norm]).log2());
            assert!(rates[0] >= 1.9, "L2 rate {} of {errors:?}", rates[0]);
            assert!(rates[1] >= 0.95, "H1 rate {} of {errors:?}", rates[1]);
        }
    }

    /// Asserts bounds on the finest level and growth by at most one a level.
    fn assert_iterations(&self, prolongation: Scheme, bound: usize) {
        let levels = 1..self.systems.len();
        let counts: Vec<[usize; 2]> =
            levels.map(|level| self.iterations(level, prolongation)).collect();
        for rhs in 0..2 {
            let counts: Vec<usize> = counts.iter().map(|count| count[rhs]).collect();
            assert!(*counts.last().unwrap() <= bound, "{}: {counts:?}", prolongation.name());
            assert!(
                counts.windows(2).all(|pair| pair[1] <= pair[0] + 1),
                "{}: {counts:?}",
                prolongation.name()
            );
        }
    }

    fn reduction(&self, prolongation: Scheme) -> f64 {
        let finest = self.systems.len() - 1;
        mean_reduction(&self.systems[finest].matrix, &mut self.multigrid(finest, prolongation), 20)
            .unwrap()
    }
}

/// Levels with 4³, 8³, 16³ and 32³ cells.
fn cube() -> Study {
    Study::new(shapes::kuhn_cube(4), Scheme::Linear, 3, &SINES)
}

/// The smooth ball, four times subdivided: about a million tets.
fn ball(levels: usize) -> Study {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/meshes/ball.msh");
    let dataset = octruss_meshio::read(&path).unwrap();
    let checked = check(dataset.mesh, &CheckOptions::default()).unwrap();
    Study::new(checked.mesh, Scheme::BoxSpline, levels, &WAVE)
}

#[test]
fn the_cube_converges_at_the_optimal_rates() {
    cube().assert_rates(&SINES);
}

#[test]
fn a_curved_body_converges_at_the_optimal_rates() {
    ball(4).assert_rates(&WAVE);
}

#[test]
fn iterations_are_bounded_on_every_level_of_the_cube() {
    let cube = cube();
    cube.assert_iterations(Scheme::Linear, 9);
    cube.assert_iterations(Scheme::BoxSpline, 7);
}

#[test]
fn iterations_are_bounded_on_every_level_of_a_curved_body() {
    let ball = ball(3);
    ball.assert_iterations(Scheme::Linear, 9);
    ball.assert_iterations(Scheme::BoxSpline, 7);
}

#[test]
fn box_spline_prolongation_reduces_more_a_cycle_and_costs_more() {
    let cube = cube();
    let [linear, box_spline] =
        [Scheme::Linear, Scheme::BoxSpline].map(|scheme| cube.reduction(scheme));
    assert!(linear <= 0.25 && box_spline <= 0.10, "{linear} {box_spline}");
    assert!(box_spline <= 0.6 * linear, "{linear} {box_spline}");
    let [linear, box_spline] = [Scheme::Linear, Scheme::BoxSpline]
        .map(|scheme| cube.multigrid(3, scheme).operator_complexity());
    assert!(linear < 1.15 && box_spline > 1.3, "{linear} {box_spline}");
}

#[test]
fn one_pass_of_full_multigrid_reaches_the_discretisation_with_prescribed_values() {
    let cube = Study::new(shapes::kuhn_cube(2), Scheme::Linear, 4, &WAVE);
    for scheme in [Scheme::Linear, Scheme::BoxSpline] {
        cube.assert_full_multigrid(&WAVE, |level| cube.matrices(level, scheme), 1.2);
    }
    cube.assert_full_multigrid(&WAVE, |level| cube.quadratic_matrices(level), 1.2);
    // Without a lift the layer of elements at the boundary spoils it.
    let zero = vec![0.0; cube.systems[4].rhs.len()];
    let pass = cube.full_multigrid(4, &cube.quadratic_matrices(4), zero);
    let ratio = cube.error_ratio(4, &pass, &WAVE);
    assert!(ratio > 3.0, "{ratio}");
}

#[test]
fn one_pass_of_full_multigrid_reaches_the_discretisation_on_a_curved_body() {
    let ball = ball(3);
    ball.assert_full_multigrid(&WAVE, |level| ball.matrices(level, Scheme::BoxSpline), 1.2);
    ball.assert_full_multigrid(&WAVE, |level| ball.quadratic_matrices(level), 1.2);
}

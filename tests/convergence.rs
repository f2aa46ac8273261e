//! Manufactured solutions: rates of the error, iterations of the solver, and
//! the two prolongations side by side, all asserted.

use std::f64::consts::PI;
use std::path::Path;

use octruss_mesh::{
    CheckOptions, FeatureOptions, Hierarchy, Scheme, SubdivisionMatrix, TetMesh, check, shapes,
    subdivision_matrix,
};
use octruss_solver::{
    Multigrid, MultigridOptions, Poisson, Scalar, SolveOptions, System, assemble,
    conjugate_gradients, h1_seminorm_error, l2_error, mean_reduction, noise, restrict_to_free,
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
            source: octruss_solver::ByRegion {
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
        let problem = manufactured.problem(&hierarchy.meshes[0]);
        let levels = hierarchy.meshes.iter().zip(&hierarchy.topologies);
        let systems =
            levels.map(|(mesh, topology)| assemble(mesh, topology, &problem).unwrap()).collect();
        Self { hierarchy, systems }
    }

    fn multigrid(&self, level: usize, prolongation: Scheme) -> Multigrid {
        let matrix = |transfer: usize| -> SubdivisionMatrix {
            subdivision_matrix(
                &self.hierarchy.meshes[transfer],
                &self.hierarchy.topologies[transfer],
                prolongation,
            )
        };
        let prolongations = (0..level)
            .rev()
            .map(|transfer| {
                let [coarse, fine] = [transfer, transfer + 1].map(|l| &self.systems[l].dofs);
                restrict_to_free(&matrix(transfer), fine, coarse).unwrap()
            })
            .collect();
        Multigrid::new(&self.systems[level].matrix, prolongations, &MultigridOptions::default())
            .unwrap()
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

    /// L2 and H1 errors on one level.
    fn errors(&self, level: usize, exact: &Manufactured) -> [f64; 2] {
        let (system, mesh) = (&self.systems[level], &self.hierarchy.meshes[level]);
        let mut multigrid = self.multigrid(level, Scheme::Linear);
        let options = SolveOptions { tolerance: 1e-10, ..SolveOptions::default() };
        let (x, _) =
            conjugate_gradients(&system.matrix, &system.rhs, &mut multigrid, &options).unwrap();
        let u = system.expand(&x).unwrap();
        [l2_error(mesh, &u, exact.solution), h1_seminorm_error(mesh, &u, exact.gradient)]
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

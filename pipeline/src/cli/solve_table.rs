//! The solves of a run, side by side.

use octruss::Report;
use octruss::amount::short;
use octruss::report::{Done, SolveFigures};
use octruss::table::table;

/// One table a solve stage, one column a prolongation.
pub fn of_solves(report: &Report) -> String {
    let mut text = String::new();
    for stage in &report.stages {
        if let Done::Solve(done) = &stage.done {
            text += &format!("{}\n", compare(&stage.name, &done.solves));
        }
    }
    text
}

fn compare(title: &str, solves: &[SolveFigures]) -> String {
    let row = |what: &str, cell: &dyn Fn(&SolveFigures) -> String| {
        std::iter::once(what.to_string()).chain(solves.iter().map(cell)).collect::<Vec<_>>()
    };
    let worst = |defects: &[f64]| defects.iter().copied().fold(0.0, f64::max);
    table(&[
        row(title, &|solve| solve.prolongation.clone()),
        row("unknowns", &|solve| short(solve.unknowns)),
        row("levels", &levels),
        row("cycle", &|solve| solve.method.cycle_and_sweeps()),
        row("smoother", &|solve| solve.method.smoother_and_degree()),
        row("iterations", &|solve| solve.iterations.to_string()),
        row("ended by", &|solve| solve.ended.clone()),
        row("estimated energy error", &|solve| match solve.energy_error {
            Some(error) => format!("{error:.1e}"),
            None => "–".into(),
        }),
        row("mean reduction a cycle", &|solve| format!("{:.4}", solve.mean_reduction)),
        row("nonzeros on all levels", &|solve| short(solve.nonzeros_all_levels)),
        row("operator complexity", &|solve| format!("{:.3}", solve.operator_complexity)),
        row("work per digit (products)", &|solve| format!("{:.1}", solve.work_per_digit)),
        row("greatest affine defect", &|solve| format!("{:.1e}", worst(&solve.affine_defects))),
        row("solution from", &|solve| value(solve.minimum)),
        row("solution to", &|solve| value(solve.maximum)),
        row("setup seconds", &|solve| format!("{:.2}", solve.setup_seconds)),
        row("solve seconds", &|solve| format!("{:.2}", solve.solve_seconds)),
    ])
}

/// How many there are, and how many of them are below the coarsest mesh.
fn levels(solve: &SolveFigures) -> String {
    match solve.algebraic_levels {
        0 => solve.levels.to_string(),
        made => format!("{}, {made} of them algebraic", solve.levels),
    }
}

/// Six decimals, or as many digits where those would be few.
fn value(value: f64) -> String {
    if value == 0.0 || value.abs() >= 0.1 { format!("{value:.6}") } else { format!("{value:.6e}") }
}

//! Where the time of a cycle goes, of the solves that were asked to tell.

use octruss::Report;
use octruss::report::{Done, KernelFigures, TrafficFigures};
use octruss::table::table;

/// A table for each solve whose traffic was measured.
pub fn of_solves(report: &Report) -> String {
    let mut text = String::new();
    for stage in &report.stages {
        let Done::Solve(done) = &stage.done else { continue };
        for solve in &done.solves {
            if let Some(account) = &solve.account {
                text += &describe(&format!("{}, {}", stage.name, solve.prolongation), account);
            }
        }
    }
    text
}

fn describe(title: &str, traffic: &TrafficFigures) -> String {
    let head = [title, "MB", "ms", "GB/s", "of copy"].map(String::from).to_vec();
    let kernels = traffic.kernels.iter().chain([&traffic.cycle]).map(row);
    let rows: Vec<Vec<String>> = std::iter::once(head).chain(kernels).collect();
    let copy = traffic.copy_bytes_per_second / 1e9;
    format!("{}copying memory: {copy:.1} GB/s, read and written\n\n", table(&rows))
}

fn row(figures: &KernelFigures) -> Vec<String> {
    let level = figures.level.map_or_else(String::new, |level| format!("level {level} "));
    vec![
        format!("{level}{}", figures.kernel),
        format!("{:.3}", figures.bytes as f64 / 1e6),
        format!("{:.3}", figures.seconds * 1e3),
        format!("{:.1}", figures.bytes_per_second / 1e9),
        format!("{:.0} %", 100.0 * figures.copy_fraction),
    ]
}

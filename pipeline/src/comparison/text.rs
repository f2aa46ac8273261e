//! A comparison as tables: for people, and as comma-separated values.

use super::carried_solution::CarriedSolution;
use super::row::Row;
use crate::amount::{bytes, short};
use crate::table::table;

/// Tables of all rows and of Chang's test, and the verdict.
pub(super) fn text(all: &[Row], carried: &[CarriedSolution], verdict: &[String]) -> String {
    let mut text = table(&rows(all));
    if !carried.is_empty() {
        let carried = carried.iter().map(|carried| {
            vec![
                format!("{} {}", carried.geometry, carried.level),
                carried.prolongation.clone(),
                format!("{:.3e}", carried.difference),
                format!("{:.3e}", carried.energy_difference),
            ]
        });
        let head = ["solution carried to", "by", "difference", "in energy"].map(String::from);
        let lines: Vec<_> = std::iter::once(head.to_vec()).chain(carried).collect();
        text += &format!("\n{}", table(&lines));
    }
    for sentence in verdict {
        text += &format!("\n{sentence}\n");
    }
    text
}

fn rows(rows: &[Row]) -> Vec<Vec<String>> {
    let head = [
        "mesh, level",
        "prolongation",
        "coarse",
        "rows",
        "cycle",
        "smoother",
        "unknowns",
        "its",
        "mean",
        "asymptotic",
        "complexity",
        "work/digit",
        "bytes/digit",
        "set-up s",
        "solve s",
    ];
    let line =
        |row: &Row| {
            let or_dash = |value: Option<String>| value.unwrap_or_else(|| "–".into());
            vec![
                format!("{} {}", row.geometry, row.level),
                row.prolongation.clone(),
                row.coarse_operator.clone(),
                rows_of(row),
                row.cycle.clone(),
                row.smoother.clone(),
                short(row.unknowns),
                or_dash(row.iterations.map(|its| its.to_string())),
                format!("{:.3}", row.mean_reduction),
                format!("{:.3}", row.asymptotic_reduction),
                format!("{:.2}", row.operator_complexity),
                or_dash(row.work_per_digit.map(|work| format!("{work:.1}"))),
                or_dash(row.bytes_per_digit.map(|digit| bytes(digit as u64))),
                spread(row.setup_seconds, row.setup_spread),
                or_dash(row.solve_seconds.map(|median| {
                    spread(median, row.solve_spread.map(|end| end.unwrap_or(median)))
                })),
            ]
        };
    std::iter::once(head.map(String::from).to_vec()).chain(rows.iter().map(line)).collect()
}

/// What was done to rows: nothing, corrected, linear on interfaces.
fn rows_of(row: &Row) -> String {
    let corrected = row.affine_defect < row.affine_defect_before;
    let inexact = row.affine_defect > octruss_mesh::NEGLIGIBLE_DEFECT;
    let affine = match (inexact, corrected) {
        (true, _) => "inexact",
        (false, true) => "corrected",
        (false, false) => "exact",
    };
    let asked = match row.affine_correction.as_str() {
        "auto" => String::new(),
        asked => format!(" ({asked})"),
    };
    let interfaces = if row.interface_rows == "linear" { ", linear interfaces" } else { "" };
    format!("{affine}{asked}{interfaces}")
}

fn spread(median: f64, [least, greatest]: [f64; 2]) -> String {
    format!("{median:.3} ({least:.3}–{greatest:.3})")
}

/// A line of names, then one a row; what is not known is empty.
pub(super) fn csv(rows: &[Row]) -> String {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    let names = [
        "problem",
        "body",
        "geometry",
        "prolongation",
        "coarse_operator",
        "affine_correction",
        "affine_defect",
        "affine_defect_before",
        "interface_rows",
        "cycle",
        "smoother",
        "level",
        "unknowns",
        "iterations",
        "mean_reduction",
        "asymptotic_reduction",
        "operator_complexity",
        "bytes_per_digit",
        "work_per_digit",
        "setup_seconds",
        "solve_seconds",
        "setup_least",
        "setup_greatest",
        "solve_least",
        "solve_greatest",
    ];
    writer.write_record(names).expect("memory takes everything");
    rows.iter().for_each(|row| writer.serialize(row).expect("memory takes everything"));
    String::from_utf8(writer.into_inner().expect("memory takes everything")).expect("text is UTF-8")
}

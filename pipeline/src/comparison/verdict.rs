//! What the numbers say, in a sentence.

use super::row::Row;

/// Figures within this factor of each other are a tie.
const TIE: f64 = 1.05;

/// For each geometry on its finest level: the best variant that prolongs by a scheme
/// against the best of those that start from linear interpolation, both by the bytes of
/// a digit.
pub(super) fn verdict(rows: &[Row]) -> Vec<String> {
    rows.chunk_by(|a, b| a.geometry == b.geometry).map(of_geometry).collect()
}

fn of_geometry(rows: &[Row]) -> String {
    let finest = rows.iter().map(|row| row.level).max().unwrap_or_default();
    let Row { problem, geometry, body, .. } = &rows[0];
    let place = format!("{problem} on the {geometry} {body}, level {finest}");
    // None if there is no such variant, Some(None) if none of them converged.
    let best = |linear: bool| {
        let on_finest = rows.iter().filter(|row| row.level == finest);
        let family: Vec<&Row> = on_finest.filter(|row| is_linear(row) == linear).collect();
        let solved = family.iter().filter(|row| row.bytes_per_digit.is_some());
        let cheapest = solved.min_by(|a, b| bytes(a).total_cmp(&bytes(b))).copied();
        (!family.is_empty()).then_some(cheapest)
    };
    match (best(false), best(true)) {
        (Some(Some(scheme)), Some(Some(linear))) => sentence(&place, scheme, linear),
        (None, _) => format!("{place}: no variant prolongs by a scheme, so there is no verdict."),
        (_, None) => format!("{place}: no variant is linear, so there is no verdict."),
        (Some(None), Some(None)) => format!("{place}: no variant converged."),
        (Some(None), _) => format!("{place}: no variant that prolongs by a scheme converged."),
        (_, Some(None)) => format!("{place}: no variant that is linear converged."),
    }
}

/// Whether linear interpolation is all that a variant prolongs by, smoothed or not.
fn is_linear(row: &Row) -> bool {
    row.prolongation.split('/').all(|part| matches!(part, "linear" | "smoothed-linear"))
}

fn bytes(row: &Row) -> f64 {
    row.bytes_per_digit.unwrap_or(f64::INFINITY)
}

fn sentence(place: &str, scheme: &Row, linear: &Row) -> String {
    let iterations = |row: &Row| row.iterations.unwrap_or_default();
    let gain = bytes(linear) / bytes(scheme);
    let outcome = match gain {
        gain if gain > TIE => format!("subdivision prolongation wins by a factor of {gain:.2}"),
        gain if gain < 1.0 / TIE => {
            format!("linear interpolation wins by a factor of {:.2}", 1.0 / gain)
        }
        gain => format!("it is a tie (a factor of {:.2})", gain.max(1.0 / gain)),
    };
    let seconds = |row: &Row| row.setup_seconds + row.solve_seconds.unwrap_or_default();
    format!(
        "{place}: the best by a scheme ({}) takes {} iterations, the best by linear interpolation \
         ({}) {}. In bytes a digit {outcome}; in seconds, set-up included, the scheme takes {:.2} \
         of the other's time.",
        scheme.variant(),
        iterations(scheme),
        linear.variant(),
        iterations(linear),
        seconds(scheme) / seconds(linear),
    )
}

//! What the numbers say, in a sentence.

use super::row::Row;

/// Figures within this factor of each other are a tie.
const TIE: f64 = 1.05;

/// For each geometry on its finest level: the best variant that prolongs by a scheme
/// against the best of those that start from linear interpolation, both by the bytes of
/// a digit.
pub(super) fn verdict(rows: &[Row]) -> Vec<String> {
    let mut sentences = Vec::new();
    for same in rows.chunk_by(|a, b| a.geometry == b.geometry) {
        let finest = same.iter().map(|row| row.level).max().unwrap_or_default();
        let solved =
            || same.iter().filter(|row| row.level == finest && row.bytes_per_digit.is_some());
        let is_linear =
            |row: &&Row| row.prolongation.ends_with("linear") && !row.prolongation.contains('/');
        let cheapest = |rows: &mut dyn Iterator<Item = &'_ Row>| -> Option<Row> {
            let least = rows.min_by(|a, b| bytes(a).total_cmp(&bytes(b)));
            least.cloned()
        };
        let linear = cheapest(&mut solved().filter(is_linear));
        let scheme = cheapest(&mut solved().filter(|row| !is_linear(row)));
        let place = format!(
            "{} on the {} {}, level {finest}",
            same[0].problem, same[0].geometry, same[0].body
        );
        sentences.push(match (scheme, linear) {
            (Some(scheme), Some(linear)) => sentence(&place, &scheme, &linear),
            _ => format!(
                "{place}: nothing to compare, since only one kind of prolongation converged."
            ),
        });
    }
    sentences
}

fn bytes(row: &Row) -> f64 {
    row.bytes_per_digit.unwrap_or(f64::INFINITY)
}

fn sentence(place: &str, scheme: &Row, linear: &Row) -> String {
    let iterations = |row: &Row| row.iterations.unwrap_or_default();
    let gain = bytes(linear) / bytes(scheme);
    let seconds = |row: &Row| row.setup_seconds + row.solve_seconds;
    let outcome = match gain {
        gain if gain > TIE => "subdivision prolongation wins",
        gain if gain < 1.0 / TIE => "linear interpolation wins",
        _ => "it is a tie",
    };
    format!(
        "{place}: the best by a scheme ({}) takes {} iterations, the best by linear interpolation \
         ({}) {}; in bytes a digit {outcome} by a factor of {:.2}, and in seconds, set-up \
         included, the scheme takes {:.2} of the other's time.",
        variant(scheme),
        iterations(scheme),
        variant(linear),
        iterations(linear),
        gain.max(1.0 / gain),
        seconds(scheme) / seconds(linear),
    )
}

fn variant(row: &Row) -> String {
    format!("{}, {}, {}", row.prolongation, row.coarse_operator, row.cycle)
}

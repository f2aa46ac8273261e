//! A comparison as a picture: for each geometry the iterations over the levels, and
//! below them the bytes of a digit.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::Row;

const WIDTH: u32 = 560;
const HEIGHT: u32 = 380;

/// What is drawn of a row; none where it is not known.
struct Quantity {
    title: &'static str,
    of: fn(&Row) -> Option<f64>,
}

const QUANTITIES: [Quantity; 2] = [
    Quantity { title: "iterations to the tolerance", of: |row| Some(row.iterations? as f64) },
    Quantity {
        title: "bytes a digit and unknown",
        of: |row| Some(row.bytes_per_digit? / row.unknowns as f64),
    },
];

/// The picture as SVG; empty axes where no row has numbers.
pub(super) fn svg(rows: &[Row]) -> String {
    let mut geometries: Vec<&str> = rows.iter().map(|row| row.geometry).collect();
    geometries.dedup();
    let size = (WIDTH * geometries.len().max(1) as u32, HEIGHT * QUANTITIES.len() as u32);
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
        let panels = area.split_evenly((QUANTITIES.len(), geometries.len().max(1)));
        let wanted = QUANTITIES.iter().flat_map(|q| geometries.iter().map(move |g| (q, *g)));
        for (panel, (quantity, geometry)) in panels.iter().zip(wanted) {
            let rows: Vec<&Row> = rows.iter().filter(|row| row.geometry == geometry).collect();
            draw(panel, quantity, geometry, &rows).expect("memory takes every drawing");
        }
        area.present().expect("memory takes every drawing");
    }
    text
}

type Failure<'a> = DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>;

fn draw<'a>(
    panel: &DrawingArea<SVGBackend<'a>, Shift>,
    quantity: &Quantity,
    geometry: &str,
    rows: &[&Row],
) -> Result<(), Failure<'a>> {
    panel.fill(&WHITE)?;
    let levels = rows.iter().map(|row| row.level);
    let finest = levels.clone().max().unwrap_or(1) as f64;
    let coarsest = levels.min().unwrap_or(0) as f64;
    let most = rows.iter().filter_map(|row| (quantity.of)(row)).fold(1.0, f64::max);
    let title = format!("{}, {geometry}", quantity.title);
    let mut chart = ChartBuilder::on(panel)
        .caption(title, ("sans-serif", 16))
        .margin(12)
        .x_label_area_size(36)
        .y_label_area_size(64)
        .build_cartesian_2d(coarsest - 0.2..finest + 0.2, 0.0..1.1 * most)?;
    let whole = |level: &f64| if level.fract() == 0.0 { format!("{level}") } else { String::new() };
    chart.configure_mesh().x_desc("level").x_labels(20).x_label_formatter(&whole).draw()?;
    for (number, (name, line)) in lines(rows).into_iter().enumerate() {
        let colour = Palette99::pick(number).stroke_width(2);
        let points: Vec<(f64, f64)> =
            line.iter().filter_map(|row| Some((row.level as f64, (quantity.of)(row)?))).collect();
        chart
            .draw_series(LineSeries::new(points.iter().copied(), colour))?
            .label(name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], colour));
        chart.draw_series(points.iter().map(|&point| Circle::new(point, 3, colour.filled())))?;
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerRight)
        .background_style(WHITE.mix(0.8))
        .border_style(BLACK.mix(0.3))
        .draw()
}

/// The rows of each variant over the levels, with its name.
fn lines<'r>(rows: &[&'r Row]) -> Vec<(String, Vec<&'r Row>)> {
    let mut lines: Vec<(String, Vec<&Row>)> = Vec::new();
    for row in rows {
        let name = [
            row.prolongation.as_str(),
            row.coarse_operator,
            &row.cycle,
            &row.smoother,
            if row.affine_correction == "off" { "uncorrected" } else { "" },
            if row.interface_rows == "linear" { "linear interfaces" } else { "" },
        ];
        let name = name.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ");
        match lines.iter_mut().find(|(other, _)| *other == name) {
            Some((_, line)) => line.push(row),
            None => lines.push((name, vec![row])),
        }
    }
    lines
}

//! A comparison as a picture: for each geometry the iterations over the levels, and
//! below them the bytes of a digit; on the right the variants with their colours.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::row::Row;

const WIDTH: u32 = 440;
const HEIGHT: u32 = 340;
const LEGEND_WIDTH: u32 = 400;
const LEGEND_LINE: u32 = 20;

/// What is drawn of a row; none where it is not known.
struct Quantity {
    title: &'static str,
    of: fn(&Row) -> Option<f64>,
}

const QUANTITIES: [Quantity; 2] = [
    Quantity { title: "iterations", of: |row| Some(row.iterations? as f64) },
    Quantity {
        title: "bytes a digit and unknown",
        of: |row| Some(row.bytes_per_digit? / row.unknowns as f64),
    },
];

type Panel<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Failure<'a> = DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>;

/// The picture as SVG.
pub(super) fn svg(rows: &[Row]) -> String {
    let mut text = String::new();
    draw(&mut text, rows).expect("memory takes every drawing");
    text
}

fn draw<'a>(text: &'a mut String, rows: &[Row]) -> Result<(), Failure<'a>> {
    let mut geometries: Vec<&str> = rows.iter().map(|row| row.geometry.as_str()).collect();
    geometries.dedup();
    let mut variants: Vec<String> = Vec::new();
    for variant in rows.iter().map(Row::variant) {
        if !variants.contains(&variant) {
            variants.push(variant);
        }
    }
    let panels_width = WIDTH * geometries.len() as u32;
    let legend_height = LEGEND_LINE * (variants.len() as u32 + 2);
    let height = legend_height.max(HEIGHT * QUANTITIES.len() as u32);
    let area = SVGBackend::with_string(text, (panels_width + LEGEND_WIDTH, height));
    let area = area.into_drawing_area();
    area.fill(&WHITE)?;
    let (left, right) = area.split_horizontally(panels_width);
    let panels = left.split_evenly((QUANTITIES.len(), geometries.len()));
    let wanted = QUANTITIES.iter().flat_map(|q| geometries.iter().map(move |g| (q, *g)));
    for (panel, (quantity, geometry)) in panels.iter().zip(wanted) {
        let rows: Vec<&Row> = rows.iter().filter(|row| row.geometry == geometry).collect();
        let title = format!("{}, {geometry}", quantity.title);
        draw_panel(panel, &title, quantity, (&rows, &variants))?;
    }
    draw_legend(&right, &variants)?;
    area.present()
}

fn draw_panel<'a>(
    panel: &Panel<'a>,
    title: &str,
    quantity: &Quantity,
    (rows, variants): (&[&Row], &[String]),
) -> Result<(), Failure<'a>> {
    let levels = rows.iter().map(|row| row.level);
    let finest = levels.clone().max().unwrap_or(1) as f64;
    let coarsest = levels.min().unwrap_or(0) as f64;
    let most = rows.iter().filter_map(|row| (quantity.of)(row)).fold(1.0, f64::max);
    let mut chart = ChartBuilder::on(panel)
        .caption(title, ("sans-serif", 16))
        .margin(12)
        .x_label_area_size(36)
        .y_label_area_size(64)
        .build_cartesian_2d(coarsest - 0.2..finest + 0.2, 0.0..1.1 * most)?;
    let whole = |level: &f64| if level.fract() == 0.0 { format!("{level}") } else { String::new() };
    chart.configure_mesh().x_desc("level").x_labels(20).x_label_formatter(&whole).draw()?;
    for (number, variant) in variants.iter().enumerate() {
        let same = rows.iter().filter(|row| row.variant() == *variant);
        let points = same.filter_map(|row| Some((row.level as f64, (quantity.of)(row)?)));
        let points: Vec<(f64, f64)> = points.collect();
        chart.draw_series(LineSeries::new(points.iter().copied(), colour(number)))?;
        let dots = points.iter().map(|&point| Circle::new(point, 3, colour(number).filled()));
        chart.draw_series(dots)?;
    }
    Ok(())
}

fn draw_legend<'a>(area: &Panel<'a>, variants: &[String]) -> Result<(), Failure<'a>> {
    for (number, variant) in variants.iter().enumerate() {
        let y = LEGEND_LINE as i32 * (number as i32 + 1);
        area.draw(&PathElement::new([(8, y), (32, y)], colour(number)))?;
        area.draw(&Circle::new((20, y), 3, colour(number).filled()))?;
        area.draw(&Text::new(variant.clone(), (40, y - 7), ("sans-serif", 14)))?;
    }
    Ok(())
}

fn colour(number: usize) -> ShapeStyle {
    Palette99::pick(number).stroke_width(2)
}

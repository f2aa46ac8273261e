//! The card that `octruss info` prints.

use std::fmt::Write;
use std::path::Path;

use octruss::describe::{Description, Quality};
use octruss::table::table;

/// A mesh on one screen.
pub fn card(path: &Path, mesh: &Description) -> String {
    let mut text = format!("{}\n\n", path.display());
    let counts = [
        ("vertices", mesh.vertices.to_string()),
        ("tets", mesh.tets.to_string()),
        ("edges", mesh.edges.to_string()),
        ("boundary faces", mesh.boundary_faces.to_string()),
        ("components", mesh.components.to_string()),
        ("volume", format!("{:.6}", mesh.volume)),
    ];
    for (what, count) in counts {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {what:<16}{count:>14}");
    }
    text += &groups(mesh);
    text += &fields(mesh);
    if let Some(quality) = &mesh.quality {
        text += &shapes(quality);
    }
    text += &remarks("findings", mesh.findings.iter().map(|finding| finding.message.as_str()));
    text += &remarks("notes", mesh.notes.iter().map(String::as_str));
    text
}

fn groups(mesh: &Description) -> String {
    let row = |kind: &str, name: &str, id: i32, count: usize, measure: f64| {
        vec![format!("  {kind} {name}"), id.to_string(), count.to_string(), format!("{measure:.6}")]
    };
    let mut rows = vec![["  group", "id", "count", "measure"].map(String::from).to_vec()];
    rows.extend(mesh.regions.iter().map(|g| row("region", &g.name, g.id, g.count, g.volume)));
    rows.extend(mesh.surfaces.iter().map(|g| row("surface", &g.name, g.id, g.count, g.area)));
    if rows.len() == 1 { String::new() } else { format!("\n{}", table(&rows)) }
}

fn fields(mesh: &Description) -> String {
    let points = mesh.point_fields.iter().map(|field| ("vertex", field));
    let cells = mesh.cell_fields.iter().map(|field| ("tet", field));
    let corners = mesh.corner_fields.iter().map(|field| ("corner of a tet", field));
    let line = |(on, field): (&str, &octruss::describe::FieldReport)| {
        format!("  {} ({} a {on})\n", field.name, field.components)
    };
    let lines: String = points.chain(cells).chain(corners).map(line).collect();
    if lines.is_empty() { lines } else { format!("\n  fields\n{lines}") }
}

fn shapes(quality: &Quality) -> String {
    let mut text = format!(
        "\n  mean ratio η    min {:.4}, mean {:.4}\n  radius ratio    min {:.4}, mean {:.4}\n  \
         dihedral angle  {:.1}° to {:.1}°, mean {:.1}°\n",
        quality.eta_min,
        quality.eta_mean,
        quality.radius_ratio_min,
        quality.radius_ratio_mean,
        quality.dihedral_min_deg,
        quality.dihedral_max_deg,
        quality.dihedral_mean_deg,
    );
    text += &histogram(&quality.eta_histogram, |bin| {
        format!("η {:.1}–{:.1}", bin as f64 / 10.0, (bin + 1) as f64 / 10.0)
    });
    text += &histogram(&quality.dihedral_histogram, |bin| {
        format!("{:>3}°–{:>3}°", 10 * bin, 10 * (bin + 1))
    });
    text
}

fn histogram(counts: &[usize], label: impl Fn(usize) -> String) -> String {
    let most = counts.iter().copied().max().unwrap_or(0).max(1);
    let mut text = String::from("\n");
    for (bin, &count) in counts.iter().enumerate() {
        // At least one block where there is anything at all.
        let bar = "█".repeat((40 * count).div_ceil(most));
        let _ = writeln!(text, "  {:<9} {count:>9} {bar}", label(bin));
    }
    text
}

fn remarks<'a>(title: &str, lines: impl Iterator<Item = &'a str>) -> String {
    let lines: String = lines.map(|line| format!("  - {line}\n")).collect();
    if lines.is_empty() { lines } else { format!("\n  {title}\n{lines}") }
}

//! Datasets to Medit files.

use std::io::{self, Write};
use std::path::Path;

use octruss_mesh::RawMesh;

use crate::aside::write_aside;
use crate::cell_kind::Simplex;
use crate::dataset::Dataset;
use crate::error::Error;

/// Writes a Medit file, ASCII, version 2, which [`crate::read`] turns into the
/// same points, tets, regions, and tagged triangles and edges again, bit for bit.
///
/// Regions and tags are the references. What the format has no room for is told
/// by [`crate::Format::losses`]. The file appears whole or not at all.
///
/// # Errors
/// [`Error::Io`] if the folder or file cannot be written; [`Error::Unsupported`]
/// if lengths in the dataset contradict each other, or a simplex has a vertex
/// beyond the points.
pub fn write(path: &Path, dataset: &Dataset) -> Result<(), Error> {
    let checked = dataset.check_lengths().and_then(|()| check_vertices(&dataset.mesh));
    checked.map_err(|message| Error::unsupported(path, message))?;
    write_aside(path, |file| write_mesh(file, &dataset.mesh))
}

/// Other programs would read beyond their lists of vertices.
fn check_vertices(mesh: &RawMesh) -> Result<(), String> {
    let points = mesh.points.len();
    for (what, vertices) in [
        ("tet", mesh.tets.as_flattened()),
        ("tagged triangle", mesh.triangles.simplices.as_flattened()),
        ("tagged edge", mesh.edges.simplices.as_flattened()),
    ] {
        if let Some(vertex) = vertices.iter().find(|&&vertex| vertex as usize >= points) {
            return Err(format!("a {what} has the vertex {vertex}, but there are {points}"));
        }
    }
    Ok(())
}

fn write_mesh(file: &mut impl Write, mesh: &RawMesh) -> io::Result<()> {
    writeln!(file, "MeshVersionFormatted 2\nDimension 3\nVertices\n{}", mesh.points.len())?;
    for [x, y, z] in &mesh.points {
        // The shortest digits that give the same double again.
        writeln!(file, "{x:?} {y:?} {z:?} 0")?;
    }
    write_cells(file, Simplex::Tet, &mesh.tets, &mesh.regions)?;
    write_cells(file, Simplex::Triangle, &mesh.triangles.simplices, &mesh.triangles.tags)?;
    write_cells(file, Simplex::Edge, &mesh.edges.simplices, &mesh.edges.tags)?;
    writeln!(file, "End")
}

/// One section, if there is anything to list; vertices are counted from 1.
fn write_cells<const N: usize>(
    file: &mut impl Write,
    simplex: Simplex,
    cells: &[[u32; N]],
    references: &[i32],
) -> io::Result<()> {
    let Some(keyword) = simplex.medit_keyword().filter(|_| !cells.is_empty()) else {
        return Ok(());
    };
    writeln!(file, "{keyword}\n{}", cells.len())?;
    for (cell, reference) in cells.iter().zip(references) {
        for &vertex in cell {
            write!(file, "{} ", u64::from(vertex) + 1)?;
        }
        writeln!(file, "{reference}")?;
    }
    Ok(())
}

//! Datasets to VTU files.

use std::path::Path;

use super::document::{Array, Document, VtuOptions};
use super::number::NumberType::{Float64, Int32, Int64, UInt8};
use crate::cell_kind::Simplex;
use crate::dataset::{Dataset, refuse_name};
use crate::error::Error;
use crate::field_data;
use crate::grid::REGION;

/// Writes a VTU file, arrays raw and uncompressed: see [`write_with`].
///
/// # Errors
/// As of [`write_with`].
pub fn write(path: &Path, dataset: &Dataset) -> Result<(), Error> {
    write_with(path, dataset, &VtuOptions::default())
}

/// Writes a VTU file that [`crate::read`] turns into the same dataset again.
///
/// Its cells are the tets, with the cell array `region` (Int32) and one array a
/// field (Float64 or Int64). Group names, tagged triangles, edges and vertices,
/// features, and which fields are derived are in `FieldData`, in arrays whose
/// names start with `octruss:`.
/// Notes are not written. The file appears whole or not at all.
///
/// # Errors
/// [`Error::Io`] if the folder or file cannot be written;
/// [`Error::Unsupported`] if lengths in the dataset contradict each other, two
/// fields have one name, a cell field is called `region`, or a name holds a
/// control character.
pub fn write_with(path: &Path, dataset: &Dataset, options: &VtuOptions) -> Result<(), Error> {
    document(dataset).map_err(|message| Error::unsupported(path, message))?.write(path, options)
}

fn document(dataset: &Dataset) -> Result<Document<'_>, String> {
    dataset.check_lengths()?;
    refuse_name(&dataset.cell_fields, REGION)?;
    let mesh = &dataset.mesh;
    let regions = Array::numbers(REGION, Int32, 1, mesh.regions.as_slice());
    let mut side = field_data::mesh_arrays(mesh)?;
    side.extend(field_data::derived_arrays(dataset));
    Ok(Document {
        points: mesh.points.len(),
        cells: mesh.tets.len(),
        field_data: side.into_iter().map(Array::side).collect(),
        point_data: dataset.point_fields.iter().map(Array::field).collect(),
        cell_data: [regions]
            .into_iter()
            .chain(dataset.cell_fields.iter().map(Array::field))
            .collect(),
        positions: vec![positions(&mesh.points)],
        topology: cells(&mesh.tets, Simplex::Tet),
    })
}

pub(super) fn positions(points: &[[f64; 3]]) -> Array<'_> {
    Array::numbers("Points", Float64, 3, points.as_flattened())
}

/// The arrays of cells that are all of one simplex. Numbers of 32 bits if
/// they suffice: half the bytes, and VTK keeps them so.
pub(super) fn cells<const N: usize>(cells: &[[u32; N]], simplex: Simplex) -> Vec<Array<'_>> {
    let vertices = cells.as_flattened();
    let largest = vertices.iter().copied().max().unwrap_or(0);
    let narrow = largest <= i32::MAX as u32 && vertices.len() <= i32::MAX as usize;
    let (connectivity, offsets) = if narrow {
        // No sign bit is set, so unsigned bits are signed ones.
        let offsets: Vec<i32> = (1..=cells.len()).map(|cell| (cell * N) as i32).collect();
        (
            Array::numbers("connectivity", Int32, 1, vertices),
            Array::numbers("offsets", Int32, 1, offsets),
        )
    } else {
        let wide: Vec<i64> = vertices.iter().copied().map(i64::from).collect();
        let offsets: Vec<i64> = (1..=cells.len()).map(|cell| (cell * N) as i64).collect();
        (
            Array::numbers("connectivity", Int64, 1, wide),
            Array::numbers("offsets", Int64, 1, offsets),
        )
    };
    let types = vec![simplex.vtk_number(); cells.len()];
    vec![connectivity, offsets, Array::numbers("types", UInt8, 1, types)]
}

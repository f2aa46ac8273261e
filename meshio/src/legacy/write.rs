//! Datasets to legacy VTK files.

use std::io;
use std::path::Path;

use vtkio::model::{
    Attribute, Attributes, ByteOrder, CellType, Cells, DataSet, FieldArray, IOBuffer,
    UnstructuredGridPiece, Version, VertexNumbers, Vtk,
};

use super::names;
use crate::aside::write_aside;
use crate::dataset::{Dataset, Field, Values, refuse_name};
use crate::error::Error;
use crate::grid::REGION;
use octruss_mesh::RawMesh;

/// Writes a legacy VTK file, binary, version 4.2.
///
/// Tets come first, then tagged triangles, edges and vertices as cells; the
/// cell array `region` holds all their tags. Cell fields, which tets alone
/// have, are NaN or 0 on the other cells. Group names and features have no
/// room in the format (see [`crate::Format::losses`]).
///
/// # Errors
/// [`Error::Io`] if the folder or file cannot be written; [`Error::Unsupported`]
/// if lengths in the dataset contradict each other, a cell field is called
/// `region`, a field has no name, or numbers do not fit the format's 32 bits.
pub fn write(path: &Path, dataset: &Dataset) -> Result<(), Error> {
    let vtk = model(dataset).map_err(|message| Error::unsupported(path, message))?;
    write_aside(path, |file| vtk.write_legacy(file).map_err(|e| io::Error::other(e.to_string())))
}

fn model(dataset: &Dataset) -> Result<Vtk, String> {
    dataset.check_lengths()?;
    refuse_name(&dataset.cell_fields, REGION)?;
    let mesh = &dataset.mesh;
    let (cells, tags) = cells(mesh)?;
    let region = FieldArray::new(REGION, 1).with_data(tags);
    let others = cells.types.len() - mesh.tets.len();
    let cell_fields = dataset.cell_fields.iter().map(|field| array(field, others));
    let cell_fields = [Ok(region)].into_iter().chain(cell_fields).collect::<Result<_, _>>()?;
    let point_fields: Vec<_> =
        dataset.point_fields.iter().map(|field| array(field, 0)).collect::<Result<_, _>>()?;
    Ok(Vtk {
        version: Version::new_legacy(4, 2),
        title: "Octruss".into(),
        // VTK reads binary legacy files in this order only.
        byte_order: ByteOrder::BigEndian,
        file_path: None,
        data: DataSet::inline(UnstructuredGridPiece {
            points: IOBuffer::F64(mesh.points.as_flattened().to_vec()),
            cells,
            data: Attributes { point: attributes(point_fields), cell: attributes(cell_fields) },
        }),
    })
}

/// All simplices as cells, with their tags.
fn cells(mesh: &RawMesh) -> Result<(Cells, Vec<i32>), String> {
    let mut listed = Listed::default();
    listed.add(CellType::Tetra, &mesh.tets, &mesh.regions);
    listed.add(CellType::Triangle, &mesh.triangles.simplices, &mesh.triangles.tags);
    listed.add(CellType::Line, &mesh.edges.simplices, &mesh.edges.tags);
    listed.add(CellType::Vertex, &mesh.vertices.simplices, &mesh.vertices.tags);
    let fits = |&number: &u32| number <= i32::MAX as u32;
    if listed.vertices.len() > i32::MAX as usize || !listed.vertices.iter().all(fits) {
        return Err("vertex numbers or counts exceed the 32 bits of the format; write .vtu".into());
    }
    let num_cells = listed.types.len() as u32;
    let cell_verts = VertexNumbers::Legacy { num_cells, vertices: listed.vertices };
    Ok((Cells { cell_verts, types: listed.types }, listed.tags))
}

#[derive(Default)]
struct Listed {
    /// How many vertices a cell has, and which, cell after cell.
    vertices: Vec<u32>,
    types: Vec<CellType>,
    tags: Vec<i32>,
}

impl Listed {
    fn add<const N: usize>(&mut self, kind: CellType, simplices: &[[u32; N]], tags: &[i32]) {
        for simplex in simplices {
            self.vertices.push(N as u32);
            self.vertices.extend_from_slice(simplex);
        }
        self.types.resize(self.types.len() + simplices.len(), kind);
        self.tags.extend_from_slice(tags);
    }
}

/// The array of a field, with `more` tuples behind it that mean "no value".
fn array(field: &Field, more: usize) -> Result<FieldArray, String> {
    if field.name.is_empty() {
        return Err("a field without a name cannot be written to this format; name it".into());
    }
    let components = u32::try_from(field.components).map_err(|_| {
        format!("the field `{}` has too many components for this format", field.name)
    })?;
    let length = field.values.len() + more * field.components;
    let buffer = match &field.values {
        Values::Float(values) => {
            let mut values = values.clone();
            values.resize(length, f64::NAN);
            IOBuffer::F64(values)
        }
        Values::Integer(values) => {
            let mut values = values.clone();
            values.resize(length, 0);
            IOBuffer::I64(values)
        }
    };
    Ok(FieldArray::new(names::encode(&field.name), components).with_buf(buffer))
}

fn attributes(arrays: Vec<FieldArray>) -> Vec<Attribute> {
    if arrays.is_empty() {
        return Vec::new();
    }
    vec![Attribute::Field { name: "FieldData".into(), data_array: arrays }]
}

//! Legacy VTK files to datasets.

use std::cell::Cell;
use std::panic::catch_unwind;

use vtkio::model::{
    Attribute, Cells, DataSet, ElementType, IOBuffer, Piece, UnstructuredGridPiece, VertexNumbers,
    Vtk,
};

use super::{dialect, names};
use crate::dataset::{Dataset, Field, Values};
use crate::error::Place;
use crate::grid::Grid;
use crate::notes;
use crate::problem::Problem;

/// The dataset in the bytes of a legacy VTK file.
pub(super) fn parse(bytes: &[u8]) -> Result<Dataset, Problem> {
    let bytes = &*dialect::respelled(bytes);
    let mut grid = Grid::default();
    let piece = unstructured(parse_all(bytes)?)?;
    grid.points = points(piece.points)?;
    set_cells(piece.cells, &mut grid)?;
    let (points, cells) = (grid.points.len(), grid.types.len());
    grid.point_fields = fields(piece.data.point, points, "points", &mut grid.notes)?;
    grid.cell_fields = fields(piece.data.cell, cells, "cells", &mut grid.notes)?;
    grid.into_dataset()
}

/// vtkio's model of the file, if it is one of the whole file: the parser stops
/// at what it does not know, and what follows would be lost in silence.
fn parse_all(bytes: &[u8]) -> Result<Vtk, Problem> {
    // The parser is not ours; should it panic on some bytes, that is an error of theirs.
    let result = catch_unwind(|| {
        vtkio::parser::parse_be(bytes).map_err(|error| {
            let left = Cell::new(0);
            let _ = error.map(|error| left.set(error.input.len()));
            left.get()
        })
    });
    let left = match result {
        Ok(Ok(([], vtk))) => return Ok(vtk),
        Ok(Ok((rest, _))) => rest.len(),
        Ok(Err(left)) => left,
        Err(_) => bytes.len(),
    };
    let stop = bytes.len() - left;
    let shown: String = String::from_utf8_lossy(&bytes[stop..])
        .trim()
        .chars()
        .take_while(|c| !c.is_control())
        .take(40)
        .collect();
    let message = if shown.is_empty() && stop + 1 >= bytes.len() {
        "the file ends too early".to_string()
    } else {
        format!(
            "the file cannot be understood from here on (`{shown}`): it is damaged, cut off or of \
             an unusual dialect; if VTK or ParaView opens it, save it as .vtu there"
        )
    };
    Err(Problem::Malformed(Place::Byte(stop), message))
}

fn unstructured(vtk: Vtk) -> Result<UnstructuredGridPiece, Problem> {
    let kind = match vtk.data {
        DataSet::UnstructuredGrid { mut pieces, .. } if pieces.len() == 1 => {
            match pieces.swap_remove(0) {
                Piece::Inline(piece) => return Ok(*piece),
                _ => "no grid of its own",
            }
        }
        DataSet::UnstructuredGrid { .. } => "no single grid",
        DataSet::PolyData { .. } => "POLYDATA",
        DataSet::StructuredGrid { .. } => "STRUCTURED_GRID",
        DataSet::ImageData { .. } => "STRUCTURED_POINTS",
        DataSet::RectilinearGrid { .. } => "RECTILINEAR_GRID",
        DataSet::Field { .. } => "fields without a mesh",
    };
    Err(Problem::unsupported(format!("the file holds {kind}; only UNSTRUCTURED_GRID is read")))
}

fn points(buffer: IOBuffer) -> Result<Vec<[f64; 3]>, Problem> {
    let flat = match values(buffer) {
        Some(Values::Float(values)) => values,
        _ => return Err(Problem::part("POINTS", "expected floating-point coordinates")),
    };
    Ok(flat.as_chunks().0.to_vec())
}

fn set_cells(cells: Cells, grid: &mut Grid) -> Result<(), Problem> {
    grid.types = cells.types.iter().map(|&number| number as u8).collect();
    match cells.cell_verts {
        VertexNumbers::Legacy { num_cells, vertices } => {
            let mut rest = vertices.as_slice();
            while let Some((&count, behind)) = rest.split_first() {
                let Some((cell, behind)) = behind.split_at_checked(count as usize) else {
                    return Err(Problem::part("CELLS", "the last cell is cut off"));
                };
                grid.connectivity.extend_from_slice(cell);
                grid.ends.push(grid.connectivity.len() as u64);
                rest = behind;
            }
            if grid.ends.len() != num_cells as usize {
                let message = format!("{num_cells} cells announced, {} listed", grid.ends.len());
                return Err(Problem::part("CELLS", message));
            }
        }
        VertexNumbers::XML { connectivity, offsets } => {
            // From version 5 on, the list starts with the 0 of the first cell.
            grid.ends = offsets.strip_prefix(&[0]).unwrap_or(&offsets).to_vec();
            let narrow: Result<Vec<u32>, _> = connectivity.into_iter().map(u32::try_from).collect();
            grid.connectivity = narrow.map_err(|_| {
                Problem::part("CELLS", "a vertex number is not from 0 to 4294967295")
            })?;
        }
    }
    if grid.connectivity.iter().any(|&vertex| vertex > i32::MAX as u32) {
        return Err(Problem::part("CELLS", "a vertex number is negative"));
    }
    Ok(())
}

fn fields(
    attributes: Vec<Attribute>,
    tuples: usize,
    of: &str,
    notes: &mut Vec<String>,
) -> Result<Vec<Field>, Problem> {
    let mut fields = Vec::new();
    let mut add = |name: &str, components: usize, buffer: IOBuffer| {
        let name = names::decode(name);
        if matches!(buffer, IOBuffer::Bit(_)) {
            notes.push(notes::bits(&name));
            return Ok(());
        }
        let part = || format!("array `{name}`");
        let values = values(buffer)
            .ok_or_else(|| Problem::part(part(), "a value does not fit 64 bits with sign"))?;
        if components == 0 || components.checked_mul(tuples) != Some(values.len()) {
            let found = format!("holds {} numbers", values.len());
            let message = format!("{found}; expected {components} for each of {tuples} {of}");
            return Err(Problem::part(part(), message));
        }
        fields.push(Field::new(name, components, values));
        Ok(())
    };
    let mut tables = Vec::new();
    for attribute in attributes {
        match attribute {
            Attribute::DataArray(array) if array.elem == ElementType::LookupTable => {
                tables.push(array.name);
            }
            Attribute::DataArray(array) => {
                add(&array.name, array.elem.num_comp() as usize, array.data)?;
            }
            Attribute::Field { data_array, .. } => {
                for array in data_array {
                    add(&array.name, array.elem as usize, array.data)?;
                }
            }
        }
    }
    notes.extend(tables.iter().map(|name| notes::lookup_table(name)));
    Ok(fields)
}

/// The numbers of a buffer, widened; `None` if one does not fit.
fn values(buffer: IOBuffer) -> Option<Values> {
    fn whole<T: Into<i64>>(values: Vec<T>) -> Values {
        Values::Integer(values.into_iter().map(Into::into).collect())
    }
    Some(match buffer {
        IOBuffer::F64(values) => Values::Float(values),
        IOBuffer::F32(values) => Values::Float(values.into_iter().map(f64::from).collect()),
        IOBuffer::Bit(values) | IOBuffer::U8(values) => whole(values),
        IOBuffer::I8(values) => whole(values),
        IOBuffer::U16(values) => whole(values),
        IOBuffer::I16(values) => whole(values),
        IOBuffer::U32(values) => whole(values),
        IOBuffer::I32(values) => whole(values),
        IOBuffer::I64(values) => Values::Integer(values),
        IOBuffer::U64(values) => {
            Values::Integer(values.into_iter().map(i64::try_from).collect::<Result<_, _>>().ok()?)
        }
    })
}

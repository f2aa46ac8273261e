//! VTU files to datasets.

use bytemuck::cast_slice_mut;

use super::array_tag::{ArrayKind, ArrayTag};
use super::decode::{self, Decoder};
use super::header::{self, Header, Piece};
use crate::dataset::{Dataset, Field, Values};
use crate::field_data::{self, PREFIX, SideArrays};
use crate::grid::Grid;
use crate::notes;
use crate::problem::Problem;

/// The dataset in the bytes of a VTU file.
pub(super) fn parse(bytes: &[u8]) -> Result<Dataset, Problem> {
    let header = header::parse(bytes)?;
    let decoder = Decoder::new(&header);
    let mut grid = Grid::default();
    for (index, piece) in header.pieces.iter().enumerate() {
        let vertices_before = grid.connectivity.len();
        append_piece(&decoder, piece, index, &mut grid)?;
        if header.pieces.len() > 1 {
            check_own_points(&grid.connectivity[vertices_before..], grid.points.len(), index)?;
        }
    }
    note_unread(&header, &mut grid.notes);
    let mut dataset = grid.into_dataset()?;
    field_data::restore(&FieldData { header: &header, decoder: &decoder }, &mut dataset)?;
    Ok(dataset)
}

fn append_piece<'a>(
    decoder: &Decoder<'a>,
    piece: &'a Piece<'a>,
    index: usize,
    grid: &mut Grid,
) -> Result<(), Problem> {
    let offset = grid.points.len();
    append_points(decoder, piece, grid)?;
    append_cells(decoder, piece, offset, grid)?;
    append_fields(
        decoder,
        &piece.point_data,
        piece.points,
        "points",
        index,
        &mut grid.point_fields,
    )?;
    append_fields(decoder, &piece.cell_data, piece.cells, "cells", index, &mut grid.cell_fields)
}

fn append_points<'a>(
    decoder: &Decoder<'a>,
    piece: &'a Piece<'a>,
    grid: &mut Grid,
) -> Result<(), Problem> {
    let Some(array) = piece.positions.first() else {
        return absent(piece.points, "Points", "the coordinates are missing");
    };
    let numbers = decoder.numbers(array)?;
    let length = numbers.expect(3, piece.points, "points (NumberOfPoints)")?;
    let start = grid.points.len();
    grid.points.resize(start + length / 3, [0.0; 3]);
    numbers.floats(cast_slice_mut(&mut grid.points[start..]))
}

fn append_cells<'a>(
    decoder: &Decoder<'a>,
    piece: &'a Piece<'a>,
    first_point: usize,
    grid: &mut Grid,
) -> Result<(), Problem> {
    let find = |name: &str| piece.topology.iter().find(|array| array.name == name);
    let [Some(types), Some(ends), Some(connectivity)] =
        ["types", "offsets", "connectivity"].map(find)
    else {
        return absent(
            piece.cells,
            "Cells",
            "expected the arrays `connectivity`, `offsets` and `types`",
        );
    };
    let types = decoder.numbers(types)?;
    let start = grid.types.len();
    let cells = types.expect(1, piece.cells, "cells (NumberOfCells)")?;
    grid.types.resize(start + cells, 0);
    types.wholes(&mut grid.types[start..], "a cell type from 0 to 255")?;

    let ends = decoder.numbers(ends)?;
    ends.expect(1, piece.cells, "cells (NumberOfCells)")?;
    grid.ends.resize(start + cells, 0);
    ends.wholes(&mut grid.ends[start..], "an offset from 0 up")?;
    let vertices_before = grid.connectivity.len();
    if vertices_before > 0 {
        for end in &mut grid.ends[start..] {
            *end = end.saturating_add(vertices_before as u64);
        }
    }

    let connectivity = decoder.numbers(connectivity)?;
    grid.connectivity.resize(vertices_before + connectivity.len(), 0);
    let vertices = &mut grid.connectivity[vertices_before..];
    connectivity.wholes(vertices, "a vertex number from 0 to 4294967295")?;
    if first_point > 0 {
        for vertex in vertices {
            // What leaves the range is beyond all points, too, and found as such.
            *vertex = vertex.saturating_add(first_point.try_into().unwrap_or(u32::MAX));
        }
    }
    Ok(())
}

/// An array may be missing where there is nothing to list.
fn absent(count: u64, part: &str, message: &str) -> Result<(), Problem> {
    if count == 0 { Ok(()) } else { Err(Problem::part(format!("<{part}>"), message)) }
}

/// In a file of several pieces, a vertex number beyond a piece's own points
/// would silently mean a point of the next.
fn check_own_points(vertices: &[u32], points: usize, index: usize) -> Result<(), Problem> {
    if vertices.iter().all(|&vertex| (vertex as usize) < points) {
        return Ok(());
    }
    Err(Problem::part(
        format!("array `connectivity` of piece {index}"),
        "a vertex number exceeds the points of the piece",
    ))
}

fn append_fields<'a>(
    decoder: &Decoder<'a>,
    arrays: &'a [ArrayTag<'a>],
    tuples: u64,
    of: &str,
    piece: usize,
    fields: &mut Vec<Field>,
) -> Result<(), Problem> {
    let mut read = Vec::new();
    for array in arrays.iter().filter(|array| matches!(array.kind, ArrayKind::Numbers(_))) {
        let numbers = decoder.numbers(array)?;
        numbers.expect(array.components, tuples, of)?;
        let values = numbers.values()?;
        read.push(Field::new(&array.name, array.components, values));
    }
    if piece == 0 {
        *fields = read;
        return Ok(());
    }
    let alike = read.len() == fields.len()
        && fields.iter_mut().zip(read).all(|(field, more)| extend(field, more));
    if alike {
        return Ok(());
    }
    Err(Problem::whole(format!(
        "the {of} of piece {piece} have other arrays than those of piece 0; \
         save all pieces with the same ones"
    )))
}

/// Appends the values of `more` if it is the same field of another piece.
fn extend(field: &mut Field, more: Field) -> bool {
    let same = field.name == more.name && field.components == more.components;
    match (&mut field.values, more.values) {
        (Values::Float(values), Values::Float(more)) if same => values.extend(more),
        (Values::Integer(values), Values::Integer(more)) if same => values.extend(more),
        _ => return false,
    }
    true
}

/// Says which arrays were left out.
fn note_unread(header: &Header<'_>, notes: &mut Vec<String>) {
    for array in header.field_data.iter().filter(|array| !array.name.starts_with(PREFIX)) {
        notes.push(notes::whole_file_array(&array.name));
    }
    let fields =
        header.pieces.first().into_iter().flat_map(|p| p.point_data.iter().chain(&p.cell_data));
    for array in fields.filter(|array| !matches!(array.kind, ArrayKind::Numbers(_))) {
        notes.push(notes::no_numbers(&array.name));
    }
}

/// The arrays of `<FieldData>` that are ours.
struct FieldData<'a> {
    header: &'a Header<'a>,
    decoder: &'a Decoder<'a>,
}

impl FieldData<'_> {
    fn find(&self, name: &str) -> Option<&ArrayTag<'_>> {
        let ours = |array: &&ArrayTag<'_>| array.name.strip_prefix(PREFIX) == Some(name);
        self.header.field_data.iter().find(ours)
    }

    fn wholes<T: super::number::Whole + Default>(
        &self,
        name: &str,
        components: usize,
        expected: &str,
    ) -> Result<Option<Vec<T>>, Problem> {
        let Some(array) = self.find(name) else { return Ok(None) };
        let numbers = self.decoder.numbers(array)?;
        if array.components != components || numbers.len() % components != 0 {
            let found = format!("found {} numbers, {} a tuple", numbers.len(), array.components);
            return Err(Problem::part(
                decode::part(&array.name),
                format!("{found}; expected {components} a tuple"),
            ));
        }
        let mut values = vec![T::default(); numbers.len()];
        numbers.wholes(&mut values, expected)?;
        Ok(Some(values))
    }
}

impl SideArrays for FieldData<'_> {
    fn vertices(&self, name: &str, components: usize) -> Result<Option<Vec<u32>>, Problem> {
        self.wholes(name, components, "a vertex number from 0 to 4294967295")
    }

    fn ids(&self, name: &str) -> Result<Option<Vec<i32>>, Problem> {
        self.wholes(name, 1, "an id of 32 bits with sign")
    }

    fn bytes(&self, name: &str) -> Result<Option<Vec<u8>>, Problem> {
        self.wholes(name, 1, "a byte")
    }
}

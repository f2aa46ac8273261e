//! Cells of several types, as VTK keeps them, and the dataset that they mean.

use bytemuck::allocation::try_cast_vec;

use crate::cell_kind::{CellKind, Simplex};
use crate::dataset::{Dataset, Field, Values};
use crate::mid_side::MidSide;
use crate::notes;
use crate::problem::Problem;
use octruss_mesh::RawMesh;

/// The name of the cell array with the region or surface of each cell.
pub(crate) const REGION: &str = "region";

/// Cell arrays that hold tags, the first one present counts: ours, then those
/// of Gmsh and Medit by way of meshio, then common ones of other programs.
const TAG_ARRAYS: [&str; 5] =
    [REGION, "gmsh:physical", "medit:ref", "CellEntityIds", "MaterialIds"];

/// Points and cells as VTK lists them, unchecked.
#[derive(Debug, Default)]
pub(crate) struct Grid {
    pub(crate) points: Vec<[f64; 3]>,
    /// VTK's number for the type of each cell.
    pub(crate) types: Vec<u8>,
    /// Where each cell ends in `connectivity`.
    pub(crate) ends: Vec<u64>,
    /// Vertex numbers of one cell after the other.
    pub(crate) connectivity: Vec<u32>,
    pub(crate) point_fields: Vec<Field>,
    pub(crate) cell_fields: Vec<Field>,
    pub(crate) notes: Vec<String>,
}

impl Grid {
    /// The dataset that the grid means: tets are cells, simplices of lower
    /// dimension are tagged by the same array as the tets.
    pub(crate) fn into_dataset(mut self) -> Result<Dataset, Problem> {
        self.check_types()?;
        self.check_ends()?;
        let tags = self.take_tags()?;
        let mut dataset = Dataset::default();
        let mut mid_side = MidSide::default();
        let tet = Simplex::Tet.vtk_number();
        if self.types.iter().all(|&number| number == tet) {
            dataset.mesh.tets = quadruples(std::mem::take(&mut self.connectivity));
            dataset.mesh.regions = tags;
            dataset.cell_fields = self.cell_fields;
        } else {
            let tets = self.sort_cells(&tags, &mut dataset.mesh, &mut mid_side);
            let subset = |field: &Field| field.subset(tets.iter().copied());
            dataset.cell_fields = self.cell_fields.iter().map(subset).collect();
            self.note_untagged(&tags);
        }
        dataset.mesh.points = self.points;
        dataset.point_fields = self.point_fields;
        dataset.notes = self.notes;
        mid_side.drop_from(&mut dataset);
        Ok(dataset)
    }

    fn check_types(&self) -> Result<(), Problem> {
        let mut counts = [0usize; 256];
        for &number in &self.types {
            counts[usize::from(number)] += 1;
        }
        let foreign: Vec<String> = (0..=u8::MAX)
            .filter(|&number| counts[usize::from(number)] > 0 && handled(number).is_none())
            .map(|number| format!("{} {}", counts[usize::from(number)], CellKind::vtk_name(number)))
            .collect();
        if foreign.is_empty() {
            return Ok(());
        }
        Err(Problem::unsupported(format!(
            "the mesh has {}; only tetrahedra, and triangles, lines and vertices as tagged parts, \
             are read: split other cells into tetrahedra first",
            foreign.join(", ")
        )))
    }

    fn check_ends(&self) -> Result<(), Problem> {
        if self.ends.len() != self.types.len() {
            let (ends, types) = (self.ends.len(), self.types.len());
            return Err(Problem::part("cells", format!("{ends} offsets for {types} cell types")));
        }
        let mut start = 0;
        for (cell, (&end, &number)) in self.ends.iter().zip(&self.types).enumerate() {
            let nodes = CellKind::of_vtk(number).map_or(0, |kind| kind.nodes as u64);
            if end.checked_sub(start) != Some(nodes) {
                return Err(Problem::part(
                    "array `offsets`",
                    format!(
                        "cell {cell} reaches from {start} to {end}, but {} has {nodes} vertices",
                        CellKind::vtk_name(number)
                    ),
                ));
            }
            start = end;
        }
        if start != self.connectivity.len() as u64 {
            return Err(Problem::part(
                "array `connectivity`",
                format!("holds {} vertex numbers, the cells need {start}", self.connectivity.len()),
            ));
        }
        Ok(())
    }

    /// Removes the cell array that holds tags, if there is one; else all are 0.
    fn take_tags(&mut self) -> Result<Vec<i32>, Problem> {
        for name in TAG_ARRAYS {
            let found = self.cell_fields.iter().position(|f| f.name == name && f.components == 1);
            let Some(index) = found else { continue };
            // A field that is no list of whole numbers only happens to have the name.
            let whole: Option<Vec<i64>> = match &self.cell_fields[index].values {
                Values::Integer(values) => Some(values.clone()),
                Values::Float(values) => values
                    .iter()
                    .map(|&value| (value.fract() == 0.0).then_some(value as i64))
                    .collect(),
            };
            let Some(whole) = whole else { continue };
            self.cell_fields.remove(index);
            return whole.into_iter().map(i32::try_from).collect::<Result<_, _>>().map_err(|_| {
                Problem::part(format!("array `{name}`"), "a tag does not fit 32 bits with sign")
            });
        }
        Ok(vec![0; self.types.len()])
    }

    /// Puts every cell where it belongs; returns which cells are tets, and collects
    /// what quadratic cells have besides their corners.
    fn sort_cells(&self, tags: &[i32], mesh: &mut RawMesh, mid_side: &mut MidSide) -> Vec<usize> {
        let mut tets = Vec::new();
        let mut start = 0;
        for (cell, &number) in self.types.iter().enumerate() {
            let Some((kind, simplex)) = handled(number) else { continue };
            let nodes = &self.connectivity[start..start + kind.nodes];
            start += kind.nodes;
            mid_side.collect(kind, nodes);
            match (simplex, nodes, tags[cell]) {
                (Simplex::Tet, &[a, b, c, d, ..], region) => {
                    tets.push(cell);
                    mesh.tets.push([a, b, c, d]);
                    mesh.regions.push(region);
                }
                (_, _, 0) => {}
                (Simplex::Triangle, &[a, b, c, ..], tag) => mesh.triangles.push([a, b, c], tag),
                (Simplex::Edge, &[a, b, ..], tag) => mesh.edges.push([a, b], tag),
                (Simplex::Vertex, &[a, ..], tag) => mesh.vertices.push([a], tag),
                _ => {}
            }
        }
        tets
    }

    fn note_untagged(&mut self, tags: &[i32]) {
        let is_tet = |number| handled(number).is_some_and(|(_, simplex)| simplex == Simplex::Tet);
        let cells = self.types.iter().zip(tags);
        let untagged = cells.filter(|&(&number, &tag)| tag == 0 && !is_tet(number)).count();
        if untagged > 0 {
            self.notes.push(notes::untagged(untagged));
        }
    }
}

/// The kind of a cell that becomes part of a mesh, and what it is there.
fn handled(number: u8) -> Option<(&'static CellKind, Simplex)> {
    let kind = CellKind::of_vtk(number)?;
    Some((kind, kind.simplex?))
}

/// Vertex numbers four by four; in place where the allocation allows it.
fn quadruples(connectivity: Vec<u32>) -> Vec<[u32; 4]> {
    try_cast_vec(connectivity).unwrap_or_else(|(_, connectivity)| {
        connectivity.chunks_exact(4).map(|v| [v[0], v[1], v[2], v[3]]).collect()
    })
}

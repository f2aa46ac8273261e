//! Cells of several types, as VTK keeps them, and the dataset that they mean.

use bytemuck::allocation::try_cast_vec;

use crate::dataset::{Dataset, Field, Values};
use crate::mid_side;
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

/// A cell type that becomes part of a mesh.
struct CellType {
    number: u8,
    corners: usize,
    nodes: usize,
}

/// Linear simplices, and quadratic ones whose corners come first.
const SIMPLICES: [CellType; 7] = [
    CellType { number: 1, corners: 1, nodes: 1 },
    CellType { number: 3, corners: 2, nodes: 2 },
    CellType { number: 5, corners: 3, nodes: 3 },
    CellType { number: 10, corners: 4, nodes: 4 },
    CellType { number: 21, corners: 2, nodes: 3 },
    CellType { number: 22, corners: 3, nodes: 6 },
    CellType { number: 24, corners: 4, nodes: 10 },
];

/// VTK's number for tets.
pub(crate) const TET: u8 = 10;

impl CellType {
    fn numbered(number: u8) -> Option<&'static Self> {
        SIMPLICES.iter().find(|known| known.number == number)
    }
}

impl Grid {
    /// The dataset that the grid means: tets are cells, simplices of lower
    /// dimension are tagged by the same array as the tets.
    pub(crate) fn into_dataset(mut self) -> Result<Dataset, Problem> {
        self.check_types()?;
        self.check_ends()?;
        let tags = self.take_tags()?;
        let mut dataset = Dataset::default();
        let mut mid_side_nodes = Vec::new();
        if self.types.iter().all(|&number| number == TET) {
            dataset.mesh.tets = quadruples(std::mem::take(&mut self.connectivity));
            dataset.mesh.regions = tags;
            dataset.cell_fields = self.cell_fields;
        } else {
            let tets = self.sort_cells(&tags, &mut dataset.mesh, &mut mid_side_nodes);
            let subset = |field: &Field| field.subset(tets.iter().copied());
            dataset.cell_fields = self.cell_fields.iter().map(subset).collect();
            self.note_untagged(&tags);
        }
        dataset.mesh.points = self.points;
        dataset.point_fields = self.point_fields;
        dataset.notes = self.notes;
        if !mid_side_nodes.is_empty() {
            let dropped = mid_side::drop_nodes(&mut dataset, &mid_side_nodes);
            dataset.notes.push(format!(
                "Second-order cells were read as linear ones; {dropped} mid-side nodes were dropped."
            ));
        }
        Ok(dataset)
    }

    fn check_types(&self) -> Result<(), Problem> {
        let mut counts = [0usize; 256];
        for &number in &self.types {
            counts[usize::from(number)] += 1;
        }
        let foreign: Vec<String> = (0..=u8::MAX)
            .filter(|&number| {
                counts[usize::from(number)] > 0 && CellType::numbered(number).is_none()
            })
            .map(|number| format!("{} {}", counts[usize::from(number)], type_name(number)))
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
            let nodes = CellType::numbered(number).map_or(0, |kind| kind.nodes as u64);
            if end.checked_sub(start) != Some(nodes) {
                return Err(Problem::part(
                    "array `offsets`",
                    format!(
                        "cell {cell} reaches from {start} to {end}, but {} has {nodes} vertices",
                        type_name(number)
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

    /// Puts every cell where it belongs; returns which cells are tets, and adds
    /// the nodes of quadratic cells that are no corners to `mid_side_nodes`.
    fn sort_cells(
        &self,
        tags: &[i32],
        mesh: &mut RawMesh,
        mid_side_nodes: &mut Vec<u32>,
    ) -> Vec<usize> {
        let mut tets = Vec::new();
        let mut start = 0;
        for (cell, &number) in self.types.iter().enumerate() {
            let Some(kind) = CellType::numbered(number) else { continue };
            let nodes = &self.connectivity[start..start + kind.nodes];
            start += kind.nodes;
            mid_side_nodes.extend_from_slice(&nodes[kind.corners..]);
            match (nodes, tags[cell]) {
                _ if kind.corners == 4 => {
                    tets.push(cell);
                    mesh.tets.push([nodes[0], nodes[1], nodes[2], nodes[3]]);
                    mesh.regions.push(tags[cell]);
                }
                (_, 0) => {}
                ([a], tag) => mesh.vertices.push([*a], tag),
                ([a, b, ..], tag) if kind.corners == 2 => mesh.edges.push([*a, *b], tag),
                ([a, b, c, ..], tag) => mesh.triangles.push([*a, *b, *c], tag),
                _ => {}
            }
        }
        tets
    }

    fn note_untagged(&mut self, tags: &[i32]) {
        let is_tet = |number| CellType::numbered(number).is_some_and(|kind| kind.corners == 4);
        let cells = self.types.iter().zip(tags);
        let untagged = cells.filter(|&(&number, &tag)| tag == 0 && !is_tet(number)).count();
        if untagged > 0 {
            self.notes.push(format!(
                "{untagged} triangles, lines or vertices without a tag were left out."
            ));
        }
    }
}

/// Vertex numbers four by four; in place where the allocation allows it.
fn quadruples(connectivity: Vec<u32>) -> Vec<[u32; 4]> {
    try_cast_vec(connectivity).unwrap_or_else(|(_, connectivity)| {
        connectivity.chunks_exact(4).map(|v| [v[0], v[1], v[2], v[3]]).collect()
    })
}

/// What VTK calls its cell types, for messages.
fn type_name(number: u8) -> String {
    let name = match number {
        0 => "empty cell",
        1 => "vertex",
        2 => "poly-vertex",
        3 => "line",
        4 => "poly-line",
        5 => "triangle",
        6 => "triangle strip",
        7 => "polygon",
        8 => "pixel",
        9 => "quadrilateral",
        10 => "tetrahedron",
        11 => "voxel",
        12 => "hexahedron",
        13 => "wedge",
        14 => "pyramid",
        21 => "quadratic line",
        22 => "quadratic triangle",
        23 => "quadratic quadrilateral",
        24 => "quadratic tetrahedron",
        25 => "quadratic hexahedron",
        26 => "quadratic wedge",
        27 => "quadratic pyramid",
        41 => "convex point set",
        42 => "polyhedron",
        _ => return format!("cell of VTK type {number}"),
    };
    format!("{name} (VTK type {number})")
}

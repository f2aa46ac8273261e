//! Which images of vertices and simplices stand beside the mirror planes.

use rayon::prelude::*;

use super::cells::{Cell, HERE, OnPlanes, meeting, shared};
use crate::core::raw_mesh::RawMesh;
use octruss_base::ragged::CHUNK;

/// So many rings of tets round a vertex decide its rows and those of its edges: rules read
/// vertices two edges away, and ask for the strata of vertices that are one away.
const RINGS: usize = 2;

/// The image of a vertex or simplex in a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Image {
    /// Its number.
    pub of: u32,
    pub cell: Cell,
}

/// Images within reach of a body, ascending, each once; not the body itself.
#[derive(Debug, Default)]
pub struct Images {
    pub vertices: Vec<Image>,
    pub tets: Vec<Image>,
    pub triangles: Vec<Image>,
    pub edges: Vec<Image>,
}

impl Images {
    /// Of a mesh whose vertices lie on these planes.
    pub fn new(mesh: &RawMesh, on: &[OnPlanes]) -> Self {
        let mut images = Self::default();
        let beside = (0u32..).zip(on).filter(|(_, planes)| **planes != 0);
        let mut front: Vec<Image> = beside.map(|(of, _)| Image { of, cell: HERE }).collect();
        for _ in 0..RINGS {
            let reached = Front::new(&front, on);
            let mut next = Vec::new();
            reached.add_images(&mesh.tets, &mut images.tets, &mut next);
            reached.add_images(&mesh.triangles.simplices, &mut images.triangles, &mut next);
            reached.add_images(&mesh.edges.simplices, &mut images.edges, &mut next);
            sort(&mut next);
            next.retain(|image| images.vertices.binary_search(image).is_err());
            images.vertices.extend(&next);
            sort(&mut images.vertices);
            front = next;
        }
        images
    }
}

/// The outermost vertices so far.
struct Front<'a> {
    vertices: &'a [Image],
    on: &'a [OnPlanes],
    is_reached: Vec<bool>,
}

impl<'a> Front<'a> {
    fn new(vertices: &'a [Image], on: &'a [OnPlanes]) -> Self {
        let mut is_reached = vec![false; on.len()];
        vertices.iter().for_each(|image| is_reached[image.of as usize] = true);
        Self { vertices, on, is_reached }
    }

    /// Adds the images of simplices at these vertices, and their vertices.
    fn add_images<const N: usize>(
        &self,
        simplices: &[[u32; N]],
        images: &mut Vec<Image>,
        vertices: &mut Vec<Image>,
    ) {
        let at_simplex = |(of, simplex): (usize, &[u32; N])| {
            let reached = simplex.iter().filter(|&&v| self.is_reached[v as usize]);
            let cells = reached.flat_map(|&v| self.cells_at(v));
            let images = cells.filter(|&cell| self.is_elsewhere(simplex, cell));
            images.map(|cell| Image { of: of as u32, cell }).collect::<Vec<_>>()
        };
        let each = simplices.par_iter().with_min_len(CHUNK).enumerate();
        let mut found: Vec<Image> = each.flat_map_iter(at_simplex).collect();
        sort(&mut found);
        for Image { of, cell } in &found {
            let corners = simplices[*of as usize].iter().map(|&v| self.vertex(v, *cell));
            vertices.extend(corners.filter(|image| image.cell != HERE));
        }
        images.extend(found);
        sort(images);
    }

    fn vertex(&self, of: u32, cell: Cell) -> Image {
        Image { of, cell: shared(cell, self.on[of as usize]) }
    }

    /// The cells that meet at the images of a vertex in the front.
    fn cells_at(&self, vertex: u32) -> impl Iterator<Item = Cell> {
        let first = self.vertices.partition_point(|image| image.of < vertex);
        let images = self.vertices[first..].iter().take_while(move |image| image.of == vertex);
        images.flat_map(move |image| meeting(image.cell, self.on[vertex as usize]))
    }

    /// Whether an image is another simplex than what it is an image of.
    fn is_elsewhere<const N: usize>(&self, simplex: &[u32; N], cell: Cell) -> bool {
        simplex.iter().any(|&v| self.vertex(v, cell).cell != HERE)
    }
}

fn sort(images: &mut Vec<Image>) {
    images.par_sort_unstable();
    images.dedup();
}

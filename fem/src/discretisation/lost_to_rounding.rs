//! Which part of a body can move, where a matrix is singular but for rounding.

use crate::discretisation::discretise::Discretisation;
use crate::discretisation::unknown::Unknown;
use crate::error::Error;
use octruss_mesh::TetMesh;
use octruss_solver::{Entry, Error as SolverError, Nodal};

/// Vertices that move by this share of the largest motion belong to what moves.
const MOVES: f64 = 0.1;

impl<E: Unknown> Discretisation<'_, E> {
    /// An error of the multigrid, in words about the mesh where it is about the matrix.
    pub(crate) fn told_of_the_mesh(&self, error: SolverError) -> Error {
        match &error {
            SolverError::CoarsestSingular { null_vector, .. } if !null_vector.is_empty() => {
                self.lost_to_rounding(null_vector)
            }
            _ => error.into(),
        }
    }

    fn lost_to_rounding(&self, null_vector: &[f64]) -> Error {
        let mesh = &self.hierarchy.finest().mesh;
        let values = <E as Entry>::Nodal::from_flat(null_vector);
        let size = |value: &E::Nodal| (0..E::SIZE).map(|k| value.at(k).abs()).fold(0.0, f64::max);
        let largest = values.iter().map(size).fold(0.0, f64::max);
        let mut moves = vec![None; mesh.points().len()];
        let free = self.finest().dofs.free().iter().zip(values);
        for (&vertex, value) in free.filter(|(_, value)| size(value) >= MOVES * largest) {
            moves[vertex as usize] = Some(value);
        }
        let all: Vec<u32> =
            (0..moves.len() as u32).filter(|v| moves[*v as usize].is_some()).collect();
        // A soft region between what is held and what moves is deformed: of several regions
        // those that move without that are meant.
        let found = regions_inside(mesh, |v| moves[v as usize].is_some()).into_iter().find_map(
            |(region, vertices)| {
                let moved = moved(mesh, &vertices, &moves);
                Some((vertices, format!("region {region}"), E::motion(&moved)?))
            },
        );
        let (vertices, regions, motion) = found.unwrap_or_else(|| {
            (all, "the mesh".into(), "several parts move, or deform without resistance".into())
        });
        let example = vertices.first().copied().unwrap_or(0);
        Error::LostToRounding { vertices: vertices.len(), example, regions, motion }
    }
}

/// The regions of tets all of whose vertices are such, with the vertices of these tets,
/// ascending.
fn regions_inside(mesh: &TetMesh, such: impl Fn(u32) -> bool) -> Vec<(i32, Vec<u32>)> {
    let tets = mesh.tets().iter().zip(mesh.regions());
    let inside = tets.filter(|(tet, _)| tet.iter().all(|v| such(*v)));
    let mut all: Vec<(i32, u32)> =
        inside.flat_map(|(tet, region)| tet.map(|vertex| (*region, vertex))).collect();
    all.sort_unstable();
    all.dedup();
    let group = |same: &[(i32, u32)]| (same[0].0, same.iter().map(|(_, v)| *v).collect());
    all.chunk_by(|a, b| a.0 == b.0).map(group).collect()
}

/// (position, value) of vertices that have one.
fn moved<V: Copy>(mesh: &TetMesh, vertices: &[u32], moves: &[Option<V>]) -> Vec<([f64; 3], V)> {
    let of = |&v: &u32| Some((mesh.points()[v as usize], moves[v as usize]?));
    vertices.iter().filter_map(of).collect()
}

//! Which vertices carry an unknown and which a prescribed value.

use crate::boundary::surface::{check_surface, triangles_of};
use crate::error::Error;
use crate::problem::scalar::Scalar;
use octruss_mesh::TetMesh;
use octruss_mesh::components::part_of_vertices;
use octruss_solver::check_size;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// Marks a vertex without an unknown.
const NONE: u32 = u32::MAX;

/// The free unknowns of a mesh, one a vertex, numbered by ascending vertex; and
/// the values of all other vertices.
///
/// Vertices that no tet uses (of free-standing tagged triangles and edges)
/// carry no unknown; their value is the prescribed one or 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Dofs {
    /// The vertex of each unknown, ascending.
    free: Vec<u32>,
    /// The unknown of each vertex, or `NONE`.
    unknowns: Vec<u32>,
    /// The value of each vertex without an unknown; 0 for the others.
    values: Vec<f64>,
    /// How many vertices are fixed although tets use them.
    fixed_count: usize,
}

impl Dofs {
    /// The unknowns of `mesh` with values prescribed on surfaces; a vertex on
    /// two surfaces takes the value of the last listed.
    ///
    /// # Errors
    /// [`Error::UnknownSurface`] if a surface has no triangles,
    /// [`Error::BoundaryValue`] if a prescribed value is not finite.
    pub fn new(mesh: &TetMesh, fixed: &[(i32, Scalar)]) -> Result<Self, Error> {
        let mut values = vec![0.0; mesh.points().len()];
        let mut is_fixed = vec![false; mesh.points().len()];
        for (surface, value) in fixed {
            check_surface(mesh, *surface)?;
            for vertex in triangles_of(mesh, *surface).flatten() {
                let (at, position) = (vertex as usize, mesh.points()[vertex as usize]);
                values[at] = value.at(position);
                is_fixed[at] = true;
                if !values[at].is_finite() {
                    let (surface, told) = (*surface, value.told_at(position));
                    return Err(Error::BoundaryValue { surface, vertex, told });
                }
            }
        }
        Ok(Self::numbered(mesh, &is_fixed, values))
    }

    /// The unknowns of all vertices of tets but some, whose values are 0.
    pub(crate) fn without(mesh: &TetMesh, fixed: impl Iterator<Item = u32>) -> Self {
        let mut is_fixed = vec![false; mesh.points().len()];
        fixed.for_each(|vertex| is_fixed[vertex as usize] = true);
        Self::numbered(mesh, &is_fixed, vec![0.0; mesh.points().len()])
    }

    fn numbered(mesh: &TetMesh, is_fixed: &[bool], values: Vec<f64>) -> Self {
        let in_tet = vertices_of_tets(mesh);
        let is_free = |v: &u32| in_tet[*v as usize] && !is_fixed[*v as usize];
        let free: Vec<u32> = (0..mesh.points().len() as u32).filter(is_free).collect();
        let mut unknowns = vec![NONE; mesh.points().len()];
        for (unknown, &vertex) in free.iter().enumerate() {
            unknowns[vertex as usize] = unknown as u32;
        }
        let fixed_count = in_tet.iter().filter(|used| **used).count() - free.len();
        Self { free, unknowns, values, fixed_count }
    }

    /// The number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.free.len()
    }

    /// The number of vertices of the mesh.
    pub fn vertices(&self) -> usize {
        self.unknowns.len()
    }

    /// How many vertices of tets have a prescribed value.
    pub fn fixed(&self) -> usize {
        self.fixed_count
    }

    /// The vertex of each unknown, ascending.
    pub fn free(&self) -> &[u32] {
        &self.free
    }

    /// The unknown of a vertex, or `None` where the value is prescribed.
    #[inline]
    pub fn unknown(&self, vertex: u32) -> Option<u32> {
        let unknown = self.unknowns[vertex as usize];
        (unknown != NONE).then_some(unknown)
    }

    /// The prescribed value of a vertex without an unknown; 0 for the others.
    #[inline]
    pub fn value(&self, vertex: u32) -> f64 {
        self.values[vertex as usize]
    }

    /// The prescribed value of each vertex without an unknown; 0 for the others.
    pub(crate) fn values(&self) -> &[f64] {
        &self.values
    }

    /// Whether all prescribed values are 0.
    pub fn is_homogeneous(&self) -> bool {
        self.values.iter().all(|v| *v == 0.0)
    }

    /// A value for each vertex: the unknowns `x` where free, prescribed ones
    /// elsewhere.
    ///
    /// # Errors
    /// [`octruss_solver::Error::Size`] unless `x` has one entry for each unknown.
    pub fn expand(&self, x: &[f64]) -> Result<Vec<f64>, Error> {
        check_size("entries of a solution", x.len(), self.free.len())?;
        let mut all = self.values.clone();
        for (&vertex, &value) in self.free.iter().zip(x) {
            all[vertex as usize] = value;
        }
        Ok(all)
    }

    /// The vertices, ascending, of each part of the mesh of which none is fixed or tied to a
    /// given value; parts by their first vertex.
    pub(crate) fn loose_parts(
        &self,
        mesh: &TetMesh,
        is_tied: impl Fn(usize) -> bool,
    ) -> Vec<Vec<u32>> {
        let parts = part_of_vertices(mesh.raw());
        let mut anchored = vec![false; self.vertices()];
        for vertex in 0..self.vertices() as u32 {
            if self.unknown(vertex).is_none() || is_tied(vertex as usize) {
                anchored[parts[vertex as usize] as usize] = true;
            }
        }
        let mut loose: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for &vertex in &self.free {
            let part = parts[vertex as usize];
            if !anchored[part as usize] {
                loose.entry(part).or_default().push(vertex);
            }
        }
        loose.into_values().collect()
    }

    /// Checks that every part of the mesh has a vertex that is fixed or tied to a
    /// given value, or no unknown at all.
    pub(crate) fn check_anchored(
        &self,
        mesh: &TetMesh,
        is_tied: impl Fn(usize) -> bool,
    ) -> Result<(), Error> {
        match self.loose_parts(mesh, is_tied).first() {
            None => Ok(()),
            Some(part) => Err(Error::NothingFixed { vertices: part.len(), example: part[0] }),
        }
    }
}

/// Whether a tet uses each vertex.
pub(crate) fn vertices_of_tets(mesh: &TetMesh) -> Vec<bool> {
    let in_tet: Vec<AtomicBool> = mesh.points().iter().map(|_| AtomicBool::new(false)).collect();
    mesh.tets().par_iter().with_min_len(4096).for_each(|tet| {
        // Most are set already: reading leaves them in the other threads' caches.
        let unset = tet.iter().map(|v| &in_tet[*v as usize]).filter(|set| !set.load(Relaxed));
        unset.for_each(|set| set.store(true, Relaxed));
    });
    in_tet.into_iter().map(AtomicBool::into_inner).collect()
}

//! Which displacements of a mesh are free: for every held vertex a projector
//! onto its free directions, and the prescribed displacement in the others.
//!
//! A vertex held in all directions carries no unknown. Any other vertex of a tet
//! carries a vector, of which the matrix sees only Q x, with the projector Q of
//! the vertex: the system is Q A Q + s (I − Q), the prescribed displacement g is
//! on the right-hand side, and the solution is Q x + g.

use crate::boundary::dofs::Dofs;
use crate::boundary::held_vertex::{Condition, HeldVertex};
use crate::boundary::noisy_planes::meant_directions;
use crate::boundary::surface::{check_surface, triangles_of};
use crate::boundary::surface_normals::{VertexNormal, facets, vertex_normals};
use crate::error::Error;
use crate::problem::elasticity::{Held, Support};
use crate::problem::scalar::Scalar;
use octruss_base::vector3::{IDENTITY, Vector3, add, apply};
use octruss_mesh::{TetMesh, Topology};
use octruss_solver::check_size;
use std::cmp::Reverse;

/// The held vertices of a mesh, ascending, and the numbering of its unknowns.
#[derive(Debug, Clone, PartialEq)]
pub struct Constraints {
    dofs: Dofs,
    held: Vec<HeldVertex>,
}

impl Constraints {
    /// The constraints that supports put on a mesh; for the levels of a hierarchy
    /// the same supports on each mesh. Where a vertex is held in one direction
    /// twice, the last listed support wins. All that is held along normals is one
    /// surface, with one normal where groups or supports meet smoothly.
    ///
    /// # Errors
    /// [`Error::UnknownSurface`]; [`Error::DetachedSurface`] and
    /// [`Error::InnerSurface`] where normals are asked for and there is no
    /// outside; [`Error::BoundaryValue`].
    pub fn new(mesh: &TetMesh, topology: &Topology, supports: &[Support]) -> Result<Self, Error> {
        check_size("vertices of the topology", topology.vertex_count(), mesh.points().len())?;
        let mut held: Vec<HeldVertex> = Vec::new();
        for (vertex, condition) in conditions(mesh, topology, supports)? {
            if held.last().is_none_or(|last| last.vertex != vertex) {
                held.push(HeldVertex::free(vertex));
            }
            held.last_mut().expect("it was pushed").hold(condition);
        }
        let clamped = held.iter().filter(|v| v.is_clamped()).map(|v| v.vertex);
        Ok(Self { dofs: Dofs::without(mesh, clamped), held })
    }

    /// The numbering of the vertices with unknowns, a vector each: all vertices
    /// of tets but those held in all directions.
    pub fn dofs(&self) -> &Dofs {
        &self.dofs
    }

    /// The vertices with a condition, ascending, clamped ones included.
    pub fn held(&self) -> &[HeldVertex] {
        &self.held
    }

    /// The projector of every unknown that is held in part, as (unknown,
    /// projector), ascending; those of all others are the identity.
    pub fn projectors(&self) -> Vec<(u32, [[f64; 3]; 3])> {
        let with_unknown = |held: &HeldVertex| {
            self.dofs.unknown(held.vertex).map(|unknown| (unknown, held.projector))
        };
        self.held.iter().filter_map(with_unknown).collect()
    }

    /// The displacement of every vertex from a solution: Q x + g; 0 where no tet
    /// is.
    ///
    /// # Errors
    /// [`octruss_solver::Error::Size`] unless `x` has a vector for each unknown.
    pub fn expand(&self, x: &[[f64; 3]]) -> Result<Vec<[f64; 3]>, Error> {
        check_size("vectors of a solution", x.len(), self.dofs.unknowns())?;
        let mut all = vec![[0.0; 3]; self.dofs.vertices()];
        for (&vertex, &value) in self.dofs.free().iter().zip(x) {
            all[vertex as usize] = value;
        }
        for held in &self.held {
            let free = &mut all[held.vertex as usize];
            *free = add(apply(&held.projector, *free), held.value);
        }
        Ok(all)
    }

    /// The place in `held` of each vertex, for quick look-up.
    pub(crate) fn by_vertex(&self) -> ByVertex<'_> {
        let mut slots = vec![u32::MAX; self.dofs.vertices()];
        for (slot, held) in (0u32..).zip(&self.held) {
            slots[held.vertex as usize] = slot;
        }
        ByVertex { held: &self.held, slots }
    }

    /// What is prescribed at each vertex; 0 where, or in directions in which, it is free.
    pub(crate) fn prescribed(&self) -> Vec<Vector3> {
        let mut prescribed = vec![[0.0; 3]; self.dofs.vertices()];
        for held in &self.held {
            prescribed[held.vertex as usize] = held.value;
        }
        prescribed
    }

    /// Whether all prescribed displacements are 0.
    pub(crate) fn is_homogeneous(&self) -> bool {
        self.held.iter().all(|held| held.value == [0.0; 3])
    }
}

/// The constraint of any vertex.
pub(crate) struct ByVertex<'a> {
    held: &'a [HeldVertex],
    slots: Vec<u32>,
}

impl ByVertex<'_> {
    #[inline]
    pub(crate) fn get(&self, vertex: u32) -> Option<&HeldVertex> {
        self.held.get(self.slots[vertex as usize] as usize)
    }

    /// The place of a vertex in [`Constraints::held`]; none where it is free.
    #[inline]
    pub(crate) fn place(&self, vertex: u32) -> Option<usize> {
        let slot = self.slots[vertex as usize] as usize;
        (slot < self.held.len()).then_some(slot)
    }

    /// How many vertices are held.
    pub(crate) fn count(&self) -> usize {
        self.held.len()
    }
}

/// All conditions, vertex by vertex in ascending order, at each the last listed support
/// first.
fn conditions(
    mesh: &TetMesh,
    topology: &Topology,
    supports: &[Support],
) -> Result<Vec<(u32, Condition)>, Error> {
    let mut all = Vec::new();
    let number_at = |support: usize, vertex: u32, value: &Scalar| {
        let position = mesh.points()[vertex as usize];
        let number = value.at(position);
        if number.is_finite() {
            return Ok(number);
        }
        let (surface, told) = (supports[support].surface, value.told_at(position));
        Err(Error::BoundaryValue { surface, vertex, told })
    };
    for (support, Support { surface, held }) in supports.iter().enumerate() {
        let Held::Components(components) = held else { continue };
        check_surface(mesh, *surface)?;
        for vertex in distinct(triangles_of(mesh, *surface).flatten().collect()) {
            for (direction, value) in IDENTITY.into_iter().zip(components) {
                let Some(value) = value else { continue };
                let value = number_at(support, vertex, value)?;
                all.push((vertex, Condition { support, direction, meant: direction, value }));
            }
        }
    }
    let facets = facets(mesh, topology, supports)?;
    let normals = vertex_normals(&facets);
    for (&VertexNormal { vertex, normal, support, .. }, meant) in
        normals.iter().zip(meant_directions(&facets, &normals))
    {
        let Held::Normal(value) = &supports[support].held else { continue };
        let value = number_at(support, vertex, value)?;
        all.push((vertex, Condition { support, direction: normal, meant, value }));
    }
    all.sort_by_key(|(vertex, condition)| (*vertex, Reverse(condition.support)));
    Ok(all)
}

fn distinct(mut vertices: Vec<u32>) -> Vec<u32> {
    vertices.sort_unstable();
    vertices.dedup();
    vertices
}

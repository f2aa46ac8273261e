//! Which displacements of a mesh are free: for every held vertex a projector
//! onto its free directions, and the prescribed displacement in the others.
//!
//! A vertex held in all directions carries no unknown. Any other vertex of a tet
//! carries a vector, of which the matrix sees only Q x, with the projector Q of
//! the vertex: the system is Q A Q + s (I − Q), the prescribed displacement g is
//! on the right-hand side, and the solution is Q x + g.

use crate::boundary::dofs::Dofs;
use crate::boundary::held_vertex::{Condition, HeldVertex};
use crate::boundary::surface::{check_surface, outward_triangles, triangles_of};
use crate::error::Error;
use crate::problem::elasticity::{Held, Support};
use crate::problem::scalar::Scalar;
use octruss_base::vector3::{IDENTITY, Vector3, add, apply, dot3, length, scale};
use octruss_mesh::{TetMesh, Topology};
use octruss_solver::check_size;

/// The cosine of 40°: normals further apart hold a vertex each for themselves.
const SAME_NORMAL: f64 = 0.766_044_443_118_978;

/// The held vertices of a mesh, ascending, and the numbering of its unknowns.
#[derive(Debug, Clone, PartialEq)]
pub struct Constraints {
    dofs: Dofs,
    held: Vec<HeldVertex>,
}

impl Constraints {
    /// The constraints that supports put on a mesh; for the levels of a hierarchy
    /// the same supports on each mesh. Where a vertex is held in one direction
    /// twice, the last listed support wins.
    ///
    /// # Errors
    /// [`Error::UnknownSurface`]; [`Error::DetachedSurface`] and
    /// [`Error::InnerSurface`] where normals are asked for and there is no
    /// outside; [`Error::BoundaryValue`].
    pub fn new(mesh: &TetMesh, topology: &Topology, supports: &[Support]) -> Result<Self, Error> {
        check_size("vertices of the topology", topology.vertex_count(), mesh.points().len())?;
        const FREE: u32 = u32::MAX;
        let mut slots = vec![FREE; mesh.points().len()];
        let mut held: Vec<HeldVertex> = Vec::new();
        for (index, support) in supports.iter().enumerate().rev() {
            for (vertex, direction, value) in conditions(mesh, topology, support)? {
                let slot = &mut slots[vertex as usize];
                if *slot == FREE {
                    *slot = held.len() as u32;
                    held.push(HeldVertex::free(vertex));
                }
                held[*slot as usize].hold(Condition { support: index, direction, value });
            }
        }
        held.sort_unstable_by_key(|vertex| vertex.vertex);
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

    /// The prescribed displacement of a vertex; 0 where it is free.
    #[inline]
    pub(crate) fn value(&self, vertex: u32) -> Vector3 {
        self.get(vertex).map_or([0.0; 3], |held| held.value)
    }
}

/// (vertex, direction, value) of all conditions of one support.
fn conditions(
    mesh: &TetMesh,
    topology: &Topology,
    support: &Support,
) -> Result<Vec<(u32, Vector3, f64)>, Error> {
    let mut conditions = Vec::new();
    let mut add = |vertex: u32, direction: Vector3, value: &Scalar| {
        let position = mesh.points()[vertex as usize];
        let number = value.at(position);
        if !number.is_finite() {
            let told = value.told_at(position);
            return Err(Error::BoundaryValue { surface: support.surface, vertex, told });
        }
        conditions.push((vertex, direction, number));
        Ok(())
    };
    match &support.held {
        Held::Components(components) => {
            check_surface(mesh, support.surface)?;
            for vertex in distinct(triangles_of(mesh, support.surface).flatten().collect()) {
                for (axis, value) in IDENTITY.into_iter().zip(components) {
                    value.as_ref().map_or(Ok(()), |value| add(vertex, axis, value))?;
                }
            }
        }
        Held::Normal(value) => {
            for (vertex, normal) in vertex_normals(mesh, topology, support.surface)? {
                add(vertex, normal, value)?;
            }
        }
    }
    Ok(conditions)
}

/// The mean normals, of length 1, at each vertex of a surface: one, or several
/// where normals differ by more than 40°.
fn vertex_normals(
    mesh: &TetMesh,
    topology: &Topology,
    surface: i32,
) -> Result<Vec<(u32, Vector3)>, Error> {
    let mut at_vertices: Vec<(u32, Vector3)> = outward_triangles(mesh, topology, surface)?
        .into_iter()
        .flat_map(|triangle| triangle.vertices.map(|vertex| (vertex, triangle.double_area)))
        .collect();
    at_vertices.sort_by_key(|(vertex, _)| *vertex);
    let mut normals = Vec::new();
    for same_vertex in at_vertices.chunk_by(|a, b| a.0 == b.0) {
        let mut groups: Vec<Vector3> = Vec::new();
        for &(_, normal) in same_vertex {
            let is_near = |group: &&mut Vector3| {
                dot3(**group, normal) >= SAME_NORMAL * length(**group) * length(normal)
            };
            match groups.iter_mut().find(is_near) {
                Some(group) => *group = add(*group, normal),
                None => groups.push(normal),
            }
        }
        let unit = |normal: Vector3| scale(1.0 / length(normal), normal);
        normals.extend(groups.into_iter().map(|group| (same_vertex[0].0, unit(group))));
    }
    Ok(normals)
}

fn distinct(mut vertices: Vec<u32>) -> Vec<u32> {
    vertices.sort_unstable();
    vertices.dedup();
    vertices
}

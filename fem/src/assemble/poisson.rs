//! The P1 stiffness matrix, assembled on edges into a known pattern.
//!
//! A tet gives six values, one an edge; diagonals are minus the sum of their
//! row, because the shape functions sum to one. The edges of the topology are
//! the pattern. Least traffic a tet: its vertices, edges, corners (the points
//! once) and region, about 48 bytes, and 12 bytes for each matrix entry.

use crate::assemble::edge_rows::{Neighbours, edge_rows};
use crate::assemble::poisson_load::{
    add_robin, add_surface_load, check_load, source_load, surrounding_values,
};
use crate::assemble::scatter::{Scatter, Sums};
use crate::assemble::uniform_source::balance_sources;
use crate::boundary::dofs::Dofs;
use crate::element::p1::{centroid, edge_stiffness};
use crate::error::Error;
use crate::free::free_bodies::FreeBodies;
use crate::problem::free::Free;
use crate::problem::poisson::Poisson;
use crate::reference::constant::constants;
use crate::reference::difference::Difference;
use octruss_base::chunks::for_chunks;
use octruss_mesh::{TetMesh, Topology};
use octruss_solver::Csr;
use octruss_solver::{check_finite, check_size};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// A linear system for the free unknowns of a mesh.
#[derive(Debug, Clone)]
pub struct System {
    /// Symmetric positive definite, unless there are free parts; one row for each unknown.
    pub matrix: Csr<f64>,
    /// The sum of each row of it, without the rounding of its diagonal, where that is known:
    /// what Robin conditions and prescribed values take.
    pub row_sums: Option<Vec<f64>>,
    /// Sources and fluxes, minus what the prescribed values contribute.
    pub rhs: Vec<f64>,
    /// Which vertices the unknowns belong to.
    pub dofs: Dofs,
    /// The same for what the solution differs by from a constant, where values are
    /// prescribed far from zero.
    pub difference: Option<Difference<f64>>,
    /// The parts without a given value, if the problem balances these: `matrix` is singular.
    pub free: Option<FreeBodies<f64>>,
}

impl System {
    /// A value for each vertex from a solution `x`: see [`Dofs::expand`].
    ///
    /// # Errors
    /// [`octruss_solver::Error::Size`] unless `x` has one entry for each unknown.
    pub fn expand(&self, x: &[f64]) -> Result<Vec<f64>, Error> {
        self.dofs.expand(x)
    }
}

/// Assembles a problem on a mesh with linear elements.
///
/// # Errors
/// [`Error::UnknownSurface`], [`Error::DetachedSurface`] and
/// [`Error::UnknownRegion`] for data without a place; [`Error::Coefficient`],
/// [`Error::SurfaceCoefficient`], [`Error::BoundaryValue`], [`Error::Load`] and
/// [`octruss_solver::Error::NotFinite`] for senseless numbers; [`Error::NothingFixed`] if a
/// connected part of the mesh has neither a prescribed value nor a Robin
/// condition, unless the problem balances such parts; [`octruss_solver::Error::Size`] if the
/// topology belongs to another mesh.
pub fn assemble(mesh: &TetMesh, topology: &Topology, problem: &Poisson) -> Result<System, Error> {
    check_size("tets of the topology", topology.tet_edges().len(), mesh.tets().len())?;
    check_size("vertices of the topology", topology.vertex_count(), mesh.points().len())?;
    problem.coefficient.check(mesh)?;
    problem.source.check(mesh)?;
    let dofs = Dofs::new(mesh, &problem.fixed)?;

    let (mut couplings, source) = couplings_and_load(mesh, topology, problem)?;
    let row_sums = add_robin(mesh, topology, &problem.robin, &mut couplings)?;
    let is_tied = |vertex: usize| row_sums.get(vertex).is_some_and(|[sum]| *sum > 0.0);
    let loose = match problem.free {
        Free::Refuse => dofs.check_anchored(mesh, is_tied).map(|()| Vec::new())?,
        Free::Balance => dofs.loose_parts(mesh, is_tied),
    };
    let neighbours = Neighbours::new(topology);
    // The diagonal is the sum of the row, 0 where `row_sums` is empty, minus all
    // couplings.
    let row_sum = |vertex: u32| row_sums.get(vertex as usize).map_or(0.0, |[sum]| *sum);
    let matrix = edge_rows(
        &dofs,
        &neighbours,
        |edge, _| couplings.at(edge)[0],
        |_, _, coupling| coupling,
        |vertex, sum| row_sum(vertex) - sum,
    );
    let constants = constants(mesh, &prescribed(&dofs), &surrounding_values(mesh, problem));
    let lifted = |load: &[[f64; 1]], values: &[f64]| {
        lifted_load(&dofs, &neighbours, &couplings, load.as_flattened(), values)
    };
    let given = |reference: Option<&[f64]>| {
        let mut load = source.clone();
        add_surface_load(mesh, topology, problem, reference, &mut load).map(|()| load)
    };
    let mut load = given(None)?;
    let free =
        (!loose.is_empty()).then(|| balance_sources(mesh, problem, &dofs, &loose, &mut load));
    let measured = |reference: Vec<f64>| {
        let mut measured = given(Some(&reference))?;
        // No given value reaches these.
        loose.iter().flatten().for_each(|&v| measured[v as usize] = load[v as usize]);
        let prescribed = less_constants(&dofs, &reference);
        let rhs = lifted(&measured, &prescribed);
        Ok::<_, Error>(Difference { reference, prescribed, rhs })
    };
    let mut difference = constants.map(measured).transpose()?;
    let mut rhs = lifted(&load, dofs.values());
    check_finite("stiffness matrix", matrix.values())?;
    check_load(mesh, problem, &rhs)?;
    if let Some(free) = &free {
        free.null_space.project(&mut rhs);
        difference.iter_mut().for_each(|d| free.null_space.project(&mut d.rhs));
    }
    let row_sums = Some(free_row_sums(&dofs, &neighbours, &couplings, row_sum));
    Ok(System { matrix, row_sums, rhs, dofs, difference, free })
}

/// The stiffness matrix for k = 1 between all vertices of tets, none of them fixed,
/// and their numbering.
pub(crate) fn whole_stiffness(
    mesh: &TetMesh,
    topology: &Topology,
) -> Result<(Csr<f64>, Dofs), Error> {
    check_size("tets of the topology", topology.tet_edges().len(), mesh.tets().len())?;
    let dofs = Dofs::new(mesh, &[])?;
    let (couplings, _) = couplings_and_load(mesh, topology, &Poisson::default())?;
    let matrix = edge_rows(
        &dofs,
        &Neighbours::new(topology),
        |edge, _| couplings.at(edge)[0],
        |_, _, coupling| coupling,
        |_, sum| -sum,
    );
    Ok((matrix, dofs))
}

/// ∫ k ∇φa · ∇φb for each edge ab, and ∫ f φ for each vertex.
fn couplings_and_load(
    mesh: &TetMesh,
    topology: &Topology,
    problem: &Poisson,
) -> Result<(Sums<1>, Vec<[f64; 1]>), Error> {
    let first_bad = AtomicUsize::new(usize::MAX);
    let of_tet = |tet: usize| tet_couplings(mesh, problem, tet, &first_bad);
    let edges = Scatter::new(topology.tet_edges(), topology.edges().len());
    let vertices = mesh.points().len();
    let sums = match source_load(mesh, problem) {
        None => (edges.sum(of_tet), vec![[0.0]; vertices]),
        Some(load) => {
            // One pass, since both have to read the corners.
            let at_vertices = Scatter::new(mesh.tets(), vertices);
            let both = |tet: usize| (of_tet(tet), load(tet));
            let (couplings, load) = edges.sum_beside(&at_vertices, both);
            (couplings, load.in_order())
        }
    };
    match first_bad.into_inner() {
        usize::MAX => Ok(sums),
        tet => {
            let region = mesh.regions()[tet];
            let told = problem.coefficient.of(region).told_at(centroid(mesh.corners(tet)));
            Err(Error::Coefficient { what: "coefficient", tet, region, told, expected: "positive" })
        }
    }
}

/// ∫ k ∇φa · ∇φb for the edges of a tet; notes the first one where k is not positive
/// and finite.
#[inline]
fn tet_couplings(
    mesh: &TetMesh,
    problem: &Poisson,
    tet: usize,
    first_bad: &AtomicUsize,
) -> [[f64; 1]; 6] {
    let corners = mesh.corners(tet);
    let k = problem.coefficient.of(mesh.regions()[tet]).at(centroid(corners));
    if !(k > 0.0 && k.is_finite()) {
        first_bad.fetch_min(tet, Relaxed);
    }
    edge_stiffness(corners).map(|value| [k * value])
}

/// The sum of each row of the matrix: that of all couplings of its vertex and its diagonal,
/// minus the couplings with vertices without an unknown.
fn free_row_sums(
    dofs: &Dofs,
    neighbours: &Neighbours,
    couplings: &Sums<1>,
    row_sum: impl Fn(u32) -> f64,
) -> Vec<f64> {
    let is_held = |vertex: u32| dofs.unknown(vertex).is_none();
    let held: Vec<f64> = (0..dofs.vertices() as u32).map(|v| f64::from(is_held(v))).collect();
    let sums: Vec<[f64; 1]> = (0..dofs.vertices() as u32).map(|v| [row_sum(v)]).collect();
    lifted_load(dofs, neighbours, couplings, sums.as_flattened(), &held)
}

/// The vertices without an unknown, with their values.
pub(crate) fn prescribed(dofs: &Dofs) -> Vec<(u32, f64)> {
    let vertices = 0..dofs.vertices() as u32;
    let held = vertices.filter(|vertex| dofs.unknown(*vertex).is_none());
    held.map(|vertex| (vertex, dofs.value(vertex))).collect()
}

/// What is prescribed at each vertex less a constant there; 0 at those with an unknown.
pub(crate) fn less_constants(dofs: &Dofs, constants: &[f64]) -> Vec<f64> {
    let mut less = vec![0.0; dofs.vertices()];
    for (vertex, value) in prescribed(dofs) {
        less[vertex as usize] = value - constants[vertex as usize];
    }
    less
}

/// The load of each unknown minus the couplings with the values of vertices without one;
/// those of the others are 0.
fn lifted_load(
    dofs: &Dofs,
    neighbours: &Neighbours,
    couplings: &Sums<1>,
    load: &[f64],
    values: &[f64],
) -> Vec<f64> {
    let mut rhs: Vec<f64> = dofs.free().iter().map(|&vertex| load[vertex as usize]).collect();
    if values.iter().all(|value| *value == 0.0) {
        return rhs;
    }
    for_chunks(&mut rhs, |first, chunk| {
        for (rhs, &vertex) in chunk.iter_mut().zip(&dofs.free()[first..]) {
            for (edge, other) in neighbours.of(vertex) {
                *rhs -= couplings.at(edge)[0] * values[other as usize];
            }
        }
    });
    rhs
}

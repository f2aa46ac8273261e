//! Δ²u = f in mixed form: w = −Δu at vertices from the lumped mass, so the operator is
//! S M⁻¹ S.
//!
//! S is the P1 stiffness matrix over *all* vertices and M the lumped mass matrix, a
//! quarter of the volume of the tets at a vertex. The rows of vertices on the boundary
//! take part, and no boundary term is added: weakly ∂u/∂n = 0 on all of the boundary.
//! So a surface with prescribed values is *clamped*, u = g and ∂u/∂n = 0; a *free* one
//! has ∂u/∂n = 0 and ∂(Δu)/∂n = 0. Good for fairing fields and morphing; a plate that is
//! free in the sense of mechanics has other conditions.

use crate::assemble::poisson::{System, less_constants, prescribed, whole_stiffness};
use crate::assemble::poisson_load::{check_load, source_vector};
use crate::boundary::dofs::Dofs;
use crate::error::Error;
use crate::problem::biharmonic::Biharmonic;
use crate::problem::poisson::Poisson;
use crate::reference::constant::constants;
use crate::reference::difference::Difference;
use octruss_base::chunks::for_chunks;
use octruss_mesh::{TetMesh, Topology};
use octruss_solver::Csr;
use octruss_solver::build_rows;
use octruss_solver::check_finite;
use octruss_solver::multiply;
use octruss_solver::transpose;

/// Assembles Δ²u = f for the free vertices of a mesh: S M⁻¹ S without the rows and
/// columns of fixed vertices, symmetric to the last bit.
///
/// # Errors
/// As [`assemble`](crate::assemble()) for sources and prescribed values.
pub fn assemble_biharmonic(
    mesh: &TetMesh,
    topology: &Topology,
    problem: &Biharmonic,
) -> Result<System, Error> {
    let dofs = Dofs::new(mesh, &problem.fixed)?;
    dofs.check_anchored(mesh, |_| false)?;
    let (stiffness, all) = whole_stiffness(mesh, topology)?;
    // Rows over the root of the mass: products of both orders then round alike.
    // The lumped mass of a vertex is what a source of 1 loads it with.
    let one = Poisson { source: 1.0.into(), ..Poisson::default() };
    let mass = source_vector(mesh, &one)?;
    let roots: Vec<f64> = mass.iter().map(|volume| volume.sqrt()).collect();
    let scaled = |row: u32| 1.0 / roots[all.free()[row as usize] as usize];
    let rows = free_rows(&stiffness, &all, &dofs, scaled);
    let matrix = multiply(&rows, &transpose(&rows));
    let as_poisson = Poisson { source: problem.source.clone(), ..Poisson::default() };
    let load = source_vector(mesh, &as_poisson)?;
    let lifted = |prescribed: &[f64]| {
        let mut rhs: Vec<f64> = dofs.free().iter().map(|&vertex| load[vertex as usize]).collect();
        if prescribed.iter().all(|value| *value == 0.0) {
            return rhs;
        }
        let mut image: Vec<f64> = vec![0.0; all.unknowns()];
        let values: Vec<f64> =
            all.free().iter().map(|&vertex| prescribed[vertex as usize]).collect();
        octruss_solver::kernels::product(&stiffness, &values, &mut image);
        for_chunks(&mut image, |first, chunk| {
            let scales = (first as u32..).map(scaled);
            chunk.iter_mut().zip(scales).for_each(|(value, scale)| *value *= scale);
        });
        let mut lifted = vec![0.0; rhs.len()];
        octruss_solver::kernels::product(&rows, &image, &mut lifted);
        rhs.iter_mut().zip(&lifted).for_each(|(rhs, lifted)| *rhs -= lifted);
        rhs
    };
    let rhs = lifted(dofs.values());
    let difference = constants(mesh, &prescribed(&dofs), &[]).map(|reference| {
        let prescribed = less_constants(&dofs, &reference);
        Difference { rhs: lifted(&prescribed), reference, prescribed }
    });
    check_finite("biharmonic matrix", matrix.values())?;
    check_load(mesh, &as_poisson, &rhs)?;
    Ok(System { matrix, row_sums: None, rhs, dofs, difference, free: None })
}

/// The rows of free vertices, each column scaled.
fn free_rows(
    stiffness: &Csr<f64>,
    all: &Dofs,
    dofs: &Dofs,
    scaled: impl Fn(u32) -> f64 + Sync,
) -> Csr<f64> {
    let row_of = |row: usize| {
        let vertex = dofs.free()[row];
        stiffness.row(all.unknown(vertex).expect("all vertices of tets are there") as usize)
    };
    build_rows(
        (dofs.unknowns(), stiffness.columns()),
        |row| row_of(row).0.len(),
        |row, indices, values| {
            let (columns, entries) = row_of(row);
            indices.copy_from_slice(columns);
            let entries =
                columns.iter().zip(entries).map(|(&column, entry)| entry * scaled(column));
            values.iter_mut().zip(entries).for_each(|(value, entry)| *value = entry);
        },
    )
}

//! A scalar problem on parts without a given value: sources that balance, and constants that
//! may be added.

use crate::assemble::lumped::lumped_volumes;
use crate::assemble::regularisation::shifts;
use crate::boundary::dofs::Dofs;
use crate::free::balance::{Balance, Balancing, share};
use crate::free::free_bodies::FreeBodies;
use crate::free::null_space::NullSpace;
use crate::problem::poisson::Poisson;
use octruss_mesh::TetMesh;

/// Adds to the load of each of these parts, given by their vertices, a uniform source that
/// balances it.
pub(crate) fn balance_sources(
    mesh: &TetMesh,
    problem: &Poisson,
    dofs: &Dofs,
    parts: &[Vec<u32>],
    load: &mut [[f64; 1]],
) -> FreeBodies<f64> {
    let volumes = lumped_volumes(mesh);
    let balance = |vertices: &Vec<u32>| {
        let sum = |value: &dyn Fn(usize) -> f64| vertices.iter().map(|&v| value(v as usize)).sum();
        let (total, volume): (f64, f64) = (sum(&|v| load[v][0]), sum(&|v| volumes[v]));
        let size: f64 = sum(&|v| load[v][0].abs());
        Balance {
            vertices: vertices.len(),
            example: vertices[0],
            share: share(total.abs(), size),
            added: Balancing::Source(-total / volume),
        }
    };
    let balances: Vec<Balance> = parts.iter().map(balance).collect();
    for (vertices, balance) in parts.iter().zip(&balances) {
        if let Balancing::Source(source) = balance.added {
            for &vertex in vertices {
                load[vertex as usize][0] += source * volumes[vertex as usize];
            }
        }
    }
    let vertices = parts.iter().map(Vec::as_slice);
    let stiffness = |tet: usize, middle| problem.coefficient.of(mesh.regions()[tet]).at(middle);
    let shifts = shifts(mesh, vertices, &volumes, stiffness);
    let at_unknowns = |all: &[f64]| dofs.free().iter().map(|&v| all[v as usize]).collect();
    let constants = parts.iter().map(|vertices| {
        let rows: Vec<u32> = vertices.iter().filter_map(|v| dofs.unknown(*v)).collect();
        let ones = vec![1.0; rows.len()];
        (rows, vec![ones])
    });
    FreeBodies {
        null_space: NullSpace::new(constants),
        balances,
        shift: at_unknowns(&shifts),
        means: vec![at_unknowns(&volumes)],
    }
}

//! Integrals over what is round each vertex: a quarter of each of its tets.

use crate::assemble::load::tet_load;
use crate::assemble::scatter::Scatter;
use crate::problem::scalar::Scalar;
use octruss_mesh::TetMesh;

/// ∫ f φ at each vertex, with f by region.
pub(crate) fn lumped<'a>(mesh: &TetMesh, f: impl Fn(i32) -> &'a Scalar + Sync) -> Vec<f64> {
    let scatter = Scatter::new(mesh.tets(), mesh.points().len());
    let sums = scatter.sum(|tet| {
        let f = f(mesh.regions()[tet]);
        tet_load(mesh.corners(tet), f.is_constant(), |p| [f.at(p)])
    });
    sums.in_order().into_flattened()
}

/// The volume round each vertex; of no tet 0.
pub(crate) fn lumped_volumes(mesh: &TetMesh) -> Vec<f64> {
    lumped(mesh, |_| &Scalar::Constant(1.0))
}

//! The matrix of linear elasticity, 3 × 3 blocks assembled on edges.
//!
//! A tet gives six blocks, one an edge; diagonal blocks are minus the sum of
//! their row, because a translation strains nothing. Least traffic a tet: its
//! vertices, edges, corners and region, about 48 bytes; 72 bytes for the sum of
//! each edge and 76 for each block of the matrix.

use crate::assemble::edge_rows::{Neighbours, edge_rows};
use crate::assemble::elasticity_load::{add_spring_forces, add_springs, blame_load};
use crate::assemble::inertia_relief::BalancedLoad;
use crate::assemble::scatter::{Scatter, Sums};
use crate::boundary::constraints::{ByVertex, Constraints};
use crate::boundary::held_vertex::{HeldVertex, projected_diagonal};
use crate::element::p1::{centroid, edge_elasticity};
use crate::error::Error;
use crate::free::free_bodies::FreeBodies;
use crate::problem::elasticity::{Elasticity, Material};
use crate::reference::difference::Difference;
use crate::reference::nearest_motion::rigid_motions;
use octruss_base::chunks::map_chunks;
use octruss_base::vector3::{
    IDENTITY, Matrix3, Vector3, ZERO, add3, apply, multiply3, scale, subtract, transpose3,
};
use octruss_mesh::reference_tet::EDGES;
use octruss_mesh::{TetMesh, Topology};
use octruss_solver::Csr;
use octruss_solver::{check_finite, check_size};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// A linear system with a vector for each unknown vertex of a mesh.
#[derive(Debug, Clone)]
pub struct VectorSystem {
    /// Q A Q + s (I − Q) with the projectors Q of the constraints and, for each
    /// vertex, the mean s of the diagonal of its block: symmetric positive
    /// definite, unless there are free parts; one row of blocks for each unknown vertex.
    pub matrix: Csr<[[f64; 3]; 3]>,
    /// The sum of each row of it, where nothing holds its vertex without the rounding of the
    /// diagonal: what springs and what is held beside it take.
    pub row_sums: Vec<[[f64; 3]; 3]>,
    /// Q (f − A g): loads minus what prescribed displacements contribute.
    pub rhs: Vec<[f64; 3]>,
    /// What is held, and which vertices the unknowns belong to.
    pub constraints: Constraints,
    /// The same for what the displacement differs by from a rigid motion, where it is
    /// prescribed far from zero.
    pub difference: Option<Difference<[f64; 3]>>,
    /// The parts that nothing holds, or not in all directions, if the problem balances their
    /// loads: `matrix` is singular.
    pub free: Option<FreeBodies<[f64; 3]>>,
}

impl VectorSystem {
    /// The displacement of each vertex from a solution: see [`Constraints::expand`].
    ///
    /// # Errors
    /// [`octruss_solver::Error::Size`] unless `x` has a vector for each unknown.
    pub fn expand(&self, x: &[[f64; 3]]) -> Result<Vec<[f64; 3]>, Error> {
        self.constraints.expand(x)
    }
}

/// Assembles a problem on a mesh with linear elements.
///
/// # Errors
/// [`Error::UnknownSurface`], [`Error::DetachedSurface`], [`Error::InnerSurface`]
/// and [`Error::UnknownRegion`] for data without a place; [`Error::Coefficient`],
/// [`Error::SurfaceCoefficient`], [`Error::BoundaryValue`], [`Error::Load`] and
/// [`octruss_solver::Error::NotFinite`] for senseless numbers; [`Error::RigidModes`] if a
/// connected part of the mesh can move as a rigid body, [`Error::Hinged`] if a body can turn
/// about edges or vertices on which it hangs; [`octruss_solver::Error::Size`] if the
/// topology belongs to another mesh.
pub fn assemble_elasticity(
    mesh: &TetMesh,
    topology: &Topology,
    problem: &Elasticity,
) -> Result<VectorSystem, Error> {
    check_size("tets of the topology", topology.tet_edges().len(), mesh.tets().len())?;
    let constraints = Constraints::new(mesh, topology, &problem.supports)?;
    let balanced = BalancedLoad::new(mesh, topology, problem, &constraints)?;
    let free = balanced.free_bodies(mesh, problem, &constraints);
    let load = balanced.total();
    let mut couplings = edge_couplings(mesh, topology, problem)?;
    let row_sums = add_springs(mesh, topology, problem, &mut couplings)?;
    let neighbours = Neighbours::new(topology);
    let stiffness = Stiffness { neighbours, couplings, row_sums };
    let by_vertex = constraints.by_vertex();
    let matrix = stiffness.projected_matrix(&constraints, &by_vertex);
    let row_sums = stiffness.projected_row_sums(&matrix, &constraints, &by_vertex);
    let lifted = |load: &[Vector3], prescribed: Option<&[Vector3]>| {
        stiffness.projected_load(&constraints, &by_vertex, load, prescribed)
    };
    let mut difference = rigid_motions(mesh, &constraints)
        .map(|(reference, prescribed)| {
            let mut load = load.clone();
            add_spring_forces(mesh, topology, problem, &reference, &mut load)?;
            let rhs = lifted(&load, Some(&prescribed));
            Ok::<_, Error>(Difference { reference, prescribed, rhs })
        })
        .transpose()?;
    let prescribed = (!constraints.is_homogeneous()).then(|| constraints.prescribed());
    let mut rhs = lifted(&load, prescribed.as_deref());
    check_finite("stiffness matrix", matrix.values().as_flattened().as_flattened())?;
    if let Err(error) = check_finite("load vector", rhs.as_flattened()) {
        return Err(blame_load(mesh, problem).err().unwrap_or(error.into()));
    }
    if let Some(free) = &free {
        free.null_space.project(&mut rhs);
        difference.iter_mut().for_each(|d| free.null_space.project(&mut d.rhs));
    }
    Ok(VectorSystem { matrix, row_sums, rhs, constraints, difference, free })
}

/// Lamé's constants λ and μ in one tet.
#[inline]
pub(crate) fn lame(material: &Material, centroid: Vector3) -> [f64; 2] {
    let (young, poisson) = (material.young.at(centroid), material.poisson.at(centroid));
    let shear = young / (2.0 * (1.0 + poisson));
    [2.0 * shear * poisson / (1.0 - 2.0 * poisson), shear]
}

/// The block (a, b) of each edge a < b, row by row.
fn edge_couplings(
    mesh: &TetMesh,
    topology: &Topology,
    problem: &Elasticity,
) -> Result<Sums<9>, Error> {
    problem.material.check(mesh)?;
    let first_bad = AtomicUsize::new(usize::MAX);
    let scatter = Scatter::new(topology.tet_edges(), topology.edges().len());
    let couplings = scatter.sum(|tet| {
        let (corners, vertices) = (mesh.corners(tet), mesh.tets()[tet]);
        let material = problem.material.of(mesh.regions()[tet]);
        let middle = centroid(corners);
        if fault(material, middle).is_some() {
            first_bad.fetch_min(tet, Relaxed);
        }
        let [lambda, mu] = lame(material, middle);
        let mut blocks = edge_elasticity(corners, lambda, mu);
        for ([a, b], block) in EDGES.into_iter().zip(&mut blocks) {
            if vertices[a] > vertices[b] {
                let [m00, m01, m02, m10, m11, m12, m20, m21, m22] = *block;
                *block = [m00, m10, m20, m01, m11, m21, m02, m12, m22];
            }
        }
        blocks
    });
    match first_bad.into_inner() {
        usize::MAX => Ok(couplings),
        tet => {
            let (region, middle) = (mesh.regions()[tet], centroid(mesh.corners(tet)));
            let fault = fault(problem.material.of(region), middle);
            let (what, told, expected) = fault.expect("it was found in this tet");
            Err(Error::Coefficient { what, tet, region, told, expected })
        }
    }
}

/// What of a material is out of its range, how it is told, and what it must be.
fn fault(material: &Material, at: Vector3) -> Option<(&'static str, String, &'static str)> {
    let Material { young, poisson, density } = material;
    let [e, nu, rho] = [young, poisson, density].map(|scalar| scalar.at(at));
    if !(e > 0.0 && e.is_finite()) {
        return Some(("Young's modulus", young.told_at(at), "positive"));
    }
    if !(nu > -1.0 && nu < 0.5) {
        return Some(("Poisson's ratio", poisson.told_at(at), "above -1 and below 0.5"));
    }
    if !(rho >= 0.0 && rho.is_finite()) {
        return Some(("density", density.told_at(at), "0 or more"));
    }
    None
}

/// The stiffness before anything is held.
struct Stiffness<'a> {
    neighbours: Neighbours<'a>,
    couplings: Sums<9>,
    /// The sum of each row of blocks; empty where all are zero.
    row_sums: Vec<[f64; 9]>,
}

impl Stiffness<'_> {
    /// The block of a vertex and its neighbour along an edge.
    #[inline]
    fn block(&self, edge: u32, vertex: u32) -> Matrix3 {
        let block = unflattened(&self.couplings.at(edge));
        if self.neighbours.is_lower(edge, vertex) { block } else { transpose3(&block) }
    }

    /// The diagonal block of a vertex from the sum of its other blocks, symmetric
    /// to the last bit.
    fn diagonal(&self, vertex: u32, others: &Matrix3) -> Matrix3 {
        let row_sum = self.row_sums.get(vertex as usize).map_or(ZERO, unflattened);
        let diagonal: Matrix3 = std::array::from_fn(|i| subtract(row_sum[i], others[i]));
        add3(&diagonal, &transpose3(&diagonal)).map(|row| scale(0.5, row))
    }

    fn projected_matrix(&self, constraints: &Constraints, held: &ByVertex) -> Csr<Matrix3> {
        edge_rows(
            constraints.dofs(),
            &self.neighbours,
            |edge, vertex| self.block(edge, vertex),
            |vertex, other, block| {
                projected(&block, held.get(vertex), held.get(other), vertex < other)
            },
            |vertex, others| {
                let diagonal = self.diagonal(vertex, &others);
                held.get(vertex).map_or(diagonal, |held| {
                    let mean = (0..3).map(|k| diagonal[k][k]).sum::<f64>() / 3.0;
                    projected_diagonal(&held.projector, &diagonal, mean)
                })
            },
        )
    }

    /// The sum of each row of the projected matrix. Where a vertex is held its diagonal block
    /// is what it is; elsewhere a translation of all strains nothing but springs, and of
    /// that what is held leaves out its part.
    fn projected_row_sums(
        &self,
        matrix: &Csr<Matrix3>,
        constraints: &Constraints,
        held: &ByVertex,
    ) -> Vec<Matrix3> {
        let mut sums = vec![ZERO; matrix.rows()];
        map_chunks(&mut sums, |first, chunk| {
            for (row, sum) in (first..).zip(chunk) {
                let vertex = constraints.dofs().free()[row];
                if held.get(vertex).is_some() {
                    *sum = matrix.row(row).1.iter().fold(ZERO, |sum, block| add3(&sum, block));
                    continue;
                }
                *sum = self.row_sums.get(vertex as usize).map_or(ZERO, unflattened);
                for (edge, other) in self.neighbours.of(vertex) {
                    let Some(held) = held.get(other) else { continue };
                    let left_out: Matrix3 =
                        std::array::from_fn(|i| subtract(IDENTITY[i], held.projector[i]));
                    let block = multiply3(&self.block(edge, vertex), &left_out);
                    *sum = std::array::from_fn(|i| subtract(sum[i], block[i]));
                }
            }
        });
        sums
    }

    /// Q (f − A g) of each unknown, with the prescribed displacement g of each vertex if it
    /// is not 0 everywhere.
    fn projected_load(
        &self,
        constraints: &Constraints,
        held: &ByVertex,
        load: &[Vector3],
        prescribed: Option<&[Vector3]>,
    ) -> Vec<Vector3> {
        let free = constraints.dofs().free();
        let mut rhs: Vec<Vector3> = free.iter().map(|&vertex| load[vertex as usize]).collect();
        map_chunks(&mut rhs, |first, chunk| {
            for (rhs, &vertex) in chunk.iter_mut().zip(&free[first..]) {
                if let Some(prescribed) = prescribed {
                    let mut others = ZERO;
                    for (edge, other) in self.neighbours.of(vertex) {
                        let block = self.block(edge, vertex);
                        others = add3(&others, &block);
                        *rhs = subtract(*rhs, apply(&block, prescribed[other as usize]));
                    }
                    let own = self.diagonal(vertex, &others);
                    *rhs = subtract(*rhs, apply(&own, prescribed[vertex as usize]));
                }
                if let Some(held) = held.get(vertex) {
                    *rhs = apply(&held.projector, *rhs);
                }
            }
        });
        rhs
    }
}

/// Q_row block Q_column; of a block and its transpose, the one that `is_upper`
/// decides for both, so that the matrix is symmetric to the last bit.
#[inline]
fn projected(
    block: &Matrix3,
    row: Option<&HeldVertex>,
    column: Option<&HeldVertex>,
    is_upper: bool,
) -> Matrix3 {
    if row.is_none() && column.is_none() {
        return *block;
    }
    let times = |held: Option<&HeldVertex>, block: Matrix3| {
        held.map_or(block, |held| multiply3(&held.projector, &block))
    };
    // (Q B)ᵀ = Bᵀ Q: two products from the left.
    if is_upper {
        transpose3(&times(column, transpose3(&times(row, *block))))
    } else {
        times(row, transpose3(&times(column, transpose3(block))))
    }
}

/// A block from its numbers, row by row.
pub(crate) fn unflattened(block: &[f64; 9]) -> Matrix3 {
    std::array::from_fn(|i| std::array::from_fn(|j| block[3 * i + j]))
}

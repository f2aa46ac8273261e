//! Linear elasticity assembled tet by tet from the textbook formula, slow and
//! obviously right, and the levels that a multigrid needs for it.

use std::sync::Arc;

use octruss_fem::{Dofs, Scalar, restrict_to_free};
use octruss_mesh::{FeatureOptions, Hierarchy, Level, Scheme, TetMesh, linear_matrix, subdivide};
use octruss_solver::Csr;

pub type Block = [[f64; 3]; 3];

/// A system for the vertices that are not clamped, constrained in some directions
/// on every level, with what prolongs between levels, coarsest first.
pub struct Body {
    pub matrix: Csr<Block>,
    pub prolongations: Vec<Csr<f64>>,
    pub projectors: Vec<Vec<(u32, Block)>>,
}

/// A mesh with Young's modulus 1, refined without a change of shape, clamped on a
/// surface. `free(x)` is the projector onto the free directions of the vertex at x,
/// where it has one.
pub fn body(
    coarse: TetMesh,
    refinements: usize,
    (prolong, poisson_ratio, clamped): (Scheme, f64, i32),
    free: impl Fn([f64; 3]) -> Option<Block>,
) -> Body {
    let mut hierarchy = Hierarchy::new(coarse, &FeatureOptions::default());
    for _ in 0..refinements {
        hierarchy.subdivide(Scheme::Linear).unwrap();
    }
    let fixed = [(clamped, Scalar::from(0.0))];
    let dofs: Vec<Dofs> =
        hierarchy.levels().iter().map(|level| Dofs::new(&level.mesh, &fixed).unwrap()).collect();
    let prolongation = |level: usize| {
        let Level { mesh, topology, .. } = &*hierarchy.levels()[level];
        let matrix = match prolong {
            Scheme::Linear => linear_matrix(topology),
            smooth => subdivide(mesh, topology, smooth, level + 1).unwrap().2.matrix,
        };
        restrict_to_free(&matrix, &dofs[level + 1], &dofs[level]).unwrap()
    };
    let constrained = |(level, dofs): (&Arc<Level>, &Dofs)| {
        let of = |(row, &vertex): (usize, &u32)| {
            free(level.mesh.points()[vertex as usize]).map(|q| (row as u32, q))
        };
        dofs.free().iter().enumerate().filter_map(of).collect()
    };
    let levels = hierarchy.levels().iter().zip(&dofs);
    let projectors: Vec<Vec<(u32, Block)>> = levels.map(constrained).collect();
    let matrix = stiffness(&hierarchy.finest().mesh, &dofs[refinements], poisson_ratio);
    Body {
        matrix: constrain(&matrix, &projectors[refinements]),
        prolongations: (0..refinements).map(prolongation).collect(),
        projectors,
    }
}

/// ∫ λ div u div v + 2 μ ε(u) : ε(v), block (a, b) of a tet being
/// V (λ ∇φa ∇φbᵀ + μ ∇φb ∇φaᵀ + μ ∇φa · ∇φb I).
fn stiffness(mesh: &TetMesh, dofs: &Dofs, nu: f64) -> Csr<Block> {
    let (lambda, mu) = (nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), 0.5 / (1.0 + nu));
    let mut triplets: Vec<(u32, u32, Block)> = Vec::new();
    for (t, tet) in mesh.tets().iter().enumerate() {
        let (gradients, volume) = gradients(mesh.corners(t));
        for a in 0..4 {
            for b in 0..4 {
                let (ga, gb) = (gradients[a], gradients[b]);
                let dot: f64 = (0..3).map(|k| ga[k] * gb[k]).sum();
                let entry = |i: usize, j: usize| {
                    let shear = if i == j { mu * dot } else { 0.0 };
                    volume * (lambda * ga[i] * gb[j] + mu * gb[i] * ga[j] + shear)
                };
                if let (Some(row), Some(column)) = (dofs.unknown(tet[a]), dofs.unknown(tet[b])) {
                    let block = [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)));
                    triplets.push((row, column, block));
                }
            }
        }
    }
    triplets.sort_by_key(|(row, column, _)| (*row, *column));
    let (mut offsets, mut indices, mut values) = (vec![0; dofs.unknowns() + 1], vec![], vec![]);
    for same in triplets.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        offsets[same[0].0 as usize + 1] += 1;
        indices.push(same[0].1);
        let entry = |i: usize, j: usize| same.iter().map(|(.., block)| block[i][j]).sum::<f64>();
        values.push([0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j))));
    }
    for row in 0..dofs.unknowns() {
        offsets[row + 1] += offsets[row];
    }
    Csr::new(dofs.unknowns(), offsets, indices, values).unwrap()
}

/// The gradients of a tet's shape functions and its volume: ∇φ₁ is the cross
/// product of the other two edge vectors over six times the volume.
fn gradients([o, a, b, c]: [[f64; 3]; 4]) -> ([[f64; 3]; 4], f64) {
    let edge = |p: [f64; 3]| [p[0] - o[0], p[1] - o[1], p[2] - o[2]];
    let cross = |u: [f64; 3], v: [f64; 3]| {
        [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    };
    let (a, b, c) = (edge(a), edge(b), edge(c));
    let across = [cross(b, c), cross(c, a), cross(a, b)];
    let det: f64 = (0..3).map(|k| a[k] * across[0][k]).sum();
    let [ga, gb, gc] = across.map(|normal| normal.map(|n| n / det));
    let go = [0, 1, 2].map(|k| -(ga[k] + gb[k] + gc[k]));
    ([go, ga, gb, gc], det / 6.0)
}

/// Q A Q + s (I − Q), s the largest entry of the diagonal block.
fn constrain(matrix: &Csr<Block>, projectors: &[(u32, Block)]) -> Csr<Block> {
    let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let of = |row: u32| {
        let found = projectors.binary_search_by_key(&row, |(row, _)| *row);
        found.map_or(identity, |at| projectors[at].1)
    };
    let times = |a: &Block, b: &Block| {
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum::<f64>()))
    };
    let mut values = Vec::with_capacity(matrix.nonzeros());
    for row in 0..matrix.rows() as u32 {
        let (columns, blocks) = matrix.row(row as usize);
        for (&column, block) in columns.iter().zip(blocks) {
            let mut value = times(&times(&of(row), block), &of(column));
            if row == column {
                let s = block.as_flattened().iter().copied().fold(0.0, f64::max);
                for i in 0..3 {
                    for j in 0..3 {
                        value[i][j] += s * (identity[i][j] - of(row)[i][j]);
                    }
                }
            }
            values.push(value);
        }
    }
    let offsets = (0..=matrix.rows()).map(|row| matrix.offset(row)).collect();
    Csr::new(matrix.columns(), offsets, matrix.indices().to_vec(), values).unwrap()
}

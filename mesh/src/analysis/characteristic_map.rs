//! The map of a star by its three dominant eigenvectors.

use super::eigenvectors;
use super::error::AnalysisError;
use super::local_matrix::LocalMatrix;
use super::no_map::NoMap;
use super::refined_star::RefinedStar;
use super::tet_grid::TetGrid;
use crate::core::raw_mesh::RawMesh;
use crate::core::reference_tet::six_volumes;
use crate::core::tet_mesh::TetMesh;
use crate::scheme::Scheme;

/// How often the star is split for the sample of the map.
const LEVELS: usize = 3;
/// The iteration for the outer rings ends when nothing moves by more than this.
const SETTLED: f64 = 1e-13;
const STEPS: usize = 500;
/// Volumes and barycentric coordinates below this are rounding.
const ROUNDING: f64 = 1e-9;

/// The characteristic map of a scheme at a vertex, sampled: the star, split
/// linearly three times, and where the eigenvectors of λ1, λ2 and λ3 put its
/// vertices.
///
/// By the eigenvector equation this is the control net of the map after three
/// steps of the scheme, each scaled by the eigenvalues; the map itself repeats
/// on every scale.
#[derive(Debug, Clone, PartialEq)]
pub struct CharacteristicMap {
    /// λ1, λ2, λ3.
    pub eigenvalues: [f64; 3],
    /// The sample: points are images, coordinate i that of λ(i+1); tets may
    /// overlap or be inverted. Vertex 0 is the centre, at the origin.
    pub image: RawMesh,
    /// Where each vertex lies in the star.
    pub preimage: Vec<[f64; 3]>,
    /// For each vertex how many edges lead to the centre; 8 on the rim.
    pub layers: Vec<u32>,
}

impl CharacteristicMap {
    /// Samples the map at a vertex; `Ok(Err(_))` says why there is none.
    ///
    /// # Errors
    /// As [`LocalMatrix::new`] and [`LocalMatrix::spectrum`].
    pub fn new(
        mesh: &TetMesh,
        vertex: u32,
        scheme: Scheme,
    ) -> Result<Result<Self, NoMap>, AnalysisError> {
        let local = LocalMatrix::new(mesh, vertex, scheme)?;
        let (eigenvalues, vectors) = match eigenvectors::dominant(&local.matrix, &local.spectrum()?)
        {
            Ok(found) => found,
            Err(none) => return Ok(Err(none)),
        };
        let star = RefinedStar::new(mesh, vertex, LEVELS, scheme)?;
        let inner = star.within(local.rings);
        let mut image = vec![[0.0; 3]; star.layers.len()];
        for (i, &v) in inner.iter().enumerate() {
            image[v as usize] = [0, 1, 2].map(|k| vectors[(i, k)]);
        }
        extend_outwards(&star, local.rings, eigenvalues, &mut image);
        let mut raw = star.mesh.into_raw();
        let preimage = std::mem::replace(&mut raw.points, image);
        make_right_handed(&mut raw);
        Ok(Ok(Self { eigenvalues, image: raw, preimage, layers: star.layers }))
    }

    /// Whether no tet of the sample is flat or turned over against the others.
    pub fn is_regular(&self) -> bool {
        let volumes: Vec<f64> =
            (0..self.image.tets.len()).map(|t| six_volumes(self.corners(t))).collect();
        let largest = volumes.iter().copied().fold(0.0, f64::max);
        volumes.iter().all(|&volume| volume > ROUNDING * largest)
    }

    /// Whether the barycentre of every tet of the sample lies in no other.
    pub fn is_injective(&self) -> bool {
        let grid = TetGrid::new(&self.image.points, &self.image.tets);
        (0..self.image.tets.len()).all(|t| {
            let corners = self.corners(t);
            let centre = [0, 1, 2].map(|k| corners.iter().map(|p| p[k]).sum::<f64>() / 4.0);
            grid.containing(centre, -ROUNDING).all(|(found, _)| found as usize == t)
        })
    }

    fn corners(&self, tet: usize) -> [[f64; 3]; 4] {
        self.image.tets[tet].map(|v| self.image.points[v as usize])
    }
}

/// Continues eigenvectors from the closed inner rings over the whole star:
/// iterates x ← Λ⁻¹ S x outside, where S has smaller eigenvalues than inside.
fn extend_outwards(star: &RefinedStar, rings: u32, lambda: [f64; 3], image: &mut [[f64; 3]]) {
    let outer: Vec<u32> =
        (0..image.len() as u32).filter(|&v| star.layers[v as usize] > rings).collect();
    for _ in 0..STEPS {
        let mut largest_move = 0.0f64;
        // Each value is used as soon as it is found (Gauss-Seidel).
        for &vertex in &outer {
            let mut sum = [0.0; 3];
            for (column, weight) in star.row(vertex) {
                let value = image[column as usize];
                (0..3).for_each(|k| sum[k] += weight * value[k] / lambda[k]);
            }
            let old = std::mem::replace(&mut image[vertex as usize], sum);
            (0..3).for_each(|k| largest_move = largest_move.max((sum[k] - old[k]).abs()));
        }
        if largest_move < SETTLED {
            break;
        }
    }
}

/// Eigenvectors have no sign: mirrors the image if most of it is turned over.
fn make_right_handed(image: &mut RawMesh) {
    let total: f64 =
        image.tets.iter().map(|tet| six_volumes(tet.map(|v| image.points[v as usize]))).sum();
    if total < 0.0 {
        image.points.iter_mut().for_each(|point| point[2] = -point[2]);
    }
}

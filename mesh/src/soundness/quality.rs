//! Shape measures of tets.

use nalgebra::Vector3;
use rayon::prelude::*;

use crate::core::raw_mesh::RawMesh;
use crate::core::reference_tet::{EDGES, FACES, corners, six_volumes};
use octruss_base::ragged::CHUNK;

/// How many equal bins the histograms of η and of the radius ratio have.
pub const RATIO_BINS: usize = 10;

/// How many equal bins the histogram of dihedral angles has: ten degrees each.
pub const ANGLE_BINS: usize = 18;

/// Quality measures of a whole mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct QualitySummary {
    /// The mean ratios η of the tets; see [`mean_ratio`].
    pub eta: Distribution<RATIO_BINS>,
    /// The radius ratios of the tets; see [`radius_ratio`].
    pub radius_ratio: Distribution<RATIO_BINS>,
    /// The six dihedral angles of every tet, in degrees.
    pub dihedral_deg: Distribution<ANGLE_BINS>,
    /// The tet with the smallest η, the first of equals.
    pub worst_tet: usize,
}

/// How the values of one measure are spread.
#[derive(Debug, Clone, PartialEq)]
pub struct Distribution<const BINS: usize> {
    /// The smallest value.
    pub min: f64,
    /// The mean.
    pub mean: f64,
    /// The largest value.
    pub max: f64,
    /// How many values fall into each of equal bins from 0 to the measure's
    /// upper end, which counts in the last; negative values count in the first.
    pub histogram: [usize; BINS],
}

/// The mean ratio η = 12 (3 V)^(2/3) / Σ L² of a tet: 1 for a regular one, 0 for
/// a flat one, negative for an inverted one.
///
/// Wang's thesis, equation 3.5, prints the cube root garbled.
pub fn mean_ratio(corners: [[f64; 3]; 4]) -> f64 {
    let volume = six_volumes(corners) / 6.0;
    let squares: f64 =
        EDGES.iter().map(|&[a, b]| (point(corners[a]) - point(corners[b])).norm_squared()).sum();
    if squares == 0.0 {
        0.0
    } else {
        12.0 * (3.0 * volume).cbrt().powi(2) * volume.signum() / squares
    }
}

/// The six dihedral angles of a tet in degrees, at its edges in the order of
/// [`EDGES`]; not a number where a face has no area.
pub fn dihedral_angles(corners: [[f64; 3]; 4]) -> [f64; 6] {
    let normals = face_normals(corners);
    // The faces at an edge are those opposite the two vertices not on it; their
    // outward normals enclose 180 degrees less the dihedral angle.
    std::array::from_fn(|edge| {
        let [c, d] = crate::core::reference_tet::opposite_ends(edge);
        let cosine = -normals[c].normalize().dot(&normals[d].normalize());
        cosine.clamp(-1.0, 1.0).acos().to_degrees()
    })
}

/// Three times the inscribed over the circumscribed radius: 1 for a regular
/// tet, 0 for a flat one, negative for an inverted one.
pub fn radius_ratio(corners: [[f64; 3]; 4]) -> f64 {
    let volume = six_volumes(corners) / 6.0;
    let area: f64 = face_normals(corners).iter().map(|normal| 0.5 * normal.norm()).sum();
    let [a, b, c] = [1, 2, 3].map(|v| point(corners[v]) - point(corners[0]));
    let to_centre = a.norm_squared() * b.cross(&c)
        + b.norm_squared() * c.cross(&a)
        + c.norm_squared() * a.cross(&b);
    // inscribed = 3 V / area, circumscribed = |to_centre| / (12 V)
    let denominator = area * to_centre.norm();
    if denominator == 0.0 { 0.0 } else { 108.0 * volume * volume.abs() / denominator }
}

/// Outward normals of the four faces, twice the face's area long.
fn face_normals(corners: [[f64; 3]; 4]) -> [Vector3<f64>; 4] {
    FACES.map(|face| {
        let [a, b, c] = face.map(|v| point(corners[v]));
        (b - a).cross(&(c - a))
    })
}

fn point(p: [f64; 3]) -> Vector3<f64> {
    Vector3::from(p)
}

/// The smallest η of a mesh and the mean; infinite and not a number without tets.
/// A small part of the work of [`summarise`].
pub fn mean_ratio_range(mesh: &RawMesh) -> (f64, f64) {
    let chunk = |tets: &[[u32; 4]]| {
        let ratios = tets.iter().map(|&tet| mean_ratio(corners(&mesh.points, tet)));
        ratios.fold((f64::INFINITY, 0.0), |(min, sum), eta| (min.min(eta), sum + eta))
    };
    // Fixed chunks added in order: the same bits for any number of threads.
    let chunks: Vec<(f64, f64)> = mesh.tets.par_chunks(CHUNK).map(chunk).collect();
    let min = chunks.iter().map(|chunk| chunk.0).fold(f64::INFINITY, f64::min);
    (min, chunks.iter().map(|chunk| chunk.1).sum::<f64>() / mesh.tets.len() as f64)
}

/// The smallest η of a mesh; infinite without tets.
pub fn smallest_mean_ratio(mesh: &RawMesh) -> f64 {
    mean_ratio_range(mesh).0
}

/// η of every tet.
pub fn mean_ratios(mesh: &RawMesh) -> Vec<f64> {
    let ratio = |&tet: &[u32; 4]| mean_ratio(corners(&mesh.points, tet));
    mesh.tets.par_iter().with_min_len(CHUNK).map(ratio).collect()
}

/// Summarises the quality of a mesh; `None` if it has no tets. Vertex numbers
/// must be in range.
pub fn summarise(mesh: &RawMesh) -> Option<QualitySummary> {
    // Fixed chunks added in order: the same bits for any number of threads.
    let parts: Vec<QualitySummary> = mesh
        .tets
        .par_chunks(CHUNK)
        .enumerate()
        .map(|(chunk, tets)| {
            let mut sum = QualitySummary::EMPTY;
            for (i, tet) in tets.iter().enumerate() {
                sum.add(CHUNK * chunk + i, corners(&mesh.points, *tet));
            }
            sum
        })
        .collect();
    let mut total = parts.into_iter().reduce(QualitySummary::merge)?;
    total.eta.mean /= mesh.tets.len() as f64;
    total.radius_ratio.mean /= mesh.tets.len() as f64;
    total.dihedral_deg.mean /= 6.0 * mesh.tets.len() as f64;
    Some(total)
}

/// Until all is merged, means hold sums.
impl QualitySummary {
    const EMPTY: Self = Self {
        eta: Distribution::EMPTY,
        radius_ratio: Distribution::EMPTY,
        dihedral_deg: Distribution::EMPTY,
        worst_tet: 0,
    };

    fn add(&mut self, tet: usize, corners: [[f64; 3]; 4]) {
        let eta = mean_ratio(corners);
        if eta < self.eta.min {
            self.worst_tet = tet;
        }
        self.eta.add(eta, 1.0);
        self.radius_ratio.add(radius_ratio(corners), 1.0);
        for angle in dihedral_angles(corners) {
            self.dihedral_deg.add(angle, 180.0);
        }
    }

    fn merge(mut self, later: Self) -> Self {
        if later.eta.min < self.eta.min {
            self.worst_tet = later.worst_tet;
        }
        self.eta.merge(&later.eta);
        self.radius_ratio.merge(&later.radius_ratio);
        self.dihedral_deg.merge(&later.dihedral_deg);
        self
    }
}

impl<const BINS: usize> Distribution<BINS> {
    const EMPTY: Self =
        Self { min: f64::INFINITY, mean: 0.0, max: f64::NEG_INFINITY, histogram: [0; BINS] };

    fn add(&mut self, value: f64, upper: f64) {
        self.min = self.min.min(value);
        self.max = self.max.max(value);
        self.mean += value;
        let bin = (value.max(0.0) / upper * BINS as f64) as usize;
        self.histogram[bin.min(BINS - 1)] += 1;
    }

    fn merge(&mut self, later: &Self) {
        self.min = self.min.min(later.min);
        self.max = self.max.max(later.max);
        self.mean += later.mean;
        for (count, more) in self.histogram.iter_mut().zip(later.histogram) {
            *count += more;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::shapes::{five_tet_cube, regular_tet};

    const RIGHT_TET: [[f64; 3]; 4] =
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    #[test]
    fn a_regular_tet_has_ratio_one_and_its_dihedral_angle() {
        let corners = regular_tet().corners(0);
        assert!((mean_ratio(corners) - 1.0).abs() < 1e-14);
        assert!((radius_ratio(corners) - 1.0).abs() < 1e-14);
        for angle in dihedral_angles(corners) {
            assert!((angle - (1.0f64 / 3.0).acos().to_degrees()).abs() < 1e-12);
        }
    }

    #[test]
    fn the_right_tet_has_its_known_measures() {
        // V = 1/6, Σ L² = 9: η = 12 (1/2)^(2/3) / 9.
        assert!((mean_ratio(RIGHT_TET) - 12.0 * 0.25f64.cbrt() / 9.0).abs() < 1e-14);
        // r = 1 / (3 + √3), R = √3 / 2.
        let expected = 3.0 / (3.0 + 3.0f64.sqrt()) / (3.0f64.sqrt() / 2.0);
        assert!((radius_ratio(RIGHT_TET) - expected).abs() < 1e-14);
        let angles = dihedral_angles(RIGHT_TET);
        for edge in 0..3 {
            assert!((angles[edge] - 90.0).abs() < 1e-12, "edges along the axes");
            assert!((angles[edge + 3] - 3.0f64.sqrt().recip().acos().to_degrees()).abs() < 1e-12);
        }
    }

    #[test]
    fn inverted_and_flat_tets_are_told_apart() {
        let mut inverted = RIGHT_TET;
        inverted.swap(0, 1);
        assert_eq!(mean_ratio(inverted), -mean_ratio(RIGHT_TET));
        assert!(radius_ratio(inverted) < 0.0);
        let flat = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
        assert_eq!((mean_ratio(flat), radius_ratio(flat)), (0.0, 0.0));
        assert_eq!(mean_ratio([[1.0; 3]; 4]), 0.0);
    }

    #[test]
    fn the_five_tet_cube_has_wangs_values() {
        // Wang's thesis, table 3-7, for the cube itself: minimum .839947, mean .871958.
        let summary = summarise(five_tet_cube().raw()).unwrap();
        assert!((summary.eta.min - 0.839947).abs() < 5e-7);
        assert!((summary.eta.mean - 0.871958).abs() < 5e-7);
        assert_eq!(summary.worst_tet, 1);
        assert_eq!(summary.eta.histogram.iter().sum::<usize>(), 5);
        assert_eq!(summary.eta.histogram[8], 4);
        // Four corner tets: three right angles and three of acos(1/√3); the regular
        // tet in the middle has six of acos(1/3).
        let expected = (4.0 * 3.0 * (90.0 + 54.735610317) + 6.0 * 70.528779366) / 30.0;
        assert!((summary.dihedral_deg.mean - expected).abs() < 1e-8);
        assert_eq!(summary.dihedral_deg.histogram[5], 12);
        assert_eq!(summary.dihedral_deg.histogram[7], 6);
        assert!(summarise(&RawMesh::default()).is_none());
    }
}

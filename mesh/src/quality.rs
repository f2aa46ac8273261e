//! Shape measures of tets.

use nalgebra::Vector3;
use rayon::prelude::*;

use crate::chunks::CHUNK;
use crate::raw_mesh::RawMesh;
use crate::reference_tet::{EDGES, FACES, six_volumes};

/// How many equal bins the histogram of η has.
pub const BINS: usize = 10;

/// Quality measures of a whole mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct QualitySummary {
    /// Mean ratio η: smallest and mean; see [`mean_ratio`].
    pub eta_min: f64,
    /// The mean of η over all tets.
    pub eta_mean: f64,
    /// The tet with the smallest η, the first of equals.
    pub worst_tet: usize,
    /// The smallest angle between two faces of a tet, in degrees.
    pub dihedral_min_deg: f64,
    /// The largest angle between two faces of a tet, in degrees.
    pub dihedral_max_deg: f64,
    /// Smallest radius ratio; see [`radius_ratio`].
    pub radius_ratio_min: f64,
    /// The mean of the radius ratios.
    pub radius_ratio_mean: f64,
    /// How many tets have η in [i / 10, (i + 1) / 10); 1 counts in the last,
    /// inverted tets in the first.
    pub eta_histogram: [usize; BINS],
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
        let [c, d] = crate::reference_tet::opposite_ends(edge);
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

/// η of every tet.
pub fn mean_ratios(mesh: &RawMesh) -> Vec<f64> {
    let corners = |tet: &[u32; 4]| tet.map(|v| mesh.points[v as usize]);
    mesh.tets.par_iter().with_min_len(CHUNK).map(|tet| mean_ratio(corners(tet))).collect()
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
            let mut sum = EMPTY;
            for (i, tet) in tets.iter().enumerate() {
                sum.add(CHUNK * chunk + i, tet.map(|v| mesh.points[v as usize]));
            }
            sum
        })
        .collect();
    let mut total = parts.into_iter().reduce(QualitySummary::merge)?;
    total.eta_mean /= mesh.tets.len() as f64;
    total.radius_ratio_mean /= mesh.tets.len() as f64;
    Some(total)
}

const EMPTY: QualitySummary = QualitySummary {
    eta_min: f64::INFINITY,
    eta_mean: 0.0,
    worst_tet: 0,
    dihedral_min_deg: f64::INFINITY,
    dihedral_max_deg: f64::NEG_INFINITY,
    radius_ratio_min: f64::INFINITY,
    radius_ratio_mean: 0.0,
    eta_histogram: [0; BINS],
};

impl QualitySummary {
    fn add(&mut self, tet: usize, corners: [[f64; 3]; 4]) {
        let eta = mean_ratio(corners);
        if eta < self.eta_min {
            (self.eta_min, self.worst_tet) = (eta, tet);
        }
        self.eta_mean += eta;
        self.eta_histogram[((eta.max(0.0) * BINS as f64) as usize).min(BINS - 1)] += 1;
        for angle in dihedral_angles(corners) {
            self.dihedral_min_deg = self.dihedral_min_deg.min(angle);
            self.dihedral_max_deg = self.dihedral_max_deg.max(angle);
        }
        let ratio = radius_ratio(corners);
        self.radius_ratio_min = self.radius_ratio_min.min(ratio);
        self.radius_ratio_mean += ratio;
    }

    /// Means still hold sums here.
    fn merge(mut self, later: Self) -> Self {
        if later.eta_min < self.eta_min {
            (self.eta_min, self.worst_tet) = (later.eta_min, later.worst_tet);
        }
        self.eta_mean += later.eta_mean;
        self.dihedral_min_deg = self.dihedral_min_deg.min(later.dihedral_min_deg);
        self.dihedral_max_deg = self.dihedral_max_deg.max(later.dihedral_max_deg);
        self.radius_ratio_min = self.radius_ratio_min.min(later.radius_ratio_min);
        self.radius_ratio_mean += later.radius_ratio_mean;
        for (count, more) in self.eta_histogram.iter_mut().zip(later.eta_histogram) {
            *count += more;
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{five_tet_cube, regular_tet};

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
        assert!((summary.eta_min - 0.839947).abs() < 5e-7);
        assert!((summary.eta_mean - 0.871958).abs() < 5e-7);
        assert_eq!(summary.worst_tet, 1);
        assert_eq!(summary.eta_histogram.iter().sum::<usize>(), 5);
        assert_eq!(summary.eta_histogram[8], 4);
        assert!(summarise(&RawMesh::default()).is_none());
    }
}

//! What a description of a mesh holds.

use octruss_mesh::quality::QualitySummary;
use serde::Serialize;

use crate::report::FindingReport;

/// What `octruss info` tells. Tets and tagged simplices that name vertices
/// which do not exist are counted in `findings` alone.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Description {
    /// Points of the file.
    pub vertices: usize,
    /// Tets of the file.
    pub tets: usize,
    /// Edges of tets, tagged triangles and tagged edges.
    pub edges: usize,
    /// Faces of exactly one tet.
    pub boundary_faces: usize,
    /// Groups of tets.
    pub regions: Vec<Region>,
    /// Groups of triangles.
    pub surfaces: Vec<Surface>,
    /// The sum of the tets' signed volumes, in cubed mesh units.
    pub volume: f64,
    /// Parts that share no vertex.
    pub components: usize,
    /// None without tets.
    pub quality: Option<Quality>,
    /// Fields on vertices.
    pub point_fields: Vec<FieldReport>,
    /// Fields on tets.
    pub cell_fields: Vec<FieldReport>,
    /// Fields with a value for each corner of each tet.
    pub corner_fields: Vec<FieldReport>,
    /// Only what is wrong or remarkable.
    pub findings: Vec<FindingReport>,
    /// What the reader left out or changed.
    pub notes: Vec<String>,
}

/// A group of tets.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Region {
    /// The name, or the id in digits.
    pub name: String,
    /// The number by which tets refer to it.
    pub id: i32,
    /// How many tets belong to it.
    pub count: usize,
    /// Their signed volume.
    pub volume: f64,
}

/// A group of triangles.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Surface {
    /// The name, or the id in digits.
    pub name: String,
    /// The number by which triangles refer to it.
    pub id: i32,
    /// How many triangles belong to it.
    pub count: usize,
    /// Their area.
    pub area: f64,
}

/// The shapes of all tets.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Quality {
    /// The worst mean ratio η: 1 regular, 0 flat, negative inverted.
    pub eta_min: f64,
    /// The mean of η.
    pub eta_mean: f64,
    /// How many tets have η in each tenth from 0 to 1.
    pub eta_histogram: Vec<usize>,
    /// The smallest angle between two faces of a tet, in degrees.
    pub dihedral_min_deg: f64,
    /// The mean of these angles.
    pub dihedral_mean_deg: f64,
    /// The greatest.
    pub dihedral_max_deg: f64,
    /// How many of them lie in each ten degrees from 0 to 180.
    pub dihedral_histogram: Vec<usize>,
    /// The worst radius ratio.
    pub radius_ratio_min: f64,
    /// The mean of the radius ratios.
    pub radius_ratio_mean: f64,
    /// How many tets have a radius ratio in each tenth from 0 to 1.
    pub radius_ratio_histogram: Vec<usize>,
}

/// A field by name.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FieldReport {
    /// The name.
    pub name: String,
    /// Values a vertex or tet.
    pub components: usize,
}

impl From<QualitySummary> for Quality {
    fn from(summary: QualitySummary) -> Self {
        Self {
            eta_min: summary.eta.min,
            eta_mean: summary.eta.mean,
            eta_histogram: summary.eta.histogram.to_vec(),
            dihedral_min_deg: summary.dihedral_deg.min,
            dihedral_mean_deg: summary.dihedral_deg.mean,
            dihedral_max_deg: summary.dihedral_deg.max,
            dihedral_histogram: summary.dihedral_deg.histogram.to_vec(),
            radius_ratio_min: summary.radius_ratio.min,
            radius_ratio_mean: summary.radius_ratio.mean,
            radius_ratio_histogram: summary.radius_ratio.histogram.to_vec(),
        }
    }
}

//! Refining the mesh, level by level.

use octruss_mesh::quality::{QualitySummary, summarise};
use octruss_mesh::{FeatureOptions, Scheme, TetMesh};
use serde::{Deserialize, Serialize};

use super::Context;
use super::groups::group_ids;
use crate::amount::short;
use crate::error::Error;
use crate::recipe::{Degrees, SchemeName};
use crate::state::State;

/// Refines every tet into eight, some times over. What stays sharp is found
/// once, on the coarsest mesh: a second such stage inherits it from the first.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct Subdivide {
    /// The weights that move the vertices.
    pub scheme: SchemeName,
    /// How many times.
    pub levels: u8,
    /// Edges stay sharp where outward normals differ by more, in degrees; 180 for none.
    pub crease_angle: Degrees,
    /// Curve groups stay sharp.
    pub group_curves: bool,
    /// Point groups stay where they are.
    pub group_points: bool,
    /// Borders between surface groups stay sharp.
    pub group_borders: bool,
    /// Surface groups inside a region that are refined as surfaces, by name.
    pub surfaces: Vec<String>,
}

/// All levels, the coarsest first.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SubdivideReport {
    /// The scheme's name.
    pub scheme: &'static str,
    /// Vertices of the finest level.
    pub vertices: usize,
    /// Tets of the finest level.
    pub tets: usize,
    /// One a level.
    pub levels: Vec<LevelReport>,
}

/// One level.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LevelReport {
    /// Vertices.
    pub vertices: usize,
    /// Tets.
    pub tets: usize,
    /// The worst mean ratio η of a tet: 1 regular, 0 flat.
    pub eta_min: f64,
    /// The mean of η.
    pub eta_mean: f64,
}

impl Default for Subdivide {
    fn default() -> Self {
        let features = FeatureOptions::default();
        Self {
            scheme: SchemeName(Scheme::BoxSpline),
            levels: 1,
            crease_angle: Degrees(features.crease_angle),
            group_curves: features.group_curves,
            group_points: features.group_points,
            group_borders: features.group_borders,
            surfaces: Vec::new(),
        }
    }
}

impl Subdivide {
    pub(super) fn run(
        &self,
        state: &mut State,
        context: &Context,
    ) -> Result<SubdivideReport, Error> {
        let mesh = state.finest().ok_or_else(|| context.order("check"))?;
        let features = self.feature_options(mesh, context)?;
        state.levels(&features);
        let mut levels = vec![level_report(state, context)?];
        for number in 1..=usize::from(self.levels) {
            let what = format!("level {number} of {}", self.levels);
            let level = context
                .progress
                .step(number, self.levels.into(), &what, || self.add_level(state, context))?;
            levels.push(level);
        }
        let finest = &levels[levels.len() - 1];
        let (vertices, tets) = (finest.vertices, finest.tets);
        Ok(SubdivideReport { scheme: self.scheme.0.name(), vertices, tets, levels })
    }

    fn add_level(
        &self,
        state: &mut State,
        context: &Context,
    ) -> Result<(LevelReport, String), Error> {
        state
            .refine(self.scheme.0)
            .map_err(|source| Error::Subdivide { stage: context.progress.label.into(), source })?;
        let report = level_report(state, context)?;
        let tets = format!("{} tets", short(report.tets));
        Ok((report, tets))
    }

    fn feature_options(&self, mesh: &TetMesh, context: &Context) -> Result<FeatureOptions, Error> {
        let mut surfaces = Vec::new();
        for name in &self.surfaces {
            let ids = group_ids(mesh.raw(), 2, name).map_err(|text| context.request(text))?;
            surfaces.extend(ids);
        }
        Ok(FeatureOptions {
            crease_angle: self.crease_angle.0,
            group_curves: self.group_curves,
            group_points: self.group_points,
            group_borders: self.group_borders,
            surfaces,
            ..FeatureOptions::default()
        })
    }
}

fn level_report(state: &State, context: &Context) -> Result<LevelReport, Error> {
    let mesh = state.finest().ok_or_else(|| context.order("check"))?;
    let quality = summarise(mesh.raw());
    let eta = |of: fn(&QualitySummary) -> f64| quality.as_ref().map_or(f64::NAN, of);
    Ok(LevelReport {
        vertices: mesh.points().len(),
        tets: mesh.tets().len(),
        eta_min: eta(|quality| quality.eta.min),
        eta_mean: eta(|quality| quality.eta.mean),
    })
}

impl SubdivideReport {
    pub(super) fn summary(&self) -> String {
        let (vertices, tets) = (short(self.vertices), short(self.tets));
        format!("{} scheme: {vertices} vertices, {tets} tets", self.scheme)
    }
}

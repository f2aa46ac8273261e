//! Refining the mesh, level by level.

use octruss_base::choice::Named;
use octruss_mesh::guard::usual_floor;
use octruss_mesh::{
    Diagonal, ExtraFeatures, FeatureOptions, Marking, Overshoot, Scheme, Step, TetMesh, Topology,
    marking_report,
};
use octruss_mesh::{MAX_TETS, most_levels};
use serde::Deserialize;
use toml::Spanned;

use super::context::Context;
use super::field_notes::field_notes;
use super::groups::group_ids;
use super::jumps::start_jumps;
use crate::error::Error;
use crate::options::{Degrees, Ends, Fraction, GroupBordersKey, MinQuality, SchemeName};
use crate::report::{CarriedFields, LevelReport, StrataCounts, SubdivideReport};
use crate::state::{RefineError, State};

/// Refines every tet into eight, some times over. The marking and what stays
/// sharp are found once, on the coarsest mesh: a second such stage, or a mesh
/// that was written by an earlier run, has them already, and the options about
/// them (from `marking` to `extra_corners`) then have no effect.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct Subdivide {
    /// The weights that move the vertices.
    pub scheme: SchemeName,
    /// How many times.
    pub levels: u8,
    /// The tension of the interpolatory schemes, 1/16 unless given.
    pub tension: Option<Fraction>,
    /// The weight of an interior vertex itself in `loop-solid`, 0.8 unless given.
    pub interior: Option<Fraction>,
    /// Which inner diagonal splits a tet.
    pub diagonal: Named<Diagonal>,
    /// Keep the mean ratio η above this by pulling vertices back towards the
    /// linear rule; half of the smallest that the coarsest mesh has unless given,
    /// `off` for no such guard.
    pub min_quality: Option<MinQuality>,
    /// Fields on vertices or tets that may jump between regions, by name: each is
    /// carried for every region by itself. Those that the file gives at the corners
    /// of each tet are carried so without being named.
    pub jumps: Vec<Spanned<String>>,
    /// Keep each value of a field within the range of those it is made from;
    /// positions are never clamped.
    pub clamp: bool,
    /// How the marked pair of each coarse tet is chosen; `shortest` unless given.
    pub marking: Option<Named<Marking>>,
    /// Edges stay sharp where outward normals differ by more, in degrees; 180
    /// for none, 40 unless given.
    pub crease_angle: Option<Degrees>,
    /// Curve groups stay sharp; true unless given.
    pub group_curves: Option<bool>,
    /// Point groups stay where they are; true unless given.
    pub group_points: Option<bool>,
    /// Borders between surface groups stay sharp: `flat` (those across which the surface
    /// is flat) unless given, `all` or true, `none` or false.
    pub group_borders: Option<GroupBordersKey>,
    /// Surface groups inside a region that are refined as surfaces, by name.
    pub surfaces: Option<Vec<Spanned<String>>>,
    /// Edges that stay sharp, by their ends: vertices of the checked mesh, from 0, in
    /// the order of the file.
    pub extra_creases: Option<Vec<Ends>>,
    /// Vertices of the checked mesh that stay where they are, from 0, in the order of
    /// the file.
    pub extra_corners: Option<Vec<u32>>,
}

impl Default for Subdivide {
    fn default() -> Self {
        Self {
            scheme: Named(Scheme::BoxSpline),
            levels: 1,
            tension: None,
            interior: None,
            diagonal: Named(Diagonal::default()),
            min_quality: None,
            jumps: Vec::new(),
            clamp: false,
            marking: None,
            crease_angle: None,
            group_curves: None,
            group_points: None,
            group_borders: None,
            surfaces: None,
            extra_creases: None,
            extra_corners: None,
        }
    }
}

/// The keys of those of these fields that are given: a key is the name of its field, as
/// serde spells it.
macro_rules! given_keys {
    ($options:expr, $($field:ident),+ $(,)?) => {{
        let fields = [$((stringify!($field), $options.$field.is_some())),+];
        let given = fields.into_iter().filter(|(_, is_given)| *is_given);
        given.map(|(field, _)| field.replace('_', "-")).collect::<Vec<_>>()
    }};
}

impl Subdivide {
    pub(super) fn run(
        &self,
        state: &mut State,
        context: &Context,
    ) -> Result<SubdivideReport, Error> {
        let mesh = context.needed(state.mesh.finest())?;
        self.refuse_too_many(mesh.tets().len(), context)?;
        let mut notes = self.without_effect(mesh);
        let features = self.feature_options(mesh, context)?;
        // A mesh with features is marked already.
        let unmarked = mesh.features().is_none();
        let unmarked = unmarked.then(|| marking_report(&Topology::new(mesh.raw())));
        notes.extend(start_jumps(&self.jumps, state, context)?);
        notes.extend(field_notes(state, self.levels));
        context.remark(&notes);
        context.needed(state.levels(&features))?;
        let hierarchy = context.needed(state.mesh.levels())?;
        let reasons = Some(&state.feature_reasons).filter(|_| hierarchy.transfers() == 0);
        let strata = StrataCounts::of_finest(hierarchy, reasons);
        let mut report = SubdivideReport::new(self.scheme(), hierarchy, unmarked, strata);
        report.notes = notes;
        let mut clamped = 0;
        for number in 1..=usize::from(self.levels) {
            let what = format!("level {number} of {}", self.levels);
            let (level, more) = context
                .step(number, self.levels.into(), &what, || self.add_level(state, context))?;
            report.add(level);
            clamped += more;
        }
        report.fields = CarriedFields::of(state, self.clamp.then_some(clamped));
        Ok(report)
    }

    fn add_level(
        &self,
        state: &mut State,
        context: &Context,
    ) -> Result<((LevelReport, usize), String), Error> {
        let overshoot = if self.clamp { Overshoot::Clamp } else { Overshoot::Allow };
        let finest = context.needed(state.mesh.finest())?;
        let step = self.step(finest);
        let clamped = match state.refine(step, overshoot) {
            Ok(clamped) => clamped,
            Err(RefineError::Missing(missing)) => return context.needed(Err(missing)),
            Err(RefineError::Subdivide(source)) => {
                return Err(Error::Subdivide { stage: context.stage.label.clone(), source });
            }
        };
        let hierarchy = context.needed(state.mesh.levels())?;
        let report = LevelReport::of_finest(hierarchy);
        let result = report.result();
        Ok(((report, clamped), result))
    }

    /// Parameters of a scheme other than the one chosen.
    pub(super) fn contradiction(&self) -> Option<String> {
        let scheme = self.scheme.0;
        let wrong = |key: &str, owner: &str| {
            Some(format!("`{key}` belongs to {owner}, but `scheme` is `{}`", scheme.name()))
        };
        match (scheme, self.tension, self.interior) {
            (Scheme::Interpolatory { .. }, _, None) | (Scheme::LoopSolid { .. }, None, _) => None,
            (_, None, None) => None,
            (Scheme::Interpolatory { .. }, ..) | (_, None, Some(_)) => {
                wrong("interior", "`loop-solid`")
            }
            _ => wrong("tension", "`interpolatory` and `interpolatory-literal`"),
        }
    }

    /// The scheme with its parameters.
    pub(crate) fn scheme(&self) -> Scheme {
        match self.scheme.0 {
            Scheme::Interpolatory { tension, marked } => {
                Scheme::Interpolatory { tension: self.tension.map_or(tension, |w| w.0), marked }
            }
            Scheme::LoopSolid { interior } => {
                Scheme::LoopSolid { interior: self.interior.map_or(interior, |c| c.0) }
            }
            other => other,
        }
    }

    fn step(&self, coarse: &TetMesh) -> Step {
        let min_quality = match self.min_quality {
            // The linear rule is what the guard would pull back to.
            _ if self.scheme.0 == Scheme::Linear => None,
            Some(MinQuality::Off) => None,
            Some(MinQuality::Floor(eta)) => Some(eta),
            None => Some(usual_floor(coarse)),
        };
        Step { diagonal: self.diagonal.0, min_quality, ..self.scheme().into() }
    }

    /// Before any level is made: the last one is the one that does not fit.
    fn refuse_too_many(&self, tets: usize, context: &Context) -> Result<(), Error> {
        let most = most_levels(tets);
        if u32::from(self.levels) <= most {
            return Ok(());
        }
        let levels = self.levels;
        Err(context.request(format!(
            "levels = {levels} would make {tets} · 8^{levels} tets, more than the {MAX_TETS} that \
             can be numbered; at most {most} levels fit"
        )))
    }

    /// Notes about options that come too late, or that this scheme has no use for.
    fn without_effect(&self, mesh: &TetMesh) -> Vec<String> {
        let given = given_keys!(
            self,
            marking,
            crease_angle,
            group_curves,
            group_points,
            group_borders,
            surfaces,
            extra_creases,
            extra_corners,
        );
        let mut notes = Vec::new();
        if mesh.features().is_some() && !given.is_empty() {
            let given = given.join(", ");
            notes.push(format!(
                "what stays sharp is recorded, in the file or earlier: {given} without effect"
            ));
        }
        if self.clamp && !self.scheme().overshoots() {
            notes.push(format!(
                "no weight of the {} scheme is negative: clamp without effect",
                self.scheme().name()
            ));
        }
        notes
    }

    fn feature_options(&self, mesh: &TetMesh, context: &Context) -> Result<FeatureOptions, Error> {
        let mut surfaces = Vec::new();
        for name in self.surfaces.iter().flatten() {
            surfaces.extend(group_ids(mesh.raw(), 2, name, context)?);
        }
        let creases: Vec<[u32; 2]> =
            self.extra_creases.iter().flatten().map(|&Ends(ends)| ends).collect();
        let corners = self.extra_corners.as_deref().unwrap_or_default();
        let extra = ExtraFeatures::new(mesh, &creases, corners)
            .map_err(|error| context.request(error.to_string()))?;
        let defaults = FeatureOptions::default();
        Ok(FeatureOptions {
            marking: self.marking.map_or(defaults.marking, |marking| marking.0),
            crease_angle: self.crease_angle.map_or(defaults.crease_angle, |angle| angle.0),
            group_curves: self.group_curves.unwrap_or(defaults.group_curves),
            group_points: self.group_points.unwrap_or(defaults.group_points),
            group_borders: self.group_borders.map_or(defaults.group_borders, |key| key.0),
            surfaces,
            mirrors: defaults.mirrors,
            extra,
        })
    }
}

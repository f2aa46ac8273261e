//! What stays sharp, from the keys of the stage.

use octruss_mesh::{ExtraFeatures, FeatureOptions, Mirrors, Scheme, TetMesh, mirror_candidates};

use super::keys::Subdivide;
use crate::error::Error;
use crate::options::Ends;
use crate::stages::context::Context;
use crate::stages::groups::group_ids;

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
    /// Notes about options that come too late, or that this scheme has no use for.
    pub(super) fn without_effect(&self, mesh: &TetMesh) -> Vec<String> {
        let given = given_keys!(
            self,
            marking,
            crease_angle,
            group_curves,
            group_points,
            group_borders,
            surfaces,
            mirror,
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
        if self.scheme().keeps_vertices() {
            let given = [
                ("interpolate", self.interpolate == Some(true)),
                ("project-limit", self.project_limit),
                ("curve-ends", self.curve_ends.is_some()),
            ];
            for (key, _) in given.into_iter().filter(|(_, is_given)| *is_given) {
                notes.push(format!(
                    "the {} scheme keeps vertices: {key} without effect",
                    self.scheme().name()
                ));
            }
        }
        if self.clamp && !self.step(mesh, true).overshoots() {
            notes.push(format!(
                "no weight of the {} scheme is negative: clamp without effect",
                self.scheme().name()
            ));
        }
        notes
    }

    pub(super) fn feature_options(
        &self,
        mesh: &TetMesh,
        context: &Context,
    ) -> Result<FeatureOptions, Error> {
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
            mirrors: self.mirrors(mesh, context)?,
            extra,
        })
    }
    fn mirrors(&self, mesh: &TetMesh, context: &Context) -> Result<Mirrors, Error> {
        // Those that are recorded count.
        if mesh.features().is_some() {
            return Ok(Mirrors::default());
        }
        let mut groups = Vec::new();
        for name in self.mirror.iter().flatten() {
            groups.extend(group_ids(mesh.raw(), 2, name, context)?);
        }
        Mirrors::new(mesh, &groups).map_err(|error| context.request(error.to_string()))
    }

    /// A note about surfaces that look like planes of symmetry, where nothing is known of any.
    pub(super) fn proposed_mirrors(&self, mesh: &TetMesh) -> Option<String> {
        if self.scheme() == Scheme::Linear || self.mirror.is_some() || mesh.features().is_some() {
            return None;
        }
        let found = mirror_candidates(mesh).into_iter();
        let mut names: Vec<String> = found.map(|id| mesh.raw().group_name(2, id)).collect();
        names.sort();
        names.dedup();
        let (first, more) = names.split_first()?;
        let named = more.iter().fold(format!("`{first}`"), |all, name| format!("{all}, `{name}`"));
        Some(format!(
            "flat, with round surfaces that end there at right angles: {named}; where this is a \
             plane of symmetry, name it in `mirror`, and they go on as if reflected"
        ))
    }
}

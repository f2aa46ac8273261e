//! What the stage takes.

use octruss_base::choice::Named;
use octruss_mesh::{CurveEnds, Diagonal, Marking, Scheme};
use serde::Deserialize;
use toml::Spanned;

use crate::options::{Degrees, Ends, Fraction, GroupBordersKey, MinQuality, SchemeName};

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
    /// Let the smooth surface pass through the boundary vertices of the mesh that is refined
    /// first, which then stay; `false` for the published scheme, which moves them. True
    /// unless given, and of no effect where a scheme keeps vertices; a mesh that was refined
    /// without goes on without.
    pub interpolate: Option<bool>,
    /// Put the boundary vertices of the last level onto the limit of further ones. Unless
    /// `interpolate` is false they are nearly there.
    pub project_limit: bool,
    /// The rule where curves end at corners: `parabola` where the surface passes through the
    /// input unless given, else `fixed`.
    pub curve_ends: Option<Named<CurveEnds>>,
    /// Flat surface groups that are planes of symmetry, by name: curves and surfaces that end
    /// there go on as if reflected.
    pub mirror: Option<Vec<Spanned<String>>>,
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
            interpolate: None,
            project_limit: false,
            curve_ends: None,
            mirror: None,
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

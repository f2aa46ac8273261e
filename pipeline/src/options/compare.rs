//! What is compared: the table `[compare]` of a config.

use std::num::NonZeroU8;

use octruss_base::choice::{Auto, Choice, Named};
use octruss_fem::{CoarseOperator, Prolongations, Sweeps};
use octruss_mesh::{AffineCorrection, InterfaceRows};
use octruss_solver::Smoother;
use serde::Deserialize;

use super::several::Several;

/// How the coarse mesh is refined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Geometry {
    /// At midpoints: the shape stays.
    Flat,
    /// By the scheme of the stage `subdivide`.
    Subdivided,
}

impl Choice for Geometry {
    const WHAT: &'static str = "geometry";
    const ALL: &'static [Self] = &[Self::Flat, Self::Subdivided];
    fn name(self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::Subdivided => "subdivided",
        }
    }
}

/// Everything that is varied: every list times every other. A list that is not given
/// holds what the stage `solve` says.
#[derive(Debug, Clone, PartialEq, Deserialize, Default)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct Compare {
    /// Both, unless given; the flat one alone if the scheme is linear.
    pub geometry: Option<Several<Named<Geometry>>>,
    /// Which levels are solved, the input being 0; all above it unless given.
    pub levels: Option<Several<NonZeroU8>>,
    /// What prolongs.
    pub prolongation: Option<Several<Prolongations>>,
    /// Which rows are made exact for linear functions.
    pub affine_correction: Option<Several<Named<AffineCorrection>>>,
    /// What rows on interfaces read.
    pub interface_rows: Option<Several<Named<InterfaceRows>>>,
    /// Where coarse matrices come from.
    pub coarse_operator: Option<Several<Named<CoarseOperator>>>,
    /// Smoothing sweeps before and after each coarse correction.
    pub sweeps: Option<Several<Sweeps>>,
    /// What a smoothing sweep is.
    pub smoother: Option<Several<Auto<Smoother>>>,
    /// How often each is set up and solved, for the spread of times; 3 unless given.
    pub repeats: Option<NonZeroU8>,
}

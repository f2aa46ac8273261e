//! What is compared: the table `[compare]` of a config.

use std::num::NonZeroU8;

use octruss_mesh::{AffineCorrection, InterfaceRows, Scheme};
use octruss_solver::Smoother;
use serde::Deserialize;

use octruss_fem::{CoarseOperator, Prolongations, Sweeps};

use crate::recipe::{Auto, Choice, Named, Several};
use crate::stages::Solve;

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

impl Compare {
    /// The geometries; by the linear scheme both are the same.
    pub(super) fn geometries(&self, scheme: Scheme) -> Vec<Geometry> {
        match &self.geometry {
            Some(given) => given.iter().map(|Named(geometry)| *geometry).collect(),
            None if scheme == Scheme::Linear => vec![Geometry::Flat],
            None => Geometry::ALL.to_vec(),
        }
    }

    /// The levels to solve on, of `most`, finest first.
    ///
    /// # Errors
    /// A level that is not made.
    pub(super) fn levels(&self, most: u8) -> Result<Vec<usize>, String> {
        if most == 0 {
            return Err("stage `subdivide` makes no level: set `levels` to at least 1".into());
        }
        let Some(given) = &self.levels else { return Ok((1..=most.into()).rev().collect()) };
        let mut levels: Vec<usize> = given.iter().map(|level| level.get().into()).collect();
        levels.sort_unstable_by(|a, b| b.cmp(a));
        match levels.first() {
            Some(&finest) if finest > most.into() => Err(format!(
                "`compare.levels` names level {finest}, but stage `subdivide` makes {most}"
            )),
            _ => Ok(levels),
        }
    }

    pub(super) fn repeats(&self) -> usize {
        self.repeats.map_or(3, |repeats| repeats.get().into())
    }

    /// The solves to compare, each with one prolongation.
    pub(super) fn variants(&self, solve: &Solve) -> Vec<Solve> {
        let mut variants = vec![solve.clone()];
        vary(&mut variants, &self.smoother, |solve, one| solve.options.smoother = one.0);
        vary(&mut variants, &self.sweeps, |solve, one| solve.options.sweeps = *one);
        let prolongations = self.prolongation.as_ref().unwrap_or(&solve.prolongation);
        vary(&mut variants, &Some(prolongations.clone()), |solve, one| {
            solve.prolongation = [*one].into();
        });
        vary(&mut variants, &self.interface_rows, |solve, one| {
            solve.options.interface_rows = one.0
        });
        vary(&mut variants, &self.affine_correction, |solve, one| {
            solve.options.affine_correction = one.0
        });
        vary(&mut variants, &self.coarse_operator, |solve, one| {
            solve.options.coarse_operator = one.0
        });
        variants
    }
}

/// Each variant once for each choice, if there are choices.
fn vary<T>(variants: &mut Vec<Solve>, choices: &Option<Several<T>>, set: impl Fn(&mut Solve, &T)) {
    let Some(choices) = choices else { return };
    let with = |(variant, choice): (&Solve, &T)| {
        let mut variant = variant.clone();
        set(&mut variant, choice);
        variant
    };
    let pairs = variants.iter().flat_map(|variant| choices.iter().map(move |one| (variant, one)));
    *variants = pairs.map(with).collect();
}

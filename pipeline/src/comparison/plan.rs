//! What a table `[compare]` comes to, with the stages that it varies.

use octruss_base::choice::{Choice, Named};
use octruss_fem::Prolongations;
use octruss_mesh::Scheme;

use crate::options::{Compare, Geometry, Several};
use crate::stages::Solve;

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

    /// The solves to compare, each with one prolongation; if none is named anywhere, with
    /// that of the mission and its baseline.
    pub(super) fn variants(&self, solve: &Solve) -> Vec<Solve> {
        let mut variants = vec![solve.clone()];
        vary(&mut variants, &self.smoother, |solve, one| solve.options.smoother = one.0);
        vary(&mut variants, &self.sweeps, |solve, one| solve.options.sweeps = *one);
        let named = self.prolongation.as_ref().or(solve.prolongation.as_ref()).cloned();
        let usual = || [Scheme::BoxSpline, Scheme::Linear].map(Prolongations::from).into();
        vary(&mut variants, &Some(named.unwrap_or_else(usual)), |solve, one| {
            solve.prolongation = Some([*one].into());
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

//! Refining the mesh, level by level.

use octruss_mesh::{MAX_TETS, Overshoot, Topology, marking_report, most_levels};

use super::keys::Subdivide;
use crate::error::Error;
use crate::report::{
    AT_LIMIT, CarriedFields, LevelReport, LimitFigures, StrataCounts, SubdivideReport,
};
use crate::stages::context::Context;
use crate::stages::field_notes::field_notes;
use crate::stages::jumps::start_jumps;
use crate::state::{RefineError, State};

/// The share of its volume by which a body may change without a note.
const WORTH_A_NOTE: f64 = 0.01;

impl Subdivide {
    pub(in crate::stages) fn run(
        &self,
        state: &mut State,
        context: &Context,
    ) -> Result<SubdivideReport, Error> {
        let mesh = context.needed(state.mesh.finest())?;
        self.refuse_too_many(mesh.tets().len(), context)?;
        let mut notes = self.without_effect(mesh);
        notes.extend(self.proposed_mirrors(mesh));
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
            let (level, more) = context.step(number, self.levels.into(), &what, || {
                self.add_level(state, number == usize::from(self.levels), context)
            })?;
            report.add(level);
            clamped += more;
        }
        let late = self.late_notes(&report.levels);
        context.remark(&late);
        report.notes.extend(late);
        report.fields = CarriedFields::of(state, self.clamp.then_some(clamped));
        Ok(report)
    }

    fn add_level(
        &self,
        state: &mut State,
        is_last: bool,
        context: &Context,
    ) -> Result<((LevelReport, usize), String), Error> {
        let overshoot = if self.clamp { Overshoot::Clamp } else { Overshoot::Allow };
        let finest = context.needed(state.mesh.finest())?;
        let step = self.step(finest, is_last);
        let clamped = match state.refine(step, overshoot) {
            Ok(clamped) => clamped,
            Err(RefineError::Missing(missing)) => return context.needed(Err(missing)),
            Err(RefineError::Subdivide(source)) => {
                return Err(Error::Subdivide { stage: context.stage.label.clone(), source });
            }
        };
        let hierarchy = context.needed(state.mesh.levels())?;
        let limit = LimitFigures::of_finest(hierarchy, step);
        let report = LevelReport { limit, ..LevelReport::of_finest(hierarchy) };
        let result = report.result();
        Ok(((report, clamped), result))
    }

    /// Notes about what only the levels tell, the one that the stage began with first.
    fn late_notes(&self, levels: &[LevelReport]) -> Vec<String> {
        let (first, last) = (&levels[0], &levels[levels.len() - 1]);
        let mut notes = Vec::new();
        if let (Some(before), Some(after)) = (first.volume, last.volume)
            && last.interpolation.is_none()
            && !self.scheme().keeps_vertices()
            && (after / before - 1.0).abs() > WORTH_A_NOTE
        {
            let (percent, scheme) = (100.0 * (after / before - 1.0), self.scheme().name());
            notes.push(format!(
                "the volume changed by {percent:+.1} %, since the {scheme} scheme moves the \
                 boundary; with `interpolate = true` from the input on the surface passes through \
                 its vertices"
            ));
        }
        let at_limit = |level: &&LevelReport| {
            level.interpolation.as_ref().is_some_and(|made| made.placement == AT_LIMIT)
        };
        if levels.iter().any(|level| at_limit(&level)) {
            notes.push(
                "along normals the guard would pull more boundary vertices back, as in thin walls: \
                 they go to the limit itself, and vertices inside follow the scheme, old ones, \
                 too"
                    .into(),
            );
        }
        let made = levels.iter().filter_map(|level| level.interpolation.as_ref());
        if let Some(missed) = made.clone().find(|made| !made.has_converged) {
            notes.push(format!(
                "the smooth surface passes by vertices of the input by up to {:.1e}: control points \
                 were not found in the iterations that are allowed; look for badly shaped boundary \
                 triangles",
                missed.residual
            ));
        }
        let inexact: usize = made.map(|made| made.inexact_rows).sum();
        if inexact > 0 {
            notes.push(format!(
                "{inexact} rows of the prolongation could not be made exact for linear functions: \
                 solves may take more iterations"
            ));
        }
        notes
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
}

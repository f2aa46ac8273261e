//! Refining the mesh, level by level.

use octruss_mesh::{MAX_TETS, Overshoot, Topology, marking_report, most_levels};

use super::keys::Subdivide;
use crate::error::Error;
use crate::report::{CarriedFields, LevelReport, StrataCounts, SubdivideReport};
use crate::stages::context::Context;
use crate::stages::field_notes::field_notes;
use crate::stages::jumps::start_jumps;
use crate::state::{RefineError, State};

impl Subdivide {
    pub(in crate::stages) fn run(
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

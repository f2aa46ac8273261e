//! `octruss refine`: a mesh file into a finer one.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use octruss::Error;
use octruss::options::{Degrees, GroupBordersKey, MinQuality, SchemeName};
use octruss::output::write_with_surfaces;
use octruss::run::run_stages;
use octruss::stages::{Check, Import, Stage, Subdivide, Workplace};
use octruss_base::choice::Named;
use octruss_mesh::{CurveEnds, Diagonal, Marking};
use octruss_meshio::{Dataset, check_target};
use toml::Spanned;

use crate::cli::display::Display;
use crate::cli::say::say;
use crate::cli::threads::Threads;

/// Refine a mesh: every tet into eight, N times over
#[derive(clap::Args)]
#[command(after_help = "Example:\n  \
    octruss refine part.msh part.vtu --scheme box-spline --levels 2 --crease-angle 30\n\n\
    What stays sharp is found once, on the mesh given, and recorded in a .vtu: refining\n\
    that again by one level equals refining by two at once. Tagged surfaces go beside\n\
    a .vtu, as NAME.surfaces.vtu. The mesh is numbered anew; the fields input-vertex (-1:\n\
    made by refining) and input-tet tell where each vertex and tet is in IN, from 0.")]
pub struct Refine {
    /// Mesh to read
    #[arg(value_name = "IN")]
    input: PathBuf,
    /// File to write: .vtu keeps everything, .vtk has no room for names and features,
    /// .mesh none for fields and point groups either
    #[arg(value_name = "OUT")]
    output: PathBuf,
    /// The weights: linear keeps the shape, interpolatory and interpolatory-literal the
    /// vertices; box-spline, averaged and loop-solid smooth
    #[arg(long)]
    scheme: SchemeName,
    /// How many times
    #[arg(long, value_name = "N")]
    levels: u8,
    /// Let the smooth surface pass through the vertices of the boundary, which then stay;
    /// =false for the published scheme, which moves them and loses volume; a file that was
    /// refined so goes on so [default: true]
    #[arg(long, value_name = "BOOL", num_args = 0..=1, require_equals = true,
          default_missing_value = "true")]
    interpolate: Option<bool>,
    /// Put the boundary vertices of the last level onto the limit of further ones; unless
    /// --interpolate=false they are nearly there
    #[arg(long)]
    project_limit: bool,
    /// The rule where curves end at corners: parabola or fixed [default: parabola with
    /// --interpolate, else fixed]
    #[arg(long, value_name = "RULE")]
    curve_ends: Option<Named<CurveEnds>>,
    /// A flat surface that is a plane of symmetry, by name; may be given several times:
    /// what ends there goes on as if reflected
    #[arg(long, value_name = "SURFACE")]
    mirror: Vec<String>,
    /// Edges stay sharp where outward normals differ by more; 180 for none by angle (curve
    /// groups and where surfaces meet stay) [default: 40]
    #[arg(long, value_name = "DEG")]
    crease_angle: Option<Degrees>,
    /// Which borders between surface groups stay sharp below that angle: flat (those across
    /// which the surface is flat), all or none [default: flat]
    #[arg(long, value_name = "WHICH")]
    group_borders: Option<GroupBordersKey>,
    /// How marked pairs are chosen: shortest, agree, breadth-first or as-ordered
    /// [default: shortest]
    #[arg(long)]
    marking: Option<Named<Marking>>,
    /// Which diagonal splits a tet: inherit or shortest-each-level [default: inherit]
    #[arg(long)]
    diagonal: Option<Named<Diagonal>>,
    /// Keep the mean ratio of tets above this by pulling vertices back towards the
    /// linear rule; off for no such guard [default: half of the input's smallest]
    #[arg(long, value_name = "ETA|off")]
    min_quality: Option<MinQuality>,
    /// Turn inverted tets over instead of refusing them
    #[arg(long)]
    reorient: bool,
    #[command(flatten)]
    threads: Threads,
    /// No progress on stderr; notes and errors stay
    #[arg(long)]
    quiet: bool,
}

impl Refine {
    pub fn run(&self) -> anyhow::Result<()> {
        let format = check_target(&self.output)?;
        let refined = self.threads.install(|| self.refined())??;
        for loss in format.losses(&refined) {
            say(&format!("note: {loss}"));
        }
        write_with_surfaces(&self.output, &refined)?;
        Ok(())
    }

    fn refined(&self) -> Result<Dataset, Error> {
        let defaults = Subdivide::default();
        let stages = [
            Stage::Import(Import { path: self.input.clone() }),
            Stage::Check(Check { reorient: self.reorient }),
            Stage::Subdivide(Subdivide {
                scheme: self.scheme,
                levels: self.levels,
                interpolate: self.interpolate,
                project_limit: self.project_limit,
                curve_ends: self.curve_ends,
                mirror: (!self.mirror.is_empty()).then(|| {
                    self.mirror.iter().map(|name| Spanned::new(0..0, name.clone())).collect()
                }),
                crease_angle: self.crease_angle,
                group_borders: self.group_borders,
                marking: self.marking,
                diagonal: self.diagonal.unwrap_or(defaults.diagonal),
                min_quality: self.min_quality,
                ..defaults
            }),
        ];
        let (here, display) = (Path::new(""), Display::new(self.quiet));
        let work = Workplace {
            input_folder: here,
            output_folder: here,
            source: None,
            observer: &display,
            stop: &AtomicBool::new(false),
        };
        let state = run_stages(&stages, work)?;
        for field in &state.sided_fields.fields {
            let name = &field.name;
            say(&format!(
                "note: the field `{name}`, given at the corners of tets, was left out; \
                 `octruss run` writes it, for each region by itself"
            ));
        }
        let refined = state.into_dataset();
        refined.notes.iter().for_each(|note| say(&format!("note: {note}")));
        Ok(refined)
    }
}

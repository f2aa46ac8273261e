//! `octruss basis`: a basis function of a scheme.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use octruss::options::{Degrees, SchemeName};
use octruss_mesh::analysis::{LineSample, basis_function, sample_line};
use octruss_mesh::most_levels;
use octruss_mesh::{FeatureOptions, Hierarchy};
use octruss_meshio::{Dataset, Field, check_target, write, write_aside};

use crate::cli::sound_mesh::SoundMesh;

/// Samples of a line on either side of the vertex.
const SAMPLES: u32 = 500;

/// Refine the field that is 1 at one vertex and 0 at the others
#[derive(Args)]
#[command(after_help = "Examples:\n  \
    octruss basis part.msh --vertex 17 --levels 3 basis.vtu\n  \
    octruss basis part.msh --vertex 17 --levels 3 basis.vtu --line line.csv --direction 0,0,1\n\n\
    The line runs through the vertex; its columns are the distance along it, the point,\n\
    and the value, linear in each tet of the finest mesh. Levels are made as the scheme\n\
    alone would make them, without the guard of quality that refine has.")]
pub struct Basis {
    /// Mesh to read
    mesh: PathBuf,
    /// File to write: the finest mesh with the field `basis`
    #[arg(value_name = "OUT")]
    output: PathBuf,
    /// The vertex, numbered from 0 on its level
    #[arg(long, value_name = "I")]
    vertex: u32,
    /// How often to refine
    #[arg(long, value_name = "N")]
    levels: u8,
    /// The level on which the vertex is 1
    #[arg(long, value_name = "L", default_value_t = 0)]
    at_level: u8,
    /// The weights, as in configs
    #[arg(long, value_name = "NAME", default_value = "box-spline")]
    scheme: SchemeName,
    /// Edges stay sharp where outward normals differ by more
    #[arg(long, value_name = "DEG", default_value = "40")]
    crease_angle: Degrees,
    /// File for the values along a line, .csv
    #[arg(long, value_name = "OUT.csv")]
    line: Option<PathBuf>,
    /// Where the line goes from the vertex
    #[arg(long, value_name = "X,Y,Z", default_value = "1,0,0", value_parser = direction, allow_hyphen_values = true)]
    direction: [f64; 3],
}

fn direction(text: &str) -> Result<[f64; 3], String> {
    let parts: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    let vector: Option<[f64; 3]> = parts.ok().and_then(|parts| parts.try_into().ok());
    let is_direction =
        |v: &[f64; 3]| v.iter().all(|x| x.is_finite()) && v.iter().any(|&x| x != 0.0);
    vector.filter(is_direction).ok_or("expected three numbers, not all 0, such as 0,0,1".into())
}

impl Basis {
    pub fn run(&self) -> anyhow::Result<()> {
        // Asked first: refining may take long.
        check_target(&self.output)?;
        if let Some(path) = self.line.as_ref().filter(|path| !is_csv(path)) {
            anyhow::bail!("--line {}: expected a file name that ends in .csv", path.display());
        }
        let sound = SoundMesh::read(&self.mesh, self.crease_angle.0)?;
        let vertex = if self.at_level == 0 { sound.vertex(self.vertex)? } else { self.vertex };
        let (tets, most) = (sound.mesh.tets().len(), most_levels(sound.mesh.tets().len()));
        if u32::from(self.levels) > most {
            anyhow::bail!("--levels {}: at most {most} levels of {tets} tets fit", self.levels);
        }
        let mut hierarchy = Hierarchy::new(sound.mesh, &FeatureOptions::default());
        for _ in 0..self.levels {
            hierarchy.subdivide(self.scheme.0)?;
        }
        let values = basis_function(&hierarchy, self.at_level.into(), vertex)?;
        let finest = &hierarchy.finest().mesh;
        if let Some(path) = &self.line {
            // A vertex keeps its number on finer levels.
            let through = finest.points()[vertex as usize];
            write_line(path, &sample_line(finest, &values, through, self.direction, SAMPLES))?;
        }
        let mesh = finest.raw().clone();
        let point_fields = vec![Field::scalar("basis", values)];
        Ok(write(&self.output, &Dataset { mesh, point_fields, ..Dataset::default() })?)
    }
}

fn is_csv(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("csv"))
}

fn write_line(path: &Path, line: &[LineSample]) -> anyhow::Result<()> {
    Ok(write_aside(path, |file| {
        writeln!(file, "distance,x,y,z,value")?;
        line.iter().try_for_each(|LineSample { distance, point: [x, y, z], value }| {
            writeln!(file, "{distance},{x},{y},{z},{value}")
        })
    })?)
}

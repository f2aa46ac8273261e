//! `octruss spectrum`: eigenvalues of a scheme at a vertex or an edge.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use octruss::options::{Degrees, SchemeName};
use octruss_mesh::TetMesh;
use octruss_mesh::analysis::{
    CharacteristicMap, LocalMatrix, MapVerdict, Spectrum as Eigenvalues, Verdict, at_midpoint,
    stars,
};
use octruss_meshio::{Dataset, Field, Values, write};
use serde_json::json;

use crate::cli::say::print;
use crate::cli::vertex_place::VertexPlace;

/// Eigenvalues below this are not printed, unless as JSON.
const SMALL: f64 = 1e-6;

/// Show how smooth a scheme is at a vertex or an edge: eigenvalues and verdict
#[derive(Args)]
#[command(after_help = "Examples:\n  octruss spectrum --vertex icosahedron\n  \
    octruss spectrum --edge 5 --marks twist --scheme averaged --json\n  \
    octruss spectrum --vertex part.msh:17 --map map.vtu\n\n\
    The verdict is numerical evidence, no proof: convergent if 1 is a simple eigenvalue and\n\
    the others are smaller; the characteristic map, by the eigenvectors of λ1 to λ3, is\n\
    sampled by the tets round the vertex, split three times.")]
pub struct Spectrum {
    #[command(flatten)]
    place: Place,
    /// How the tets round the edge mark their pairs
    #[arg(long, value_enum, default_value = "all", requires = "edge", conflicts_with = "vertex")]
    marks: Marks,
    /// The weights, as in configs
    #[arg(long, value_name = "NAME", default_value = "box-spline")]
    scheme: SchemeName,
    /// Edges of a mesh stay sharp where outward normals differ by more
    #[arg(long, value_name = "DEG", default_value = "40")]
    crease_angle: Degrees,
    /// Print JSON for scripts
    #[arg(long)]
    json: bool,
    /// File for the sampled characteristic map: .vtu, .vtk, or .mesh, which has no room for
    /// its fields
    #[arg(long, value_name = "OUT")]
    map: Option<PathBuf>,
}

#[derive(Args)]
#[group(required = true, multiple = false)]
struct Place {
    /// bipyramid:N, stack:N,L, octahedron, icosahedron (the star's link), or MESH:VERTEX
    #[arg(long, value_name = "PLACE")]
    vertex: Option<VertexPlace>,
    /// The midpoint of an edge of so many tets
    #[arg(long, value_name = "VALENCE", value_parser = clap::value_parser!(u32).range(3..=64))]
    edge: Option<u32>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Marks {
    /// All mark the edge
    All,
    /// None marks it and neighbours agree; for even valences
    Alternate,
    /// None marks it and neighbours disagree on every face
    Twist,
}

impl From<Marks> for stars::Marks {
    fn from(marks: Marks) -> Self {
        match marks {
            Marks::All => Self::All,
            Marks::Alternate => Self::Alternate,
            Marks::Twist => Self::Twist,
        }
    }
}

impl Spectrum {
    pub fn run(&self) -> anyhow::Result<()> {
        let (mesh, vertex) = self.mesh()?;
        let scheme = self.scheme.0;
        let local = LocalMatrix::new(&mesh, vertex, scheme)?;
        let spectrum = local.spectrum()?;
        let map = CharacteristicMap::new(&mesh, vertex, scheme)?;
        let verdict = Verdict::new(&spectrum, &map);
        print(&if self.json {
            as_json(&local, &spectrum, &verdict)
        } else {
            as_text(&local, &spectrum, &verdict)
        })?;
        match (&self.map, map) {
            (None, _) => Ok(()),
            (Some(path), Ok(map)) => write_map(path, map),
            (Some(path), Err(none)) => {
                anyhow::bail!("{} is not written, there is no map: {none}", path.display())
            }
        }
    }

    fn mesh(&self) -> anyhow::Result<(TetMesh, u32)> {
        if let Some(valence) = self.place.edge {
            if matches!(self.marks, Marks::Alternate) && valence % 2 == 1 {
                anyhow::bail!(
                    "--marks alternate: {valence} tets cannot alternate round an edge; \
                     give an even valence, or other marks"
                );
            }
            return Ok(at_midpoint(&stars::edge_ring(valence, self.marks.into()), [0, 1])?);
        }
        let place = self.place.vertex.as_ref().expect("one of the two is required");
        place.mesh(self.crease_angle.0)
    }
}

fn as_json(local: &LocalMatrix, spectrum: &Eigenvalues, verdict: &Verdict) -> String {
    let map = match verdict.map {
        MapVerdict::Sampled { regular, injective, tets } => {
            json!({ "regular": regular, "injective": injective, "tets": tets })
        }
        MapVerdict::NotApplicable(why) => json!({ "not-applicable": why.to_string() }),
    };
    let value = json!({
        "rings": local.rings,
        "rows": local.matrix.nrows(),
        "eigenvalues": spectrum.eigenvalues,
        "verdict": {
            "convergent": verdict.convergent,
            "separated": verdict.separated,
            "characteristic-map": map,
        },
    });
    format!("{value:#}\n")
}

fn as_text(local: &LocalMatrix, spectrum: &Eigenvalues, verdict: &Verdict) -> String {
    let rings = match local.rings {
        1 => "one-ring".into(),
        more => format!("{more}-ring"),
    };
    let mut text = format!("{rings} block, {} rows\n\n", local.matrix.nrows());
    let large = (0..spectrum.eigenvalues.len()).take_while(|&i| spectrum.modulus(i) > SMALL);
    for i in large {
        let [re, im] = spectrum.eigenvalues[i];
        let imaginary = if im.abs() > SMALL { format!(" {im:+.6} i") } else { String::new() };
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {:<6}{re:9.6}{imaginary}", format!("λ{i}"));
    }
    let yes = |holds| if holds { "yes" } else { "no" };
    let map = match verdict.map {
        MapVerdict::Sampled { regular, injective, tets } => {
            format!("regular {}, injective {} ({tets} tets)", yes(regular), yes(injective))
        }
        MapVerdict::NotApplicable(why) => format!("not applicable: {why}"),
    };
    let lines = [
        ("convergent", yes(verdict.convergent)),
        ("λ3 above λ4", yes(verdict.separated)),
        ("characteristic map", &map),
    ];
    text.push('\n');
    for (what, holds) in lines {
        let _ = writeln!(text, "  {what:<20}{holds}");
    }
    text
}

fn write_map(path: &Path, map: CharacteristicMap) -> anyhow::Result<()> {
    let layers = map.layers.iter().map(|&layer| i64::from(layer)).collect();
    let preimage = Values::Float(map.preimage.into_flattened());
    let preimage = Field::new("preimage", 3, preimage);
    let layer = Field::new("layer", 1, Values::Integer(layers));
    let point_fields = vec![preimage, layer];
    Ok(write(path, &Dataset { mesh: map.image, point_fields, ..Dataset::default() })?)
}

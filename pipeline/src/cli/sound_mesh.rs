//! A mesh file that may be analysed.

use std::path::Path;

use octruss::Error;
use octruss_mesh::{CheckOptions, Checked, FeatureOptions, TetMesh, check, prepare};

/// A checked mesh with its features.
pub struct SoundMesh {
    pub mesh: TetMesh,
    kept_vertices: Option<Vec<u32>>,
}

impl SoundMesh {
    /// Reads and checks a mesh; finds its features with the usual options, but
    /// for the crease angle in degrees, unless the file records them.
    pub fn read(path: &Path, crease_angle: f64) -> Result<Self, Error> {
        let raw = octruss_meshio::read(path)?.mesh;
        let Checked { mesh, kept_vertices, .. } = check(raw, &CheckOptions::default())
            .map_err(|source| Error::Unsound { path: path.into(), source })?;
        let options = FeatureOptions { crease_angle, ..FeatureOptions::default() };
        Ok(Self { mesh: prepare(mesh, &options), kept_vertices })
    }

    /// The vertex that has this number in the file, where unused ones count.
    pub fn vertex(&self, number: u32) -> anyhow::Result<u32> {
        let Some(kept) = &self.kept_vertices else { return Ok(number) };
        let found = kept.binary_search(&number);
        found
            .map(|at| at as u32)
            .map_err(|_| anyhow::anyhow!("vertex {number} is not used by any tet"))
    }
}

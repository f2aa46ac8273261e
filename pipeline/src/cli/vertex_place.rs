//! `--vertex`: a named star, or a vertex of a mesh.

use std::path::PathBuf;
use std::str::FromStr;

use octruss_mesh::TetMesh;
use octruss_mesh::analysis::stars;

use super::sound_mesh::SoundMesh;

/// Stars with more neighbours have matrices of thousands of rows.
const MOST_NEIGHBOURS: u32 = 200;

/// Where to look at a scheme.
#[derive(Debug, Clone, PartialEq)]
pub enum VertexPlace {
    /// Two poles over layers of rings: n, layers.
    Stack(u32, u32),
    /// A vertex of a mesh file, by its number from 0.
    OfMesh(PathBuf, u32),
}

impl FromStr for VertexPlace {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "octahedron" => return Ok(Self::Stack(4, 1)),
            "icosahedron" => return Ok(Self::Stack(5, 2)),
            _ => {}
        }
        let (name, numbers) = text
            .rsplit_once(':')
            .ok_or("expected bipyramid:N, stack:N,L, octahedron, icosahedron, or MESH:VERTEX")?;
        let number = |text: &str| {
            text.parse::<u32>().map_err(|_| format!("expected a number from 0, found `{text}`"))
        };
        match name {
            "bipyramid" => stack(number(numbers)?, 1),
            "stack" => {
                let (n, layers) =
                    numbers.split_once(',').ok_or("expected stack:N,L, such as stack:5,2")?;
                stack(number(n)?, number(layers)?)
            }
            _ => Ok(Self::OfMesh(name.into(), number(numbers)?)),
        }
    }
}

fn stack(n: u32, layers: u32) -> Result<VertexPlace, String> {
    let neighbours = n.checked_mul(layers).filter(|most| *most <= MOST_NEIGHBOURS);
    if n < 3 || layers == 0 || neighbours.is_none() {
        return Err(format!(
            "expected rings of 3 or more and at most {MOST_NEIGHBOURS} vertices in all rings"
        ));
    }
    Ok(VertexPlace::Stack(n, layers))
}

impl VertexPlace {
    /// The mesh, and the number of the vertex in it.
    pub fn mesh(&self, crease_angle: f64) -> anyhow::Result<(TetMesh, u32)> {
        match self {
            Self::Stack(n, layers) => Ok((stars::stack(*n, *layers), 0)),
            Self::OfMesh(path, number) => {
                let sound = SoundMesh::read(path, crease_angle)?;
                let vertex = sound.vertex(*number)?;
                Ok((sound.mesh, vertex))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_numbers_are_understood() {
        let good = [
            ("octahedron", VertexPlace::Stack(4, 1)),
            ("icosahedron", VertexPlace::Stack(5, 2)),
            ("bipyramid:7", VertexPlace::Stack(7, 1)),
            ("stack:6,3", VertexPlace::Stack(6, 3)),
            ("a:b/part.msh:12", VertexPlace::OfMesh("a:b/part.msh".into(), 12)),
        ];
        for (text, place) in good {
            assert_eq!(text.parse(), Ok(place));
        }
        for text in ["cube", "bipyramid:2", "stack:5", "stack:5,0", "stack:300,9", "part.msh:-1"] {
            assert!(text.parse::<VertexPlace>().unwrap_err().contains("expected"), "{text}");
        }
    }
}

//! Medit meshes (`.mesh`), ASCII, as mmg, TetGen, FreeFem and Gmsh exchange them.
//!
//! Vertices keep the order of the file, tets the order of their corners. The
//! reference of a tet is its region, 0 for none. Triangles and edges with a
//! reference other than 0 are tagged by it, the others left out. Second-order
//! simplices are read by their corners. References of vertices are left out:
//! remeshers repeat the geometry there, and as points that stay fixed, vertices
//! all over a surface would keep subdivision from smoothing it. So are required
//! and ridge entities, normals, and whatever else a file lists. The notes tell
//! of all that. Coordinates may be NaN or infinite: checking the mesh finds that.
//!
//! Malformed content is reported with its line; other dimensions, cells that are
//! no simplices of first or second order, and the binary form (`.meshb`) are
//! unsupported.
//!
//! A file is a sequence of words, whatever the lines: a keyword, a count, and so
//! many entries, as in the [manual of libMeshb](https://github.com/LoicMarechal/libMeshb).

mod header;
mod read;
mod words;
mod write;

pub use write::write;

use crate::format_spec::FormatSpec;
use crate::losses;

/// Medit's `.mesh`, ASCII: holds points, tets, and tagged triangles and edges.
pub const FORMAT: FormatSpec = FormatSpec {
    name: "Medit",
    extension: "mesh",
    signatures: &["MeshVersionFormatted"],
    tells_strangers: false,
    read: read::parse,
    write: Some(write::write),
    losses: |dataset| {
        [losses::group_names, losses::tagged_vertices, losses::features, losses::fields]
            .into_iter()
            .filter_map(|loss| loss("Medit", dataset))
            .collect()
    },
};

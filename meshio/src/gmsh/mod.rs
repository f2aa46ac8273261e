//! Gmsh meshes (`.msh`): MSH 2.0 to 2.2 and 4.1, ASCII and binary of either byte
//! order, read only.
//!
//! Nodes keep the order of the file, tets the order of their corners. The
//! region of a tet is its first physical group, 0 for none. Triangles, lines
//! and points are listed once for each of their physical groups and left out
//! if they have none; a negative group turns them round. Second-order elements
//! are read as linear ones and their mid-side nodes dropped. `$NodeData`,
//! `$ElementData` and `$ElementNodeData` become fields (of tets and their corners
//! only), NaN where the file gives no value. The notes tell what was left out.
//! Coordinates may be NaN or infinite: checking the mesh finds that.
//!
//! Malformed content is reported with its line (ASCII) or byte (binary); other
//! versions, and elements that are not simplices of first or second order, are
//! unsupported.
//!
//! The format is described in Gmsh's manual,
//! <https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format>. A file is a
//! sequence of sections; one scanner reads numbers from text and binary
//! alike, so that each section is written once.

mod assemble;
mod data;
mod elements;
mod entities;
mod header;
mod names;
mod nodes;
mod read;
mod scanner;
mod sections;
mod tags;
mod v2;
mod v4;

use crate::format_spec::FormatSpec;

/// Gmsh's `.msh`, read only.
pub const FORMAT: FormatSpec = FormatSpec {
    name: "Gmsh",
    extension: "msh",
    signatures: &["$MeshFormat"],
    tells_strangers: true,
    read: read::parse,
    write: None,
    losses: |_| Vec::new(),
};

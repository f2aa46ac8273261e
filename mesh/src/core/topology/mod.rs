//! Edges and faces of a mesh, and who touches whom.

mod edge_faces;
mod edge_tets;
mod edges_and_faces;
mod from_simplices;
mod vertex_edges;

pub use edge_faces::EdgeFaces;
pub use edge_tets::EdgeTets;
pub(crate) use edges_and_faces::ascending;
pub use edges_and_faces::{NONE, Topology};
pub use vertex_edges::VertexEdges;

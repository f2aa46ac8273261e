//! Why there is no limit at a place.

/// Why the limit cannot be evaluated.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LimitError {
    /// There is no such face.
    #[error("there is no face {face}: the mesh has {faces}, numbered from 0")]
    NoFace {
        /// The number asked for.
        face: u32,
        /// How many there are.
        faces: usize,
    },
    /// The face belongs to no surface stratum.
    #[error(
        "face {face} lies inside the solid and has no limit surface; choose a face of the \
         boundary, of an interface, or of a surface that is kept"
    )]
    NotOnSurface {
        /// The number asked for.
        face: u32,
    },
    /// The coordinates are outside the triangle.
    #[error("({u}, {v}) is outside the triangle: u, v and 1 - u - v must not be negative")]
    Outside {
        /// The coordinate of the second corner.
        u: f64,
        /// The coordinate of the third corner.
        v: f64,
    },
    /// A smooth vertex whose triangles are not one disc.
    #[error(
        "surfaces touch at vertex {vertex}: its triangles make no single disc, and the limit \
         there is no surface; make the vertex a corner"
    )]
    NotADisc {
        /// The vertex.
        vertex: u32,
    },
    /// There are not as many points as vertices.
    #[error("there are {points} points for {vertices} vertices; give one for each")]
    Points {
        /// How many were given.
        points: usize,
        /// How many are needed.
        vertices: usize,
    },
    /// There is no such edge.
    #[error("there is no edge {edge}: the mesh has {edges}, numbered from 0")]
    NoEdge {
        /// The number asked for.
        edge: u32,
        /// How many there are.
        edges: usize,
    },
    /// The edge is no part of a curve.
    #[error("edge {edge} is on no curve; choose a crease or the border of a surface")]
    NotOnCurve {
        /// The number asked for.
        edge: u32,
    },
    /// The edge ends where the curve runs out in a surface or in the solid.
    #[error(
        "edge {edge} ends at vertex {vertex}, where the curve runs out (a dart): there it \
         follows the surface; evaluate a triangle at the edge instead"
    )]
    EndsInDart {
        /// The number asked for.
        edge: u32,
        /// The end that follows no curve.
        vertex: u32,
    },
    /// The parameter is outside the edge.
    #[error("{t} is outside the edge: the parameter runs from 0 to 1")]
    OutsideEdge {
        /// The parameter asked for.
        t: f64,
    },
}

//! Why a place cannot be analysed.

/// Why a place cannot be analysed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AnalysisError {
    /// There is no such vertex.
    #[error("there is no vertex {vertex}: the mesh has {vertices}, numbered from 0")]
    NoVertex {
        /// The number asked for.
        vertex: u32,
        /// How many there are.
        vertices: usize,
    },
    /// There is no such edge.
    #[error("vertices {} and {} share no edge", ends[0], ends[1])]
    NoEdge {
        /// The vertices asked for.
        ends: [u32; 2],
    },
    /// The vertex is not a corner of any tet.
    #[error("vertex {vertex} belongs to no tet; choose a vertex of the solid")]
    NoTets {
        /// The number asked for.
        vertex: u32,
    },
    /// There is no such level.
    #[error("there is no level {level}: the finest is {finest}")]
    NoLevel {
        /// The level asked for.
        level: usize,
        /// The number of the finest.
        finest: usize,
    },
    /// A block of so many rings is not closed, or not at hand.
    #[error(
        "{rings} rings were asked for; the scheme needs at least {least}, and {most} are at hand"
    )]
    Rings {
        /// The number asked for.
        rings: u32,
        /// The fewest whose rows read nothing else.
        least: u32,
        /// The most that can be had.
        most: u32,
    },
    /// The iteration for the eigenvalues did not end.
    #[error("the eigenvalues of a matrix of {size} rows were not found in {steps} steps")]
    Eigenvalues {
        /// How many rows the matrix has.
        size: usize,
        /// How many steps were taken.
        steps: usize,
    },
    /// The tets at the vertex cannot be refined.
    #[error("the tets at the vertex cannot be refined: {0}")]
    Refine(#[from] crate::SubdivideError),
}

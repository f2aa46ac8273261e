//! Why a surface group cannot be a mirror plane.

/// Why surface groups cannot be mirror planes; each message names the group, what was
/// found and what is needed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MirrorError {
    /// The mesh has no triangles of this group.
    #[error(
        "surface {group} cannot be a mirror plane: it has no triangles; name a surface of the mesh"
    )]
    NoTriangles {
        /// The name of the group.
        group: String,
    },
    /// Some triangles are inside the body, or no faces of it.
    #[error(
        "surface {group} cannot be a mirror plane: {count} of its triangles are not on the \
         boundary; name a part of the boundary"
    )]
    NotOnBoundary {
        /// The name of the group.
        group: String,
        /// How many triangles.
        count: usize,
    },
    /// The triangles are not in one plane.
    #[error(
        "surface {group} cannot be a mirror plane: it is up to {distance:.3e} away from the \
         plane nearest to it and up to {degrees:.3} degrees inclined to it, where {allowed:.1e} \
         and 1 degree are allowed; name a flat surface, and give planes at an angle a group each"
    )]
    NotFlat {
        /// The name of the group.
        group: String,
        /// The largest distance of a vertex from the plane, in mesh units.
        distance: f64,
        /// The largest angle of a triangle with the plane.
        degrees: f64,
        /// The distance that is allowed, in mesh units.
        allowed: f64,
    },
    /// The body lies on both sides of the plane.
    #[error(
        "surface {group} cannot be a mirror plane: {count} vertices lie behind it, up to \
         {distance:.3e} away; a body must lie on one side of its mirror planes"
    )]
    Behind {
        /// The name of the group.
        group: String,
        /// How many vertices.
        count: usize,
        /// How far behind the farthest is, in mesh units.
        distance: f64,
    },
    /// Two planes meet at another angle than a right one.
    #[error(
        "surfaces {} and {} cannot both be mirror planes: they meet at {degrees:.4} degrees; \
         mirror planes must be perpendicular or parallel",
        groups[0],
        groups[1]
    )]
    Oblique {
        /// The names of the groups.
        groups: [String; 2],
        /// The angle between the planes, at most 90.
        degrees: f64,
    },
    /// Parts of the mesh lie in a plane between vertices of it, but not in the group.
    #[error(
        "mirror planes would close a gap: {count} edges or faces between their vertices \
         are not in the groups that are named (the first: between vertices {a} and {b}); name \
         the other groups in the plane, too, or refine the mesh there"
    )]
    Gap {
        /// How many edges and faces.
        count: usize,
        /// An end of the first such edge.
        a: u32,
        /// The other end.
        b: u32,
    },
}

//! Everything that can go wrong in this crate.

use crate::rigid_mode::RigidMode;
use octruss_solver::Unfinished;

/// Why a problem could not be assembled or solved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The algebra failed: sizes that do not fit, numbers that are not finite, a system
    /// that cannot be solved.
    #[error(transparent)]
    Solver(#[from] octruss_solver::Error),
    /// Boundary data name a surface without triangles.
    #[error("no triangle belongs to surface {id}; surfaces of this mesh: {known:?}")]
    UnknownSurface {
        /// The id asked for.
        id: i32,
        /// The ids in use, ascending.
        known: Vec<i32>,
    },
    /// Boundary data are given on triangles that are no faces of tets.
    #[error(
        "{detached} triangles of surface {id} are no faces of tets, so what is given there is \
         lost; give it on a surface of the body"
    )]
    DetachedSurface {
        /// The surface.
        id: i32,
        /// How many of its triangles stand free.
        detached: usize,
    },
    /// Something that needs an outward normal is given on a surface inside the body.
    #[error(
        "{inner} triangles of surface {id} have tets on both sides, so there is no outward \
         normal; give components, or a surface of the boundary"
    )]
    InnerSurface {
        /// The surface.
        id: i32,
        /// How many of its triangles are inside.
        inner: usize,
    },
    /// A coefficient or source names a region without tets.
    #[error("no tet belongs to region {id}; regions of this mesh: {known:?}")]
    UnknownRegion {
        /// The id asked for.
        id: i32,
        /// The ids in use, ascending.
        known: Vec<i32>,
    },
    /// A coefficient of a tet is out of its range, infinite or not a number.
    #[error("the {what} of region {region} is {told} (tet {tet}); it must be {expected}")]
    Coefficient {
        /// Which coefficient.
        what: &'static str,
        /// The smallest tet number at fault.
        tet: usize,
        /// Its region.
        region: i32,
        /// What was found: the value, with expression and position if it has them.
        told: String,
        /// What it must be.
        expected: &'static str,
    },
    /// A coefficient of a surface is out of its range, infinite or not a number.
    #[error("the {what} of surface {surface} is {told}; it must be {expected}")]
    SurfaceCoefficient {
        /// Which coefficient.
        what: &'static str,
        /// The surface.
        surface: i32,
        /// What was found: the value, with expression and position if it has them.
        told: String,
        /// What it must be.
        expected: &'static str,
    },
    /// A source or load is infinite or not a number somewhere.
    #[error("the {what} of {place} is {told}; it must be finite everywhere")]
    Load {
        /// Which load.
        what: &'static str,
        /// The region or surface.
        place: String,
        /// What was found: the value, with expression and position if it has them.
        told: String,
    },
    /// A prescribed boundary value is infinite or not a number.
    #[error("the value of surface {surface} at vertex {vertex} is {told}; it must be finite")]
    BoundaryValue {
        /// The surface that prescribes it.
        surface: i32,
        /// The first vertex at fault.
        vertex: u32,
        /// What was found: the value, with expression and position if it has them.
        told: String,
    },
    /// A part of the mesh has no vertex with a prescribed value, so that the
    /// solution there is determined up to a constant only.
    #[error(
        "nothing is fixed on a connected part of the mesh with {vertices} vertices, among them \
         vertex {example}; prescribe a value on one of its surfaces, or solve for the solution \
         without mean with `free = \"balance\"`"
    )]
    NothingFixed {
        /// The size of the part.
        vertices: usize,
        /// Its smallest vertex number.
        example: u32,
    },
    /// A part of an elastic body can move without deforming.
    #[error(
        "a connected part of the mesh with {vertices} vertices, among them vertex {example}, can \
         still move as a rigid body: {}; hold more of it, with `fixed` or `springs`, or with \
         planes of symmetry where loads are symmetric, or let inertia balance the loads with \
         `free = \"balance\"`",
        list(.modes)
    )]
    RigidModes {
        /// The size of the part.
        vertices: usize,
        /// Its smallest vertex number.
        example: u32,
        /// The independent motions that remain, at most six.
        modes: Vec<RigidMode>,
    },
    /// What holds a part of the body is less than rounding of what the part is made of.
    #[error(
        "what holds {vertices} vertices of {regions}, among them vertex {example}, is less than \
         rounding of the numbers of the system: {motion}; hold more of it, or bring coefficients \
         nearer together than fourteen powers of ten"
    )]
    LostToRounding {
        /// How many vertices can move.
        vertices: usize,
        /// The first of them.
        example: u32,
        /// The regions of the tets that have no others.
        regions: String,
        /// How they move, in words.
        motion: String,
    },
    /// A body that shares only edges or single vertices with the rest can move about these.
    #[error(
        "a body of the mesh with {vertices} vertices, among them vertex {example}, hangs on the \
         rest by edges or single vertices only and can still move: {}; give it a face in common \
         with the rest, hold more of it, or leave it out",
        list(.modes)
    )]
    Hinged {
        /// The size of the body.
        vertices: usize,
        /// Its smallest vertex number.
        example: u32,
        /// The independent motions that remain, at most six.
        modes: Vec<RigidMode>,
    },
    /// Nothing acts on what is free, so that the solution would be zero.
    #[error(
        "nothing acts on what is free, so the solution would be zero everywhere: {missing}; what \
         acts where all is fixed has no effect"
    )]
    NoLoad {
        /// What the problem lacks, and what to do.
        missing: &'static str,
    },
}

impl Error {
    /// What an iteration left behind that did not reach its goal, if this is about one.
    pub fn unfinished(&self) -> Option<&Unfinished> {
        match self {
            Self::Solver(error) => error.unfinished(),
            _ => None,
        }
    }
}

fn list(modes: &[RigidMode]) -> String {
    modes.iter().map(RigidMode::to_string).collect::<Vec<_>>().join(", ")
}

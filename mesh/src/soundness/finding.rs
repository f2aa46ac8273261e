//! What a check can find in a mesh.

use std::fmt;

/// How many places a finding names.
pub(crate) const EXAMPLES: usize = 5;

/// One kind of problem, how often it occurs and where first.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// What is wrong.
    pub kind: FindingKind,
    /// How many times; for [`FindingKind::DisconnectedParts`] the number of parts.
    pub count: usize,
    /// The first few places, as numbers (from 0) of what the kind names.
    pub examples: Vec<u32>,
    /// The same places in words, where numbers alone tell too little; else empty.
    pub places: Vec<String>,
    /// Whether the check mended it.
    pub mended: bool,
}

impl Finding {
    /// One, at no place.
    pub(crate) fn of(kind: FindingKind) -> Self {
        Self { kind, count: 1, examples: Vec::new(), places: Vec::new(), mended: false }
    }
}

/// The kinds of problems, the worst first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum FindingKind {
    /// There is no tet.
    NoTets,
    /// A coordinate is infinite or not a number; examples are vertices.
    NonFiniteCoordinates,
    /// More tets and tagged simplices than can be numbered in 32 bits.
    TooLarge,
    /// A tet or tagged simplex names a vertex that does not exist; examples are
    /// the numbers it names.
    IndexOutOfRange,
    /// A tet has no volume, or names a vertex twice; examples are tets.
    ZeroVolumeTets,
    /// A tet has negative volume; examples are tets.
    InvertedTets,
    /// A tet has the same vertices as an earlier one; examples are tets.
    DuplicateTets,
    /// A face belongs to more than two tets; examples are tets on such faces.
    OversharedFaces,
    /// The mesh records a crease that is not one of its edges; examples are
    /// vertices.
    StrayCreases,
    /// A tagged triangle or edge names a vertex twice; examples are vertices.
    DegenerateSimplices,
    /// A tagged simplex is listed twice under one tag; examples are vertices.
    /// The check leaves the copies out.
    RepeatedSimplices,
    /// A vertex lies exactly where an earlier one does; examples are vertices.
    DuplicateVertices,
    /// No simplex uses a vertex; examples are vertices.
    UnusedVertices,
    /// Parts meet at edges or single vertices and have no face in common; examples are the
    /// first tets of the second of each pair of parts.
    Hinges,
    /// The tets form more than one part; examples are the first tets of parts.
    DisconnectedParts,
}

impl FindingKind {
    /// Whether refining and solving refuse such a mesh. The others are remarks.
    pub fn stops(self) -> bool {
        self < Self::RepeatedSimplices
    }

    /// The name for reports, in kebab case.
    pub fn name(self) -> &'static str {
        match self {
            Self::NoTets => "no-tets",
            Self::NonFiniteCoordinates => "non-finite-coordinates",
            Self::IndexOutOfRange => "index-out-of-range",
            Self::ZeroVolumeTets => "zero-volume-tets",
            Self::InvertedTets => "inverted-tets",
            Self::DuplicateTets => "duplicate-tets",
            Self::OversharedFaces => "overshared-faces",
            Self::StrayCreases => "stray-creases",
            Self::TooLarge => "too-large",
            Self::DegenerateSimplices => "degenerate-simplices",
            Self::RepeatedSimplices => "repeated-simplices",
            Self::DuplicateVertices => "duplicate-vertices",
            Self::UnusedVertices => "unused-vertices",
            Self::Hinges => "hinges",
            Self::DisconnectedParts => "disconnected-parts",
        }
    }

    /// What was found, the noun of the examples, and what to do about it.
    fn words(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::NoTets => ("no tets", "", "octruss works on tetrahedral meshes; mesh the volume"),
            Self::NonFiniteCoordinates => (
                "vertices with a coordinate that is not a finite number",
                "vertex",
                "repair the file",
            ),
            Self::IndexOutOfRange => {
                ("references to vertices that do not exist", "vertex", "repair the file")
            }
            Self::ZeroVolumeTets => ("tets without volume", "tet", "remove them in the mesher"),
            Self::InvertedTets => ("inverted tets", "tet", "give --reorient to turn them round"),
            Self::DuplicateTets => ("tets that repeat an earlier one", "tet", "remove the copies"),
            Self::OversharedFaces => (
                "faces shared by more than two tets",
                "tet",
                "tets overlap there; mesh the volume again",
            ),
            Self::StrayCreases => {
                ("recorded creases that are not edges", "vertex", "repair the file")
            }
            Self::TooLarge => ("simplices, too many to number", "", "split the mesh"),
            Self::DegenerateSimplices => {
                ("tagged triangles or edges that name a vertex twice", "vertex", "repair the file")
            }
            Self::RepeatedSimplices => {
                ("tagged simplices listed twice under one tag", "vertex", "the copies are left out")
            }
            Self::DuplicateVertices => (
                "vertices on top of an earlier one",
                "vertex",
                "merge them unless a crack is meant",
            ),
            Self::UnusedVertices => {
                ("vertices that no simplex uses", "vertex", "they are left out")
            }
            Self::Hinges => (
                "pairs of parts that hang together by edges or single vertices only",
                "tet",
                "a hinge, about which an elastic body turns freely, and heat passes by its few \
                 vertices alone; mesh the parts with faces in common unless it is meant",
            ),
            Self::DisconnectedParts => {
                ("parts that do not touch", "tet", "each part needs fixed values of its own")
            }
        }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (what, noun, advice) = self.kind.words();
        if self.kind == FindingKind::NoTets {
            return write!(f, "{what}: {advice}");
        }
        write!(f, "{} {what} (", self.count)?;
        if self.places.is_empty() {
            let places: Vec<String> = self.examples.iter().map(|k| format!("{noun} {k}")).collect();
            f.write_str(&places.join(", "))?;
        } else {
            f.write_str(&self.places.join("; "))?;
        }
        let advice = if self.mended { "mended as asked" } else { advice };
        let more = if self.count > self.examples.len() { ", …" } else { "" };
        write!(f, "{more}): {advice}")
    }
}

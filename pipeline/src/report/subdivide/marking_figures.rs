//! How far the marked pairs agree.

use std::collections::BTreeMap;

use octruss_mesh::MarkingReport;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

/// How far the marking agrees, before it is chosen and after.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MarkingFigures {
    /// Faces between two tets.
    pub interior_faces: usize,
    /// Those whose tets marked different edges in the order they came in.
    pub conflicting_faces_before: usize,
    /// The same as marked.
    pub conflicting_faces: usize,
    /// How many interior edges of level 1 have so many tets round them, in the
    /// order they came in.
    #[serde(deserialize_with = "by_number")]
    pub edge_valences_before: BTreeMap<u32, usize>,
    /// The same as marked.
    #[serde(deserialize_with = "by_number")]
    pub edge_valences: BTreeMap<u32, usize>,
}

impl MarkingFigures {
    pub(super) fn new(before: MarkingReport, after: MarkingReport) -> Self {
        Self {
            interior_faces: after.interior_faces,
            conflicting_faces_before: before.conflicting_faces,
            conflicting_faces: after.conflicting_faces,
            edge_valences_before: before.split_edge_valences.into_iter().collect(),
            edge_valences: after.split_edge_valences.into_iter().collect(),
        }
    }
}

/// Counts by numbers: within something larger, serde takes keys of JSON for text alone.
fn by_number<'de, D: Deserializer<'de>>(deserializer: D) -> Result<BTreeMap<u32, usize>, D::Error> {
    let counts = BTreeMap::<String, usize>::deserialize(deserializer)?;
    let number = |(key, count): (String, usize)| Ok((key.parse()?, count));
    let counts: Result<_, std::num::ParseIntError> = counts.into_iter().map(number).collect();
    counts.map_err(D::Error::custom)
}

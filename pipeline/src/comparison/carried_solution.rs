//! How a coarse solution fares when it is carried up.

use serde::{Deserialize, Serialize};

use crate::null::null_as_nan;

/// How near a carried solution comes to the one computed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CarriedSolution {
    /// `flat` or `subdivided`.
    pub geometry: String,
    /// The level it was carried to.
    pub level: usize,
    /// What carried it.
    pub prolongation: String,
    /// ‖carried − computed‖ / ‖computed‖ over the free unknowns.
    #[serde(deserialize_with = "null_as_nan")]
    pub difference: f64,
    /// The same in the energy norm of the finer level.
    #[serde(deserialize_with = "null_as_nan")]
    pub energy_difference: f64,
}

//! What balances the loads of parts that nothing holds.

use octruss_fem::{Balance, Balancing};
use serde::{Deserialize, Serialize};

use super::body_figures::Force;
use crate::null::null_as_nan;

/// What was added to the loads of a part that nothing holds, so that they balance.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FreePartFigures {
    /// How many vertices it has.
    pub vertices: usize,
    /// Its smallest vertex number.
    pub vertex: u32,
    /// The size of what was added relative to that of the loads.
    #[serde(deserialize_with = "null_as_nan")]
    pub share: f64,
    /// Of a scalar problem the source that was added, per unit of volume.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub source: Option<f64>,
    /// Of an elastic body the acceleration of its centre of mass.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub acceleration: Option<Force>,
    /// Of an elastic body the angular acceleration.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angular_acceleration: Option<Force>,
}

impl FreePartFigures {
    /// What was added, in words.
    pub(crate) fn note(&self) -> String {
        let Self { vertices, vertex, .. } = self;
        let part =
            format!("nothing holds the part with {vertices} vertices, among them vertex {vertex}");
        match (self.source, self.acceleration, self.angular_acceleration) {
            (Some(source), ..) => format!(
                "{part}, and its sources and fluxes do not balance: a uniform source of \
                 {source:.6e} was added"
            ),
            (_, Some(linear), Some(angular)) => format!(
                "{part}, in some directions or all, and its loads do not balance: the inertia of \
                 an acceleration of {} and an angular acceleration of {} was added",
                told(linear),
                told(angular)
            ),
            _ => part,
        }
    }
}

fn told(Force { x, y, z }: Force) -> String {
    format!("({x:.4e}, {y:.4e}, {z:.4e})")
}

impl From<&Balance> for FreePartFigures {
    fn from(balance: &Balance) -> Self {
        let Balance { vertices, example, share, added } = *balance;
        let (source, linear, angular) = match added {
            Balancing::Source(source) => (Some(source), None, None),
            Balancing::Acceleration { linear, angular, .. } => (None, Some(linear), Some(angular)),
        };
        Self {
            vertices,
            vertex: example,
            share,
            source,
            acceleration: linear.map(Force::from),
            angular_acceleration: angular.map(Force::from),
        }
    }
}

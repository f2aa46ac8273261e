//! Readying the coarsest mesh, once: its marking, its creases and corners.

mod extra;
mod feature_reasons;
mod found;
mod group_borders;
mod mirror_candidates;
mod mirror_error;
mod mirrors;
mod options;
mod prepare;
mod reason;
mod surface_creases;

pub use extra::{ExtraFeatures, FeatureError};
pub use feature_reasons::FeatureReasons;
pub use found::find_features;
pub use group_borders::GroupBorders;
pub use mirror_candidates::mirror_candidates;
pub use mirror_error::MirrorError;
pub use mirrors::Mirrors;
pub use options::FeatureOptions;
pub use prepare::prepare;
pub use reason::Reason;

//! From a triangle's surroundings down to the regular patch that holds a place.

pub(super) mod descent;
pub(super) mod ring;
pub(super) mod spline_patch;

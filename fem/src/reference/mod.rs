//! What the unknowns of a problem are measured from where values are prescribed far from
//! zero: a constant, or a rigid motion, for each part of the body.

pub mod constant;
pub mod difference;
pub mod nearest_motion;
pub mod offset;

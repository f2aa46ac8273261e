//! The rule table: for each dimension of stratum one vertex rule and one edge
//! rule, by scheme.
//!
//! | stratum | approximating schemes | interpolatory |
//! | --- | --- | --- |
//! | point | fixed | fixed |
//! | curve | cubic B-spline | four-point |
//! | surface | Loop with Warren's weights | modified butterfly |
//! | solid | the scheme's own | the scheme's own |

mod averaged;
mod box_spline;
mod curve;
mod interpolatory;
pub mod limit;
mod loop_solid;
mod shares;
pub mod surface;
pub mod table;

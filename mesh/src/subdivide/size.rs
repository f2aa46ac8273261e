//! How large a refined mesh can be.

use crate::subdivide::red_split::parts::PARTS;

/// Edge slots of tets are numbered in 32 bits.
pub const MAX_TETS: usize = u32::MAX as usize / 6;

/// How many levels so many tets can be refined by the red split.
pub fn most_levels(tets: usize) -> u32 {
    // The greatest l with tets · PARTS^l ≤ MAX_TETS.
    (MAX_TETS / tets.max(1)).checked_ilog(PARTS).unwrap_or(0)
}

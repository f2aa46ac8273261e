//! What a multigrid tells of itself: its levels, its memory, its time.

pub mod summary;
pub mod table;
pub mod traffic;

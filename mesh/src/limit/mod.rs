//! Where subdivision without end leads.

mod across;
pub mod distances;
pub mod positions;

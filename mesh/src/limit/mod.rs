//! Where subdivision without end leads.

pub mod positions;

//! Parts of a body that nothing holds: what may be added to their solution, what balances
//! their loads, and what regularises their matrix for a preconditioner.

pub mod balance;
pub mod free_bodies;
pub mod free_part;
pub mod null_space;

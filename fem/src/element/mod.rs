//! What happens on one tet.

pub mod p1;
pub mod quadrature;

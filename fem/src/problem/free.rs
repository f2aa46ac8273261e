//! What becomes of bodies that nothing holds.

use octruss_base::choice::Choice;

/// What becomes of parts of a body that nothing holds, or not in all directions: any constant
/// or rigid motion may be added to their solution, and there is none unless their loads
/// balance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Free {
    /// They are refused, with the motions that are left.
    #[default]
    Refuse,
    /// Their loads are balanced, Poisson's equation by a uniform source, elasticity by the
    /// inertia of the rigid acceleration that the loads cause; of all solutions the one
    /// without mean, or without rigid motion, is taken.
    Balance,
}

impl Choice for Free {
    const WHAT: &'static str = "treatment of free bodies";
    const ALL: &'static [Self] = &[Self::Refuse, Self::Balance];
    fn name(self) -> &'static str {
        match self {
            Self::Refuse => "refuse",
            Self::Balance => "balance",
        }
    }
}

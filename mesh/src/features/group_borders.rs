//! Which borders between surface groups are creases of their own.

/// Which borders between surface groups are creases of their own, besides those
/// edges that are sharp by their angle.
///
/// Groups come from CAD, which splits smooth surfaces into patches for its own
/// reasons, and marks where something is held or pushed. A crease on a smooth
/// curved surface is a ridge: both sides are rounded off, it is not. On a flat one
/// it changes no shape, and the outline of a group stays where it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum GroupBorders {
    /// Those that cost nothing: the border of two groups is a crease if the surface
    /// is flat, to one degree, across all of it but where it is sharp by its angle.
    #[default]
    Flat,
    /// All, at any angle.
    All,
    /// None: surfaces are shaped as if they had no groups.
    None,
}

impl GroupBorders {
    /// Every choice.
    pub const ALL: [Self; 3] = [Self::Flat, Self::All, Self::None];

    /// The name by which configurations and the command line call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::All => "all",
            Self::None => "none",
        }
    }
}

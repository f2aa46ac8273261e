//! How marked pairs are chosen.

/// How the marked pairs of the initial tets are chosen.
///
/// All are deterministic and take time in proportion to the tets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Marking {
    /// The pair whose midpoints are closest, so that children keep the best
    /// shapes ([Bey 1995], and Wang's thesis, section 3.1). Ties go to
    /// agreement with the neighbours, then to the order at hand; never to a
    /// longer diagonal.
    ///
    /// [Bey 1995]: https://doi.org/10.1007/BF02238487
    #[default]
    Shortest,
    /// As few conflicting faces as a greedy choice from tet to tet and a local
    /// search find, whatever the shapes; ties go to the shorter diagonal.
    /// Finds a marking without conflicts wherever there is one.
    Agree,
    /// Chang's algorithm 4.2: breadth first from tet 0, each choosing the pair
    /// that agrees with most visited neighbours, ties by the order at hand. As
    /// printed, it *excludes* the edges that neighbours mark, which makes nearly
    /// all faces conflict; the argument in its section 4.6.2 asks for agreement,
    /// so this is the reading here.
    BreadthFirst,
    /// The order of vertices that the mesh came with.
    AsOrdered,
}

impl Marking {
    /// Every strategy.
    pub const ALL: [Self; 4] = [Self::Shortest, Self::Agree, Self::BreadthFirst, Self::AsOrdered];

    /// The name by which configurations and the command line call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Shortest => "shortest",
            Self::Agree => "agree",
            Self::BreadthFirst => "breadth-first",
            Self::AsOrdered => "as-ordered",
        }
    }
}

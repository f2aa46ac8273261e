//! What was added to the loads of a free part.

/// What was added to the loads of a part that nothing holds, so that they balance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Balance {
    /// How many vertices the part has.
    pub vertices: usize,
    /// Its smallest vertex number.
    pub example: u32,
    /// The size of what was added relative to that of the loads, both summed over vertices
    /// without regard to signs: rounding if these balance, 1 if nothing does. 0 without loads.
    pub share: f64,
    /// What was added.
    pub added: Balancing,
}

/// What balances loads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Balancing {
    /// A source, the same for each unit of the part's volume.
    Source(f64),
    /// The inertia −ρ (a + α × (x − c)) of the rigid acceleration that the loads cause, as far
    /// as what holds the part leaves it. Of a part without mass, that of a density of 1.
    Acceleration {
        /// The centre of mass, c.
        centre: [f64; 3],
        /// a, there.
        linear: [f64; 3],
        /// α.
        angular: [f64; 3],
    },
}

/// What was added, relative to the loads.
pub(crate) fn share(added: f64, loads: f64) -> f64 {
    if loads > 0.0 { added / loads } else { 0.0 }
}

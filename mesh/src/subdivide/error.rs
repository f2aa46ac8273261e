//! Why a step was refused.

use crate::subdivide::size::MAX_TETS;

/// Why a step was refused; the coarse mesh is untouched.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SubdivideError {
    /// Moving the vertices would turn tets inside out.
    #[error(
        "level {level} would invert {count} of {total} tets (the first: {}); \
         guard the quality, use fewer levels, keep more edges sharp, or improve the worst tets \
         of the input",
        list(examples)
    )]
    Inverted {
        /// The level that was being made; the input is level 0.
        level: usize,
        /// How many tets would have a volume that is not positive.
        count: usize,
        /// How many tets the level would have.
        total: usize,
        /// The first of them, by number.
        examples: Vec<u32>,
    },
    /// The numbers of the fine mesh do not fit 32 bits.
    #[error(
        "level {level} would have {tets} tets, more than the {MAX_TETS} that can be numbered; use fewer levels"
    )]
    TooLarge {
        /// The level that was being made.
        level: usize,
        /// How many tets it would have.
        tets: usize,
    },
}

fn list(numbers: &[u32]) -> String {
    numbers.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")
}

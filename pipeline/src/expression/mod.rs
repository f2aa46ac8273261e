//! Expressions in the position, as configs write them: `20 + 5*sin(pi*x/100)`.
//!
//! ```text
//! text ─tokens─▶ names, numbers, signs ─parser─▶ code for a stack machine
//! ```
//!
//! From weakest to strongest: `or`, `and`, comparisons (1 where they hold, else
//! 0), `+ -`, `* /`, signs and `not`, `^`. Powers group from the right and bind
//! stronger than signs: `-x^2` is −(x²).

mod code;
mod compiled;
mod fault;
mod names;
mod parser;
mod tokens;

pub use compiled::{Expression, ExpressionError};

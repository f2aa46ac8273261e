//! Expressions as code for a stack machine.

/// Values that may wait on the stack at a time.
pub(super) const STACK: usize = 32;

/// A function of one value.
pub(super) type Unary = fn(f64) -> f64;
/// A function of two values.
pub(super) type Binary = fn(f64, f64) -> f64;

/// One step: takes its operands off the stack and puts its result there.
#[derive(Clone, Copy)]
pub(super) enum Op {
    Number(f64),
    /// x, y or z.
    Coordinate(usize),
    Unary(Unary),
    Binary(Binary),
    /// Of condition, then and else.
    Select,
}

impl Op {
    /// How many values it takes.
    pub(super) fn operands(&self) -> usize {
        match self {
            Self::Number(_) | Self::Coordinate(_) => 0,
            Self::Unary(_) => 1,
            Self::Binary(_) => 2,
            Self::Select => 3,
        }
    }
}

/// Runs code whose stack the parser has found to fit.
#[inline]
pub(super) fn run(code: &[Op], position: [f64; 3]) -> f64 {
    let mut stack = [0.0; STACK];
    let mut top = 0;
    for op in code {
        top -= op.operands();
        stack[top] = match op {
            Op::Number(number) => *number,
            Op::Coordinate(axis) => position[*axis],
            Op::Unary(f) => f(stack[top]),
            Op::Binary(f) => f(stack[top], stack[top + 1]),
            Op::Select if stack[top] != 0.0 => stack[top + 1],
            Op::Select => stack[top + 2],
        };
        top += 1;
    }
    stack[0]
}

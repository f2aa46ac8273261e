//! Motions without deformation, as messages tell them.

use std::fmt;

/// Components below this, relative to the largest, are rounding.
pub(crate) const ROUNDING: f64 = 1e-5;

/// A motion without deformation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RigidMode {
    /// Along a direction.
    Translation {
        /// Of length 1.
        direction: [f64; 3],
    },
    /// Round an axis.
    Rotation {
        /// Of the axis, of length 1.
        direction: [f64; 3],
        /// A point of the axis.
        point: [f64; 3],
    },
    /// Round an axis and along it.
    Screw {
        /// Of the axis, of length 1.
        direction: [f64; 3],
        /// A point of the axis.
        point: [f64; 3],
        /// The way along the axis for a whole turn.
        pitch: f64,
    },
}

impl fmt::Display for RigidMode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Translation { direction } => write!(f, "translation along {}", Axis(direction)),
            Self::Rotation { direction, point } => {
                write!(f, "rotation about {} through {}", Axis(direction), Point(point))
            }
            Self::Screw { direction, point, pitch } => {
                let (axis, point) = (Axis(direction), Point(point));
                write!(f, "screw along {axis} through {point}, {pitch:.4} a turn")
            }
        }
    }
}

/// A coordinate axis by its name, other directions by their components.
struct Axis<'a>(&'a [f64; 3]);

impl fmt::Display for Axis<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let along = |k: usize| self.0[k].abs() > 1.0 - ROUNDING * ROUNDING;
        match (0..3).find(|&k| along(k)) {
            Some(k) => f.write_str(["x", "y", "z"][k]),
            None => Point(self.0).fmt(f),
        }
    }
}

struct Point<'a>(&'a [f64; 3]);

impl fmt::Display for Point<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.0;
        write!(f, "({x:.4}, {y:.4}, {z:.4})")
    }
}

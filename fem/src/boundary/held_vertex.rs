//! One vertex whose displacement is prescribed, wholly or in part.

use octruss_base::vector3::{
    IDENTITY, Matrix3, Vector3, ZERO, add, dot3, length, multiply3, outer, scale, subtract,
};

/// Directions this close (the sine of the angle between a direction and those
/// held already) count as held: 0.06°, some ten times what coordinates with six
/// digits leave. Noisier planes are told by what their normals stand for.
pub(crate) const SAME_DIRECTION: f64 = 1e-3;

/// A vertex with up to three independent conditions direction · u = value.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldVertex {
    /// Which vertex.
    pub vertex: u32,
    /// The orthogonal projector onto its free directions; zero where none is.
    pub projector: [[f64; 3]; 3],
    /// The prescribed displacement, in the held directions.
    pub value: [f64; 3],
    conditions: Vec<Condition>,
    /// The directions made orthonormal, with the values along them.
    basis: Vec<(Vector3, f64)>,
    /// What the directions stand for, made orthonormal.
    meant: Vec<Vector3>,
}

/// direction · u = value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Condition {
    /// Which of the problem's supports asks for it.
    pub(crate) support: usize,
    /// Of length 1.
    pub(crate) direction: Vector3,
    /// What the direction is but for noise, of length 1: decides whether it is held
    /// already.
    pub(crate) meant: Vector3,
    pub(crate) value: f64,
}

impl HeldVertex {
    pub(crate) fn free(vertex: u32) -> Self {
        Self {
            vertex,
            projector: IDENTITY,
            value: [0.0; 3],
            conditions: Vec::new(),
            basis: Vec::new(),
            meant: Vec::new(),
        }
    }

    /// Adds a condition unless its direction, or what it stands for, is held already.
    pub(crate) fn hold(&mut self, condition: Condition) {
        let along = |sum, &held: &Vector3| subtract(sum, scale(dot3(held, condition.meant), held));
        let meant = self.meant.iter().fold(condition.meant, along);
        let (mut rest, mut value) = (condition.direction, condition.value);
        for &(held, along) in &self.basis {
            let share = dot3(held, condition.direction);
            rest = subtract(rest, scale(share, held));
            value -= share * along;
        }
        let size = length(rest);
        if length(meant) <= SAME_DIRECTION || size <= SAME_DIRECTION || self.is_clamped() {
            return;
        }
        self.meant.push(scale(1.0 / length(meant), meant));
        let (direction, value) = (scale(1.0 / size, rest), value / size);
        self.basis.push((direction, value));
        self.conditions.push(condition);
        self.value = add(self.value, scale(value, direction));
        self.projector = if self.is_clamped() {
            ZERO
        } else {
            let held = outer(direction, direction);
            std::array::from_fn(|i| subtract(self.projector[i], held[i]))
        };
    }

    /// Whether no direction is free.
    pub fn is_clamped(&self) -> bool {
        self.basis.len() == 3
    }

    /// The directions that are held, as they were asked for.
    pub(crate) fn directions(&self) -> impl Iterator<Item = Vector3> {
        self.conditions.iter().map(|condition| condition.direction)
    }

    /// A force that acts in the held directions alone, as what each support
    /// contributes along its own direction.
    pub(crate) fn shares(&self, force: Vector3) -> Vec<(usize, Vector3)> {
        // force = Σ λ_k direction_k. The basis comes from the directions in
        // order, so that basis · direction is upper triangular.
        let count = self.basis.len();
        let mut lambdas = [0.0; 3];
        for row in (0..count).rev() {
            let basis = self.basis[row].0;
            let later: f64 = (row + 1..count)
                .map(|k| lambdas[k] * dot3(basis, self.conditions[k].direction))
                .sum();
            let own = dot3(basis, self.conditions[row].direction);
            lambdas[row] = (dot3(basis, force) - later) / own;
        }
        let share = |(condition, lambda): (&Condition, f64)| {
            (condition.support, scale(lambda, condition.direction))
        };
        self.conditions.iter().zip(lambdas).map(share).collect()
    }
}

/// Q A Q + s (I − Q) for a symmetric block A, symmetric to the last bit.
pub(crate) fn projected_diagonal(q: &Matrix3, block: &Matrix3, s: f64) -> Matrix3 {
    let inner = multiply3(&multiply3(q, block), q);
    std::array::from_fn(|i| {
        std::array::from_fn(|j| 0.5 * (inner[i][j] + inner[j][i]) + s * (IDENTITY[i][j] - q[i][j]))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn condition(support: usize, direction: Vector3, value: f64) -> Condition {
        Condition { support, direction, meant: direction, value }
    }

    #[test]
    fn a_noisy_normal_that_stands_for_a_held_axis_holds_nothing_more() {
        let x = condition(0, [1.0, 0.0, 0.0], 2.0);
        let (cos, sin) = (0.03_f64.cos(), 0.03_f64.sin());
        let noisy = Condition { meant: x.direction, ..condition(1, [cos, 0.0, sin], 2.0) };
        for [first, second] in [[x, noisy], [noisy, x]] {
            let mut vertex = HeldVertex::free(0);
            vertex.hold(first);
            vertex.hold(second);
            assert_eq!(vertex.directions().collect::<Vec<_>>(), [first.direction]);
        }
        // One that stands for itself is a second direction.
        let mut vertex = HeldVertex::free(0);
        vertex.hold(x);
        vertex.hold(condition(1, noisy.direction, 2.0));
        assert_eq!(vertex.directions().count(), 2);
    }

    #[test]
    fn skew_conditions_are_all_met_and_their_forces_told_apart() {
        let mut vertex = HeldVertex::free(7);
        vertex.hold(condition(4, [1.0, 0.0, 0.0], 2.0));
        vertex.hold(condition(9, [0.6, 0.8, 0.0], 6.0));
        // Held already, so without effect.
        vertex.hold(condition(5, [0.0, 1.0, 0.0], 99.0));
        assert!(!vertex.is_clamped());
        assert_eq!(vertex.projector[2], [0.0, 0.0, 1.0]);
        // u_x = 2 and 0.6 · 2 + 0.8 u_y = 6.
        for (found, exact) in vertex.value.iter().zip([2.0, 6.0, 0.0]) {
            assert!((found - exact).abs() < 1e-14);
        }
        // (5, 8, 0) = −1 · (1, 0, 0) + 10 · (0.6, 0.8, 0).
        let shares = vertex.shares([5.0, 8.0, 0.0]);
        for ((support, force), exact) in
            shares.into_iter().zip([(4, [-1.0, 0.0, 0.0]), (9, [6.0, 8.0, 0.0])])
        {
            assert_eq!(support, exact.0);
            assert!(length(subtract(force, exact.1)) < 1e-13, "{force:?}");
        }
        vertex.hold(condition(1, [0.0, 0.6, 0.8], 0.0));
        assert!(vertex.is_clamped());
        assert_eq!(vertex.projector, ZERO);
    }
}

//! Rigid motions as vectors of six numbers, and the spaces of those that are left.

use crate::rigid_mode::{ROUNDING, RigidMode};
use nalgebra::{Matrix6, RowVector6, SymmetricEigen, Vector6};
use octruss_base::vector3::{IDENTITY, Vector3, add, cross, dot3, length, scale, subtract};

/// Motions that change the held directions by less than this, relative to what a
/// held motion does, squared, count as free.
pub(crate) const FREE: f64 = 1e-12;

/// direction · u = 0 at a position.
pub(crate) type Hold = (Vector3, Vector3);

/// Where motions are measured from and in: (ω, t) moves x by t + ω × (x − centre) / size.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    centre: Vector3,
    size: f64,
}

impl Frame {
    /// Round positions; where there are none, round anyone.
    pub(crate) fn around(
        positions: impl ExactSizeIterator<Item = Vector3> + Clone,
        anywhere: impl Fn() -> Vector3,
    ) -> Self {
        let count = positions.len();
        let sum = positions.clone().fold([0.0; 3], add);
        let centre = if count == 0 { anywhere() } else { scale(1.0 / count as f64, sum) };
        let size = positions.map(|p| length(subtract(p, centre))).fold(0.0, f64::max);
        // A single position has no size; any will do.
        let size = if size > 1e-9 * length(centre) { size } else { 1.0 };
        Self { centre, size }
    }

    /// What motions do along a direction at a position: direction · (t + ω × x) =
    /// direction · t + (x × direction) · ω.
    pub(crate) fn row(&self, position: Vector3, direction: Vector3) -> Vector6<f64> {
        let arm = scale(1.0 / self.size, subtract(position, self.centre));
        let [a, b, c] = cross(arm, direction);
        let [d, e, f] = direction;
        Vector6::new(a, b, c, d, e, f)
    }

    /// The sum of the squares of all rows.
    pub(crate) fn gram(&self, held: &[Hold]) -> Matrix6<f64> {
        held.iter().fold(Matrix6::zeros(), |gram, &(position, direction)| {
            let row = self.row(position, direction);
            gram + row * row.transpose()
        })
    }

    /// A space of motions by modes as plain as they get.
    pub(crate) fn modes(&self, space: Vec<RowVector6<f64>>) -> Vec<RigidMode> {
        echelon(space).iter().map(|row| mode(row, self)).collect()
    }
}

impl Frame {
    /// The motion nearest to displacements of some positions, in the mean of squares; none if
    /// what is left of them is more than a tenth.
    pub(crate) fn nearest_mode(&self, moved: &[(Vector3, Vector3)]) -> Option<RigidMode> {
        let (mut gram, mut sum) = (Matrix6::zeros(), Vector6::zeros());
        let along = |&(position, displacement): &(Vector3, Vector3)| {
            let axes = IDENTITY.into_iter().zip(displacement);
            axes.map(move |(axis, value)| (self.row(position, axis), value))
        };
        for (row, value) in moved.iter().flat_map(along) {
            gram += row * row.transpose();
            sum += value * row;
        }
        let motion = gram.pseudo_inverse(FREE).ok()? * sum;
        let squares = moved
            .iter()
            .flat_map(along)
            .map(|(row, value)| [(value - motion.dot(&row)).powi(2), value.powi(2)]);
        let [rest, whole] = squares.fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]);
        let is_rigid = rest < 0.01 * whole;
        is_rigid.then(|| mode(&motion.transpose(), self))
    }
}

/// The motions that leave direction · u = 0 at all held positions.
pub(crate) fn free_modes(held: &[Hold], anywhere: impl Fn() -> Vector3) -> Vec<RigidMode> {
    let frame = Frame::around(held.iter().map(|(position, _)| *position), anywhere);
    let eigen = SymmetricEigen::new(frame.gram(held));
    let bound = FREE * eigen.eigenvalues.max();
    frame.modes(eigenvectors(&eigen, |value| value <= bound))
}

/// The eigenvectors of such eigenvalues.
pub(crate) fn eigenvectors(
    eigen: &SymmetricEigen<f64, nalgebra::U6>,
    such: impl Fn(f64) -> bool,
) -> Vec<RowVector6<f64>> {
    let chosen = (0..6).filter(|&k| such(eigen.eigenvalues[k]));
    chosen.map(|k| eigen.eigenvectors.column(k).transpose()).collect()
}

/// The same space by rows as sparse as they get: reduced row echelon form, so
/// that rotations come first and pure translations stand alone.
fn echelon(mut rows: Vec<RowVector6<f64>>) -> Vec<RowVector6<f64>> {
    let mut done = 0;
    for column in 0..6 {
        let size = |row: usize| rows[row][column].abs();
        let Some(best) = (done..rows.len()).max_by(|&a, &b| size(a).total_cmp(&size(b))) else {
            break;
        };
        if size(best) < ROUNDING {
            continue;
        }
        rows.swap(done, best);
        let pivot = rows[done] / rows[done][column];
        rows[done] = pivot;
        for other in (0..rows.len()).filter(|&other| other != done) {
            let factor = rows[other][column];
            rows[other] -= factor * pivot;
        }
        done += 1;
    }
    rows.truncate(done);
    rows
}

/// The motion t + ω × (x − centre) / size, for the row (ω, t).
fn mode(row: &RowVector6<f64>, frame: &Frame) -> RigidMode {
    let Frame { centre, size } = *frame;
    let largest = row.amax();
    let clean = |k: usize| if row[k].abs() < ROUNDING * largest { 0.0 } else { row[k] };
    let turn: Vector3 = std::array::from_fn(clean);
    let shift: Vector3 = std::array::from_fn(|k| clean(3 + k));
    let angle = length(turn);
    if angle == 0.0 {
        return RigidMode::Translation { direction: scale(1.0 / length(shift), shift) };
    }
    let direction = scale(1.0 / angle, turn);
    let offset = scale(size / (angle * angle), cross(turn, shift));
    let point = add(centre, offset);
    let along = size * dot3(shift, direction) / angle;
    if along.abs() < ROUNDING * size {
        RigidMode::Rotation { direction, point }
    } else {
        RigidMode::Screw { direction, point, pitch: std::f64::consts::TAU * along }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const X: Vector3 = [1.0, 0.0, 0.0];
    const Y: Vector3 = [0.0, 1.0, 0.0];
    const Z: Vector3 = [0.0, 0.0, 1.0];

    fn told(held: &[(Vector3, Vector3)]) -> Vec<String> {
        free_modes(held, || [1.0, 2.0, 3.0]).iter().map(RigidMode::to_string).collect()
    }

    #[test]
    fn nothing_held_leaves_all_six() {
        assert_eq!(
            told(&[]),
            [
                "rotation about x through (1.0000, 2.0000, 3.0000)",
                "rotation about y through (1.0000, 2.0000, 3.0000)",
                "rotation about z through (1.0000, 2.0000, 3.0000)",
                "translation along x",
                "translation along y",
                "translation along z",
            ]
        );
    }

    #[test]
    fn a_clamped_point_leaves_rotations_and_a_clamped_line_one() {
        let clamp = |p: Vector3| [(p, X), (p, Y), (p, Z)];
        let point = told(&clamp([5.0, 0.0, 7.0]));
        assert_eq!(point.len(), 3);
        assert_eq!(point[1], "rotation about y through (5.0000, 0.0000, 7.0000)");
        let line = [clamp([1.0, 1.0, 0.0]), clamp([1.0, 1.0, 4.0])].concat();
        assert_eq!(told(&line), ["rotation about z through (1.0000, 1.0000, 2.0000)"]);
        let plane = [clamp([0.0; 3]), clamp([1e-3, 0.0, 0.0]), clamp([0.0, 1e-3, 0.0])].concat();
        assert_eq!(told(&plane), [""; 0]);
    }

    #[test]
    fn a_plane_slides_and_turns_and_a_skew_direction_is_told_by_components() {
        let plane = [(X, Z), (Y, Z), ([0.0; 3], Z)];
        let modes = told(&plane);
        assert!(modes[0].starts_with("rotation about z through"), "{modes:?}");
        assert_eq!(&modes[1..], ["translation along x", "translation along y"]);
        // x and y are tied by their sum: what is left of them is their difference.
        let tie = [0.6, 0.8, 0.0];
        let skew = [(X, Z), (Y, Z), ([0.0; 3], Z), (X, tie), (Y, tie)];
        assert_eq!(told(&skew), ["translation along (0.8000, -0.6000, 0.0000)"]);
    }

    #[test]
    fn a_nut_on_a_thread_has_a_screw_left() {
        // Points on the unit circle that may not leave radially, and whose way up
        // is tied to the way round: u_z = 0.5 u_round.
        let held: Vec<_> = (0..5)
            .flat_map(|k| {
                let (sin, cos) = (f64::from(k) * 1.1).sin_cos();
                let tie = [0.5 * sin, -0.5 * cos, 1.0];
                let p = [3.0 + cos, sin, 0.0];
                [(p, [cos, sin, 0.0]), (p, tie)]
            })
            .collect();
        // A whole turn is 2π round and half of that up.
        assert_eq!(told(&held), ["screw along z through (3.0000, 0.0000, 0.0000), 3.1416 a turn"]);
    }
}

//! Whether values lie far from zero, beside what they vary by.

/// Values that differ from a reference by less than this, relative to themselves (root mean
/// squares), are measured from it. What varies more has no digit to gain.
const FAR: f64 = 0.1;

/// Whether values with this sum of squares, which differ from a reference by this, lie far
/// from zero.
pub(crate) fn is_far(squares: f64, squared_differences: f64) -> bool {
    squares > 0.0 && squared_differences <= FAR * FAR * squares
}

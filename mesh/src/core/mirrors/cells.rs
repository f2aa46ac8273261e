//! The cells of space that mirror planes make.
//!
//! Planes are perpendicular or parallel, so their normals are among three axes, and along
//! each the body has at most a *low* and a *high* plane. Cells are counted along each axis
//! from the body's own, 0; in odd ones its image is turned round.

use smallvec::{SmallVec, smallvec};

/// A cell by its number along each axis.
pub type Cell = [i8; 3];

/// The body's own cell.
pub const HERE: Cell = [0; 3];

/// The planes that a vertex lies on, a bit each.
pub type OnPlanes = u8;

/// The bit of the low plane of an axis.
pub const fn low(axis: usize) -> OnPlanes {
    1 << (2 * axis)
}

/// The bit of the high plane of an axis.
pub const fn high(axis: usize) -> OnPlanes {
    2 << (2 * axis)
}

/// Whether one of the planes is across an axis.
pub const fn is_across(planes: OnPlanes, axis: usize) -> bool {
    planes & (low(axis) | high(axis)) != 0
}

/// A vertex on a plane is the same in both cells there; this is the even one.
pub fn shared(cell: Cell, planes: OnPlanes) -> Cell {
    std::array::from_fn(|axis| match cell[axis] {
        number if number & 1 == 0 => number,
        number if planes & high(axis) != 0 => number - 1,
        number if planes & low(axis) != 0 => number + 1,
        number => number,
    })
}

/// All cells that meet in the image of a vertex in a cell as [`shared`] gives it.
pub fn meeting(cell: Cell, planes: OnPlanes) -> SmallVec<[Cell; 8]> {
    let mut cells: SmallVec<[Cell; 8]> = smallvec![cell];
    for axis in 0..3 {
        let across = match planes {
            on if on & high(axis) != 0 => 1,
            on if on & low(axis) != 0 => -1,
            _ => continue,
        };
        for at in 0..cells.len() {
            let mut next = cells[at];
            next[axis] += across;
            cells.push(next);
        }
    }
    cells
}

/// Whether images in a cell have the other orientation.
pub fn is_inside_out(cell: Cell) -> bool {
    cell.iter().map(|number| number & 1).sum::<i8>() & 1 == 1
}

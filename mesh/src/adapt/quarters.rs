//! Quartering a face: the red split of a triangle, and Wang's 1-to-4 split of a tet.

use crate::adapt::parts::Parts;

/// Quarters the face of these three places of a simplex; `midpoint` knows the vertex
/// between two vertices. Three parts at the corners, then the one in the middle; what
/// is not in the face, all have. Each is oriented as the whole.
pub(super) fn quartered<const N: usize>(
    simplex: [u32; N],
    face: [usize; 3],
    midpoint: impl Fn(u32, u32) -> u32,
) -> Parts<N> {
    let middle = |i: usize| midpoint(simplex[face[i % 3]], simplex[face[(i + 1) % 3]]);
    let middles = [0, 1, 2].map(middle);
    let with = |corners: [u32; 3]| {
        let mut part = simplex;
        face.into_iter().zip(corners).for_each(|(place, vertex)| part[place] = vertex);
        part
    };
    let [ab, bc, ca] = middles;
    let [a, b, c] = face.map(|place| simplex[place]);
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]].into_iter().map(with).collect()
}

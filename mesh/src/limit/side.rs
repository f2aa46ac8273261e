//! To which side the normal of a surface points.

use crate::core::reference_tet::FACES;
use crate::core::topology::{NONE, Topology};

/// Whether a face a < b < c is clockwise seen from the side that its normal
/// points to: out of the solid on the boundary, out of the smaller region
/// between two; a face inside a region, or without tets, is as it is.
pub(super) fn flipped(topology: &Topology, tets: &[[u32; 4]], regions: &[i32], face: u32) -> bool {
    told_flipped(topology, tets, regions, face).unwrap_or(false)
}

/// The same, `None` for a face inside a region, or without tets.
pub(super) fn told_flipped(
    topology: &Topology,
    tets: &[[u32; 4]],
    regions: &[i32],
    face: u32,
) -> Option<bool> {
    let [first, second] = topology.face_tets()[face as usize];
    let region = |tet: u32| regions[tet as usize];
    let out_of = match (first, second) {
        (NONE, _) => return None,
        (_, NONE) => first,
        _ if region(first) == region(second) => return None,
        _ if region(second) < region(first) => second,
        _ => first,
    };
    Some(!is_outward(topology.faces()[face as usize], &tets[out_of as usize]))
}

/// Whether a face of a positively oriented tet is counter-clockwise from outside.
fn is_outward(face: [u32; 3], tet: &[u32; 4]) -> bool {
    FACES.iter().any(|local| {
        let outward = local.map(|v| tet[v]);
        (0..3).any(|turn| face == [0, 1, 2].map(|i| outward[(i + turn) % 3]))
    })
}

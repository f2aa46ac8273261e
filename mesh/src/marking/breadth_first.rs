//! The tets of a mesh in breadth-first order over faces.

use crate::core::topology::{NONE, Topology};

/// The face-connected parts of a mesh; each lists its tets by their distance
/// from its lowest-numbered tet.
pub(super) fn breadth_first_parts(topology: &Topology) -> Vec<Vec<u32>> {
    let tets = topology.tet_faces().len();
    let mut reached = vec![false; tets];
    let mut parts = Vec::new();
    for root in 0..tets {
        if std::mem::replace(&mut reached[root], true) {
            continue;
        }
        let mut part = vec![root as u32];
        let mut next = 0;
        while let Some(&tet) = part.get(next) {
            next += 1;
            for neighbour in neighbours(topology, tet as usize) {
                if neighbour != NONE && !std::mem::replace(&mut reached[neighbour as usize], true) {
                    part.push(neighbour);
                }
            }
        }
        parts.push(part);
    }
    parts
}

/// The tet across each face, or [`NONE`].
pub(super) fn neighbours(topology: &Topology, tet: usize) -> [u32; 4] {
    topology.tet_faces()[tet].map(|face| {
        let [first, second] = topology.face_tets()[face as usize];
        if first == tet as u32 { second } else { first }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::raw_mesh::RawMesh;
    use crate::core::shapes::five_tet_cube;

    #[test]
    fn parts_are_told_apart_and_ordered_by_distance() {
        // Two five-tet cubes: in each the four corner tets surround the first.
        let mut raw = five_tet_cube().into_raw();
        let second: Vec<_> = raw.tets.iter().map(|tet| tet.map(|v| v + 8)).collect();
        raw.tets.rotate_left(1);
        raw.tets.extend(second);
        raw.points.extend_from_within(..);
        let parts = breadth_first_parts(&Topology::new(&RawMesh { regions: vec![0; 10], ..raw }));
        assert_eq!(parts.len(), 2);
        assert_eq!(parts[0][..2], [0, 4]);
        assert_eq!(parts[1][0], 5);
        assert_eq!([parts[0].len(), parts[1].len()], [5, 5]);
    }
}

//! By what a file tells that its points and tets are still those it was written with.

use octruss_mesh::RawMesh;

/// Odd, with bits all over: the golden ratio's fraction in 64 bits (Knuth, The
/// Art of Computer Programming 3, section 6.4).
const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;

/// The numbers of points and tets, then the lower and upper half of a checksum
/// of all coordinates and vertex numbers in their order.
///
/// The checksum is no secret: it finds what filters do (points left out, moved
/// or renumbered, tets left out), not what somebody contrives. Counts beyond 32
/// bits are cut, which no mesh with vertex numbers of 32 bits notices.
pub(crate) fn fingerprint(mesh: &RawMesh) -> [u32; 4] {
    // Adding zero turns −0 into 0: text may lose that sign.
    let coordinates = mesh.points.as_flattened().iter().map(|x| (x + 0.0).to_bits());
    let vertices = mesh.tets.iter().flat_map(|&[a, b, c, d]| [join(a, b), join(c, d)]);
    // Rotating lets the upper bits of a word, too, reach all bits.
    let mix = |sum: u64, word: u64| (sum.rotate_left(29) ^ word).wrapping_mul(FACTOR);
    let sum = vertices.fold(coordinates.fold(0, mix), mix);
    [mesh.points.len() as u32, mesh.tets.len() as u32, sum as u32, (sum >> 32) as u32]
}

fn join(low: u32, high: u32) -> u64 {
    u64::from(low) | u64::from(high) << 32
}

#[cfg(test)]
mod tests {
    use super::*;
    use octruss_mesh::shapes;

    #[test]
    fn small_meshes_have_sums_computed_by_hand() {
        let one_tet = RawMesh { tets: vec![[1, 0, 0, 0]], ..RawMesh::default() };
        // 1 times the factor; then that, rotated, times the factor again.
        let sum = FACTOR.rotate_left(29).wrapping_mul(FACTOR);
        assert_eq!(fingerprint(&RawMesh::default()), [0; 4]);
        assert_eq!(fingerprint(&one_tet), [0, 1, sum as u32, (sum >> 32) as u32]);
    }

    #[test]
    fn every_change_shows() {
        let sound = shapes::kuhn_cube(2).into_raw();
        type Change = (&'static str, fn(&mut RawMesh));
        let changes: [Change; 7] = [
            ("a point moved by one unit in the last place", |mesh| {
                mesh.points[3][1] = f64::from_bits(mesh.points[3][1].to_bits() + 1);
            }),
            ("three signs", |mesh| mesh.points[13] = mesh.points[13].map(|x| -x)),
            ("two points swapped", |mesh| mesh.points.swap(4, 5)),
            ("two vertices of a tet swapped", |mesh| mesh.tets[7].swap(0, 2)),
            ("two tets swapped", |mesh| mesh.tets.swap(0, 1)),
            ("the last tet gone", |mesh| mesh.tets.truncate(47)),
            ("a point more", |mesh| mesh.points.push([0.0; 3])),
        ];
        for (name, change) in changes {
            let mut mesh = sound.clone();
            change(&mut mesh);
            assert_ne!(fingerprint(&mesh), fingerprint(&sound), "{name}");
        }
        let mut mesh = sound.clone();
        mesh.points[0][0] = -0.0;
        assert_eq!(fingerprint(&mesh), fingerprint(&sound), "the sign of a zero");
    }
}

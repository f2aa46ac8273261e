//! The parts that a mesh consists of.

use crate::raw_mesh::RawMesh;

/// For each vertex the lowest vertex number of its part, where tets that share
/// a vertex belong together. A vertex of no tet is a part of its own. Vertex
/// numbers must be in range.
pub fn part_of_vertices(raw: &RawMesh) -> Vec<u32> {
    let mut roots: Vec<u32> = (0..raw.points.len() as u32).collect();
    for tet in &raw.tets {
        let mut low = root(&mut roots, tet[0]);
        for &v in &tet[1..] {
            let other = root(&mut roots, v);
            let (smaller, larger) = (low.min(other), low.max(other));
            roots[larger as usize] = smaller;
            low = smaller;
        }
    }
    (0..raw.points.len() as u32).map(|v| root(&mut roots, v)).collect()
}

/// The representative of a vertex's part; paths are halved on the way.
fn root(roots: &mut [u32], mut v: u32) -> u32 {
    while roots[v as usize] != v {
        roots[v as usize] = roots[roots[v as usize] as usize];
        v = roots[v as usize];
    }
    v
}

/// The first tet of each part, in order.
pub fn first_tets(raw: &RawMesh) -> Vec<u32> {
    let parts = part_of_vertices(raw);
    let mut seen = vec![false; raw.points.len()];
    let mut first = Vec::new();
    for (t, tet) in (0u32..).zip(&raw.tets) {
        let part = parts[tet[0] as usize] as usize;
        if !std::mem::replace(&mut seen[part], true) {
            first.push(t);
        }
    }
    first
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::five_tet_cube;

    #[test]
    fn a_second_cube_is_a_second_part() {
        let mut raw = five_tet_cube().into_raw();
        let shifted: Vec<_> = raw.points.iter().map(|p| p.map(|x| x + 5.0)).collect();
        raw.points.extend(shifted);
        raw.tets.extend(five_tet_cube().tets().iter().map(|tet| tet.map(|v| v + 8)));
        raw.points.push([9.0; 3]);
        let parts = part_of_vertices(&raw);
        assert_eq!(parts, [[0; 8].as_slice(), &[8; 8], &[16]].concat());
        assert_eq!(first_tets(&raw), [0, 5]);
    }
}

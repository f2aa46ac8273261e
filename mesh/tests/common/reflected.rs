//! Bodies made of parts by reflection, and what of one is what of the other.

use octruss_mesh::{CheckOptions, Hierarchy, Level, RawMesh, TetMesh, check};

/// The plane where one coordinate has a value.
#[derive(Clone, Copy)]
pub struct Plane {
    pub axis: usize,
    pub place: f64,
    /// The surface group of the part that lies in it.
    pub group: i32,
}

/// A body of a part and its reflections in planes, one after the other; the part's
/// vertices come first. With the vertex of the part that each of its own is, or is an
/// image of.
pub fn reflected(part: &RawMesh, planes: &[Plane]) -> (TetMesh, Vec<u32>) {
    let mut all = part.clone();
    let mut of: Vec<u32> = (0..part.points.len() as u32).collect();
    for &Plane { axis, place, group } in planes {
        let own = all.triangles.clone();
        all.triangles = Default::default();
        own.iter().filter(|&(_, tag)| tag != group).for_each(|(t, tag)| all.triangles.push(t, tag));
        let half = all.clone();
        let image: Vec<u32> = (0..half.points.len())
            .map(|v| {
                let mut point = half.points[v];
                if (point[axis] - place).abs() < 1e-9 {
                    return v as u32;
                }
                point[axis] = 2.0 * place - point[axis];
                all.points.push(point);
                of.push(of[v]);
                all.points.len() as u32 - 1
            })
            .collect();
        let to_image = |v: u32| image[v as usize];
        all.tets.extend(half.tets.iter().map(|&[a, b, c, d]| [c, b, a, d].map(to_image)));
        all.regions.extend(&half.regions);
        half.triangles.iter().for_each(|(t, tag)| all.triangles.push(t.map(to_image), tag));
        half.edges.iter().for_each(|(e, tag)| all.edges.push(e.map(to_image), tag));
        half.vertices.iter().for_each(|(v, tag)| all.vertices.push(v.map(to_image), tag));
    }
    let mesh = check(all, &CheckOptions::default()).expect("a sound mesh").mesh;
    (mesh, of)
}

/// A part and its body, refined alike.
pub struct Pair {
    pub part: Hierarchy,
    pub body: Hierarchy,
    /// For each level the vertex of the body that each of the part is.
    pub in_body: Vec<Vec<u32>>,
    /// For each level the vertex of the part that each of the body is or is an image of.
    pub in_part: Vec<Vec<u32>>,
}

impl Pair {
    /// `of` tells for the coarsest meshes, whose first vertices are the same.
    pub fn new(part: Hierarchy, body: Hierarchy, of: Vec<u32>) -> Self {
        let n = part.coarsest().mesh.points().len() as u32;
        let mut pair = Self { part, body, in_body: vec![(0..n).collect()], in_part: vec![of] };
        for level in 0..pair.part.transfers() {
            let [part, body] = [&pair.part, &pair.body].map(|levels| &*levels.levels()[level]);
            let in_body = refined(&pair.in_body[level], part, body);
            let in_part = refined(&pair.in_part[level], body, part);
            pair.in_body.push(in_body);
            pair.in_part.push(in_part);
        }
        pair
    }
}

/// What a map from the vertices of one mesh to those of another becomes by a step.
fn refined(map: &[u32], from: &Level, to: &Level) -> Vec<u32> {
    let n = to.mesh.points().len() as u32;
    let midpoint = |&[a, b]: &[u32; 2]| {
        let [a, b] = [a, b].map(|v| map[v as usize]);
        n + to.topology.edge_between(a, b).expect("an image of an edge is one")
    };
    map.iter().copied().chain(from.topology.edges().iter().map(midpoint)).collect()
}

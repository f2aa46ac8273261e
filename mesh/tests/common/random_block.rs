//! Random blocks with holes, regions, tags, orders and numberings.

use octruss_mesh::reference_tet::MARKING_PERMUTATIONS;
use octruss_mesh::{CheckOptions, RawMesh, TetMesh, check, shapes};
use proptest::prelude::*;

/// A block of Kuhn cells that lost some tets, with random regions, marked
/// pairs, vertex numbers, displaced vertices, and free-standing simplices.
pub fn blocks() -> impl Strategy<Value = TetMesh> {
    let cells = prop::array::uniform3(1u32..4);
    (cells, any::<u64>()).prop_map(|(cells, seed)| {
        let mut random = Random::new(seed);
        let mut raw = shapes::kuhn_box(cells, cells.map(f64::from)).into_raw();
        for point in raw.points.as_flattened_mut() {
            *point += 0.05 * (random.below(1000) as f64 / 500.0 - 1.0);
        }
        let keep: Vec<bool> = raw.tets.iter().map(|_| random.below(10) > 0).collect();
        let mut kept = keep.iter();
        raw.tets.retain(|_| *kept.next().unwrap());
        raw.regions = raw.tets.iter().map(|_| random.below(2) as i32).collect();
        raw.triangles.simplices.retain(|_| random.below(2) == 0);
        raw.triangles.tags.truncate(raw.triangles.simplices.len());
        random.renumber(&mut raw);
        for tet in &mut raw.tets {
            let order = MARKING_PERMUTATIONS[random.below(3)];
            *tet = order.map(|v| tet[v]);
        }
        add_free_simplices(&mut raw);
        check(raw, &CheckOptions::default()).expect("a valid mesh").mesh
    })
}

/// Numbers that look random and are the same in every run.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed | 1)
    }

    /// A number from 0 to `n` − 1.
    pub fn below(&mut self, n: usize) -> usize {
        // xorshift64
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % n
    }

    /// Shuffles the vertices of a mesh without tagged edges and vertices.
    pub fn renumber(&mut self, raw: &mut RawMesh) {
        let n = raw.points.len();
        let mut new: Vec<u32> = (0..n as u32).collect();
        for i in (1..n).rev() {
            new.swap(i, self.below(i + 1));
        }
        let old = raw.points.clone();
        for (v, point) in old.into_iter().enumerate() {
            raw.points[new[v] as usize] = point;
        }
        let tets = raw.tets.as_flattened_mut().iter_mut();
        for v in tets.chain(raw.triangles.simplices.as_flattened_mut()) {
            *v = new[*v as usize];
        }
    }
}

/// A fin of one triangle that hangs on vertex 0, and a curve to nowhere.
fn add_free_simplices(raw: &mut RawMesh) {
    let n = raw.points.len() as u32;
    raw.points.extend([[-9.0, 0.0, 0.0], [-9.0, 1.0, 0.0], [-8.0, 0.0, 5.0]]);
    raw.triangles.push([n, 0, n + 1], 77);
    raw.edges.push([n + 2, 0], 78);
}

//! Small named meshes for tests, examples and model problems.

use crate::core::raw_mesh::RawMesh;
use crate::core::tet_mesh::TetMesh;

/// One regular tetrahedron with edges of length 2√2.
pub fn regular_tet() -> TetMesh {
    from_lists(
        vec![[1.0, 1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0], [-1.0, -1.0, 1.0]],
        vec![[0, 1, 2, 3]],
    )
}

/// The unit cube in five tets: a regular one inside and four at corners.
pub fn five_tet_cube() -> TetMesh {
    let points = (0..8u32).map(|v| [v & 1, v >> 1 & 1, v >> 2 & 1].map(f64::from)).collect();
    from_lists(points, vec![[0, 3, 6, 5], [1, 0, 3, 5], [2, 3, 0, 6], [4, 0, 5, 6], [7, 3, 6, 5]])
}

/// The unit cube in n³ cells of six tets each, all round the cells' main
/// diagonals (the Kuhn or Freudenthal lattice), marked so that no two tets
/// disagree about a common face. Six tagged surfaces are named `x0`, `x1`,
/// `y0`, `y1`, `z0`, `z1`, with the ids 1 to 6.
///
/// # Panics
/// If `n` is 0.
pub fn kuhn_cube(n: u32) -> TetMesh {
    kuhn_box([n, n, n], [1.0, 1.0, 1.0])
}

/// A box from the origin to `size` in `cells` Kuhn cells of six tets each, with
/// the named surfaces of [`kuhn_cube`].
///
/// # Panics
/// If a number of cells is 0.
pub fn kuhn_box(cells: [u32; 3], size: [f64; 3]) -> TetMesh {
    assert!(cells.iter().all(|&n| n > 0), "a box needs at least one cell a direction");
    let [nx, ny, nz] = cells;
    let vertex = |[i, j, k]: [u32; 3]| (k * (ny + 1) + j) * (nx + 1) + i;
    let mut raw = RawMesh::default();
    for (k, j, i) in grid([nx + 1, ny + 1, nz + 1]) {
        let at = [i, j, k];
        raw.points.push(std::array::from_fn(|d| size[d] * f64::from(at[d]) / f64::from(cells[d])));
    }
    for (k, j, i) in grid(cells) {
        for tet in kuhn_cell([i, j, k]) {
            raw.tets.push(tet.map(vertex));
        }
    }
    raw.regions = vec![0; raw.tets.len()];
    tag_box_faces(&mut raw, size);
    TetMesh::trusted(raw)
}

fn grid([nx, ny, nz]: [u32; 3]) -> impl Iterator<Item = (u32, u32, u32)> {
    (0..nz).flat_map(move |k| (0..ny).flat_map(move |j| (0..nx).map(move |i| (k, j, i))))
}

/// The six monotone lattice paths across a cell, positively oriented. A path
/// reversed keeps its marked pair, so odd axis orders are walked backwards.
fn kuhn_cell(origin: [u32; 3]) -> [[[u32; 3]; 4]; 6] {
    const AXES: [([usize; 3], bool); 6] = [
        ([0, 1, 2], false),
        ([1, 2, 0], false),
        ([2, 0, 1], false),
        ([0, 2, 1], true),
        ([2, 1, 0], true),
        ([1, 0, 2], true),
    ];
    AXES.map(|(axes, odd)| {
        let mut path = [origin; 4];
        for step in 0..3 {
            path[step + 1] = path[step];
            path[step + 1][axes[step]] += 1;
        }
        // Swapping x0 and x2 flips the orientation and keeps {x0x2, x1x3}.
        if odd {
            path.swap(0, 2);
        }
        path
    })
}

fn tag_box_faces(raw: &mut RawMesh, size: [f64; 3]) {
    let sides = [
        ("x0", 0, 0.0),
        ("x1", 0, size[0]),
        ("y0", 1, 0.0),
        ("y1", 1, size[1]),
        ("z0", 2, 0.0),
        ("z1", 2, size[2]),
    ];
    for (index, (name, axis, value)) in sides.into_iter().enumerate() {
        let id = index as i32 + 1;
        raw.groups.push(crate::Group { dimension: 2, id, name: name.into() });
        for tet in &raw.tets {
            for face in crate::core::reference_tet::FACES {
                let triangle = face.map(|v| tet[v]);
                if triangle.iter().all(|&v| raw.points[v as usize][axis] == value) {
                    raw.triangles.push(triangle, id);
                }
            }
        }
    }
}

/// A mesh from points and tets alone, region 0, without tags; tets with
/// negative volume are reoriented.
fn from_lists(points: Vec<[f64; 3]>, mut tets: Vec<[u32; 4]>) -> TetMesh {
    for tet in &mut tets {
        if crate::core::reference_tet::six_volumes(tet.map(|v| points[v as usize])) < 0.0 {
            tet.swap(0, 2);
        }
    }
    let regions = vec![0; tets.len()];
    TetMesh::trusted(RawMesh { points, tets, regions, ..RawMesh::default() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_fill_their_volume_with_positive_tets() {
        for (mesh, volume) in [
            (regular_tet(), 8.0 / 3.0),
            (five_tet_cube(), 1.0),
            (kuhn_cube(3), 1.0),
            (kuhn_box([1, 2, 3], [1.0, 2.0, 4.0]), 8.0),
        ] {
            let volumes: Vec<f64> = (0..mesh.tets().len()).map(|t| mesh.volume(t)).collect();
            assert!(volumes.iter().all(|&v| v > 0.0));
            assert!((volumes.iter().sum::<f64>() - volume).abs() < 1e-13);
        }
    }

    #[test]
    fn the_box_names_all_its_boundary_faces() {
        let mesh = kuhn_box([1, 2, 3], [1.0, 1.0, 1.0]);
        assert_eq!(mesh.triangles().len(), 2 * 2 * (2 + 3 + 6));
        assert_eq!(mesh.raw().group_names(2), ["x0", "x1", "y0", "y1", "z0", "z1"]);
    }
}

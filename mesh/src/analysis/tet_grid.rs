//! Finding the tets that contain a point.

use crate::core::reference_tet::six_volumes;

/// A regular grid of boxes over a set of tets, about one box a tet, each with
/// the tets whose bounding boxes meet it.
pub(crate) struct TetGrid<'a> {
    points: &'a [[f64; 3]],
    tets: &'a [[u32; 4]],
    low: [f64; 3],
    box_size: [f64; 3],
    boxes_a_side: usize,
    boxes: Vec<Vec<u32>>,
}

impl<'a> TetGrid<'a> {
    /// Vertex numbers must be in range and coordinates finite.
    pub fn new(points: &'a [[f64; 3]], tets: &'a [[u32; 4]]) -> Self {
        let boxes_a_side = (tets.len() as f64).cbrt().ceil().max(1.0) as usize;
        let [low, high] = bounds(points);
        let box_size = [0, 1, 2].map(|k| (high[k] - low[k]) / boxes_a_side as f64);
        let boxes = vec![Vec::new(); boxes_a_side.pow(3)];
        let mut grid = Self { points, tets, low, box_size, boxes_a_side, boxes };
        for (t, tet) in (0u32..).zip(tets) {
            let [low, high] = bounds(&tet.map(|v| points[v as usize])).map(|p| grid.box_of(p));
            for i in low[0]..=high[0] {
                for j in low[1]..=high[1] {
                    for k in low[2]..=high[2] {
                        let number = grid.number([i, j, k]);
                        grid.boxes[number].push(t);
                    }
                }
            }
        }
        grid
    }

    /// The tets, of either orientation, in which all barycentric coordinates of
    /// a point are at least −`tolerance`, ascending, with these coordinates.
    pub fn containing(
        &self,
        point: [f64; 3],
        tolerance: f64,
    ) -> impl Iterator<Item = (u32, [f64; 4])> {
        self.boxes[self.number(self.box_of(point))].iter().filter_map(move |&t| {
            let corners = self.tets[t as usize].map(|v| self.points[v as usize]);
            let volume = six_volumes(corners);
            let shares: [f64; 4] = std::array::from_fn(|i| {
                let mut part = corners;
                part[i] = point;
                six_volumes(part) / volume
            });
            // Shares in a flat tet are no numbers, and fail.
            shares.iter().all(|&share| share >= -tolerance).then_some((t, shares))
        })
    }

    /// The box of a point; the nearest for a point outside.
    fn box_of(&self, point: [f64; 3]) -> [usize; 3] {
        [0, 1, 2].map(|k| {
            let at = (point[k] - self.low[k]) / self.box_size[k];
            (at as usize).min(self.boxes_a_side - 1)
        })
    }

    fn number(&self, [i, j, k]: [usize; 3]) -> usize {
        (i * self.boxes_a_side + j) * self.boxes_a_side + k
    }
}

/// The lowest and the highest coordinates.
fn bounds(points: &[[f64; 3]]) -> [[f64; 3]; 2] {
    points.iter().fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], point| {
        [[0, 1, 2].map(|k| low[k].min(point[k])), [0, 1, 2].map(|k| high[k].max(point[k]))]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::shapes::kuhn_cube;

    #[test]
    fn a_point_is_found_in_its_tet_and_on_a_face_in_both() {
        let mesh = kuhn_cube(3);
        let grid = TetGrid::new(mesh.points(), mesh.tets());
        for t in 0..mesh.tets().len() {
            let corners = mesh.corners(t);
            let centre = [0, 1, 2].map(|k| corners.iter().map(|p| p[k]).sum::<f64>() / 4.0);
            let found: Vec<_> = grid.containing(centre, 0.0).collect();
            assert_eq!(found.len(), 1);
            assert_eq!(found[0].0 as usize, t);
            assert!(found[0].1.iter().all(|share| (share - 0.25).abs() < 1e-12));
        }
        // All six tets of a cell share its main diagonal.
        assert_eq!(grid.containing([0.5; 3], 1e-12).count(), 6);
        assert_eq!(grid.containing([1.5, 0.5, 0.5], 1e-12).count(), 0);
    }
}

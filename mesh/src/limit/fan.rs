//! The triangles of one surface at one vertex, between its curves, and the
//! rules of the vertex and of the edges that lead out from it.

use crate::subdivide::rules::surface::neighbours_share;
use octruss_base::vector3::{Vector3, add, scale, subtract};
use smallvec::SmallVec;

/// Points about one vertex; enough in place for ordinary valences.
pub(super) type Around = SmallVec<[Vector3; 8]>;

/// Which rule moves the vertex of a fan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum FanRule {
    /// The surface's, by all neighbours.
    Smooth,
    /// The curve's, by these two neighbours.
    Curve([Vector3; 2]),
    /// None: the vertex stays.
    Fixed,
}

/// The neighbours of a vertex in one sector, counter-clockwise as seen by one
/// of the sector's triangles.
///
/// A closed fan goes all round. An open one begins and ends at curve edges;
/// where a curve runs out in the vertex (a dart), both are the same edge, and
/// the first neighbour is repeated as the last.
#[derive(Debug, Clone)]
pub(super) struct Fan {
    pub rule: FanRule,
    pub closed: bool,
    /// The place of the triangle's next corner; the one after it follows.
    pub at: usize,
    pub points: Around,
}

impl Fan {
    /// The neighbour `steps` after the triangle's next corner; in a closed fan
    /// any number leads somewhere.
    pub fn neighbour(&self, steps: isize) -> usize {
        let place = self.at as isize + steps;
        if self.closed {
            place.rem_euclid(self.points.len() as isize) as usize
        } else {
            place as usize
        }
    }

    /// Whether the edge to the triangle's next corner is on a curve.
    pub fn next_is_curve(&self) -> bool {
        !self.closed && self.at == 0
    }

    /// Whether the edge to the triangle's corner after next is on a curve.
    pub fn previous_is_curve(&self) -> bool {
        !self.closed && self.at + 2 == self.points.len()
    }

    /// The neighbours, each once.
    pub fn distinct(&self) -> &[Vector3] {
        let is_dart = !self.closed && self.rule == FanRule::Smooth;
        &self.points[..self.points.len() - usize::from(is_dart)]
    }

    /// Where the rule moves the vertex.
    pub fn moved(&self, centre: Vector3) -> Vector3 {
        match self.rule {
            FanRule::Fixed => centre,
            FanRule::Curve([p, q]) => add(scale(0.75, centre), scale(0.125, add(p, q))),
            FanRule::Smooth => {
                let ring = self.distinct();
                let share = neighbours_share(ring.len());
                let mean = scale(1.0 / ring.len() as f64, sum(ring));
                add(centre, scale(share, subtract(mean, centre)))
            }
        }
    }

    /// The new vertex of the edge to a neighbour.
    pub fn spoke(&self, centre: Vector3, place: usize) -> Vector3 {
        let (ring, last) = (&self.points, self.points.len() - 1);
        let [before, after] = match (self.closed, place) {
            (false, 0) => return middle(centre, ring[0]),
            (false, p) if p == last => return middle(centre, ring[p]),
            (true, 0) => [last, 1],
            (true, p) if p == last => [p - 1, 0],
            (_, p) => [p - 1, p + 1],
        };
        let ends = scale(3.0 / 8.0, add(centre, ring[place]));
        add(ends, scale(1.0 / 8.0, add(ring[before], ring[after])))
    }

    /// The fan one level finer, of the vertex at its new place.
    pub fn refined(&self, centre: Vector3) -> Self {
        let rule = match self.rule {
            FanRule::Curve(ends) => FanRule::Curve(ends.map(|end| middle(centre, end))),
            same => same,
        };
        let points = (0..self.points.len()).map(|place| self.spoke(centre, place)).collect();
        Self { rule, closed: self.closed, at: self.at, points }
    }

    /// Takes a vector off all points.
    pub fn shift(&mut self, origin: Vector3) {
        self.points.iter_mut().for_each(|p| *p = subtract(*p, origin));
        if let FanRule::Curve(ends) = &mut self.rule {
            *ends = ends.map(|p| subtract(p, origin));
        }
    }
}

/// The sum of some points.
pub(super) fn sum(points: &[Vector3]) -> Vector3 {
    points.iter().fold([0.0; 3], |sum, &p| add(sum, p))
}

/// The rule of an edge on a curve.
pub(super) fn middle(a: Vector3, b: Vector3) -> Vector3 {
    scale(0.5, add(a, b))
}

//! One subdivision of a ring: the ring of one of the triangle's four children.

use octruss_base::vector3::Vector3;
use smallvec::smallvec;

use super::fan::{Fan, FanRule};
use super::ring::Ring;

impl Ring {
    /// The child at corner i: corner i at its new place, the others the new
    /// vertices of the edges that lead there.
    pub fn corner_child(&self, i: usize) -> Self {
        let new = NewVertices::new(self);
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let (next, previous, across) = (new.edges[i], new.edges[k], new.edges[j]);
        let own = new.corners[i];
        let mut corners = [own; 3];
        (corners[j], corners[k]) = (next, previous);
        let is_curve = [self.fans[i].next_is_curve(), self.fans[i].previous_is_curve()];
        // Seen from the new vertex of the edge i j, counter-clockwise from its
        // next corner, the one on the edge k i; then from that of the edge k i.
        let beside_next = if is_curve[0] {
            on_curve([new.corners[j], across, previous, own], 2)
        } else {
            let outer = [self.spoke(i, -1), self.spoke(j, 2)];
            inside([previous, own, outer[0], outer[1], new.corners[j], across])
        };
        let beside_previous = if is_curve[1] {
            on_curve([own, next, across, new.corners[k]], 0)
        } else {
            let outer = [self.spoke(k, -1), self.spoke(i, 2)];
            inside([own, next, across, new.corners[k], outer[0], outer[1]])
        };
        let mut fans = [const { None }; 3];
        fans[i] = Some(self.fans[i].refined(self.corners[i]));
        (fans[j], fans[k]) = (Some(beside_next), Some(beside_previous));
        let fans = fans.map(|fan| fan.expect("one for each corner"));
        Self { origin: self.origin, corners, fans }
    }

    /// The child in the middle: corner i on the edge opposite the old corner i.
    pub fn middle_child(&self) -> Self {
        let new = NewVertices::new(self);
        let fan = |i: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            // The edges j k (this vertex), k i and i j.
            let (next, previous) = (new.edges[k], new.edges[i]);
            if self.fans[j].next_is_curve() {
                return on_curve([new.corners[k], next, previous, new.corners[j]], 1);
            }
            let outer = [self.spoke(j, -1), self.spoke(k, 2)];
            inside([next, previous, new.corners[j], outer[0], outer[1], new.corners[k]])
        };
        let corners = [new.edges[1], new.edges[2], new.edges[0]];
        Self { origin: self.origin, corners, fans: [fan(0), fan(1), fan(2)] }
    }

    /// The new vertex of an edge from corner i, by the steps from its next corner.
    fn spoke(&self, i: usize, steps: isize) -> Vector3 {
        let fan = &self.fans[i];
        fan.spoke(self.corners[i], fan.neighbour(steps))
    }
}

/// The new vertices of a triangle.
struct NewVertices {
    corners: [Vector3; 3],
    /// Edge i leads from corner i to the next.
    edges: [Vector3; 3],
}

impl NewVertices {
    fn new(ring: &Ring) -> Self {
        let corners = [0, 1, 2].map(|i| ring.fans[i].moved(ring.corners[i]));
        Self { corners, edges: [0, 1, 2].map(|i| ring.spoke(i, 0)) }
    }
}

/// The fan of a new vertex inside a surface.
fn inside(points: [Vector3; 6]) -> Fan {
    Fan { rule: FanRule::Smooth, closed: true, at: 0, points: points.into_iter().collect() }
}

/// The fan of a new vertex on a curve.
fn on_curve([first, second, third, last]: [Vector3; 4], at: usize) -> Fan {
    let rule = FanRule::Curve([first, last]);
    Fan { rule, closed: false, at, points: smallvec![first, second, third, last] }
}

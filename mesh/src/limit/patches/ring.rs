//! A triangle with all that its limit depends on: what lies round its corners.

use octruss_base::vector3::{Vector3, add, scale, subtract};

use super::spline_patch::Patch;
use crate::limit::fan::Fan;

/// What lies round a corner of a triangle, from the triangle's next corner on,
/// counter-clockwise.
#[derive(Debug, Clone)]
pub(in crate::limit) enum Surroundings {
    /// Six neighbours of the regular lattice, some of them perhaps mirrored.
    Regular([Vector3; 6]),
    /// Anything else.
    Extraordinary(Fan),
}

/// A triangle of some level with what lies round its corners: this is closed
/// under subdivision, so that the ring of each child follows from it.
///
/// Points are differences from an origin that goes with the triangle, so that
/// what is small stays exact however deep the recursion is.
#[derive(Debug, Clone)]
pub(in crate::limit) struct Ring {
    pub origin: Vector3,
    pub corners: [Vector3; 3],
    /// Those of corner i count from corner i + 1.
    pub round: [Surroundings; 3],
}

impl Surroundings {
    /// Where the rule moves the corner.
    pub fn moved(&self, centre: Vector3) -> Vector3 {
        match self {
            Self::Extraordinary(fan) => fan.moved(centre),
            Self::Regular(ring) => {
                let sum = ring.iter().fold([0.0; 3], |sum, &p| add(sum, p));
                add(scale(5.0 / 8.0, centre), scale(1.0 / 16.0, sum))
            }
        }
    }

    /// The new vertex of the edge to the neighbour some steps after the
    /// triangle's next corner.
    pub fn spoke(&self, centre: Vector3, steps: isize) -> Vector3 {
        match self {
            Self::Extraordinary(fan) => fan.spoke(centre, fan.neighbour(steps)),
            Self::Regular(ring) => {
                let at = |step: isize| ring[step.rem_euclid(6) as usize];
                let ends = scale(3.0 / 8.0, add(centre, at(steps)));
                add(ends, scale(1.0 / 8.0, add(at(steps - 1), at(steps + 1))))
            }
        }
    }

    /// Whether the edge to the next corner is on a curve that no mirror image
    /// continues.
    fn next_is_curve(&self) -> bool {
        matches!(self, Self::Extraordinary(fan) if fan.next_is_curve())
    }

    fn previous_is_curve(&self) -> bool {
        matches!(self, Self::Extraordinary(fan) if fan.previous_is_curve())
    }
}

impl Ring {
    /// The control points of the patch, if all corners are regular.
    pub fn patch(&self) -> Option<Patch> {
        let [Surroundings::Regular(a), Surroundings::Regular(b), Surroundings::Regular(c)] =
            &self.round
        else {
            return None;
        };
        Some(patch(self.corners, [a, b, c]))
    }

    /// Goes to the child at corner i: corner i at its new place, which becomes
    /// the origin, and the new vertices of the edges that lead there.
    pub fn go_to_corner(&mut self, i: usize) {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let own = self.round[i].moved(self.corners[i]);
        let [at_j, at_k] = [j, k].map(|c| subtract(self.round[c].moved(self.corners[c]), own));
        let [ij, jk, ki] = [i, j, k].map(|c| subtract(self.spoke(c, 0), own));
        let here = [0.0; 3];
        // Seen from the new vertex of the edge i j, then from that of k i.
        let beyond_ij = self.beyond(i, own, [here, ij, at_j], [ki, jk]);
        let beyond_ki = self.beyond(k, own, [at_k, ki, here], [jk, ij]);
        let beside_j = [ki, here, beyond_ij[0], beyond_ij[1], at_j, jk];
        let beside_k = [here, ij, jk, at_k, beyond_ki[0], beyond_ki[1]];
        let inner = match &self.round[i] {
            Surroundings::Regular(_) => Surroundings::Regular(std::array::from_fn(|step| {
                subtract(self.spoke(i, step as isize), own)
            })),
            Surroundings::Extraordinary(fan) => {
                let mut fan = fan.refined(self.corners[i]);
                fan.shift(own);
                Surroundings::Extraordinary(fan)
            }
        };
        self.origin = add(self.origin, own);
        (self.corners[i], self.corners[j], self.corners[k]) = (here, ij, ki);
        self.round[i] = inner;
        self.round[j] = Surroundings::Regular(beside_j);
        self.round[k] = Surroundings::Regular(beside_k);
    }

    /// The patch of the child in the middle, whose corner i is on the edge
    /// opposite corner i.
    pub fn middle_patch(&self) -> Patch {
        let at = [0, 1, 2].map(|c| self.round[c].moved(self.corners[c]));
        let edges = [0, 1, 2].map(|c| self.spoke(c, 0));
        let round = |i: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let (next, previous) = (edges[k], edges[i]);
            let beyond = self.beyond(j, [0.0; 3], [at[j], edges[j], at[k]], [previous, next]);
            [next, previous, at[j], beyond[0], beyond[1], at[k]]
        };
        patch([edges[1], edges[2], edges[0]], [&round(0), &round(1), &round(2)])
    }

    fn spoke(&self, i: usize, steps: isize) -> Vector3 {
        self.round[i].spoke(self.corners[i], steps)
    }

    /// The new vertices beyond the edge from corner i to the next, first that
    /// on the side of corner i: those of the edges there, or across a curve the
    /// mirror images of the two on this side. Given as differences from
    /// `origin`, as is what it gets: the new vertices along the edge, and the
    /// two on this side.
    fn beyond(
        &self,
        i: usize,
        origin: Vector3,
        [start, new, end]: [Vector3; 3],
        [near_start, near_end]: [Vector3; 2],
    ) -> [Vector3; 2] {
        let j = (i + 1) % 3;
        if self.round[i].next_is_curve() || self.round[j].previous_is_curve() {
            let mirrored = |along, inner| subtract(add(new, along), inner);
            return [mirrored(start, near_start), mirrored(end, near_end)];
        }
        [self.spoke(i, -1), self.spoke(j, 2)].map(|point| subtract(point, origin))
    }
}

/// The control points of a triangle with regular corners.
pub(in crate::limit) fn patch([a, b, c]: [Vector3; 3], round: [&[Vector3; 6]; 3]) -> Patch {
    let [at_a, at_b, at_c] = round;
    [a, b, c, at_b[5], at_c[3], at_c[4], at_a[2], at_a[3], at_a[4], at_a[5], at_b[3], at_b[4]]
}

//! Motions of bodies that meet at edges or single vertices only.
//!
//! Bodies that hang together by faces are rigid to this check; where they share less, they
//! are coupled by equal displacements at the shared vertices. A body that is held in all its
//! motions holds what it shares with its neighbours; what is left after that moves together,
//! if at all: six unknowns a body, a row for each held direction, three for each vertex shared
//! by two, and the null space of all these rows.

use crate::boundary::motions::{FREE, Frame, Hold, eigenvectors, free_modes};
use crate::rigid_mode::RigidMode;
use nalgebra::{DMatrix, Matrix6, SymmetricEigen};
use octruss_base::disjoint_sets::DisjointSets;
use octruss_base::vector3::{IDENTITY, Vector3};
use octruss_mesh::Bodies;
use std::collections::BTreeSet;

/// Up to how many bodies that hold one another only together are looked at: the dense
/// eigenproblem takes a second for as many, and grows with the third power. A mesh with more
/// of them passes here, and its solve may tell that the matrix is singular.
const MOST: usize = 100;

/// A body that can move about its hinges, with these motions: of several the one with the
/// fewest. `held` is what is held of each.
pub(crate) fn loose_body(
    points: &[Vector3],
    bodies: &Bodies,
    mut held: Vec<Vec<Hold>>,
) -> Option<(u32, Vec<RigidMode>)> {
    if bodies.shared().is_empty() {
        return None;
    }
    let loose = hold_by_neighbours(points, bodies, &mut held);
    let mut found: Vec<(u32, Vec<RigidMode>)> = Vec::new();
    for group in groups(bodies, &loose) {
        if group.len() <= MOST {
            found.extend(Group { points, bodies, held: &held, members: &group }.motions());
        }
    }
    found.into_iter().min_by_key(|(body, modes)| (modes.len(), *body))
}

/// Adds to what is held of each body the vertices that it shares with wholly held ones, again
/// and again; which bodies with neighbours are not wholly held in the end.
fn hold_by_neighbours(points: &[Vector3], bodies: &Bodies, held: &mut [Vec<Hold>]) -> Vec<bool> {
    let mut meetings: Vec<Vec<usize>> = vec![Vec::new(); bodies.count()];
    for (place, (_, meeting)) in bodies.shared().iter().enumerate() {
        meeting.iter().for_each(|body| meetings[*body as usize].push(place));
    }
    let mut loose: Vec<bool> = meetings.iter().map(|places| !places.is_empty()).collect();
    let mut waiting: BTreeSet<usize> = (0..bodies.count()).filter(|&body| loose[body]).collect();
    while let Some(body) = waiting.pop_first() {
        if !free_modes(&held[body], || [0.0; 3]).is_empty() {
            continue;
        }
        loose[body] = false;
        for &place in &meetings[body] {
            let (vertex, meeting) = &bodies.shared()[place];
            for other in meeting.iter().map(|body| *body as usize).filter(|&body| loose[body]) {
                held[other].extend(IDENTITY.map(|axis| (points[*vertex as usize], axis)));
                waiting.insert(other);
            }
        }
    }
    loose
}

/// The loose bodies that share vertices, ascending.
fn groups(bodies: &Bodies, loose: &[bool]) -> Vec<Vec<u32>> {
    let mut sets = DisjointSets::new(bodies.count());
    for (_, meeting) in bodies.shared() {
        let mut loose = meeting.iter().filter(|body| loose[**body as usize]);
        if let Some(&first) = loose.next() {
            loose.for_each(|&body| sets.join(first, body));
        }
    }
    let is_loose = |body: &u32| loose[*body as usize];
    let mut members: Vec<(u32, u32)> =
        (0..bodies.count() as u32).filter(is_loose).map(|body| (sets.lowest(body), body)).collect();
    members.sort_unstable();
    let group = |same: &[(u32, u32)]| same.iter().map(|(_, body)| *body).collect();
    members.chunk_by(|a, b| a.0 == b.0).map(group).collect()
}

/// Bodies that hold one another, if at all, only together.
struct Group<'a> {
    points: &'a [Vector3],
    bodies: &'a Bodies,
    held: &'a [Vec<Hold>],
    /// Ascending.
    members: &'a [u32],
}

impl Group<'_> {
    /// The bodies that can move, with their motions.
    fn motions(&self) -> Vec<(u32, Vec<RigidMode>)> {
        let meetings = self.meetings();
        let frames: Vec<Frame> =
            (0..self.members.len()).map(|member| self.frame(member, &meetings)).collect();
        let eigen = SymmetricEigen::new(self.gram(&frames, &meetings));
        let bound = FREE * eigen.eigenvalues.max();
        let free: Vec<usize> =
            (0..eigen.eigenvalues.len()).filter(|&k| eigen.eigenvalues[k] <= bound).collect();
        let null_space = eigen.eigenvectors.select_columns(&free);
        let mut motions = Vec::new();
        for (member, frame) in frames.iter().enumerate() {
            let own = null_space.rows(6 * member, 6);
            let mut squares = Matrix6::zeros();
            squares.copy_from(&(own * own.transpose()));
            // Columns of the null space have length 1: what is less does not move.
            let space = eigenvectors(&SymmetricEigen::new(squares), |value| value > FREE);
            if !space.is_empty() {
                motions.push((self.members[member], frame.modes(space)));
            }
        }
        motions
    }

    /// Shared vertices with the places of the members that share them, where some do.
    fn meetings(&self) -> Vec<(Vector3, Vec<usize>)> {
        let place = |body: &u32| self.members.binary_search(body).ok();
        let meetings = self.bodies.shared().iter().map(|(vertex, meeting)| {
            let members: Vec<usize> = meeting.iter().filter_map(place).collect();
            (self.points[*vertex as usize], members)
        });
        meetings.filter(|(_, members)| members.len() > 1).collect()
    }

    /// Round all places where a member is held or shares a vertex.
    fn frame(&self, member: usize, meetings: &[(Vector3, Vec<usize>)]) -> Frame {
        let held = &self.held[self.members[member] as usize];
        let met = meetings.iter().filter(|(_, members)| members.contains(&member));
        let positions: Vec<Vector3> =
            held.iter().map(|(position, _)| *position).chain(met.map(|(p, _)| *p)).collect();
        Frame::around(positions.iter().copied(), || [0.0; 3])
    }

    /// The sum of the squares of all rows, six unknowns a member.
    fn gram(&self, frames: &[Frame], meetings: &[(Vector3, Vec<usize>)]) -> DMatrix<f64> {
        let size = 6 * self.members.len();
        let mut gram = DMatrix::zeros(size, size);
        let mut add = |a: usize, b: usize, block: Matrix6<f64>| {
            let mut view = gram.fixed_view_mut::<6, 6>(6 * a, 6 * b);
            view += block;
        };
        for (member, frame) in frames.iter().enumerate() {
            // Whatever the number of places where a motion is held, it counts as one row.
            let held = SymmetricEigen::new(frame.gram(&self.held[self.members[member] as usize]));
            let bound = FREE * held.eigenvalues.max();
            for row in eigenvectors(&held, |value| value > bound) {
                add(member, member, row.transpose() * row);
            }
        }
        for (position, members) in meetings {
            for (&a, b) in members[1..].iter().map(|b| (&members[0], *b)) {
                for axis in IDENTITY {
                    let [one, other] = [a, b].map(|member| frames[member].row(*position, axis));
                    add(a, a, one * one.transpose());
                    add(b, b, other * other.transpose());
                    add(a, b, -one * other.transpose());
                    add(b, a, -other * one.transpose());
                }
            }
        }
        gram
    }
}

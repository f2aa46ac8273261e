//! Control points with the sectors of their surfaces: from numbers to points.

use std::array::from_fn;

use octruss_base::vector3::{Vector3, add, subtract};

use super::corner::CornerLimit;
use super::error::LimitError;
use super::fan::{Fan, FanRule};
use super::patches::ring::{Ring, Surroundings};
use super::sectors::{CornerPlace, Sector, Sectors};
use crate::core::topology::NONE;

/// One point a vertex, and the sectors.
#[derive(Debug, Clone)]
pub(super) struct Controls<'a> {
    pub points: &'a [Vector3],
    pub sectors: Sectors,
}

impl Controls<'_> {
    /// The ring of a triangle; its first corner is the origin.
    ///
    /// # Errors
    /// If surfaces touch at a smooth corner.
    #[inline]
    pub fn ring(&self, corners: &[CornerPlace; 3]) -> Result<Ring, LimitError> {
        let sectors = corners.map(|corner| &self.sectors.sectors[corner.sector as usize]);
        if let Some(sector) = sectors.iter().find(|sector| sector.touches) {
            return Err(LimitError::NotADisc { vertex: sector.vertex });
        }
        let points = sectors.map(|sector| self.points[sector.vertex as usize]);
        let origin = points[0];
        Ok(Ring {
            origin,
            corners: points.map(|point| subtract(point, origin)),
            round: from_fn(|i| self.surroundings(corners[i], sectors[i], origin)),
        })
    }

    /// The limit at the vertex of a sector.
    pub fn sector_limit(&self, number: u32) -> CornerLimit {
        let sector = &self.sectors.sectors[number as usize];
        let origin = self.points[sector.vertex as usize];
        let neighbours = self.sectors.neighbours(number as usize);
        let mut limit = if sector.closed && !sector.fixed && sector.along[0] == NONE {
            // Most vertices are smooth; these need no list of points.
            let ring = neighbours.iter().map(|&v| subtract(self.points[v as usize], origin));
            let mut limit = CornerLimit::smooth(ring, neighbours.len());
            if sector.reversed {
                limit.reverse();
            }
            limit
        } else {
            let corner = CornerPlace { sector: number, at: 0, reversed: sector.reversed };
            CornerLimit::new(&self.fan(corner, sector, origin), [0.0; 3])
        };
        limit.position = add(origin, limit.position);
        limit
    }

    /// What lies round a corner, in the triangle's order.
    #[inline]
    fn surroundings(&self, corner: CornerPlace, sector: &Sector, origin: Vector3) -> Surroundings {
        if sector.regular {
            Surroundings::Regular(self.hexagon(corner, sector, origin))
        } else {
            Surroundings::Extraordinary(self.fan(corner, sector, origin))
        }
    }

    /// The six neighbours of a regular corner, mirrored across its curve where
    /// it has one.
    #[inline]
    fn hexagon(&self, corner: CornerPlace, sector: &Sector, origin: Vector3) -> [Vector3; 6] {
        let neighbours = self.sectors.neighbours(corner.sector as usize);
        let point = |place: usize| subtract(self.points[neighbours[place] as usize], origin);
        let at = corner.at as usize;
        // Against the order the neighbour by which the way leaves comes first.
        let place = |step: usize| {
            let turned = if corner.reversed { at + 7 - step } else { at + step };
            turned % 6
        };
        if sector.closed {
            return from_fn(|step| point(place(step)));
        }
        let centre = subtract(self.points[sector.vertex as usize], origin);
        let all: [Vector3; 4] = from_fn(point);
        let mirrored = |along, inner| subtract(add(centre, along), inner);
        from_fn(|step| match place(step) {
            4 => mirrored(all[3], all[2]),
            5 => mirrored(all[0], all[1]),
            known => all[known],
        })
    }

    /// The fan of a corner, as differences from an origin, in the triangle's
    /// order.
    fn fan(&self, corner: CornerPlace, sector: &Sector, origin: Vector3) -> Fan {
        let neighbours = self.sectors.neighbours(corner.sector as usize);
        let point = |&v: &u32| subtract(self.points[v as usize], origin);
        let (at, n) = (corner.at as usize, neighbours.len());
        let (points, at) = if corner.reversed {
            // The neighbour by which the way leaves comes first.
            let at = if sector.closed { (2 * n - 2 - at) % n } else { n - 2 - at };
            (neighbours.iter().rev().map(point).collect(), at)
        } else {
            (neighbours.iter().map(point).collect(), at)
        };
        let rule = match sector.along {
            _ if sector.fixed => FanRule::Fixed,
            [NONE, _] => FanRule::Smooth,
            ends => FanRule::Curve(ends.map(|v| point(&v))),
        };
        Fan { rule, closed: sector.closed, at, points }
    }
}

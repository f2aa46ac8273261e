//! The limit of the surface strata, at any place of any triangle.

use std::array::from_fn;

use octruss_base::chunks::map_ranges;
use octruss_base::vector3::{Vector3, add, scale, subtract};

use super::corner::CornerLimit;
use super::error::LimitError;
use super::fan::{Fan, FanRule};
use super::point::{SurfacePoint, oriented};
use super::ring::Ring;
use super::sectors::{CornerPlace, Sector, Sectors, flipped};
use super::spline_patch;
use crate::core::raw_mesh::RawMesh;
use crate::core::strata::Strata;
use crate::core::topology::{NONE, Topology};

/// Where in a triangle: the number of its face in the [`Topology`], and the
/// barycentric coordinates (u, v) of its second and third corner, in ascending
/// order of vertices.
pub type Place = (u32, [f64; 2]);

/// The limit of the surface strata under the approximating schemes.
///
/// Surfaces are cut along curves: a triangle reads its own side only. Points
/// may be others than the mesh's own (virtual control points).
#[derive(Debug, Clone)]
pub struct LimitSurface<'a> {
    topology: &'a Topology,
    mesh: &'a RawMesh,
    points: &'a [Vector3],
    sectors: Sectors,
}

/// A vertex on a limit surface, seen from one of its sectors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectorLimit {
    /// The vertex.
    pub vertex: u32,
    /// A face of the sector.
    pub face: u32,
    /// The limit there; the normal as that of [`SurfacePoint::normal`].
    pub limit: CornerLimit,
}

/// How near a corner (u, v) is the corner itself: there even the slowest
/// eigenvalue, 5/8, has brought all points together in double precision.
const AT_CORNER: f64 = 1.0 / (1u128 << 127) as f64;

impl<'a> LimitSurface<'a> {
    /// Of a mesh with this topology and these strata; one point a vertex.
    ///
    /// # Errors
    /// If the points are not as many as the vertices.
    pub fn new(
        mesh: &'a RawMesh,
        topology: &'a Topology,
        strata: &Strata,
        points: &'a [Vector3],
    ) -> Result<Self, LimitError> {
        let vertices = topology.vertex_count();
        if points.len() != vertices {
            return Err(LimitError::Points { points: points.len(), vertices });
        }
        Ok(Self { topology, mesh, points, sectors: Sectors::new(topology, strata) })
    }

    /// The limit position at a place, in mesh units.
    ///
    /// # Errors
    /// If the face is on no surface, (u, v) outside the triangle, or a corner
    /// smooth though surfaces touch there.
    pub fn position(&self, (face, uv): Place) -> Result<Vector3, LimitError> {
        let ring = self.ring(face, uv)?;
        Ok(match descend(ring, uv) {
            Reached::Patch(patch) => {
                add(patch.origin, spline_patch::value(&patch.controls, patch.uv))
            }
            Reached::Corner(ring, i) => {
                add(ring.origin, CornerLimit::new(&ring.fans[i], ring.corners[i]).position)
            }
        })
    }

    /// Position, derivatives, normal and curvatures at a place.
    ///
    /// # Errors
    /// As [`Self::position`].
    pub fn evaluate(&self, (face, uv): Place) -> Result<SurfacePoint, LimitError> {
        let ring = self.ring(face, uv)?;
        let flip = self.is_flipped(face);
        Ok(match descend(ring, uv) {
            Reached::Patch(patch) => {
                let point = spline_patch::with_derivatives(&patch.controls, patch.uv);
                let first = point.first.map(|d| scale(patch.scale, d));
                let second = point.second.map(|d| scale(patch.scale * patch.scale, d));
                SurfacePoint::regular(add(patch.origin, point.value), first, second, flip)
            }
            Reached::Corner(ring, i) => {
                let limit = CornerLimit::new(&ring.fans[i], ring.corners[i]);
                SurfacePoint {
                    position: add(ring.origin, limit.position),
                    tangents: limit.tangents,
                    second: None,
                    normal: oriented(limit.normal, flip),
                    curvatures: None,
                }
            }
        })
    }

    /// [`Self::position`] at many places, in parallel.
    ///
    /// # Errors
    /// The first that occurs, in order.
    pub fn positions(&self, places: &[Place]) -> Result<Vec<Vector3>, LimitError> {
        in_parallel(places.len(), |i| self.position(places[i]))
    }

    /// [`Self::evaluate`] at many places, in parallel.
    ///
    /// # Errors
    /// The first that occurs, in order.
    pub fn evaluate_all(&self, places: &[Place]) -> Result<Vec<SurfacePoint>, LimitError> {
        in_parallel(places.len(), |i| self.evaluate(places[i]))
    }

    /// The limit at every vertex on a surface, one entry for each sector, by
    /// vertex; by masks, without evaluating patches. Those of
    /// [`Self::touching`] are left out.
    pub fn sector_limits(&self) -> Vec<SectorLimit> {
        let sectors = &self.sectors.sectors;
        let chunks = map_ranges(sectors.len(), |range| {
            let whole = range.filter(|&number| !sectors[number].touches);
            let limits = whole.map(|number| {
                let Sector { vertex, face, reversed, .. } = sectors[number];
                let origin = self.points[vertex as usize];
                let corner = CornerPlace { sector: number as u32, at: 0, reversed };
                let mut limit = CornerLimit::new(&self.fan(corner, origin), [0.0; 3]);
                limit.position = add(origin, limit.position);
                limit.normal = oriented(limit.normal, self.is_flipped(face));
                SectorLimit { vertex, face, limit }
            });
            limits.collect::<Vec<_>>()
        });
        chunks.concat()
    }

    /// The smooth vertices at which surfaces touch, ascending: about them there
    /// is no limit surface.
    pub fn touching(&self) -> Vec<u32> {
        let sectors = self.sectors.sectors.iter().filter(|sector| sector.touches);
        let mut vertices: Vec<u32> = sectors.map(|sector| sector.vertex).collect();
        vertices.dedup();
        vertices
    }

    fn is_flipped(&self, face: u32) -> bool {
        flipped(self.topology, &self.mesh.tets, &self.mesh.regions, face)
    }

    /// The ring of a triangle, if the place is a place.
    #[inline]
    fn ring(&self, face: u32, [u, v]: [f64; 2]) -> Result<Ring, LimitError> {
        let Some(&number) = self.sectors.number_of.get(face as usize) else {
            return Err(LimitError::NoFace { face, faces: self.sectors.number_of.len() });
        };
        let Some(places) = self.sectors.corners.get(number as usize) else {
            return Err(LimitError::NotOnSurface { face });
        };
        // Rounding may take the third coordinate a little below zero.
        if !(u >= 0.0 && v >= 0.0 && u + v <= 1.0 + 4.0 * f64::EPSILON) {
            return Err(LimitError::Outside { u, v });
        }
        let vertices = self.topology.faces()[face as usize];
        let sectors = places.map(|place| &self.sectors.sectors[place.sector as usize]);
        if let Some(sector) = sectors.into_iter().find(|sector| sector.touches) {
            return Err(LimitError::NotADisc { vertex: sector.vertex });
        }
        let origin = self.points[vertices[0] as usize];
        Ok(Ring {
            origin,
            corners: vertices.map(|v| subtract(self.points[v as usize], origin)),
            fans: from_fn(|i| self.fan(places[i], origin)),
        })
    }

    /// The fan of a corner, as differences from an origin, in the triangle's
    /// order.
    #[inline]
    fn fan(&self, corner: CornerPlace, origin: Vector3) -> Fan {
        let sector = &self.sectors.sectors[corner.sector as usize];
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

/// What a recursion ends in.
enum Reached {
    Patch(SubPatch),
    /// An extraordinary corner of a ring.
    Corner(Ring, usize),
}

/// A regular patch inside a triangle.
struct SubPatch {
    origin: Vector3,
    controls: spline_patch::Patch,
    uv: [f64; 2],
    /// Derivatives by the triangle's coordinates over those by the patch's.
    scale: f64,
}

/// Subdivides a ring towards a place until that lies in a regular patch
/// (Wang's Table 5-1, without its end at a fixed depth).
#[inline]
fn descend(mut ring: Ring, [u, v]: [f64; 2]) -> Reached {
    let mut at = inside([u, v]);
    let mut scale = 1.0;
    loop {
        if let Some(controls) = ring.patch() {
            let uv = [at[1], at[2]];
            return Reached::Patch(SubPatch { origin: ring.origin, controls, uv, scale });
        }
        let Some(i) = (0..3).find(|&i| at[i] >= 0.5) else {
            ring = ring.middle_child();
            at = at.map(|x| 1.0 - 2.0 * x);
            scale *= -2.0;
            continue;
        };
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        if at[j].max(at[k]) < AT_CORNER && ring.fans[i].hexagon(ring.corners[i]).is_none() {
            return Reached::Corner(ring, i);
        }
        ring = ring.corner_child(i);
        let corner = ring.corners[i];
        ring = ring.rebased(corner);
        at = at.map(|x| 2.0 * x);
        // The first two are exact; the third is what they leave.
        (at[1], at[2]) = match i {
            0 => (at[1], at[2]),
            1 => (at[1] - 1.0, at[2]),
            _ => (at[1], at[2] - 1.0),
        };
        at[0] = 1.0 - at[1] - at[2];
        scale *= 2.0;
    }
}

/// The three barycentric coordinates; a sum above one is rounding, and is taken
/// off the larger.
fn inside([u, v]: [f64; 2]) -> [f64; 3] {
    if u + v < 1.0 {
        [1.0 - u - v, u, v]
    } else if u < v {
        [0.0, u, 1.0 - u]
    } else {
        [0.0, 1.0 - v, v]
    }
}

/// Results in order, or the first error.
fn in_parallel<T: Send>(
    n: usize,
    each: impl Fn(usize) -> Result<T, LimitError> + Sync,
) -> Result<Vec<T>, LimitError> {
    let chunks = map_ranges(n, |range| range.map(&each).collect::<Result<Vec<T>, _>>());
    let chunks = chunks.into_iter().collect::<Result<Vec<_>, _>>()?;
    Ok(chunks.into_iter().flatten().collect())
}

//! The limit of the surface strata, at any place of any triangle.

use octruss_base::chunks::map_ranges;
use octruss_base::vector3::{Vector3, add, scale};
use rayon::prelude::*;

use super::controls::Controls;
use super::corner::CornerLimit;
use super::error::LimitError;
use super::patches::descent::{Reached, descend};
use super::patches::ring::Ring;
use super::patches::spline_patch;
use super::point::{SurfacePoint, oriented};
use super::sectors::{Sector, Sectors};
use super::side::flipped;
use crate::core::raw_mesh::RawMesh;
use crate::core::strata::Strata;
use crate::core::topology::Topology;

/// Where in a triangle: the number of its face in the [`Topology`], and the
/// barycentric coordinates (u, v) of its second and third corner, in ascending
/// order of vertices.
pub type Place = (u32, [f64; 2]);

/// The limit of the surface strata under the approximating schemes.
///
/// Surfaces are cut along curves: a triangle reads its own side only. Points
/// may be others than the mesh's own (virtual control points).
///
/// ```
/// use octruss_mesh::{FeatureOptions, Strata, Topology, limit::surface::LimitSurface};
/// use octruss_mesh::{prepare, shapes};
///
/// let mesh = prepare(shapes::kuhn_cube(2), &FeatureOptions::default());
/// let topology = Topology::new(mesh.raw());
/// let strata = Strata::new(mesh.raw(), &topology, mesh.features().unwrap());
/// let surface = LimitSurface::new(mesh.raw(), &topology, &strata, mesh.points())?;
/// let face = (0..).find(|&face| strata.is_surface[face as usize]).unwrap();
/// let point = surface.evaluate((face, [0.25, 0.5]))?;
/// // The faces of a cube are flat.
/// assert!(point.curvatures.unwrap()[1].abs() < 1e-9);
/// # Ok::<(), octruss_mesh::limit::LimitError>(())
/// ```
#[derive(Debug, Clone)]
pub struct LimitSurface<'a> {
    controls: Controls<'a>,
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

impl<'a> LimitSurface<'a> {
    /// Of a mesh with this topology and these strata; one point a vertex.
    ///
    /// # Errors
    /// If the points are not as many as the vertices.
    pub fn new(
        mesh: &RawMesh,
        topology: &Topology,
        strata: &Strata,
        points: &'a [Vector3],
    ) -> Result<Self, LimitError> {
        let vertices = topology.vertex_count();
        if points.len() != vertices {
            return Err(LimitError::Points { points: points.len(), vertices });
        }
        let sectors = Sectors::new(topology, strata, |face| {
            flipped(topology, &mesh.tets, &mesh.regions, face)
        });
        Ok(Self { controls: Controls { points, sectors } })
    }

    /// The limit position at a place, in mesh units.
    ///
    /// # Errors
    /// If the face is on no surface, (u, v) outside the triangle, or a corner
    /// smooth though surfaces touch there.
    #[inline]
    pub fn position(&self, place: Place) -> Result<Vector3, LimitError> {
        Ok(match descend(self.ring(place)?, place.1) {
            Reached::Patch(patch) => {
                add(patch.origin, spline_patch::value(&patch.controls, patch.uv))
            }
            Reached::Corner(corner) => {
                add(corner.origin, CornerLimit::new(&corner.fan, corner.centre).position)
            }
        })
    }

    /// Position, derivatives, normal and curvatures at a place.
    ///
    /// # Errors
    /// As [`Self::position`].
    pub fn evaluate(&self, place: Place) -> Result<SurfacePoint, LimitError> {
        let ring = self.ring(place)?;
        let flip = self.controls.sectors.is_flipped(place.0);
        Ok(match descend(ring, place.1) {
            Reached::Patch(patch) => {
                let point = spline_patch::with_derivatives(&patch.controls, patch.uv);
                let first = point.first.map(|d| scale(patch.scale, d));
                let second = point.second.map(|d| scale(patch.scale * patch.scale, d));
                SurfacePoint::regular(add(patch.origin, point.value), first, second, flip)
            }
            Reached::Corner(corner) => {
                let limit = CornerLimit::new(&corner.fan, corner.centre);
                SurfacePoint {
                    position: add(corner.origin, limit.position),
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
        let sectors = &self.controls.sectors.sectors;
        let numbers = 0..sectors.len() as u32;
        let whole: Vec<u32> = numbers.filter(|&s| !sectors[s as usize].touches).collect();
        let limits = whole.into_par_iter().with_min_len(1_024).map(|number| {
            let Sector { vertex, face, flipped, .. } = sectors[number as usize];
            let mut limit = self.controls.sector_limit(number);
            limit.normal = oriented(limit.normal, flipped);
            SectorLimit { vertex, face, limit }
        });
        limits.collect()
    }

    /// The smooth vertices at which surfaces touch, ascending: about them there
    /// is no limit surface.
    pub fn touching(&self) -> Vec<u32> {
        let sectors = self.controls.sectors.sectors.iter().filter(|sector| sector.touches);
        let mut vertices: Vec<u32> = sectors.map(|sector| sector.vertex).collect();
        vertices.dedup();
        vertices
    }

    /// The ring of a triangle, if the place is a place.
    #[inline]
    fn ring(&self, (face, [u, v]): Place) -> Result<Ring, LimitError> {
        let corners = self.controls.sectors.corners(face)?;
        // Rounding may take the third coordinate a little below zero.
        if !(u >= 0.0 && v >= 0.0 && u + v <= 1.0 + 4.0 * f64::EPSILON) {
            return Err(LimitError::Outside { u, v });
        }
        self.controls.ring(corners)
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

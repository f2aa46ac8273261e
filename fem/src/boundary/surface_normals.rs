//! The normals at the vertices of all surfaces that are held along them.
//!
//! What is held so is one surface, whatever groups it is named by and however many supports
//! these belong to: one group or four of the same triangles hold the same.

use crate::boundary::surface::outward_triangles;
use crate::error::Error;
use crate::problem::elasticity::{Held, Support};
use octruss_base::disjoint_sets::DisjointSets;
use octruss_base::vector3::{Vector3, add, cross, dot3, length, scale, subtract};
use octruss_mesh::{TetMesh, Topology};

/// The cosine of 40°: triangles further apart hold a vertex each for themselves.
pub(crate) const SMOOTH: f64 = 0.766_044_443_118_978;

/// Where triangles go round so far that their mean has less than this share of their
/// size, as at the tip of a spike of 60°, no mean stands for them.
const LEAST_MEAN: f64 = 0.5;

/// The cosine of 2°, by which a triangle of a curved surface is off the mean normal at
/// one of its vertices; noise of flat surfaces is mostly less.
const CURVED: f64 = 0.999_390_827_019_096;

/// A triangle of a surface that is held along its normal.
pub(crate) struct Facet {
    pub(crate) vertices: [u32; 3],
    /// Outward, of length 1.
    pub(crate) normal: Vector3,
    pub(crate) double_area: f64,
    /// At each vertex.
    pub(crate) angles: [f64; 3],
    /// The last listed support that holds it.
    pub(crate) support: usize,
}

/// A direction along which a vertex is held.
pub(crate) struct VertexNormal {
    pub(crate) vertex: u32,
    /// The mean by angle, of length 1.
    pub(crate) normal: Vector3,
    /// The last listed support of its triangles.
    pub(crate) support: usize,
    /// Whether some of its triangles are off it by more than noise.
    pub(crate) is_curved: bool,
}

/// The triangles of all supports that hold normals, each once, in the order of their
/// vertices.
///
/// # Errors
/// As [`outward_triangles`].
pub(crate) fn facets(
    mesh: &TetMesh,
    topology: &Topology,
    supports: &[Support],
) -> Result<Vec<Facet>, Error> {
    let mut facets = Vec::new();
    for (support, Support { surface, held }) in supports.iter().enumerate() {
        if !matches!(held, Held::Normal(_)) {
            continue;
        }
        for triangle in outward_triangles(mesh, topology, *surface)? {
            let double_area = length(triangle.double_area);
            let normal = scale(1.0 / double_area, triangle.double_area);
            let mut vertices = triangle.vertices;
            vertices.sort_unstable();
            let angles = angles(vertices.map(|vertex| mesh.points()[vertex as usize]));
            facets.push(Facet { vertices, normal, double_area, angles, support });
        }
    }
    // Of a triangle listed twice the last support stays.
    facets.sort_by_key(|facet| (facet.vertices, std::cmp::Reverse(facet.support)));
    facets.dedup_by_key(|facet| facet.vertices);
    Ok(facets)
}

/// The mean normals at each vertex of a surface, ascending: one, or several where triangles
/// round the vertex differ by 40° or more.
///
/// Two triangles less than 40° apart hold the vertex together, and so do all that are tied
/// by such pairs, in whatever order they are listed.
pub(crate) fn vertex_normals(facets: &[Facet]) -> Vec<VertexNormal> {
    let mut corners: Vec<(u32, usize)> = (0..facets.len())
        .flat_map(|facet| facets[facet].vertices.map(|vertex| (vertex, facet)))
        .collect();
    corners.sort_unstable();
    let mut normals = Vec::new();
    for corners in corners.chunk_by(|a, b| a.0 == b.0) {
        let fan: Vec<&Facet> = corners.iter().map(|&(_, facet)| &facets[facet]).collect();
        for together in smooth_parts(&fan) {
            match mean(corners[0].0, &together) {
                Some(normal) => normals.push(vertex_normal(corners[0].0, normal, &together)),
                None => normals.extend(
                    together.iter().map(|one| vertex_normal(corners[0].0, one.normal, &[one])),
                ),
            }
        }
    }
    normals
}

fn vertex_normal(vertex: u32, normal: Vector3, facets: &[&Facet]) -> VertexNormal {
    let support = facets.iter().map(|facet| facet.support).max().unwrap_or(0);
    let is_curved = facets.iter().any(|facet| dot3(facet.normal, normal) < CURVED);
    VertexNormal { vertex, normal, support, is_curved }
}

/// The triangles round a vertex in parts, each tied by angles of less than 40°.
fn smooth_parts<'a>(fan: &[&'a Facet]) -> Vec<Vec<&'a Facet>> {
    let mut sets = DisjointSets::new(fan.len());
    for (a, one) in (0u32..).zip(fan) {
        for (b, other) in (0..a).zip(fan) {
            if dot3(one.normal, other.normal) > SMOOTH {
                sets.join(a, b);
            }
        }
    }
    let mut parts: Vec<(u32, Vec<&Facet>)> = Vec::new();
    for (member, &facet) in (0u32..).zip(fan) {
        let lowest = sets.lowest(member);
        match parts.iter_mut().find(|(of, _)| *of == lowest) {
            Some((_, part)) => part.push(facet),
            None => parts.push((lowest, vec![facet])),
        }
    }
    parts.into_iter().map(|(_, part)| part).collect()
}

/// The mean normal at a vertex, of length 1, if there is one that stands for all. By the angles
/// there (Thürmer and Wüthrich 1998): how the facets of a bore are cut into triangles must not
/// turn it, else a shaft that is free to spin would be held.
fn mean(vertex: u32, facets: &[&Facet]) -> Option<Vector3> {
    let weighted = |facet: &&Facet| {
        let angles = facet.vertices.into_iter().zip(facet.angles);
        let angle = angles.filter(|(v, _)| *v == vertex).map(|(_, angle)| angle).sum();
        (angle, facet.normal)
    };
    let all = facets.iter().map(weighted);
    let sum = all.clone().fold([0.0; 3], |sum, (angle, normal)| add(sum, scale(angle, normal)));
    let size: f64 = all.map(|(angle, _)| angle).sum();
    (length(sum) > LEAST_MEAN * size).then(|| scale(1.0 / length(sum), sum))
}

/// The angles of a triangle.
fn angles(corners: [Vector3; 3]) -> [f64; 3] {
    std::array::from_fn(|k| {
        let [u, v] = [1, 2].map(|step| subtract(corners[(k + step) % 3], corners[k]));
        length(cross(u, v)).atan2(dot3(u, v))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Triangles of one size round vertex 0, with these angles of their normals to z,
    /// spread round it.
    fn fan(normals: &[Vector3]) -> Vec<Facet> {
        let facet = |(k, &normal): (u32, &Vector3)| Facet {
            vertices: [0, k + 1, k + 2],
            normal,
            double_area: 1.0,
            angles: [1.0; 3],
            support: 0,
        };
        (0..).zip(normals).map(facet).collect()
    }

    fn at_tip(facets: &[Facet]) -> Vec<Vector3> {
        let normals = vertex_normals(facets).into_iter();
        normals.filter(|normal| normal.vertex == 0).map(|normal| normal.normal).collect()
    }

    fn tilted(degrees: f64) -> Vector3 {
        let (sin, cos) = degrees.to_radians().sin_cos();
        [sin, 0.0, cos]
    }

    #[test]
    fn what_small_steps_tie_is_one_direction_in_whatever_order_it_is_listed() {
        // Neighbours in the list are 60° or 90° apart.
        let steps = [0.0, 60.0, 90.0, 30.0].map(tilted);
        let found = at_tip(&fan(&steps));
        assert_eq!(found.len(), 1);
        let exact = tilted(45.0);
        assert!((0..3).all(|k| (found[0][k] - exact[k]).abs() < 1e-12), "{found:?}");
        assert_eq!(at_tip(&fan(&[0.0, 41.0].map(tilted))).len(), 2);
        assert_eq!(at_tip(&fan(&[0.0, 39.0].map(tilted))).len(), 1);
    }

    #[test]
    fn how_a_facet_is_cut_into_triangles_does_not_turn_the_normal() {
        // At the rim of a bore two rectangles meet; one is cut at the vertex, one is not.
        let (sin, cos) = 10f64.to_radians().sin_cos();
        let at = |along: f64, up: f64| [along * cos, up, along.abs() * sin];
        let o = at(0.0, 0.0);
        let facet = |k: u32, corners: [Vector3; 3]| {
            let double_area =
                cross(subtract(corners[1], corners[0]), subtract(corners[2], corners[0]));
            let normal = scale(1.0 / length(double_area), double_area);
            let vertices = [0, k + 1, k + 2];
            Facet {
                vertices,
                normal,
                double_area: length(double_area),
                angles: angles(corners),
                support: 0,
            }
        };
        let facets = [
            facet(0, [o, at(1.0, 0.0), at(1.0, 2.0)]),
            facet(2, [o, at(1.0, 2.0), at(0.0, 2.0)]),
            facet(4, [o, at(0.0, 2.0), at(-1.0, 0.0)]),
        ];
        let found = at_tip(&facets);
        assert!(found.len() == 1 && found[0][0].abs() < 1e-12 && found[0][2] > 0.9, "{found:?}");
    }

    #[test]
    fn the_tip_of_a_blunt_cone_slides_and_that_of_a_spike_is_held() {
        let cone = |off_axis: f64| {
            let (sin, cos) = f64::to_radians(off_axis).sin_cos();
            let around = (0..24).map(|k| (f64::from(k) / 24.0 * std::f64::consts::TAU).sin_cos());
            around.map(|(s, c)| [sin * c, sin * s, cos]).collect::<Vec<_>>()
        };
        let blunt = at_tip(&fan(&cone(50.0)));
        assert!(blunt.len() == 1 && blunt[0][2] > 1.0 - 1e-12, "{blunt:?}");
        assert_eq!(at_tip(&fan(&cone(70.0))).len(), 24);
    }
}

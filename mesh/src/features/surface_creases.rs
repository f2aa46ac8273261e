//! The creases that surfaces have by their shape and their groups.

use std::collections::BTreeSet;

use crate::core::incidence::Incidence;
use crate::core::mirrors::Unfolded;
use crate::core::raw_mesh::RawMesh;
use crate::core::strata::opposite_vertices;
use crate::core::topology::{NONE, Topology};
use crate::features::group_borders::GroupBorders;
use crate::features::options::FeatureOptions;
use crate::features::reason::Reason;

/// The angle between normals, in degrees, up to which a border is flat: enough for
/// the noise of coordinates on a plane, less than meshes of curved surfaces have.
const FLAT_ANGLE: f64 = 1.0;

/// The groups of the faces on both sides of an edge, in ascending order.
type Sides<'a> = [&'a [u32]; 2];

/// Edges with other than two faces of surfaces, borders of groups, sharp edges;
/// ends ascending, sorted.
///
/// Of an unfolded mesh its own edges are looked at: those of images are alike, and at the
/// outermost ones faces seem to be a boundary that are none.
pub(super) fn surface_creases(
    unfolded: &Unfolded,
    options: &FeatureOptions,
    is_surface: &[bool],
) -> Vec<([u32; 2], Reason)> {
    let (mesh, topology) = (&*unfolded.mesh, &*unfolded.topology);
    let mut opposite = opposite_vertices(topology, is_surface);
    if unfolded.has_mirrors() {
        let is_own = |edge| topology.edges()[edge as usize][1] < unfolded.vertices() as u32;
        opposite.retain(is_own);
    }
    let groups = face_groups(mesh, topology);
    let folds = Folds { mesh, topology, groups, crease_angle: options.crease_angle };
    let bent = match options.group_borders {
        GroupBorders::Flat => folds.bent_borders(&opposite),
        GroupBorders::All | GroupBorders::None => BTreeSet::new(),
    };
    let is_kept = |sides: Sides| {
        options.group_borders != GroupBorders::None
            && sides[0] != sides[1]
            && !bent.contains(&sides)
    };
    let crease = |edge: u32| {
        let ends = topology.edges()[edge as usize];
        let reason = match *opposite.of(edge) {
            [_] => Reason::SurfaceBorder,
            [c, d] if is_kept(folds.sides(ends, [c, d])) => Reason::GroupBorder,
            [c, d] if folds.is_sharp(folds.cosine(ends, [c, d])) => Reason::Angle,
            [_, _] => return None,
            _ => Reason::Junction,
        };
        Some((ends, reason))
    };
    opposite.keys().filter_map(crease).collect()
}

/// What is asked about an edge between two faces of surfaces, given by its ends and
/// the third vertices of the faces.
struct Folds<'a> {
    mesh: &'a RawMesh,
    topology: &'a Topology,
    groups: Incidence,
    crease_angle: f64,
}

impl Folds<'_> {
    fn sides(&self, [a, b]: [u32; 2], thirds: [u32; 2]) -> Sides<'_> {
        let groups_of =
            |third| self.groups.of(self.topology.face_of([a, b, third]).unwrap_or(NONE));
        let mut sides = thirds.map(groups_of);
        sides.sort_unstable();
        sides
    }

    /// The cosine of the dihedral angle at an edge between the half planes to two
    /// vertices: −1 for a flat surface, 1 for one folded back onto itself. The
    /// angle between consistently oriented normals is 180 degrees less that angle.
    fn cosine(&self, [a, b]: [u32; 2], thirds: [u32; 2]) -> f64 {
        let at = |v: u32| nalgebra::Vector3::from(self.mesh.points[v as usize]);
        let axis = (at(b) - at(a)).normalize();
        let [u, w] = thirds.map(|third| {
            let to = at(third) - at(a);
            (to - axis * axis.dot(&to)).normalize()
        });
        u.dot(&w)
    }

    fn is_sharp(&self, cosine: f64) -> bool {
        // At 180 degrees even a fold of a surface onto itself is smooth.
        self.crease_angle < 180.0 && cosine > cosine_at(self.crease_angle)
    }

    /// The pairs of groups with a border that is bent somewhere, but not sharp. A
    /// border is judged as a whole, lest half of it be a crease.
    fn bent_borders(&self, opposite: &Incidence) -> BTreeSet<Sides<'_>> {
        let bent = |edge: u32| {
            let &[c, d] = opposite.of(edge) else { return None };
            let ends = self.topology.edges()[edge as usize];
            let sides = self.sides(ends, [c, d]);
            let is_bent = || {
                let cosine = self.cosine(ends, [c, d]);
                cosine > cosine_at(FLAT_ANGLE) && !self.is_sharp(cosine)
            };
            (sides[0] != sides[1] && is_bent()).then_some(sides)
        };
        opposite.keys().filter_map(bent).collect()
    }
}

/// The cosine between half planes where normals differ by an angle, in degrees.
fn cosine_at(degrees: f64) -> f64 {
    (180.0 - degrees).to_radians().cos()
}

/// The surface groups of each face that has any.
fn face_groups(mesh: &RawMesh, topology: &Topology) -> Incidence {
    let triangles = mesh.triangles.iter().filter(|&(_, tag)| tag != 0);
    let pairs =
        triangles.filter_map(|(triangle, tag)| Some([topology.face_of(triangle)?, tag as u32]));
    Incidence::new(pairs.collect())
}

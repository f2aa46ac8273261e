//! Searching a mesh for creases and corners.

use crate::core::raw_mesh::{Features, RawMesh};
use crate::core::strata::{Incidence, opposite_vertices, surface_faces};
use crate::core::topology::{NONE, Topology, ascending};
use crate::features::options::FeatureOptions;
use crate::features::reason::Reason;

/// Creases and corners with their reasons; sorted, each once.
pub(super) struct Found {
    pub creases: Vec<([u32; 2], Reason)>,
    pub corners: Vec<(u32, Reason)>,
    pub surfaces: Vec<i32>,
}

/// Finds creases and corners.
///
/// A crease is an edge of a surface stratum with other than two of its faces,
/// one sharper than the angle, one between different surface groups, a tagged
/// edge, or one asked for. A corner is a tagged vertex, one asked for, or one
/// where a surface touches itself in a point only.
pub fn find_features(mesh: &RawMesh, topology: &Topology, options: &FeatureOptions) -> Features {
    let Found { creases, corners, surfaces } = Found::new(mesh, topology, options);
    Features {
        creases: creases.into_iter().map(|(ends, _)| ends).collect(),
        corners: corners.into_iter().map(|(vertex, _)| vertex).collect(),
        surfaces,
        ..Features::default()
    }
}

impl Found {
    pub fn new(mesh: &RawMesh, topology: &Topology, options: &FeatureOptions) -> Self {
        let mut surfaces = options.surfaces.clone();
        surfaces.sort_unstable();
        surfaces.dedup();
        let asked_for = Features { surfaces, ..Features::default() };
        let is_surface = surface_faces(mesh, topology, &asked_for);
        let mut creases = surface_creases(mesh, topology, options, &is_surface);
        if options.group_curves {
            let tagged = mesh.edges.simplices.iter();
            creases.extend(tagged.map(|&ends| (ascending(ends), Reason::CurveGroup)));
        }
        creases.extend(options.extra.creases().iter().map(|&ends| (ends, Reason::AskedFor)));
        let mut corners = Vec::new();
        if options.group_points {
            let tagged = mesh.vertices.simplices.iter();
            corners.extend(tagged.map(|&[v]| (v, Reason::PointGroup)));
        }
        corners.extend(options.extra.corners().iter().map(|&v| (v, Reason::AskedFor)));
        let touching = touching_points(topology, &is_surface).into_iter();
        corners.extend(touching.map(|v| (v, Reason::TouchingPoint)));
        Self {
            creases: first_reasons(creases),
            corners: first_reasons(corners),
            surfaces: asked_for.surfaces,
        }
    }
}

/// Sorted, each part once, with the first of its reasons.
fn first_reasons<T: Ord + Copy>(mut found: Vec<(T, Reason)>) -> Vec<(T, Reason)> {
    found.sort_unstable();
    found.dedup_by_key(|entry| entry.0);
    found
}

/// The creases that surfaces have by their shape and their groups.
fn surface_creases(
    mesh: &RawMesh,
    topology: &Topology,
    options: &FeatureOptions,
    is_surface: &[bool],
) -> Vec<([u32; 2], Reason)> {
    let opposite = opposite_vertices(topology, is_surface);
    let groups = face_groups(mesh, topology, options.group_borders);
    // At 180 degrees even a fold of a surface onto itself is smooth.
    let smooth_cosine = (180.0 - options.crease_angle).to_radians().cos();
    let crease = |edge: u32| {
        let ends = topology.edges()[edge as usize];
        let reason = match *opposite.of(edge) {
            [_] => Reason::SurfaceBorder,
            [c, d] => {
                let group_of =
                    |third| groups.of(topology.face_of([ends[0], ends[1], third]).unwrap_or(NONE));
                let sharp = || {
                    options.crease_angle < 180.0
                        && half_plane_cosine(mesh, ends, [c, d]) > smooth_cosine
                };
                if group_of(c) != group_of(d) {
                    Reason::GroupBorder
                } else if sharp() {
                    Reason::Angle
                } else {
                    return None;
                }
            }
            _ => Reason::Junction,
        };
        Some((ends, reason))
    };
    opposite.keys().filter_map(crease).collect()
}

/// The surface groups of each face that has any; of none if `wanted` is false.
fn face_groups(mesh: &RawMesh, topology: &Topology, wanted: bool) -> Incidence {
    let triangles = mesh.triangles.iter().filter(|&(_, tag)| wanted && tag != 0);
    let pairs =
        triangles.filter_map(|(triangle, tag)| Some([topology.face_of(triangle)?, tag as u32]));
    Incidence::new(pairs.collect())
}

/// The cosine of the dihedral angle at an edge between the half planes to two
/// vertices: −1 for a flat surface, 1 for one folded back onto itself. The
/// angle between consistently oriented normals is 180 degrees less that angle.
fn half_plane_cosine(mesh: &RawMesh, [a, b]: [u32; 2], thirds: [u32; 2]) -> f64 {
    let at = |v: u32| nalgebra::Vector3::from(mesh.points[v as usize]);
    let axis = (at(b) - at(a)).normalize();
    let [u, w] = thirds.map(|third| {
        let to = at(third) - at(a);
        (to - axis * axis.dot(&to)).normalize()
    });
    u.dot(&w)
}

/// Vertices where surface faces meet in the vertex only: those whose faces are
/// not all connected through edges at the vertex.
fn touching_points(topology: &Topology, is_surface: &[bool]) -> Vec<u32> {
    let mut links = Vec::new();
    for face in (0..is_surface.len()).filter(|&face| is_surface[face]) {
        let [a, b, c] = topology.faces()[face];
        links.extend([[a, b, c], [b, a, c], [c, a, b]]);
    }
    links.sort_unstable();
    links
        .chunk_by(|p, q| p[0] == q[0])
        .filter(|link| !is_connected(link))
        .map(|link| link[0][0])
        .collect()
}

/// Whether the link edges (vertex, p, q) of one vertex form one piece.
fn is_connected(link: &[[u32; 3]]) -> bool {
    let mut reached = vec![link[0][1], link[0][2]];
    let mut open: Vec<[u32; 3]> = link[1..].to_vec();
    loop {
        let before = open.len();
        open.retain(|&[_, p, q]| {
            let touches = reached.contains(&p) || reached.contains(&q);
            if touches {
                reached.extend([p, q]);
            }
            !touches
        });
        if open.is_empty() || open.len() == before {
            return open.is_empty();
        }
    }
}

//! Readying the coarsest mesh, once: its marking, its creases and corners.

mod extra;

pub use extra::{ExtraFeatures, FeatureError};

use crate::marking::{Marking, mark};
use crate::raw_mesh::{Features, RawMesh};
use crate::strata::{Incidence, opposite_vertices, surface_faces};
use crate::tet_mesh::TetMesh;
use crate::topology::{NONE, Topology, ascending};

/// How a coarsest mesh is readied: its marking, and where its creases and
/// corners come from.
#[derive(Debug, Clone, PartialEq)]
pub struct FeatureOptions {
    /// Which pair of opposite edges each tet marks.
    pub marking: Marking,
    /// An edge of two surface faces is a crease if the angle between their
    /// outward normals exceeds this, in degrees; 180 for none.
    pub crease_angle: f64,
    /// Tagged edges (curve groups) are creases.
    pub group_curves: bool,
    /// Tagged vertices (point groups) are corners.
    pub group_points: bool,
    /// Edges between faces of different surface groups are creases.
    pub group_borders: bool,
    /// Surface groups that are surface strata even inside a region.
    pub surfaces: Vec<i32>,
    /// Creases and corners that were asked for by their vertices, of the mesh
    /// that is readied.
    pub extra: ExtraFeatures,
}

impl Default for FeatureOptions {
    fn default() -> Self {
        Self {
            marking: Marking::default(),
            crease_angle: 40.0,
            group_curves: true,
            group_points: true,
            group_borders: true,
            surfaces: Vec::new(),
            extra: ExtraFeatures::default(),
        }
    }
}

/// Readies a coarsest mesh for refinement: marks its tets and finds its
/// features. A mesh that carries features has been through this and is
/// returned as it is, whatever the options, so that refining twice by one level
/// equals once by two.
pub fn prepare(mesh: TetMesh, options: &FeatureOptions) -> TetMesh {
    if mesh.features().is_some() {
        return mesh;
    }
    let mut raw = mesh.into_raw();
    let topology = Topology::new(&raw);
    mark(&mut raw, &topology, options.marking);
    raw.features = Some(find_features(&raw, &topology, options));
    TetMesh::trusted(raw)
}

/// Finds creases and corners.
///
/// A crease is an edge of a surface stratum with other than two of its faces,
/// one sharper than the angle, one between different surface groups, a tagged
/// edge, or one asked for. A corner is a tagged vertex, one asked for, or one
/// where a surface touches itself in a point only.
pub fn find_features(mesh: &RawMesh, topology: &Topology, options: &FeatureOptions) -> Features {
    let mut features = Features { surfaces: options.surfaces.clone(), ..Features::default() };
    features.surfaces.sort_unstable();
    features.surfaces.dedup();
    let is_surface = surface_faces(mesh, topology, &features);
    let opposite = opposite_vertices(topology, &is_surface);
    let groups = face_groups(mesh, topology, options.group_borders);
    // At 180 degrees even a fold of a surface onto itself is smooth.
    let smooth_cosine = (180.0 - options.crease_angle).to_radians().cos();
    for edge in opposite.keys() {
        let ends = topology.edges()[edge as usize];
        let thirds = opposite.of(edge);
        let crease = match *thirds {
            [c, d] => {
                let sharp = options.crease_angle < 180.0
                    && half_plane_cosine(mesh, ends, [c, d]) > smooth_cosine;
                let group_of =
                    |third| groups.of(topology.face_of([ends[0], ends[1], third]).unwrap_or(NONE));
                sharp || group_of(c) != group_of(d)
            }
            _ => true,
        };
        if crease {
            features.creases.push(ends);
        }
    }
    if options.group_curves {
        features.creases.extend(mesh.edges.simplices.iter().map(|&ends| ascending(ends)));
    }
    if options.group_points {
        features.corners.extend(mesh.vertices.simplices.iter().map(|&[v]| v));
    }
    features.creases.extend(options.extra.creases());
    features.corners.extend(options.extra.corners());
    features.corners.extend(touching_points(topology, &is_surface));
    features.creases.sort_unstable();
    features.creases.dedup();
    features.corners.sort_unstable();
    features.corners.dedup();
    features
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

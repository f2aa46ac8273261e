//! Searching a mesh for creases and corners.

use crate::core::mirrors::Unfolded;
use crate::core::raw_mesh::{Features, RawMesh};
use crate::core::strata::surface_faces;
use crate::core::topology::{Topology, ascending};
use crate::features::options::FeatureOptions;
use crate::features::reason::Reason;
use crate::features::surface_creases::surface_creases;

/// Creases and corners with their reasons; sorted, each once.
pub(super) struct Found {
    pub creases: Vec<([u32; 2], Reason)>,
    pub corners: Vec<(u32, Reason)>,
    pub surfaces: Vec<i32>,
    pub mirrors: Vec<i32>,
}

/// Finds creases and corners.
///
/// A crease is an edge of a surface stratum with other than two of its faces,
/// one sharper than the angle, one between different surface groups, a tagged
/// edge, or one asked for. Surfaces go on across mirror planes, and a tagged edge in one is
/// no crease for its tag: groups of curves bound the planes, which are no surfaces of the
/// whole body. A corner is a tagged vertex, one asked for, or one
/// where a surface touches itself in a point only.
pub fn find_features(mesh: &RawMesh, topology: &Topology, options: &FeatureOptions) -> Features {
    let Found { creases, corners, surfaces, mirrors } = Found::new(mesh, topology, options);
    Features {
        creases: creases.into_iter().map(|(ends, _)| ends).collect(),
        corners: corners.into_iter().map(|(vertex, _)| vertex).collect(),
        surfaces,
        mirrors,
        ..Features::default()
    }
}

impl Found {
    pub fn new(mesh: &RawMesh, topology: &Topology, options: &FeatureOptions) -> Self {
        let mut surfaces = options.surfaces.clone();
        surfaces.sort_unstable();
        surfaces.dedup();
        let mirrors = options.mirrors.groups().to_vec();
        let asked_for = Features { surfaces, mirrors, ..Features::default() };
        let unfolded = Unfolded::with_features(mesh, topology, &asked_for);
        let is_surface = surface_faces(&unfolded.mesh, &unfolded.topology, &asked_for);
        let mut creases = surface_creases(&unfolded, options, &is_surface);
        if options.group_curves {
            let tagged = mesh.edges.simplices.iter();
            let tagged = tagged.filter(|&&ends| !unfolded.is_in_plane(ends));
            creases.extend(tagged.map(|&ends| (ascending(ends), Reason::CurveGroup)));
        }
        creases.extend(options.extra.creases().iter().map(|&ends| (ends, Reason::AskedFor)));
        let mut corners = Vec::new();
        if options.group_points {
            let tagged = mesh.vertices.simplices.iter();
            corners.extend(tagged.map(|&[v]| (v, Reason::PointGroup)));
        }
        corners.extend(options.extra.corners().iter().map(|&v| (v, Reason::AskedFor)));
        let touching = touching_points(&unfolded.topology, &is_surface).into_iter();
        let touching = touching.filter(|&v| (v as usize) < unfolded.vertices());
        corners.extend(touching.map(|v| (v, Reason::TouchingPoint)));
        Self {
            creases: first_reasons(creases),
            corners: first_reasons(corners),
            surfaces: asked_for.surfaces,
            mirrors: asked_for.mirrors,
        }
    }
}

/// Sorted, each part once, with the first of its reasons.
fn first_reasons<T: Ord + Copy>(mut found: Vec<(T, Reason)>) -> Vec<(T, Reason)> {
    found.sort_unstable();
    found.dedup_by_key(|entry| entry.0);
    found
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

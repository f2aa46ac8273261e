//! From what a file said to a mesh that can be refined and solved on.

use rayon::prelude::*;

use crate::core::components::first_tets;
use crate::core::raw_mesh::{RawMesh, Tagged};
use crate::core::reference_tet::{EDGES, FACES, six_volumes};
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::{Topology, ascending};
use crate::soundness::finding::{EXAMPLES, Finding, FindingKind};
use crate::soundness::hinges::hinges;
use octruss_base::ragged::CHUNK;
use octruss_base::vector3::{length, subtract};

/// A volume below this share of the longest edge cubed is rounding, not volume.
const FLAT: f64 = 1e-14;

/// Places of simplices are counted in 32 bits: six edges a tet, three a triangle.
const MAX_SLOTS: usize = u32::MAX as usize;

/// What [`check()`] may change.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct CheckOptions {
    /// Turn inverted tets round instead of refusing them.
    pub reorient: bool,
}

/// A sound mesh, and what was remarked or mended on the way.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked {
    /// The mesh.
    pub mesh: TetMesh,
    /// Findings that do not stop, and those that were mended.
    pub findings: Vec<Finding>,
    /// If unused vertices were left out: the old number of each vertex kept.
    pub kept_vertices: Option<Vec<u32>>,
}

/// A mesh that cannot be refined or solved on, and all that was found.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the mesh cannot be used:{}", lines(findings))]
pub struct CheckError {
    /// Everything found, the worst first.
    pub findings: Vec<Finding>,
}

fn lines(findings: &[Finding]) -> String {
    findings.iter().map(|finding| format!("\n  {finding}")).collect()
}

/// Checks a mesh and wraps it; leaves out unused vertices, and turns inverted
/// tets round if asked.
///
/// # Errors
/// With every finding if one of them stops ([`FindingKind::stops`]).
pub fn check(mut raw: RawMesh, options: &CheckOptions) -> Result<Checked, CheckError> {
    let mut findings = findings(&raw);
    for finding in &mut findings {
        finding.mended = options.reorient && finding.kind == FindingKind::InvertedTets;
    }
    if findings.iter().any(|finding| finding.kind.stops() && !finding.mended) {
        return Err(CheckError { findings });
    }
    if options.reorient {
        reorient(&mut raw);
    }
    if findings.iter().any(|finding| finding.kind == FindingKind::RepeatedSimplices) {
        drop_repeated(&mut raw.triangles);
        drop_repeated(&mut raw.edges);
        drop_repeated(&mut raw.vertices);
    }
    let unused = findings.iter().any(|finding| finding.kind == FindingKind::UnusedVertices);
    let kept_vertices = unused.then(|| drop_unused_vertices(&mut raw));
    Ok(Checked { mesh: TetMesh::trusted(raw), findings, kept_vertices })
}

/// Everything wrong or remarkable about a mesh, the worst first; empty if it is clean.
pub fn findings(raw: &RawMesh) -> Vec<Finding> {
    let slots = 6 * raw.tets.len() + 3 * raw.triangles.len() + raw.edges.len();
    if slots > MAX_SLOTS {
        let kind = FindingKind::TooLarge;
        return vec![Finding { count: slots, ..Finding::of(kind) }];
    }
    let mut found = Vec::new();
    let mut note = |kind, places: Vec<u32>| {
        if !places.is_empty() {
            let examples = places.iter().copied().take(EXAMPLES).collect();
            found.push(Finding { count: places.len(), examples, ..Finding::of(kind) });
        }
    };
    let out_of_range = out_of_range(raw);
    let in_range = out_of_range.is_empty();
    note(FindingKind::IndexOutOfRange, out_of_range);
    note(FindingKind::NonFiniteCoordinates, non_finite(raw));
    note(FindingKind::DuplicateVertices, duplicate_vertices(raw));
    let degenerate = [degenerate(&raw.triangles), degenerate(&raw.edges)].concat();
    let proper = degenerate.is_empty();
    note(FindingKind::DegenerateSimplices, degenerate);
    let repeated = [repeated(&raw.triangles), repeated(&raw.edges), repeated(&raw.vertices)];
    note(FindingKind::RepeatedSimplices, repeated.concat());
    if in_range {
        let (flat, inverted) = flat_and_inverted(raw);
        note(FindingKind::ZeroVolumeTets, flat);
        note(FindingKind::InvertedTets, inverted);
        note(FindingKind::DuplicateTets, duplicate_tets(raw));
        let faces = faces_with_tets(raw);
        note(FindingKind::OversharedFaces, overshared_faces(&faces));
        if proper {
            note(FindingKind::StrayCreases, stray_creases(raw));
        }
        note(FindingKind::UnusedVertices, unused_vertices(raw));
        let parts = first_tets(raw);
        if parts.len() > 1 {
            note(FindingKind::DisconnectedParts, parts);
        }
        found.extend(hinges(raw, &inner_faces(&faces)));
    }
    if raw.tets.is_empty() {
        found.push(Finding::of(FindingKind::NoTets));
    }
    found.sort_by_key(|finding| finding.kind);
    found
}

/// The vertex numbers of all simplices.
fn references(raw: &RawMesh) -> impl Iterator<Item = u32> {
    let tets = raw.tets.as_flattened().iter();
    let triangles = raw.triangles.simplices.as_flattened().iter();
    let edges = raw.edges.simplices.as_flattened().iter();
    let vertices = raw.vertices.simplices.as_flattened().iter();
    let features = raw.features.iter();
    let features = features.flat_map(|f| f.creases.as_flattened().iter().chain(&f.corners));
    let control_points = raw.features.iter().flat_map(|f| &f.control_points);
    let control_points = control_points.flat_map(|points| &points.vertices);
    let tagged = triangles.chain(edges).chain(vertices);
    tets.chain(tagged).chain(features).chain(control_points).copied()
}

fn out_of_range(raw: &RawMesh) -> Vec<u32> {
    references(raw).filter(|&v| v as usize >= raw.points.len()).collect()
}

fn non_finite(raw: &RawMesh) -> Vec<u32> {
    let is_bad = |p: &[f64; 3]| !p.iter().all(|x| x.is_finite());
    (0u32..).zip(&raw.points).filter(|(_, p)| is_bad(p)).map(|(v, _)| v).collect()
}

fn duplicate_vertices(raw: &RawMesh) -> Vec<u32> {
    // Adding 0 makes −0 equal to 0.
    let key = |v: &u32| raw.points[*v as usize].map(|x| (x + 0.0).to_bits());
    let mut order: Vec<u32> = (0..raw.points.len() as u32).collect();
    order.par_sort_unstable_by_key(|v| (key(v), *v));
    let mut copies: Vec<u32> =
        order.windows(2).filter(|w| key(&w[0]) == key(&w[1])).map(|w| w[1]).collect();
    copies.sort_unstable();
    copies
}

fn flat_and_inverted(raw: &RawMesh) -> (Vec<u32>, Vec<u32>) {
    let sign = |tet: &[u32; 4]| {
        let corners = tet.map(|v| raw.points[v as usize]);
        let edge_length = |[a, b]: [usize; 2]| length(subtract(corners[a], corners[b]));
        let longest = EDGES.map(edge_length).into_iter().fold(0.0, f64::max);
        let volume = six_volumes(corners);
        if volume.abs() <= FLAT * longest.powi(3) { 0 } else { volume.signum() as i8 }
    };
    let signs: Vec<i8> = raw.tets.par_iter().with_min_len(CHUNK).map(sign).collect();
    let with =
        |wanted: i8| (0u32..).zip(&signs).filter(|&(_, &s)| s == wanted).map(|(t, _)| t).collect();
    (with(0), with(-1))
}

fn duplicate_tets(raw: &RawMesh) -> Vec<u32> {
    let mut sorted: Vec<([u32; 4], u32)> =
        raw.tets.par_iter().map(|&tet| ascending(tet)).zip(0u32..raw.tets.len() as u32).collect();
    sorted.par_sort_unstable();
    let mut copies: Vec<u32> =
        sorted.windows(2).filter(|w| w[0].0 == w[1].0).map(|w| w[1].1).collect();
    copies.sort_unstable();
    copies
}

/// Each face of each tet, ascending, with the tet: sorted.
fn faces_with_tets(raw: &RawMesh) -> Vec<([u32; 3], u32)> {
    let faces_of = |(tet, vertices): (usize, &[u32; 4])| {
        FACES.map(|face| (ascending(face.map(|v| vertices[v])), tet as u32))
    };
    let mut faces: Vec<([u32; 3], u32)> =
        raw.tets.par_iter().enumerate().flat_map_iter(faces_of).collect();
    faces.par_sort_unstable();
    faces
}

/// The third tet on each face that has more than two.
fn overshared_faces(faces: &[([u32; 3], u32)]) -> Vec<u32> {
    let shared = faces.chunk_by(|p, q| p.0 == q.0).filter(|run| run.len() > 2);
    shared.map(|run| run[2].1).collect()
}

/// The two tets of each face that has two.
fn inner_faces(faces: &[([u32; 3], u32)]) -> Vec<[u32; 2]> {
    faces.windows(2).filter(|w| w[0].0 == w[1].0).map(|w| [w[0].1, w[1].1]).collect()
}

/// The first ends of recorded creases that are no edges; a sound file has none.
fn stray_creases(raw: &RawMesh) -> Vec<u32> {
    let Some(features) = &raw.features else { return Vec::new() };
    let topology = Topology::new(raw);
    let is_stray = |&&[a, b]: &&[u32; 2]| topology.edge_between(a, b).is_none();
    features.creases.iter().filter(is_stray).map(|&[a, _]| a).collect()
}

fn is_used(raw: &RawMesh) -> Vec<bool> {
    let mut used = vec![false; raw.points.len()];
    for v in references(raw) {
        used[v as usize] = true;
    }
    used
}

fn unused_vertices(raw: &RawMesh) -> Vec<u32> {
    (0u32..).zip(is_used(raw)).filter(|&(_, used)| !used).map(|(v, _)| v).collect()
}

/// The first vertices of tagged simplices that name one twice.
fn degenerate<const N: usize>(tagged: &Tagged<N>) -> Vec<u32> {
    let repeats =
        |simplex: &&[u32; N]| ascending(**simplex).windows(2).any(|pair| pair[0] == pair[1]);
    tagged.simplices.iter().filter(repeats).map(|simplex| simplex[0]).collect()
}

/// The places of simplices that are listed earlier under the same tag.
fn copies<const N: usize>(tagged: &Tagged<N>) -> Vec<usize> {
    let places = tagged.iter().enumerate();
    let mut order: Vec<([u32; N], i32, usize)> =
        places.map(|(place, (simplex, tag))| (ascending(simplex), tag, place)).collect();
    order.par_sort_unstable();
    let repeats = order.windows(2).filter(|pair| (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1));
    let mut copies: Vec<usize> = repeats.map(|pair| pair[1].2).collect();
    copies.sort_unstable();
    copies
}

/// The first vertices of simplices listed twice.
fn repeated<const N: usize>(tagged: &Tagged<N>) -> Vec<u32> {
    copies(tagged).into_iter().map(|place| tagged.simplices[place][0]).collect()
}

fn drop_repeated<const N: usize>(tagged: &mut Tagged<N>) {
    let mut keep = vec![true; tagged.len()];
    copies(tagged).into_iter().for_each(|place| keep[place] = false);
    let kept = tagged.iter().zip(&keep).filter(|(_, keep)| **keep).map(|(entry, _)| entry);
    let (simplices, tags) = kept.unzip();
    *tagged = Tagged { simplices, tags };
}

/// Swapping x0 and x2 turns a tet round and keeps its marked pair.
fn reorient(raw: &mut RawMesh) {
    let points = &raw.points;
    for tet in &mut raw.tets {
        if six_volumes(tet.map(|v| points[v as usize])) < 0.0 {
            tet.swap(0, 2);
        }
    }
}

/// Leaves out the vertices that no simplex uses; the old numbers of the rest.
fn drop_unused_vertices(raw: &mut RawMesh) -> Vec<u32> {
    let used = is_used(raw);
    let kept: Vec<u32> = (0..raw.points.len() as u32).filter(|&v| used[v as usize]).collect();
    let mut new_numbers = vec![u32::MAX; raw.points.len()];
    for (new, &old) in (0u32..).zip(&kept) {
        new_numbers[old as usize] = new;
    }
    raw.points = kept.iter().map(|&old| raw.points[old as usize]).collect();
    renumber(&mut raw.tets, &new_numbers);
    let RawMesh { triangles, edges, vertices, features, .. } = raw;
    renumber_tagged(triangles, &new_numbers);
    renumber_tagged(edges, &new_numbers);
    renumber_tagged(vertices, &new_numbers);
    if let Some(features) = features {
        renumber(&mut features.creases, &new_numbers);
        let control_points = features.control_points.iter_mut();
        let control_points = control_points.flat_map(|points| &mut points.vertices);
        let single = features.corners.iter_mut().chain(control_points);
        single.for_each(|v| *v = new_numbers[*v as usize]);
    }
    kept
}

fn renumber_tagged<const N: usize>(tagged: &mut Tagged<N>, new_numbers: &[u32]) {
    renumber(&mut tagged.simplices, new_numbers);
}

fn renumber<const N: usize>(simplices: &mut [[u32; N]], new_numbers: &[u32]) {
    for v in simplices.as_flattened_mut() {
        *v = new_numbers[*v as usize];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::shapes::{five_tet_cube, kuhn_cube};

    fn kinds(raw: &RawMesh) -> Vec<(FindingKind, usize)> {
        findings(raw).into_iter().map(|finding| (finding.kind, finding.count)).collect()
    }

    #[test]
    fn a_sound_mesh_is_clean_and_unchanged() {
        let raw = kuhn_cube(3).into_raw();
        let checked = check(raw.clone(), &CheckOptions::default()).unwrap();
        assert!(checked.findings.is_empty() && checked.kept_vertices.is_none());
        assert_eq!(checked.mesh.raw(), &raw);
    }

    #[test]
    fn each_defect_is_found_by_its_name() {
        let good = five_tet_cube().into_raw();
        type Damage = fn(&mut RawMesh);
        let table: [(FindingKind, usize, Damage); 14] = [
            (FindingKind::DegenerateSimplices, 1, |m| m.triangles.push([1, 1, 2], 5)),
            (FindingKind::DegenerateSimplices, 1, |m| m.edges.push([2, 2], 5)),
            (FindingKind::RepeatedSimplices, 1, |m| {
                m.edges.push([2, 3], 5);
                m.edges.push([2, 3], 6);
                m.edges.push([3, 2], 5);
            }),
            (FindingKind::StrayCreases, 1, |m| {
                let creases = vec![[0, 3], [0, 7]];
                m.features = Some(crate::Features { creases, ..Default::default() });
            }),
            (FindingKind::NoTets, 1, |m| {
                m.tets.clear();
                m.regions.clear();
                m.vertices.simplices = (0..8).map(|v| [v]).collect();
            }),
            (FindingKind::NonFiniteCoordinates, 1, |m| {
                m.points.push([0.0, f64::NAN, 0.0]);
                m.vertices.push([8], 1);
            }),
            (FindingKind::IndexOutOfRange, 2, |m| {
                m.tets[1][2] = 99;
                m.triangles.push([0, 1, 8], 1);
            }),
            (FindingKind::ZeroVolumeTets, 1, |m| m.points[1] = [0.5, 0.5, 0.0]),
            (FindingKind::InvertedTets, 5, |m| m.tets.iter_mut().for_each(|t| t.swap(0, 1))),
            (FindingKind::DuplicateTets, 1, |m| {
                let [a, b, c, d] = m.tets[2];
                m.tets.push([b, c, a, d]);
                m.regions.push(0);
            }),
            (FindingKind::DuplicateVertices, 1, |m| {
                m.points.push(m.points[3]);
                m.vertices.push([8], 1);
            }),
            (FindingKind::UnusedVertices, 1, |m| m.points.push([7.0; 3])),
            (FindingKind::Hinges, 1, |m| {
                m.points.extend([[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]]);
                m.tets.push([0, 8, 10, 9]);
                m.regions.push(0);
            }),
            (FindingKind::DisconnectedParts, 2, |m| {
                let tet = m.tets[1].map(|v| m.points[v as usize].map(|x| x + 5.0));
                m.points.extend(tet);
                m.tets.push([8, 9, 10, 11]);
                m.regions.push(0);
            }),
        ];
        for (kind, count, damage) in table {
            let mut raw = good.clone();
            damage(&mut raw);
            assert!(kinds(&raw).contains(&(kind, count)), "{kind:?}: {:?}", findings(&raw));
            assert_eq!(check(raw, &CheckOptions::default()).is_err(), kind.stops(), "{kind:?}");
        }
    }

    #[test]
    fn a_third_tet_on_a_face_is_found() {
        let mut raw = five_tet_cube().into_raw();
        raw.points.push([3.0, 3.0, 3.0]);
        let [a, b, c, _] = raw.tets[0];
        raw.tets.push([a, b, c, 8]);
        raw.regions.push(0);
        assert!(kinds(&raw).contains(&(FindingKind::OversharedFaces, 1)));
    }

    #[test]
    fn inverted_tets_are_turned_round_only_if_asked() {
        let good = five_tet_cube().into_raw();
        let mut raw = good.clone();
        raw.tets[3].swap(0, 2);
        assert!(check(raw.clone(), &CheckOptions::default()).is_err());
        let checked = check(raw, &CheckOptions { reorient: true }).unwrap();
        assert_eq!(checked.mesh.raw(), &good);
        assert_eq!(checked.findings[0].to_string(), "1 inverted tets (tet 3): mended as asked");
    }

    #[test]
    fn repeated_simplices_are_left_out() {
        let mut raw = five_tet_cube().into_raw();
        raw.edges.push([2, 3], 5);
        raw.edges.push([2, 3], 6);
        raw.edges.push([3, 2], 5);
        let mesh = check(raw, &CheckOptions::default()).unwrap().mesh;
        assert_eq!(mesh.edges().iter().collect::<Vec<_>>(), [([2, 3], 5), ([2, 3], 6)]);
    }

    #[test]
    fn unused_vertices_are_left_out_and_the_rest_renumbered() {
        let good = five_tet_cube().into_raw();
        let mut raw = good.clone();
        raw.points.insert(2, [9.0; 3]);
        raw.tets.as_flattened_mut().iter_mut().for_each(|v| *v += u32::from(*v >= 2));
        let checked = check(raw, &CheckOptions::default()).unwrap();
        assert_eq!(checked.kept_vertices, Some(vec![0, 1, 3, 4, 5, 6, 7, 8]));
        assert_eq!(checked.mesh.raw(), &good);
    }
}

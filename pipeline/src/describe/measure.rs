//! Measuring a mesh, sound or not.

use std::borrow::Cow;

use octruss_base::vector3::{cross, length, subtract};
use octruss_mesh::components::first_tets;
use octruss_mesh::quality::summarise;
use octruss_mesh::reference_tet::six_volumes;
use octruss_mesh::{FindingKind, RawMesh, Tagged, Topology, findings};
use octruss_meshio::{Dataset, Field};

use super::description::{Description, FieldReport, Quality, Region, Surface};
use crate::report::FindingReport;

/// Counts and measures a mesh, also a broken one.
///
/// ```
/// use octruss_meshio::Dataset;
/// let mesh = octruss_mesh::shapes::kuhn_cube(1).into_raw();
/// let cube = octruss::describe(&Dataset { mesh, ..Dataset::default() });
/// assert_eq!((cube.tets, cube.edges, cube.boundary_faces), (6, 19, 12));
/// assert!((cube.volume - 1.0).abs() < 1e-14 && cube.components == 1);
/// assert!(cube.findings.is_empty());
/// ```
pub fn describe(dataset: &Dataset) -> Description {
    let findings = findings(&dataset.mesh);
    let broken = findings.iter().any(|finding| finding.kind == FindingKind::IndexOutOfRange);
    let mesh = if broken {
        Cow::Owned(in_range(dataset.mesh.clone()))
    } else {
        Cow::Borrowed(&dataset.mesh)
    };
    let topology = Topology::new(&mesh);
    let is_boundary = |&face: &usize| topology.is_boundary(face);
    Description {
        vertices: dataset.mesh.points.len(),
        tets: dataset.mesh.tets.len(),
        edges: topology.edges().len(),
        boundary_faces: (0..topology.faces().len()).filter(is_boundary).count(),
        regions: regions(&mesh),
        surfaces: surfaces(&mesh),
        volume: total(mesh.tets.iter().map(|tet| volume(&mesh, tet))),
        components: first_tets(&mesh).len(),
        quality: summarise(&mesh).map(Quality::from),
        point_fields: dataset.point_fields.iter().map(field_report).collect(),
        cell_fields: dataset.cell_fields.iter().map(field_report).collect(),
        corner_fields: dataset.corner_fields.iter().map(field_report).collect(),
        findings: findings.iter().map(FindingReport::from).collect(),
        notes: dataset.notes.clone(),
    }
}

fn field_report(field: &Field) -> FieldReport {
    FieldReport { name: field.name.clone(), components: field.components }
}

/// The mesh without simplices that name vertices which do not exist.
fn in_range(mut mesh: RawMesh) -> RawMesh {
    let count = mesh.points.len();
    let sound: Vec<bool> =
        mesh.tets.iter().map(|tet| tet.iter().all(|&v| (v as usize) < count)).collect();
    let mut keep = sound.iter();
    mesh.regions.retain(|_| *keep.next().unwrap_or(&false));
    let mut keep = sound.iter();
    mesh.tets.retain(|_| *keep.next().unwrap_or(&false));
    mesh.triangles = tagged_in_range(&mesh.triangles, count);
    mesh.edges = tagged_in_range(&mesh.edges, count);
    mesh.vertices = tagged_in_range(&mesh.vertices, count);
    mesh.features = None;
    mesh
}

fn tagged_in_range<const N: usize>(tagged: &Tagged<N>, count: usize) -> Tagged<N> {
    let mut kept = Tagged::default();
    for (simplex, tag) in tagged.iter() {
        if simplex.iter().all(|&v| (v as usize) < count) {
            kept.push(simplex, tag);
        }
    }
    kept
}

fn regions(mesh: &RawMesh) -> Vec<Region> {
    let region = |id| {
        let tets = mesh.tets.iter().zip(&mesh.regions).filter(|&(_, &region)| region == id);
        let volumes: Vec<f64> = tets.map(|(tet, _)| volume(mesh, tet)).collect();
        let count = volumes.len();
        Region { name: mesh.group_name(3, id), id, count, volume: total(volumes) }
    };
    group_ids(mesh, 3).into_iter().map(region).collect()
}

fn surfaces(mesh: &RawMesh) -> Vec<Surface> {
    let surface = |id| {
        let triangles = mesh.triangles.iter().filter(|&(_, tag)| tag == id);
        let areas: Vec<f64> = triangles.map(|(triangle, _)| area(mesh, triangle)).collect();
        let count = areas.len();
        Surface { name: mesh.group_name(2, id), id, count, area: total(areas) }
    };
    group_ids(mesh, 2).into_iter().map(surface).collect()
}

/// Ids of groups that are named or in use, ascending.
fn group_ids(mesh: &RawMesh, dimension: u8) -> Vec<i32> {
    let named = mesh.groups.iter().filter(|group| group.dimension == dimension);
    let mut ids: Vec<i32> = named.map(|group| group.id).chain(mesh.ids(dimension)).collect();
    ids.sort_unstable();
    ids.dedup();
    ids
}

/// The sum, 0 for nothing: `sum` of no floats is −0, which JSON would show.
fn total(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(0.0, |sum, number| sum + number)
}

fn volume(mesh: &RawMesh, tet: &[u32; 4]) -> f64 {
    six_volumes(tet.map(|v| mesh.points[v as usize])) / 6.0
}

fn area(mesh: &RawMesh, triangle: [u32; 3]) -> f64 {
    let [o, a, b] = triangle.map(|v| mesh.points[v as usize]);
    length(cross(subtract(a, o), subtract(b, o))) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use octruss_mesh::Group;
    use octruss_mesh::shapes::kuhn_cube;

    fn describe_mesh(mesh: RawMesh) -> Description {
        describe(&Dataset { mesh, ..Dataset::default() })
    }

    #[test]
    fn broken_meshes_are_described_as_far_as_they_go() {
        let mut mesh = kuhn_cube(1).into_raw();
        mesh.tets.push([0, 1, 2, 99]);
        mesh.regions.push(7);
        mesh.triangles.push([0, 1, u32::MAX], 1);
        mesh.tets.push([0, 0, 1, 1]);
        mesh.regions.push(0);
        let broken = describe_mesh(mesh);
        assert_eq!((broken.tets, broken.vertices, broken.components), (8, 8, 1));
        assert!((broken.volume - 1.0).abs() < 1e-14, "only what is in range is measured");
        assert_eq!(broken.surfaces[0].count, 2);
        assert_eq!(broken.findings[0].kind, "index-out-of-range");
        assert_eq!(broken.findings[0].count, 2);
    }

    #[test]
    fn numbers_that_are_none_become_null() {
        let mut mesh = kuhn_cube(1).into_raw();
        mesh.points[0][0] = f64::NAN;
        let broken = describe_mesh(mesh);
        assert_eq!(broken.findings[0].kind, "non-finite-coordinates");
        assert!(serde_json::to_value(&broken).unwrap()["volume"].is_null());
    }

    #[test]
    fn empty_groups_measure_zero_not_minus_zero() {
        let groups = vec![
            Group { dimension: 3, id: 1, name: "solid".into() },
            Group { dimension: 2, id: 2, name: "skin".into() },
        ];
        let empty = describe_mesh(RawMesh { groups, ..RawMesh::default() });
        let numbers = [empty.volume, empty.regions[0].volume, empty.surfaces[0].area];
        assert_eq!(serde_json::to_string(&numbers).unwrap(), "[0.0,0.0,0.0]");
    }

    #[test]
    fn nothing_at_all_is_described_too() {
        let nothing = describe_mesh(RawMesh::default());
        assert_eq!((nothing.tets, nothing.edges, nothing.quality), (0, 0, None));
        assert_eq!(nothing.findings[0].kind, "no-tets");
    }
}

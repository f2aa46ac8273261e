//! Why curves and points of the coarsest mesh are what they are. All counts are
//! by hand, on the Kuhn cube of 4 × 4 × 4 cells.

use std::collections::BTreeMap;

use octruss_mesh::{
    CheckOptions, ExtraFeatures, FeatureOptions, FeatureReasons, GroupBorders, Hierarchy, Level,
    RawMesh, Reason, Scheme, Strata, check, shapes,
};

fn vertex([i, j, k]: [u32; 3]) -> u32 {
    (k * 5 + j) * 5 + i
}

fn cube() -> RawMesh {
    shapes::kuhn_cube(4).into_raw()
}

struct Explained {
    hierarchy: Hierarchy,
    reasons: FeatureReasons,
}

fn explain(raw: RawMesh, options: FeatureOptions) -> Explained {
    let mesh = check(raw, &CheckOptions::default()).unwrap().mesh;
    let hierarchy = Hierarchy::new(mesh, &options);
    let Level { mesh, topology, .. } = hierarchy.coarsest();
    let reasons = FeatureReasons::new(mesh, topology, Some(&options));
    Explained { hierarchy, reasons }
}

fn count<T>(parts: &[(T, Reason)]) -> BTreeMap<&'static str, usize> {
    let mut counts = BTreeMap::new();
    parts.iter().for_each(|(_, reason)| *counts.entry(reason.name()).or_default() += 1);
    counts
}

#[test]
fn the_edges_of_a_cube_are_borders_of_groups_or_sharp() {
    let Explained { reasons, .. } = explain(cube(), FeatureOptions::default());
    assert_eq!(count(&reasons.curves), [("group-border", 48)].into());
    assert_eq!(count(&reasons.points), [("curves-meet", 8)].into());
    let options = FeatureOptions { group_borders: GroupBorders::None, ..FeatureOptions::default() };
    let Explained { reasons, .. } = explain(cube(), options.clone());
    assert_eq!(count(&reasons.curves), [("angle", 48)].into());
    let options = FeatureOptions { crease_angle: 180.0, ..options };
    let Explained { reasons, .. } = explain(cube(), options);
    assert_eq!(reasons, FeatureReasons::default());
}

#[test]
fn every_reason_is_told() {
    let mut raw = cube();
    // An interface at x = 1/2: its border is a loop of 16 junctions, which cross
    // edges of the cube in 4 vertices.
    let right = |tet: &[u32; 4]| tet.iter().any(|&v| raw.points[v as usize][0] > 0.5);
    raw.regions = raw.tets.iter().map(|tet| i32::from(right(tet))).collect();
    // A curve group of one edge inside, which ends in a point group.
    raw.edges.push([vertex([1, 1, 1]), vertex([1, 1, 2])], 5);
    raw.vertices.push([vertex([1, 1, 1])], 5);
    // A square of two triangles inside, a surface that was asked for.
    let square = [[3, 1, 1], [3, 2, 1], [3, 2, 2], [3, 1, 2]].map(vertex);
    raw.triangles.push([square[0], square[1], square[2]], 9);
    raw.triangles.push([square[0], square[2], square[3]], 9);
    // Away from the cube an edge, and a vertex on its own.
    let free = raw.points.len() as u32;
    raw.points.extend([[7.0, 0.0, 0.0], [8.0, 0.0, 0.0], [9.0, 0.0, 0.0]]);
    raw.edges.push([free, free + 1], 6);
    raw.vertices.push([free + 2], 6);

    let mesh = check(raw.clone(), &CheckOptions::default()).unwrap().mesh;
    let asked = [[vertex([2, 1, 1]), vertex([2, 2, 1])], [vertex([0, 0, 0]), vertex([1, 0, 0])]];
    let extra = ExtraFeatures::new(&mesh, &asked, &[vertex([1, 3, 3])]).unwrap();
    let options = FeatureOptions { surfaces: vec![9], extra, ..FeatureOptions::default() };
    let Explained { reasons, hierarchy } = explain(raw.clone(), options.clone());
    assert_eq!(
        count(&reasons.curves),
        [
            ("junction", 16),
            ("surface-border", 4),
            ("asked-for", 2),
            // The one free edge and the one inside.
            ("curve-group", 2),
            // Of 48 one was asked for, which counts first.
            ("group-border", 47),
        ]
        .into()
    );
    assert_eq!(
        count(&reasons.points),
        [("asked-for", 1), ("point-group", 2), ("curves-meet", 8 + 4), ("loose-end", 2)].into()
    );
    // They are the strata, part for part.
    let topology = &hierarchy.coarsest().topology;
    let features = hierarchy.coarsest().mesh.features().unwrap();
    let strata = Strata::new(hierarchy.coarsest().mesh.raw(), topology, features);
    let curves = topology.edges().iter().zip(&strata.edge_dimensions);
    let curves = curves.filter(|(_, dimension)| **dimension == 1).map(|(&ends, _)| ends);
    assert!(reasons.curves.iter().map(|curve| curve.0).eq(curves));
    let points = (0u32..).zip(&strata.vertex_dimensions).filter(|(_, dimension)| **dimension == 0);
    assert!(reasons.points.iter().map(|point| point.0).eq(points.map(|(v, _)| v)));

    // Without curve and point groups the free ones remain.
    let options = FeatureOptions { group_curves: false, group_points: false, ..options };
    let Explained { reasons, .. } = explain(raw, options);
    assert_eq!(count(&reasons.curves)["free-edge"], 1);
    assert_eq!(count(&reasons.points)["loose-end"], 3);
}

#[test]
fn a_vertex_where_surfaces_only_touch_is_told() {
    let mut raw = cube();
    // A region of one tet in the middle, and another that shares one vertex with it.
    let place = |v: u32| raw.points[v as usize];
    let centre = vertex([2, 2, 2]);
    let at_centre = |t: &usize| raw.tets[*t].contains(&centre);
    let opposite = |t: &usize, u: &usize| {
        let shared = raw.tets[*t].iter().filter(|v| raw.tets[*u].contains(v)).count();
        shared == 1 && raw.tets[*t].iter().all(|&v| place(v)[0] <= 0.5)
    };
    let tets: Vec<usize> = (0..raw.tets.len()).filter(at_centre).collect();
    let pairs = tets.iter().flat_map(|t| tets.iter().map(move |u| (*t, *u)));
    let (t, u) = pairs.clone().find(|(t, u)| opposite(t, u)).unwrap();
    (raw.regions[t], raw.regions[u]) = (1, 1);
    let options = FeatureOptions { crease_angle: 180.0, ..FeatureOptions::default() };
    let Explained { reasons, .. } = explain(raw, options);
    assert!(reasons.points.contains(&(centre, Reason::TouchingPoint)));
    assert_eq!(count(&reasons.points)["touching-point"], 1);
}

#[test]
fn features_from_a_file_are_recorded() {
    let options = FeatureOptions::default();
    let mut hierarchy = explain(cube(), options.clone()).hierarchy;
    hierarchy.subdivide(Scheme::Linear).unwrap();
    let fine = Hierarchy::new(hierarchy.finest().mesh.clone(), &options);
    let reasons = FeatureReasons::new(&fine.finest().mesh, &fine.coarsest().topology, None);
    assert_eq!(count(&reasons.curves), [("recorded", 96)].into());
    assert_eq!(count(&reasons.points), [("curves-meet", 8)].into());
}

#[test]
fn codes_count_from_one_and_names_differ() {
    let codes: Vec<u8> = Reason::ALL.iter().map(|reason| reason.code()).collect();
    assert_eq!(codes, (1..=12).collect::<Vec<u8>>());
    let mut names: Vec<&str> = Reason::ALL.iter().map(|reason| reason.name()).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), 12);
}

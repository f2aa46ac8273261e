//! Which borders between surface groups are creases. Counts are by hand, on boxes of
//! 4 × 4 × 4 Kuhn cells, whose sides are the groups 1 to 6: −x, +x, −y, +y, −z, +z.

use std::collections::BTreeMap;

use octruss_mesh::{
    CheckOptions, FeatureOptions, FeatureReasons, GroupBorders, Hierarchy, Level, RawMesh, Scheme,
    check, shapes,
};

/// How many edges are creases for which reason.
type Counts = BTreeMap<&'static str, usize>;

fn hierarchy(raw: &RawMesh, group_borders: GroupBorders, crease_angle: f64) -> (Hierarchy, Counts) {
    let mesh = check(raw.clone(), &CheckOptions::default()).unwrap().mesh;
    let options = FeatureOptions { group_borders, crease_angle, ..FeatureOptions::default() };
    let hierarchy = Hierarchy::new(mesh, &options);
    let Level { mesh, topology, .. } = hierarchy.coarsest();
    let mut counts = Counts::new();
    for (_, reason) in FeatureReasons::new(mesh, topology, Some(&options)).curves {
        *counts.entry(reason.name()).or_default() += 1;
    }
    (hierarchy, counts)
}

fn creases(raw: &RawMesh, group_borders: GroupBorders, crease_angle: f64) -> Counts {
    hierarchy(raw, group_borders, crease_angle).1
}

/// Gives the tagged triangles that `belongs` accepts, by tag and corners, a new tag.
fn retag(raw: &mut RawMesh, new: i32, belongs: impl Fn(i32, [[f64; 3]; 3]) -> bool) {
    for (triangle, tag) in raw.triangles.simplices.iter().zip(&mut raw.triangles.tags) {
        if belongs(*tag, triangle.map(|v| raw.points[v as usize])) {
            *tag = new;
        }
    }
}

/// The unit cube with a square of 2 × 2 cells in the middle of its top as the group 9.
fn imprinted_cube() -> RawMesh {
    let mut raw = shapes::kuhn_cube(4).into_raw();
    let inner = |x: f64| (0.25..=0.75).contains(&x);
    retag(&mut raw, 9, |tag, corners| {
        tag == 6 && corners.iter().all(|p| inner(p[0]) && inner(p[1]))
    });
    raw
}

/// A shaft of radius 1 and length 2 along z: four groups of four by four facets, bends of
/// 18° and 27° between them; its ends are 5 and 6.
fn shaft() -> RawMesh {
    let mut raw = shapes::kuhn_box([4, 4, 4], [2.0, 2.0, 2.0]).into_raw();
    for point in &mut raw.points {
        let [x, y] = [point[0] - 1.0, point[1] - 1.0];
        let factor = x.abs().max(y.abs()) / x.hypot(y).max(1e-300);
        [point[0], point[1]] = [factor * x, factor * y];
    }
    raw
}

#[test]
fn an_imprint_on_a_plane_keeps_its_outline() {
    let raw = imprinted_cube();
    for kept in [GroupBorders::Flat, GroupBorders::All] {
        assert_eq!(creases(&raw, kept, 40.0), [("group-border", 48 + 8)].into());
    }
    assert_eq!(creases(&raw, GroupBorders::None, 40.0), [("angle", 48)].into());
}

#[test]
fn noise_on_a_plane_is_flat_up_to_a_degree() {
    // The top's vertex at a corner of the square rises: the edges there bend by as many
    // degrees or somewhat less, and none of the other six edges.
    let raised = |degrees: f64| {
        let mut raw = imprinted_cube();
        let corner = raw.points.iter().position(|p| *p == [0.25, 0.25, 1.0]).unwrap();
        raw.points[corner][2] += 0.25 * degrees.to_radians().tan();
        creases(&raw, GroupBorders::Flat, 40.0)
    };
    assert_eq!(raised(0.5), [("group-border", 48 + 8)].into());
    // All of the outline is given up, not two edges of it.
    assert_eq!(raised(3.0), [("group-border", 48)].into());
}

#[test]
fn patches_of_a_cylinder_are_shaped_as_one_surface() {
    let raw = shaft();
    let refined = |kept| {
        let (mut hierarchy, counts) = hierarchy(&raw, kept, 40.0);
        hierarchy.subdivide(Scheme::BoxSpline).unwrap();
        (hierarchy.finest().mesh.points().to_vec(), counts)
    };
    let (flat, all, none) =
        (refined(GroupBorders::Flat), refined(GroupBorders::All), refined(GroupBorders::None));
    // Two rims of 16 edges, and four borders of 4.
    assert_eq!(flat.1, [("group-border", 32)].into());
    assert_eq!(all.1, [("group-border", 32 + 16)].into());
    assert_eq!(none.1, [("angle", 32)].into());
    assert_eq!(flat.0, none.0);
    // Vertex 74 is half-way up the border at 45°, among neighbours above, below and, two
    // and two, at the angles atan(1/2) and atan(2). On a curve it only reads those above
    // and below and stays: a ridge.
    let radius = |points: &[[f64; 3]]| points[74][0].hypot(points[74][1]);
    let round = 0.75 + 0.25 * 1.5 / 2.5_f64.sqrt();
    assert!((radius(&flat.0) - round).abs() < 1e-14, "{} for {round}", radius(&flat.0));
    assert!((radius(&all.0) - 1.0).abs() < 1e-14, "{}", radius(&all.0));
}

#[test]
fn a_ring_round_a_cylinder_costs_nothing() {
    // Facets above the ring continue those below: it is kept, and keeps its height.
    let mut raw = shaft();
    retag(&mut raw, 1, |tag, _| tag <= 4);
    retag(&mut raw, 2, |tag, corners| tag == 1 && corners.iter().all(|p| p[2] >= 1.0));
    let [(flat, rings), (none, _)] = [GroupBorders::Flat, GroupBorders::None].map(|kept| {
        let (mut hierarchy, counts) = hierarchy(&raw, kept, 40.0);
        hierarchy.subdivide(Scheme::BoxSpline).unwrap();
        (hierarchy.finest().mesh.points().to_vec(), counts)
    });
    assert_eq!(rings, [("group-border", 3 * 16)].into());
    let on_ring =
        |v: &usize| raw.points[*v][2] == 1.0 && raw.points[*v][0].hypot(raw.points[*v][1]) > 0.99;
    let ring: Vec<usize> = (0..raw.points.len()).filter(on_ring).collect();
    assert_eq!(ring.len(), 16);
    assert!(ring.iter().all(|&v| flat[v][2] == 1.0));
    // Curve and surface rules are the same cubic splines round it.
    for (p, q) in flat.iter().zip(&none) {
        assert!((p[0] - q[0]).hypot(p[1] - q[1]) < 1e-14, "{p:?} {q:?}");
    }
}

#[test]
fn a_border_that_is_bent_is_a_crease_only_where_it_is_sharp() {
    // The top and one patch are one group, the other patches another. Their border is
    // twelve edges of the rim and two lines of four edges along the patch.
    let mut raw = shaft();
    retag(&mut raw, 6, |tag, _| tag == 1);
    retag(&mut raw, 2, |tag, _| tag <= 4);
    // Sharp by angle are these twelve, and four of the rim inside the first group; the
    // borders of the other end are sharp all over.
    let counts = creases(&raw, GroupBorders::Flat, 40.0);
    assert_eq!(counts, [("angle", 12 + 4), ("group-border", 16)].into());
    let counts = creases(&raw, GroupBorders::All, 40.0);
    assert_eq!(counts, [("angle", 4), ("group-border", 12 + 8 + 16)].into());
}

#[test]
fn patches_that_meet_at_right_angles_do_so_by_the_crease_angle() {
    let raw = shapes::kuhn_cube(4).into_raw();
    for crease_angle in [40.0, 89.0] {
        let counts = creases(&raw, GroupBorders::Flat, crease_angle);
        assert_eq!(counts, [("group-border", 48)].into());
    }
    assert_eq!(creases(&raw, GroupBorders::Flat, 180.0), [].into());
    assert_eq!(creases(&raw, GroupBorders::All, 180.0), [("group-border", 48)].into());
    assert_eq!(creases(&raw, GroupBorders::None, 180.0), [].into());
}

#[test]
fn faces_without_a_group_are_a_group_to_others() {
    let mut raw = imprinted_cube();
    let tags = raw.triangles.tags.clone();
    raw.triangles = Default::default();
    let all = imprinted_cube().triangles.simplices;
    for (triangle, _) in all.into_iter().zip(tags).filter(|(_, tag)| *tag == 9) {
        raw.triangles.push(triangle, 9);
    }
    let counts = creases(&raw, GroupBorders::Flat, 40.0);
    assert_eq!(counts, [("angle", 48), ("group-border", 8)].into());
}

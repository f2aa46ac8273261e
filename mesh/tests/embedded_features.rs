//! Creases, corners and surfaces inside the solid, where they end, and where
//! they meet the boundary: the same table of rules holds everywhere.
//!
//! All weights are derived by hand on the Kuhn lattice with spacing 1/4, whose
//! edges run along x, y, z, the diagonals of squares and those of cubes: an
//! interior vertex has 14 neighbours, one inside a flat surface of lattice
//! triangles 6.

use octruss_mesh::{
    CheckOptions, ExtraFeatures, FeatureError, FeatureOptions, Group, RawMesh, Scheme,
    SubdivisionMatrix, TetMesh, Topology, check, prepare, shapes, subdivision_matrix,
};

/// The schemes that move vertices share the rules below the solid.
const APPROXIMATING: [Scheme; 3] = [Scheme::BoxSpline, Scheme::Averaged, Scheme::LOOP_SOLID];

/// A prepared mesh with the matrix of one step; vertices go by their place in
/// the lattice, in quarters.
struct Block {
    mesh: TetMesh,
    topology: Topology,
    matrix: SubdivisionMatrix,
}

type Place = [i32; 3];

impl Block {
    fn new(raw: RawMesh, options: &FeatureOptions, scheme: Scheme) -> Self {
        let mesh = prepare(check(raw, &CheckOptions::default()).unwrap().mesh, options);
        let topology = Topology::new(mesh.raw());
        let matrix = subdivision_matrix(&mesh, &topology, scheme);
        Self { mesh, topology, matrix }
    }

    /// The row of a vertex, as places and weights.
    fn vertex(&self, at: Place) -> Vec<(Place, f64)> {
        self.row(vertex(at) as usize)
    }

    /// The row of the midpoint of an edge.
    fn edge(&self, a: Place, b: Place) -> Vec<(Place, f64)> {
        let edge = self.topology.edge_between(vertex(a), vertex(b)).expect("a lattice edge");
        self.row(self.topology.vertex_count() + edge as usize)
    }

    fn row(&self, row: usize) -> Vec<(Place, f64)> {
        let (columns, weights) = self.matrix.row(row);
        let place = |&v: &u32| self.mesh.points()[v as usize].map(|x| (4.0 * x).round() as i32);
        columns.iter().map(place).zip(weights.iter().copied()).collect()
    }
}

/// The number of a vertex of the block of 4 × 4 × 4 cells.
fn vertex([i, j, k]: Place) -> u32 {
    ((k * 5 + j) * 5 + i) as u32
}

fn lattice() -> RawMesh {
    shapes::kuhn_cube(4).into_raw()
}

/// Tags the lattice triangles that have all their vertices at such places.
fn tag_triangles(raw: &mut RawMesh, tag: i32, holds: impl Fn(Place) -> bool) {
    let topology = Topology::new(raw);
    let place = |v: u32| raw.points[v as usize].map(|x| (4.0 * x).round() as i32);
    let inside = topology.faces().iter().filter(|face| face.iter().all(|&v| holds(place(v))));
    inside.for_each(|&face| raw.triangles.push(face, tag));
    raw.groups.push(Group { dimension: 2, id: tag, name: "embedded".into() });
}

fn assert_row(mut found: Vec<(Place, f64)>, expected: &[(Place, f64)]) {
    let mut expected = expected.to_vec();
    found.sort_by_key(|entry| entry.0);
    expected.sort_by_key(|entry| entry.0);
    assert_eq!(found.len(), expected.len(), "{found:?} against {expected:?}");
    for ((at, weight), (place, known)) in found.iter().zip(&expected) {
        assert!(at == place && (weight - known).abs() < 1e-15, "{found:?} against {expected:?}");
    }
}

/// The 14 neighbours in the lattice.
fn neighbours([i, j, k]: Place) -> impl Iterator<Item = Place> {
    let positive = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [0, 1, 1], [1, 0, 1], [1, 1, 1]];
    positive.into_iter().flat_map(move |[x, y, z]| [[i + x, j + y, k + z], [i - x, j - y, k - z]])
}

const CENTRE: Place = [2, 2, 2];

#[test]
fn a_tagged_curve_in_the_solid_is_a_cubic_spline_and_its_ends_are_smooth() {
    let mut raw = lattice();
    // Bent at the centre; its ends are darts.
    let [start, end] = [[1, 2, 2], [2, 3, 2]];
    raw.edges.push([vertex(start), vertex(CENTRE)], 5);
    raw.edges.push([vertex(end), vertex(CENTRE)], 5);
    for scheme in APPROXIMATING {
        let block = Block::new(raw.clone(), &FeatureOptions::default(), scheme);
        assert_row(block.vertex(CENTRE), &[(start, 0.125), (CENTRE, 0.75), (end, 0.125)]);
        assert_row(block.edge(start, CENTRE), &[(start, 0.5), (CENTRE, 0.5)]);
    }
    let block = Block::new(raw.clone(), &FeatureOptions::default(), Scheme::BoxSpline);
    let mut smooth = vec![(start, 18.0 / 32.0)];
    smooth.extend(neighbours(start).map(|place| (place, 1.0 / 32.0)));
    assert_row(block.vertex(start), &smooth);
    // Without curve groups the centre is smooth as well.
    let options = FeatureOptions { group_curves: false, ..FeatureOptions::default() };
    let block = Block::new(raw, &options, Scheme::BoxSpline);
    assert_eq!(block.vertex(CENTRE).len(), 15);
}

#[test]
fn three_curves_that_meet_in_the_solid_make_a_corner() {
    let mut raw = lattice();
    for end in [[1, 2, 2], [2, 3, 2], [2, 2, 3]] {
        raw.edges.push([vertex(end), vertex(CENTRE)], 5);
    }
    let block = Block::new(raw, &FeatureOptions::default(), Scheme::BoxSpline);
    assert_row(block.vertex(CENTRE), &[(CENTRE, 1.0)]);
}

#[test]
fn a_tagged_point_in_the_solid_stays() {
    let mut raw = lattice();
    raw.vertices.push([vertex(CENTRE)], 3);
    for scheme in APPROXIMATING {
        let block = Block::new(raw.clone(), &FeatureOptions::default(), scheme);
        assert_row(block.vertex(CENTRE), &[(CENTRE, 1.0)]);
        // Edges at it are in the solid and read as before: here one of 6 tets.
        if scheme == Scheme::BoxSpline {
            let row = block.edge(CENTRE, [3, 2, 2]);
            assert_eq!(row.len(), 8);
            assert!(row.contains(&(CENTRE, 10.0 / 32.0)));
        }
    }
}

#[test]
fn an_embedded_surface_follows_loop_and_its_border_is_a_crease() {
    let mut raw = lattice();
    // The square 1/4 ≤ x, y ≤ 3/4 at z = 1/2.
    tag_triangles(&mut raw, 9, |[i, j, k]| k == 2 && (1..=3).contains(&i) && (1..=3).contains(&j));
    assert_eq!(raw.triangles.tags.iter().filter(|&&tag| tag == 9).count(), 8);
    let options = FeatureOptions { surfaces: vec![9], ..FeatureOptions::default() };
    for scheme in APPROXIMATING {
        let block = Block::new(raw.clone(), &options, scheme);
        let ring = [[3, 2, 2], [3, 3, 2], [2, 3, 2], [1, 2, 2], [1, 1, 2], [2, 1, 2]];
        let mut inner = vec![(CENTRE, 10.0 / 16.0)];
        inner.extend(ring.map(|place| (place, 1.0 / 16.0)));
        assert_row(block.vertex(CENTRE), &inner);
        assert_row(
            block.edge(CENTRE, [3, 2, 2]),
            &[(CENTRE, 0.375), ([3, 2, 2], 0.375), ([3, 3, 2], 0.125), ([2, 1, 2], 0.125)],
        );
        assert_row(
            block.vertex([2, 1, 2]),
            &[([1, 1, 2], 0.125), ([2, 1, 2], 0.75), ([3, 1, 2], 0.125)],
        );
        assert_row(block.edge([1, 1, 2], [2, 1, 2]), &[([1, 1, 2], 0.5), ([2, 1, 2], 0.5)]);
    }
    // Triangles of other groups are labels only.
    let block = Block::new(raw, &FeatureOptions::default(), Scheme::BoxSpline);
    assert_eq!(block.vertex(CENTRE).len(), 15);
}

#[test]
fn an_interface_follows_loop_and_meets_the_boundary_in_a_curve() {
    let mut raw = lattice();
    let left = |tet: &[u32; 4]| tet.iter().all(|&v| raw.points[v as usize][0] <= 0.5);
    raw.regions = raw.tets.iter().map(|tet| if left(tet) { 1 } else { 2 }).collect();
    for scheme in APPROXIMATING {
        let block = Block::new(raw.clone(), &FeatureOptions::default(), scheme);
        let ring = [[2, 3, 2], [2, 3, 3], [2, 2, 3], [2, 1, 2], [2, 1, 1], [2, 2, 1]];
        let mut inner = vec![(CENTRE, 10.0 / 16.0)];
        inner.extend(ring.map(|place| (place, 1.0 / 16.0)));
        assert_row(block.vertex(CENTRE), &inner);
        assert_row(
            block.edge(CENTRE, [2, 3, 2]),
            &[(CENTRE, 0.375), ([2, 3, 2], 0.375), ([2, 3, 3], 0.125), ([2, 2, 1], 0.125)],
        );
        // Three faces meet at its edges on the side y = 0.
        assert_row(
            block.vertex([2, 0, 2]),
            &[([2, 0, 1], 0.125), ([2, 0, 2], 0.75), ([2, 0, 3], 0.125)],
        );
        assert_row(block.edge([2, 0, 2], [2, 0, 3]), &[([2, 0, 2], 0.5), ([2, 0, 3], 0.5)]);
        // Where that curve crosses an edge of the cube, four creases meet.
        assert_row(block.vertex([2, 0, 0]), &[([2, 0, 0], 1.0)]);
    }
}

#[test]
fn a_crease_that_ends_on_the_boundary_leaves_a_smooth_dart() {
    let raw = lattice();
    let mesh = check(raw.clone(), &CheckOptions::default()).unwrap().mesh;
    let (dart, next, corner) = ([2, 2, 4], [3, 2, 4], [1, 3, 4]);
    let extra = ExtraFeatures::new(&mesh, &[[vertex(next), vertex(dart)]], &[vertex(corner)]);
    let options = FeatureOptions { extra: extra.unwrap(), ..FeatureOptions::default() };
    for scheme in APPROXIMATING {
        let block = Block::new(raw.clone(), &options, scheme);
        let ring = [[3, 2, 4], [3, 3, 4], [2, 3, 4], [1, 2, 4], [1, 1, 4], [2, 1, 4]];
        let mut smooth = vec![(dart, 10.0 / 16.0)];
        smooth.extend(ring.map(|place| (place, 1.0 / 16.0)));
        assert_row(block.vertex(dart), &smooth);
        assert_row(block.edge(dart, next), &[(dart, 0.5), (next, 0.5)]);
        assert_row(block.vertex(corner), &[(corner, 1.0)]);
    }
}

#[test]
fn features_asked_for_by_vertex_equal_tagged_ones() {
    let plain = lattice();
    let mut tagged = plain.clone();
    for [a, b] in [[[1, 2, 2], CENTRE], [CENTRE, [2, 3, 2]]] {
        tagged.edges.push([vertex(a), vertex(b)], 5);
    }
    tagged.vertices.push([vertex([3, 3, 3])], 6);
    let mesh = check(plain, &CheckOptions::default()).unwrap().mesh;
    let creases = tagged.edges.simplices.iter().map(|&[a, b]| [b, a]).collect::<Vec<_>>();
    let extra = ExtraFeatures::new(&mesh, &creases, &[vertex([3, 3, 3])]).unwrap();
    let options = FeatureOptions { extra, ..FeatureOptions::default() };
    let asked = prepare(mesh, &options);
    let tagged = check(tagged, &CheckOptions::default()).unwrap().mesh;
    let tagged = prepare(tagged, &FeatureOptions::default());
    assert_eq!(asked.features(), tagged.features());
    assert!(asked.features().unwrap().creases.is_sorted());
}

#[test]
fn edges_and_vertices_that_do_not_exist_are_named() {
    let mesh = shapes::five_tet_cube();
    // 0-7 is a diagonal of the cube, no edge of these tets.
    let refused = ExtraFeatures::new(&mesh, &[[0, 1], [7, 0]], &[]).unwrap_err();
    assert_eq!(refused, FeatureError::NoEdge { ends: [7, 0] });
    assert_eq!(
        refused.to_string(),
        "the crease 7-0 is no edge of the mesh; name the two ends of an edge, counted from 0"
    );
    let refused = ExtraFeatures::new(&mesh, &[[0, 1]], &[7, 8]).unwrap_err();
    assert_eq!(refused, FeatureError::NoVertex { vertex: 8, vertices: 8 });
    assert_eq!(
        refused.to_string(),
        "the corner 8 is no vertex of the mesh, which has 8; name one from 0 to 7"
    );
    assert!(ExtraFeatures::new(&mesh, &[[3, 3]], &[]).is_err());
    assert!(ExtraFeatures::new(&mesh, &[[1, u32::MAX]], &[]).is_err());
    assert!(ExtraFeatures::new(&mesh, &[[1, 0], [0, 1]], &[0, 0]).is_ok());
}

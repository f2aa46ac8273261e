//! Meshes that Gmsh itself wrote. Counts are those that Gmsh prints when it
//! reads them (`data/gmsh/make.py`), volumes those of `data/gmsh/blocks.geo`.

use std::path::PathBuf;

use octruss_mesh::{Group, RawMesh, Tagged};
use octruss_meshio::{Dataset, Field, Values};

const BLOCKS: [&str; 4] = [
    "blocks-4.1-ascii.msh",
    "blocks-4.1-binary.msh",
    "blocks-2.2-ascii.msh",
    "blocks-2.2-binary.msh",
];

fn read(name: &str) -> Dataset {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/gmsh");
    octruss_meshio::read(&folder.join(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// How many simplices each id has, by ascending id.
fn tally(tags: &[i32]) -> Vec<(i32, usize)> {
    let mut ids = tags.to_vec();
    ids.sort_unstable();
    ids.dedup();
    ids.iter().map(|&id| (id, tags.iter().filter(|&&tag| tag == id).count())).collect()
}

fn volume(mesh: &RawMesh, tet: [u32; 4]) -> f64 {
    let [a, b, c, d] = tet.map(|vertex| mesh.points[vertex as usize]);
    let [u, v, w] = [b, c, d].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
    let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    (normal[0] * w[0] + normal[1] * w[1] + normal[2] * w[2]) / 6.0
}

/// The volume of each region; every tet must have a positive one.
fn volumes(mesh: &RawMesh) -> Vec<(i32, f64)> {
    let each: Vec<f64> = mesh.tets.iter().map(|&tet| volume(mesh, tet)).collect();
    assert!(each.iter().all(|&volume| volume > 0.0));
    let sum = |id| each.iter().zip(&mesh.regions).filter(|pair| *pair.1 == id).map(|p| p.0).sum();
    tally(&mesh.regions).into_iter().map(|(id, _)| (id, sum(id))).collect()
}

fn assert_block_volumes(mesh: &RawMesh) {
    let [(1, left), (2, right)] = volumes(mesh)[..] else { panic!("expected regions 1 and 2") };
    assert!((left - 1.0).abs() < 1e-12, "{left}");
    assert!((right - 0.5).abs() < 1e-12, "{right}");
}

/// The simplices by the bits of their corners' coordinates, free of any numbering.
fn geometry<const N: usize>(
    mesh: &RawMesh,
    simplices: &[[u32; N]],
    tags: &[i32],
) -> Vec<(i32, Vec<[u64; 3]>)> {
    let corners = |simplex: &[u32; N]| -> Vec<[u64; 3]> {
        simplex.iter().map(|&vertex| mesh.points[vertex as usize].map(f64::to_bits)).collect()
    };
    let mut all: Vec<_> =
        tags.iter().copied().zip(simplices).map(|(tag, s)| (tag, corners(s))).collect();
    all.sort();
    all
}

fn tagged_geometry<const N: usize>(
    mesh: &RawMesh,
    tagged: &Tagged<N>,
) -> Vec<(i32, Vec<[u64; 3]>)> {
    geometry(mesh, &tagged.simplices, &tagged.tags)
}

#[test]
fn blocks_have_the_counts_that_gmsh_prints() {
    for name in BLOCKS {
        let Dataset { mesh, point_fields, cell_fields, notes, .. } = read(name);
        assert_eq!(mesh.points.len(), 117, "{name}");
        assert_eq!(tally(&mesh.regions), [(1, 184), (2, 124)], "{name}");
        let surfaces = [(3, 26), (4, 26), (5, 52), (6, 26), (30, 26)];
        assert_eq!(tally(&mesh.triangles.tags), surfaces, "{name}");
        assert_eq!(tally(&mesh.edges.tags), [(7, 3)], "{name}");
        assert_eq!(tally(&mesh.vertices.tags), [(8, 1)], "{name}");
        assert_eq!(mesh.points[mesh.vertices.simplices[0][0] as usize], [0.0; 3], "{name}");
        assert!(point_fields.is_empty() && cell_fields.is_empty());
        assert_eq!(notes.len(), 1, "{notes:?}");
        assert!(notes[0].starts_with("124 tets are in several volume groups"), "{notes:?}");
    }
}

#[test]
fn blocks_have_names_and_volumes() {
    let names = [
        (0, 8, "tip"),
        (1, 7, "seam"),
        (2, 3, "inlet"),
        (2, 4, "outlet"),
        (2, 5, "walls"),
        (2, 6, "reversed"),
        (3, 1, "left block"),
        (3, 2, "right block"),
        (3, 12, "heated"),
    ];
    for name in BLOCKS {
        let mesh = read(name).mesh;
        let expected =
            names.map(|(dimension, id, name)| Group { dimension, id, name: name.into() });
        assert_eq!(mesh.groups, expected, "{name}");
        assert_eq!(mesh.group_name(2, 30), "30");
        assert_block_volumes(&mesh);
    }
}

#[test]
fn all_flavours_are_the_same_mesh_up_to_numbering() {
    let expected = read(BLOCKS[0]).mesh;
    for name in &BLOCKS[1..] {
        let mesh = read(name).mesh;
        let sorted = |mesh: &RawMesh| {
            let mut points: Vec<_> = mesh.points.iter().map(|p| p.map(f64::to_bits)).collect();
            points.sort_unstable();
            points
        };
        assert_eq!(sorted(&mesh), sorted(&expected), "{name}");
        let tets = |mesh: &RawMesh| geometry(mesh, &mesh.tets, &mesh.regions);
        assert_eq!(tets(&mesh), tets(&expected), "{name}");
        let triangles = |mesh: &RawMesh| tagged_geometry(mesh, &mesh.triangles);
        assert_eq!(triangles(&mesh), triangles(&expected), "{name}");
        let edges = |mesh: &RawMesh| tagged_geometry(mesh, &mesh.edges);
        assert_eq!(edges(&mesh), edges(&expected), "{name}");
    }
}

#[test]
fn a_negative_group_turns_triangles_round() {
    for name in BLOCKS {
        let Tagged { simplices, tags } = read(name).mesh.triangles;
        let of = |id| simplices.iter().zip(&tags).filter(move |pair| *pair.1 == id).map(|p| *p.0);
        let turned: Vec<_> = of(6).map(|[a, b, c]| [a, c, b]).collect();
        assert_eq!(turned, of(30).collect::<Vec<_>>(), "{name}");
    }
}

#[test]
fn second_order_tets_are_read_as_linear_ones() {
    for name in ["second-order.msh", "second-order-2.2-binary.msh"] {
        let Dataset { mesh, notes, .. } = read(name);
        assert_eq!(mesh.points.len(), 65, "{name}");
        assert_eq!(tally(&mesh.regions), [(1, 100), (2, 70)], "{name}");
        let surfaces = [(3, 14), (4, 14), (5, 28), (6, 14), (30, 14)];
        assert_eq!(tally(&mesh.triangles.tags), surfaces, "{name}");
        assert_eq!(tally(&mesh.edges.tags), [(7, 2)], "{name}");
        assert_block_volumes(&mesh);
        let note = "Second-order cells, 170 tets among them, were read as linear ones; \
                    292 mid-side nodes were dropped.";
        assert!(notes.iter().any(|line| line == note), "{notes:?}");
    }
}

#[test]
fn sparse_node_tags_in_any_order() {
    let Dataset { mesh, notes, .. } = read("sparse-tags.msh");
    let points = [
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, -1.0],
    ];
    assert_eq!(mesh.points, points);
    assert_eq!(mesh.tets, [[5, 0, 1, 2], [5, 0, 2, 3], [5, 0, 3, 4], [5, 0, 4, 1]]);
    assert_eq!(mesh.regions, [9; 4]);
    // The regular octahedron with half-axis 1 has the volume 4/3.
    let [(9, volume)] = volumes(&mesh)[..] else { panic!("expected region 9") };
    assert!((volume - 4.0 / 3.0).abs() < 1e-15);
    assert!(notes.is_empty(), "{notes:?}");
}

#[test]
fn node_and_element_data_become_fields() {
    for name in ["fields-ascii.msh", "fields-binary.msh", "fields-2.2-binary.msh"] {
        let Dataset { mesh, point_fields, cell_fields, notes, .. } = read(name);
        let above: Vec<f64> = mesh.points.iter().map(|point| point[2] + 2.0).collect();
        assert_eq!(above.len(), 6);
        assert_eq!(point_fields, [Field::scalar("T", above)], "{name}");
        let [flux] = &cell_fields[..] else { panic!("{name}: one cell field expected") };
        assert_eq!((flux.name.as_str(), flux.components), ("heat flux", 3));
        let Values::Float(values) = &flux.values else { panic!("floating-point values expected") };
        assert_eq!(values[..9], [1.0, 0.5, -1.0, 2.0, 0.5, -2.0, 3.0, 0.5, -3.0], "{name}");
        assert!(values.len() == 12 && values[9..].iter().all(|value| value.is_nan()), "{name}");
        assert_eq!(
            notes,
            ["The field \"heat flux\" has no value for 1 of 4 tets; it is NaN there."],
            "{name}"
        );
    }
}

#[test]
fn parts_of_a_mesh_have_the_groups_of_the_whole() {
    for name in ["partitioned.msh", "partitioned-binary.msh"] {
        let mesh = read(name).mesh;
        assert_eq!(tally(&mesh.regions), [(1, 100), (2, 70)], "{name}");
        let surfaces = [(3, 14), (4, 14), (5, 28), (6, 14), (30, 14)];
        assert_eq!(tally(&mesh.triangles.tags), surfaces, "{name}");
        assert_block_volumes(&mesh);
    }
}

#[test]
fn other_sections_are_passed_over() {
    // A binary file with $Periodic.
    let Dataset { mesh, notes, .. } = read("periodic.msh");
    let [(1, volume)] = volumes(&mesh)[..] else { panic!("expected region 1") };
    assert!((volume - 1.0).abs() < 1e-12);
    assert!(notes.is_empty(), "{notes:?}");
}

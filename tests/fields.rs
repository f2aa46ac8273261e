//! Fields on their way through a run: at vertices, per side, on tets.

mod common;

use std::path::Path;

use common::{code, integers, octruss, report, sample, stderr, succeed};
use octruss_mesh::{RawMesh, shapes};
use octruss_meshio::{Dataset, Field, Values, read, write};
use serde_json::Value;

/// The Kuhn cube of 4 × 4 × 4 cells, region 1 where x < 1/2, else 2.
fn halves() -> RawMesh {
    let mut raw = shapes::kuhn_cube(4).into_raw();
    let left = |tet: &[u32; 4]| tet.iter().all(|&v| raw.points[v as usize][0] <= 0.5);
    raw.regions = raw.tets.iter().map(|tet| if left(tet) { 1 } else { 2 }).collect();
    raw
}

/// A density of 8 in region 1 and 3 in region 2, on tets.
fn density(mesh: &RawMesh) -> Field {
    let of_region = |&region: &i32| if region == 1 { 8.0 } else { 3.0 };
    Field::scalar("density", mesh.regions.iter().map(of_region).collect())
}

fn at_vertices(mesh: &RawMesh, name: &str, value: impl Fn(&[f64; 3]) -> f64) -> Field {
    Field::scalar(name, mesh.points.iter().map(value).collect())
}

/// Writes a mesh file and a config that refines it with these options.
fn set_up(folder: &Path, dataset: &Dataset, options: &str) {
    write(&folder.join("mesh.vtu"), dataset).unwrap();
    let config = format!(
        "name = \"f\"\n[[stage]]\nkind = \"import\"\npath = \"mesh.vtu\"\n[[stage]]\n\
         kind = \"check\"\n[[stage]]\nkind = \"subdivide\"\n{options}\n[[stage]]\nkind = \"write\"\n"
    );
    std::fs::write(folder.join("f.toml"), config).unwrap();
}

/// The report of the stage that subdivides.
fn subdivide(folder: &Path) -> Value {
    report(&folder.join("out/f"))["stages"][2].clone()
}

fn floats(field: &Field) -> &[f64] {
    let Values::Float(values) = &field.values else { panic!("{} is not of floats", field.name) };
    values
}

#[test]
fn a_field_of_tets_that_jumps_is_carried_for_each_region_by_itself() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = halves();
    let cell_fields = vec![density(&mesh)];
    let dataset = Dataset { mesh, cell_fields, ..Dataset::default() };
    for scheme in octruss_mesh::Scheme::ALL {
        let options = format!("scheme = \"{}\"\nlevels = 2\njumps = [\"density\"]", scheme.name());
        set_up(folder.path(), &dataset, &options);
        succeed(folder.path(), &["run", "f.toml", "--quiet"]);
        let fields = &subdivide(folder.path())["fields"];
        let figures = &fields["sides"]["density"];
        let number = |key: &str| figures[key].as_f64().unwrap();
        assert!((number("minimum") - 3.0).abs() < 1e-12, "{figures}");
        assert!((number("maximum") - 8.0).abs() < 1e-12);
        assert!((number("largest_jump") - 5.0).abs() < 1e-12);
        assert_eq!(fields["vertices"], serde_json::json!({}));
        assert_eq!(fields["tets"]["density"]["maximum"], 8.0);
        assert!(fields["clamped"].is_null());

        let out = folder.path().join("out/f");
        let apart = read(&out.join("solution.sides.vtu")).unwrap();
        let whole = read(&out.join("solution.vtu")).unwrap();
        // 17³ vertices, those of the interface once more.
        assert_eq!(whole.mesh.points.len(), 4913);
        assert_eq!(apart.mesh.points.len(), 4913 + 289);
        assert_eq!(apart.mesh.tets.len(), whole.mesh.tets.len());
        for (tet, &region) in apart.mesh.tets.iter().zip(&apart.mesh.regions) {
            for &v in tet {
                let value = floats(&apart.point_fields[0])[v as usize];
                assert!((value - if region == 1 { 8.0 } else { 3.0 }).abs() < 1e-12);
            }
        }
        assert_eq!(whole.cell_fields.iter().filter(|field| field.name == "density").count(), 1);
        assert!(whole.point_fields.iter().all(|field| field.name != "density"));
    }
}

/// Real meshes meet in rows that lattices do not have; here with the guard, too.
#[test]
fn constants_of_the_brackets_regions_stay_with_every_scheme_and_guard() {
    let folder = tempfile::tempdir().unwrap();
    let mut dataset = read(&sample("bracket.msh")).unwrap();
    dataset.cell_fields = vec![density(&dataset.mesh)];
    for scheme in octruss_mesh::Scheme::ALL {
        let options =
            format!("scheme = \"{}\"\njumps = [\"density\"]\nmin-quality = 0.35", scheme.name());
        set_up(folder.path(), &dataset, &options);
        succeed(folder.path(), &["run", "f.toml", "--quiet"]);
        let figures = subdivide(folder.path())["fields"]["sides"]["density"].clone();
        let number = |key: &str| figures[key].as_f64().unwrap();
        assert!((number("minimum") - 3.0).abs() < 1e-12, "{}: {figures}", scheme.name());
        assert!((number("maximum") - 8.0).abs() < 1e-12, "{}: {figures}", scheme.name());
        assert!((number("largest_jump") - 5.0).abs() < 1e-12);
    }
}

#[test]
fn a_second_stage_goes_on_with_the_sides_of_the_first() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = halves();
    let ramp = |tet: &[u32; 4]| tet.iter().map(|&v| mesh.points[v as usize][0]).sum();
    let cell_fields = vec![Field::scalar("ramp", mesh.tets.iter().map(ramp).collect())];
    let dataset = Dataset { mesh, cell_fields, ..Dataset::default() };
    let sides = |options: &str| {
        set_up(folder.path(), &dataset, options);
        succeed(folder.path(), &["run", "f.toml", "--quiet"]);
        std::fs::read(folder.path().join("out/f/solution.sides.vtu")).unwrap()
    };
    let once = sides("levels = 2\njumps = [\"ramp\"]");
    for second in ["", "jumps = [\"ramp\"]"] {
        let options = format!("jumps = [\"ramp\"]\n[[stage]]\nkind = \"subdivide\"\n{second}");
        assert!(sides(&options) == once);
    }
}

#[test]
fn names_of_no_field_or_of_two_are_refused_where_they_stand() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = halves();
    let cell_fields = vec![density(&mesh), Field { name: "both".into(), ..density(&mesh) }];
    let point_fields = vec![at_vertices(&mesh, "both", |p| p[0])];
    let dataset = Dataset { mesh, cell_fields, point_fields, ..Dataset::default() };
    for (options, says) in [
        (
            "jumps = [\"both\", \"densty\"]",
            "f.toml:9:10: stage `subdivide`: both a field on vertices and one on tets are called `both`",
        ),
        (
            "jumps = [\"densty\"]",
            "f.toml:9:10: stage `subdivide`: no field is called `densty`; did you mean `density`? \
             (valid: both, density)",
        ),
    ] {
        set_up(folder.path(), &dataset, options);
        let output = octruss(folder.path(), &["run", "f.toml", "--quiet"]);
        assert_eq!(code(&output), 1);
        assert!(stderr(&output).contains(says), "{}", stderr(&output));
    }
    let bare = Dataset { mesh: halves(), ..Dataset::default() };
    set_up(folder.path(), &bare, "jumps = [\"density\"]");
    let output = octruss(folder.path(), &["run", "f.toml", "--quiet"]);
    let says = "no field is called `density`: the mesh file has no fields";
    assert!(stderr(&output).contains(says), "{}", stderr(&output));
}

#[test]
fn clamping_keeps_an_interpolatory_scheme_from_overshooting_and_is_counted() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = shapes::kuhn_cube(4).into_raw();
    let step = at_vertices(&mesh, "step", |p| f64::from(p[0] > 0.4));
    let dataset = Dataset { mesh, point_fields: vec![step], ..Dataset::default() };
    let run = |options: &str| {
        set_up(folder.path(), &dataset, options);
        let output = octruss(folder.path(), &["run", "f.toml", "--quiet"]);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        let points = read(&folder.path().join("out/f/solution.vtu")).unwrap().mesh.points;
        (subdivide(folder.path()), stderr(&output), points)
    };
    let scheme = "scheme = \"interpolatory\"\nlevels = 2";
    let (free, _, positions) = run(scheme);
    let maximum =
        |report: &Value| report["fields"]["vertices"]["step"]["maximum"].as_f64().unwrap();
    // A tension of 1/16: past the step the first midpoint is 1 + 1/16.
    assert!(maximum(&free) >= 1.0625 - 1e-12);
    assert!(free["fields"]["clamped"].is_null());
    let (clamped, _, same) = run(&format!("{scheme}\nclamp = true"));
    assert_eq!(maximum(&clamped), 1.0);
    assert_eq!(clamped["fields"]["vertices"]["step"]["minimum"], 0.0);
    assert!(clamped["fields"]["clamped"].as_u64().unwrap() > 100);
    assert_eq!(positions, same, "positions are never clamped");

    let (report, told, _) = run("scheme = \"box-spline\"\ninterpolate = false\nclamp = true");
    let note = "no weight of the box-spline scheme is negative: clamp without effect";
    assert_eq!(report["notes"], serde_json::json!([note]));
    assert!(told.contains(note), "{told}");
    assert_eq!(report["fields"]["clamped"], 0);
}

#[test]
fn whole_numbers_become_means_components_stay_together_and_gaps_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = shapes::kuhn_cube(2).into_raw();
    let n = mesh.points.len();
    let numbers = Values::Integer((0..n as i64).collect());
    let vectors = mesh.points.iter().flat_map(|p| [p[0], 2.0 * p[1], -p[2]]).collect();
    let mut gaps = vec![1.0; n];
    gaps[0] = f64::NAN;
    let point_fields = vec![
        Field::new("number", 1, numbers),
        Field::new("velocity", 3, Values::Float(vectors)),
        Field::scalar("gaps", gaps),
    ];
    let tets = Values::Integer((0..mesh.tets.len() as i64).collect());
    let cell_fields = vec![Field::new("part", 1, tets)];
    let dataset = Dataset { mesh, point_fields, cell_fields, ..Dataset::default() };
    set_up(folder.path(), &dataset, "scheme = \"linear\"");
    succeed(folder.path(), &["run", "f.toml", "--quiet"]);
    let report = subdivide(folder.path());
    assert_eq!(
        report["notes"],
        serde_json::json!([
            "the field `number` holds whole numbers; refined, it holds means of them",
            "the field `gaps` is no number at 1 of 27 vertices, and none at new vertices that \
             read these",
        ])
    );
    // Vertex 0 is a corner of the cube on 7 edges.
    assert_eq!(report["fields"]["vertices"]["gaps"]["not_numbers"], 8);
    assert_eq!(report["fields"]["vertices"]["velocity"]["components"], 3);
    let fine = read(&folder.path().join("out/f/solution.vtu")).unwrap();
    let named = |name: &str| fine.point_fields.iter().find(|field| field.name == name).unwrap();
    for (p, v) in fine.mesh.points.iter().zip(floats(named("velocity")).as_chunks::<3>().0) {
        assert_eq!(*v, [p[0], 2.0 * p[1], -p[2]]);
    }
    // Between the vertices 0 and 1.
    assert!(floats(named("number")).contains(&0.5));
    let parts = integers(&fine.cell_fields, "part");
    assert!(!parts.is_empty() && parts == integers(&fine.cell_fields, "input-tet"));
}

#[test]
fn strata_and_features_are_written_to_look_at() {
    let folder = tempfile::tempdir().unwrap();
    let dataset = Dataset { mesh: halves(), ..Dataset::default() };
    set_up(folder.path(), &dataset, "extra-corners = [0]");
    succeed(folder.path(), &["run", "f.toml", "--quiet"]);
    let out = folder.path().join("out/f");
    let coarse = read(&out.join("level-0.vtu")).unwrap();
    let count = |dataset: &Dataset| {
        let field = dataset.point_fields.iter().find(|field| field.name == "stratum").unwrap();
        assert!(field.derived);
        let Values::Integer(dimensions) = &field.values else { panic!("dimensions are whole") };
        [0, 1, 2, 3].map(|d| dimensions.iter().filter(|&&dimension| dimension == d).count())
    };
    // 12 edges of the cube with 3 vertices inside each, and a loop of 16 round the
    // interface; they cross in 4 vertices, which stay, as do the 8 corners. The
    // interface has 9 vertices inside, of 27; the sides 6 · 9 less 3 of the loop
    // on four of them.
    assert_eq!(count(&coarse), [12, 32 + 12, 9 + 54 - 12, 18]);
    let fine = read(&out.join("solution.vtu")).unwrap();
    assert_eq!(count(&fine)[0], 12);
    let strata = &subdivide(folder.path())["strata"];
    assert_eq!(strata["curve_reasons"]["junction"], 16);
    assert_eq!(strata["curve_reasons"]["group-border"], 48);
    assert_eq!(strata["curve_reasons"]["angle"], 0);
    assert_eq!(strata["point_reasons"]["asked-for"], 1);
    assert_eq!(strata["point_reasons"]["curves-meet"], 11);
    let features =
        String::from_utf8_lossy(&std::fs::read(out.join("features.vtu")).unwrap()).into_owned();
    // 12 · 3 + 8 vertices on the cube's edges and 12 more on the loop; as cells 12
    // fixed ones and 48 + 16 edges.
    let piece = "<Piece NumberOfPoints=\"56\" NumberOfCells=\"76\">";
    assert!(features.contains(piece), "{}", &features[..1500]);
    for name in ["junction", "group-border", "asked-for", "curves-meet"] {
        assert!(features.contains(name), "{name}");
    }

    let more = ["run", "f.toml", "--quiet", "--set", "stage.write.features=false", "--out", "none"];
    succeed(folder.path(), &more);
    assert!(!folder.path().join("none/features.vtu").exists());
}

/// Quality and stratum belong to the mesh that they were computed from.
#[test]
fn what_was_computed_from_a_mesh_does_not_outlive_it() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = shapes::kuhn_cube(2).into_raw();
    let point_fields = vec![at_vertices(&mesh, "height", |p| p[2])];
    let dataset = Dataset { mesh, point_fields, ..Dataset::default() };
    set_up(folder.path(), &dataset, "");
    succeed(folder.path(), &["run", "f.toml", "--quiet"]);
    let names = |fields: &[Field]| -> Vec<String> {
        fields.iter().map(|field| field.name.clone()).collect()
    };
    let out = folder.path().join("out/f");
    let written = read(&out.join("solution.vtu")).unwrap();
    assert_eq!(names(&written.point_fields), ["height", "stratum", "input-vertex"]);
    assert_eq!(names(&written.cell_fields), ["quality", "input-tet"]);

    let refine =
        ["refine", "out/f/solution.vtu", "next.vtu", "--scheme", "linear", "--levels", "1"];
    let output = octruss(folder.path(), &refine);
    assert_eq!(code(&output), 0);
    let refined = read(&folder.path().join("next.vtu")).unwrap();
    assert_eq!(names(&refined.point_fields), ["height", "input-vertex"]);
    assert_eq!(names(&refined.cell_fields), ["input-tet"]);
    // Converted, the mesh is the same, and so is what was computed from it.
    succeed(folder.path(), &["convert", "out/f/solution.vtu", "same.vtu"]);
    assert_eq!(read(&folder.path().join("same.vtu")).unwrap(), written);

    // A user's own field of such a name makes room, which is told.
    let quality = Field::scalar("quality", vec![7.0; dataset.mesh.tets.len()]);
    set_up(folder.path(), &Dataset { cell_fields: vec![quality], ..dataset }, "");
    let output = octruss(folder.path(), &["run", "f.toml", "--quiet"]);
    assert!(stderr(&output).contains("the mesh file has a field `quality`, which was left out"));
    let again = read(&out.join("solution.vtu")).unwrap();
    assert!(floats(&again.cell_fields[0]).iter().all(|&eta| eta <= 1.0));
}

/// Two tets with a common face, in two regions; the second is inverted in the
/// file and a node is left over, so that corners and numbers change on the way.
#[test]
fn values_at_the_corners_of_tets_need_not_be_named_to_jump() {
    let folder = tempfile::tempdir().unwrap();
    let msh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n9 7 7 7\n1 0 0 0\n2 1 0 0\n\
        3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n$Elements\n2\n8 4 2 1 1 1 2 3 4\n\
        9 4 2 2 1 2 4 3 5\n$EndElements\n$ElementNodeData\n1\n\"rho\"\n1\n0\n3\n0\n1\n2\n\
        8 4 1 2 3 4\n9 4 20 40 30 50\n$EndElementNodeData\n";
    std::fs::write(folder.path().join("two.msh"), msh).unwrap();
    for jumps in ["", "jumps = [\"rho\"]"] {
        let config = format!(
            "name = \"f\"\n[[stage]]\nkind = \"import\"\npath = \"two.msh\"\n[[stage]]\n\
             kind = \"check\"\nreorient = true\n[[stage]]\nkind = \"subdivide\"\n\
             scheme = \"linear\"\n{jumps}\n[[stage]]\nkind = \"write\"\n"
        );
        std::fs::write(folder.path().join("f.toml"), config).unwrap();
        succeed(folder.path(), &["run", "f.toml", "--quiet"]);
        let figures = &subdivide(folder.path())["fields"]["sides"]["rho"];
        // At the node 4: 40 − 4.
        assert_eq!(figures["largest_jump"], 36.0);
        let apart = read(&folder.path().join("out/f/solution.sides.vtu")).unwrap();
        let rho = floats(&apart.point_fields[0]);
        let mut seen = Vec::new();
        for (tet, &region) in apart.mesh.tets.iter().zip(&apart.mesh.regions) {
            for &v in tet {
                seen.push((
                    region,
                    apart.mesh.points[v as usize].map(|x| x as f32),
                    rho[v as usize],
                ));
            }
        }
        // Nodes, and midpoints of edges: 1–2 of the first tet, 2–4 of either, 4–5 of the second.
        for known in [
            (1, [0.0, 0.0, 0.0], 1.0),
            (1, [0.0, 0.0, 1.0], 4.0),
            (2, [0.0, 0.0, 1.0], 40.0),
            (2, [1.0, 1.0, 1.0], 50.0),
            (1, [0.5, 0.0, 0.0], 1.5),
            (1, [0.5, 0.0, 0.5], 3.0),
            (2, [0.5, 0.0, 0.5], 30.0),
            (2, [0.5, 0.5, 1.0], 45.0),
        ] {
            assert!(seen.contains(&known), "{known:?} among {seen:?}");
        }
    }
    let refine =
        ["refine", "two.msh", "fine.vtu", "--scheme", "linear", "--levels", "1", "--reorient"];
    let refined = octruss(folder.path(), &refine);
    assert_eq!(code(&refined), 0, "{}", stderr(&refined));
    assert!(
        stderr(&refined).contains("the field `rho`, given at the corners of tets, was left out")
    );
    let converted = octruss(folder.path(), &["convert", "two.msh", "two.vtu"]);
    assert!(stderr(&converted).contains("hold no values at the corners of each tet: rho left out"));
    assert!(succeed(folder.path(), &["info", "two.msh"]).contains("rho (1 a corner of a tet)"));
}

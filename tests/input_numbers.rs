//! A run sorts the coarsest mesh; what it writes tells where each part is in the file.

mod common;

use std::path::Path;

use common::{code, integers, octruss, report, sample, stderr, succeed};
use octruss_mesh::shapes;
use octruss_meshio::{Dataset, Field, Values, read, write};

/// The numbers of the vertices and of the tets in the mesh file.
fn numbers(dataset: &Dataset) -> [&[i64]; 2] {
    let Dataset { point_fields, cell_fields, .. } = dataset;
    for field in point_fields.iter().chain(cell_fields) {
        assert_eq!(field.derived, !["x", "own"].contains(&field.name.as_str()), "{}", field.name);
    }
    [integers(point_fields, "input-vertex"), integers(cell_fields, "input-tet")]
}

/// Runs a config of the stages import, check, others and write.
fn run(folder: &Path, mesh: &str, stages: &str) {
    let config = format!(
        "name = \"r\"\n[[stage]]\nkind = \"import\"\npath = \"{mesh}\"\n[[stage]]\n\
         kind = \"check\"\n{stages}\n[[stage]]\nkind = \"write\"\n"
    );
    std::fs::write(folder.join("r.toml"), config).unwrap();
    succeed(folder, &["run", "r.toml", "--quiet"]);
}

#[test]
fn the_numbers_lead_back_to_the_file_where_unused_points_count() {
    let folder = tempfile::tempdir().unwrap();
    let mut input = read(&sample("bracket.msh")).unwrap();
    // Two points that nothing uses: checking drops them.
    let mesh = &mut input.mesh;
    mesh.points.splice(100..100, [[-1.0; 3], [-2.0; 3]]);
    let vertices = mesh.tets.as_flattened_mut().iter_mut();
    let vertices = vertices.chain(mesh.triangles.simplices.as_flattened_mut());
    let vertices = vertices.chain(mesh.edges.simplices.as_flattened_mut());
    let vertices = vertices.chain(mesh.vertices.simplices.as_flattened_mut());
    vertices.filter(|v| **v >= 100).for_each(|v| *v += 2);
    let tets = input.mesh.tets.len();
    input.cell_fields =
        vec![Field::new("own", 1, Values::Integer((0..tets as i64).map(|t| 5 * t).collect()))];
    input.point_fields = vec![Field::scalar("x", input.mesh.points.iter().map(|p| p[0]).collect())];
    write(&folder.path().join("mesh.vtu"), &input).unwrap();
    let stage = "[[stage]]\nkind = \"subdivide\"\nscheme = \"linear\"\nlevels = 2";
    run(folder.path(), "mesh.vtu", stage);

    let out = folder.path().join("out/r");
    let coarse_points = input.mesh.points.len() - 2;
    for (file, children) in [("level-0.vtu", 1), ("level-1.vtu", 8), ("solution.vtu", 64)] {
        let level = read(&out.join(file)).unwrap();
        let [of_vertices, of_tets] = numbers(&level);
        let (old, made) = of_vertices.split_at(coarse_points);
        assert!(made.iter().all(|&number| number == -1));
        let mut all = old.to_vec();
        all.sort_unstable();
        let kept: Vec<i64> =
            (0..old.len() as i64 + 2).filter(|n| ![100, 101].contains(n)).collect();
        assert_eq!(all, kept);
        for (point, &number) in level.mesh.points.iter().zip(old) {
            assert_eq!(*point, input.mesh.points[number as usize]);
        }
        for (tet, &number) in of_tets.iter().enumerate() {
            assert_eq!(number, of_tets[tet / children * children]);
            assert_eq!(level.mesh.regions[tet], input.mesh.regions[number as usize]);
        }
        let mut all: Vec<i64> = of_tets.iter().copied().step_by(children).collect();
        if children == 1 {
            for (tet, &number) in level.mesh.tets.iter().zip(of_tets) {
                let mut found = tet.map(|v| of_vertices[v as usize]);
                let mut given = input.mesh.tets[number as usize].map(i64::from);
                found.sort_unstable();
                given.sort_unstable();
                assert_eq!(found, given);
            }
        }
        all.sort_unstable();
        assert!(all.into_iter().eq(0..tets as i64));
    }
    // The user's own fields went along.
    let fine = read(&out.join("solution.vtu")).unwrap();
    let own = integers(&fine.cell_fields, "own");
    assert!(own.iter().zip(numbers(&fine)[1]).all(|(own, tet)| *own == 5 * tet));
    let Values::Float(x) = &fine.point_fields[0].values else { panic!("floats") };
    assert!(x.iter().zip(&fine.mesh.points).all(|(x, p)| (x - p[0]).abs() < 1e-12));
}

#[test]
fn refining_our_own_file_goes_on_with_the_numbers_of_the_first() {
    let folder = tempfile::tempdir().unwrap();
    let bracket = sample("bracket.msh");
    let refine = |input: &Path, output: &str| {
        let output = folder.path().join(output);
        let arguments = [input, &output].map(|path| path.display().to_string());
        let options = ["--scheme", "linear", "--levels", "1"].map(String::from);
        succeed(folder.path(), &[&["refine".to_string()], &arguments[..], &options[..]].concat());
        output
    };
    let twice = read(&refine(&refine(&bracket, "once.vtu"), "twice.vtu")).unwrap();
    let input = read(&bracket).unwrap();
    let [vertices, tets] = numbers(&twice);
    let file = input.mesh.points.len();
    for (point, &number) in twice.mesh.points.iter().zip(&vertices[..file]) {
        assert_eq!(*point, input.mesh.points[number as usize]);
    }
    assert!(vertices[file..].iter().all(|&number| number == -1));
    assert!(tets.chunks(64).all(|family| family.iter().all(|tet| *tet == family[0])));
    assert_eq!(*tets.iter().max().unwrap(), 3097);

    // A legacy file does not tell that they are derived, nor what is sharp: a new start.
    let legacy = refine(&bracket, "once.vtk");
    let output = octruss(
        folder.path(),
        &["refine", "once.vtk", "again.vtu", "--scheme", "linear", "--levels", "1"],
    );
    assert_eq!(code(&output), 0);
    assert!(stderr(&output).contains("has a field `input-tet`, which was left out"));
    let (again, legacy) = (read(&folder.path().join("again.vtu")).unwrap(), read(&legacy).unwrap());
    for (point, &number) in again.mesh.points.iter().zip(&numbers(&again)[0][..8]) {
        assert_eq!(*point, legacy.mesh.points[number as usize]);
    }
    assert_eq!(*numbers(&again)[1].iter().max().unwrap(), 8 * 3098 - 1);
}

#[test]
fn corners_and_creases_asked_for_are_those_of_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let mut mesh = shapes::kuhn_cube(3).into_raw();
    mesh.triangles = Default::default();
    mesh.groups.clear();
    let vertex = |[i, j, k]: [u32; 3]| 16 * k + 4 * j + i;
    // A corner of the cube, and an edge of it along y.
    let [corner, from, to] = [[3, 0, 3], [0, 0, 0], [0, 1, 0]].map(vertex);
    write(&folder.path().join("cube.vtu"), &Dataset { mesh, ..Dataset::default() }).unwrap();
    let stage = format!(
        "[[stage]]\nkind = \"subdivide\"\ncrease-angle = 180\nmin-quality = \"off\"\n\
         interpolate = false\n\
         extra-corners = [{corner}]\nextra-creases = [[{to}, {from}]]"
    );
    run(folder.path(), "cube.vtu", &stage);
    let strata = &report(&folder.path().join("out/r"))["stages"][2]["strata"];
    assert_eq!(strata["point_reasons"]["asked-for"], 1);
    assert_eq!(strata["curve_reasons"]["asked-for"], 1);
    let fine = read(&folder.path().join("out/r/solution.vtu")).unwrap();
    let has = |wanted: [f64; 3]| fine.mesh.points.contains(&wanted);
    assert!(has([1.0, 0.0, 1.0]), "the corner stays");
    assert!(!has([1.0, 1.0, 1.0]) && !has([0.0, 0.0, 1.0]), "others are rounded");
    // A crease that ends at a dart still has the midpoint of its edge.
    assert!(fine.mesh.points.iter().any(|p| {
        p.iter().zip([0.0, 1.0 / 6.0, 0.0]).all(|(x, middle)| (x - middle).abs() < 1e-14)
    }));
}

#[test]
fn a_mesh_that_is_not_refined_keeps_the_order_of_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let bracket = sample("bracket.msh");
    run(folder.path(), &bracket.display().to_string(), "");
    let written = read(&folder.path().join("out/r/solution.vtu")).unwrap();
    let input = read(&bracket).unwrap().mesh;
    assert!(written.mesh.points == input.points && written.mesh.tets == input.tets);
    assert!(numbers(&written).iter().all(|of| of.iter().copied().eq(0..of.len() as i64)));
}

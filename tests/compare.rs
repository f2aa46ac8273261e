//! `octruss compare`: every variant in one table, in every form.

mod common;

use std::path::Path;

use common::{code, octruss, repository, stderr, succeed};
use serde_json::Value;

/// Compares on two small levels of the torus; what was printed, and the JSON.
fn compare(folder: &Path, more: &[&str]) -> (String, Value) {
    let config = repository("configs/prolongation-study-torus.toml").display().to_string();
    let small = ["compare", &config, "--out", "c", "--set", "compare.levels=[1, 2]"];
    let small = small.iter().chain(&["--set", "compare.repeats=1"]).chain(more);
    let printed = succeed(folder, &small.map(|text| text.to_string()).collect::<Vec<_>>());
    let json = std::fs::read_to_string(folder.join("c/compare.json")).unwrap();
    (printed, serde_json::from_str(&json).unwrap())
}

fn number(row: &Value, key: &str) -> f64 {
    row[key].as_f64().unwrap_or_else(|| panic!("{key} of {row}"))
}

#[test]
fn every_variant_has_its_row() {
    let folder = tempfile::tempdir().unwrap();
    let (printed, json) = compare(folder.path(), &[]);
    let rows = json["rows"].as_array().unwrap();
    // Geometries, levels, sweeps, prolongations, coarse operators.
    assert_eq!(rows.len(), 2 * 2 * 2 * 3 * 2);
    for row in rows {
        assert_eq!((&row["problem"], &row["body"]), (&"elasticity".into(), &"torus".into()));
        assert!(number(row, "iterations") > 3.0 && number(row, "unknowns") > 1000.0);
        assert!(number(row, "operator_complexity") > 1.0 && number(row, "bytes_per_digit") > 1e5);
        assert!(number(row, "setup_seconds") > 0.0 && number(row, "solve_seconds") > 0.0);
        assert!(number(row, "mean_reduction") < 1.0 && number(row, "asymptotic_reduction") < 1.0);
        assert_eq!(row["affine_correction"], "auto");
        let exact = row["prolongation"] == "box-spline" || row["geometry"] == "flat";
        assert_eq!(number(row, "affine_defect") < 1e-8, exact, "{row}");
    }
    let find = |geometry: &str, prolongation: &str| {
        let wanted = [
            ("geometry", geometry),
            ("prolongation", prolongation),
            ("coarse_operator", "galerkin"),
            ("cycle", "V(2,2)"),
        ];
        let found = rows
            .iter()
            .find(|row| row["level"] == 2 && wanted.iter().all(|(key, value)| row[*key] == *value));
        number(found.unwrap(), "iterations")
    };
    assert!(2.0 * find("subdivided", "box-spline") <= find("subdivided", "linear"));
    assert!(find("flat", "box-spline") <= find("flat", "linear"));
    // Chang's test: on the subdivided body the scheme carries the solution far better.
    let carried = json["carried"].as_array().unwrap();
    assert_eq!(carried.len(), 2 * 2 * 2);
    let energy = |prolongation: &str| {
        let found = carried.iter().find(|carried| {
            carried["geometry"] == "subdivided"
                && carried["level"] == 2
                && carried["prolongation"] == prolongation
        });
        number(found.unwrap(), "energy_difference")
    };
    assert!(3.0 * energy("box-spline") < energy("linear"));
    // A verdict for each geometry, printed below the tables.
    let verdict = json["verdict"].as_array().unwrap();
    assert_eq!(verdict.len(), 2);
    assert!(verdict.iter().all(|sentence| printed.contains(sentence.as_str().unwrap())));
    assert!(verdict[1].as_str().unwrap().contains("subdivision prolongation wins"));
}

#[test]
fn rows_name_the_smoother_that_ran() {
    let folder = tempfile::tempdir().unwrap();
    let config = std::fs::read_to_string(repository("configs/prolongation-study-torus.toml"));
    let meshes = repository("examples/meshes").display().to_string();
    let config = config.unwrap().replace("../examples/meshes", &meshes);
    let lines = config.lines().filter(|line| !line.starts_with("smoother"));
    let silent: Vec<&str> = lines.collect();
    std::fs::write(folder.path().join("c.toml"), silent.join("\n")).unwrap();
    let smoothers = |more: &[&str]| -> Vec<String> {
        let few = [
            "compare.levels=[1]",
            "compare.sweeps=[1]",
            "compare.prolongation=[\"box-spline\", \"linear\"]",
            "compare.coarse-operator=[\"galerkin\"]",
        ];
        let set = few.iter().chain(more).flat_map(|set| ["--set", set]);
        let arguments: Vec<&str> =
            ["compare", "c.toml", "--out", "c"].into_iter().chain(set).collect();
        succeed(folder.path(), &arguments);
        let json = std::fs::read_to_string(folder.path().join("c/compare.json")).unwrap();
        let json: Value = serde_json::from_str(&json).unwrap();
        let rows = json["rows"].as_array().unwrap().iter();
        let mut names: Vec<String> =
            rows.map(|row| row["smoother"].as_str().unwrap().into()).collect();
        names.sort();
        names.dedup();
        names
    };
    assert_eq!(smoothers(&[]), ["hybrid-gauss-seidel"]);
    // A degree asks for the polynomial, but not in the place of another smoother.
    let degree = "stage.solve.smoothing-degree=2";
    assert_eq!(smoothers(&[degree]), ["chebyshev-2"]);
    let list = "compare.smoother=[\"gauss-seidel\", \"chebyshev\"]";
    assert_eq!(smoothers(&[degree, list]), ["chebyshev-2", "gauss-seidel"]);
    let list = "compare.smoother=[\"auto\", \"l1-jacobi\"]";
    assert_eq!(smoothers(&[list]), ["hybrid-gauss-seidel", "l1-jacobi"]);
}

#[test]
fn the_same_numbers_come_as_text_csv_json_and_picture() {
    let folder = tempfile::tempdir().unwrap();
    let few = ["--set", "compare.sweeps=[1]", "--set", "compare.coarse-operator=[\"galerkin\"]"];
    let (printed, json) = compare(folder.path(), &few);
    let file = |name: &str| std::fs::read_to_string(folder.path().join("c").join(name)).unwrap();
    assert_eq!(printed, file("compare.txt"));
    let csv = file("compare.csv");
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let names = reader.headers().unwrap().clone();
    let column = |name: &str| names.iter().position(|other| other == name).unwrap();
    let lines: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let rows = json["rows"].as_array().unwrap();
    assert_eq!((lines.len(), rows.len()), (2 * 2 * 3, 2 * 2 * 3));
    for (line, row) in lines.iter().zip(rows) {
        assert_eq!(&line[column("prolongation")], row["prolongation"].as_str().unwrap());
        for key in ["iterations", "mean_reduction", "affine_defect", "setup_seconds"] {
            let (cell, value) = (line[column(key)].parse::<f64>().unwrap(), number(row, key));
            assert!((cell - value).abs() <= 1e-15 * value.abs(), "{key}: {cell} {value}");
        }
        let least = row["solve_spread"][0].as_f64().unwrap();
        let cell = line[column("solve_least")].parse::<f64>().unwrap();
        assert!((cell - least).abs() <= 1e-15 * least);
    }
    let picture = file("compare.svg");
    assert!(picture.starts_with("<svg") && picture.contains("smoothed-linear"));
    assert!(picture.contains("iterations, subdivided"));
}

#[test]
fn what_cannot_be_compared_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = repository("examples/meshes/cube.msh").display().to_string();
    let import = format!("name = \"c\"\n[[stage]]\nkind = \"import\"\npath = \"{mesh}\"\n");
    let check = format!("{import}[[stage]]\nkind = \"check\"\n");
    let refine = format!("{check}[[stage]]\nkind = \"subdivide\"\nlevels = 1\n");
    let solve = "[[stage]]\nkind = \"solve\"\nfixed = [{ surface = \"x0\", value = 0 }]\n";
    let cases = [
        (check.clone(), 2, "c.toml: cannot compare: there is no stage `subdivide`"),
        (refine.clone(), 2, "c.toml: cannot compare: there is no stage `solve` after `subdivide`"),
        (
            format!("{refine}{solve}[compare]\nlevels = [1, 2]\n"),
            2,
            "c.toml:13:1: cannot compare: `compare.levels` names level 2, but stage `subdivide` makes 1",
        ),
        (
            format!("{refine}{solve}[compare]\ngeometry = [\"flatt\"]\n"),
            2,
            "unknown geometry `flatt`; did you mean `flat`?",
        ),
        (format!("{refine}{solve}[compare]\nsweep = [1]\n"), 2, "unknown key `sweep`"),
        (
            format!("{refine}{solve}[compare]\nsweeps = []\n"),
            2,
            "`sweeps`: expected a list of at least one",
        ),
        (
            format!("{refine}{solve}[compare]\nsweeps = [1, 2, 1]\n"),
            2,
            "`sweeps`: entry 3 of the list stands in it before",
        ),
    ];
    for (config, expected, says) in cases {
        std::fs::write(folder.path().join("c.toml"), config).unwrap();
        let run = octruss(folder.path(), &["compare", "c.toml"]);
        assert_eq!(code(&run), expected, "{}", stderr(&run));
        assert!(stderr(&run).contains(says), "{says}:\n{}", stderr(&run));
        assert!(!folder.path().join("out").exists());
    }
}

#[test]
fn variants_that_do_not_converge_have_rows_without_figures() {
    let folder = tempfile::tempdir().unwrap();
    let few = ["--set", "stage.solve.max-iterations=12", "--set", "compare.sweeps=[2]"];
    let (printed, json) = compare(folder.path(), &few);
    let rows = json["rows"].as_array().unwrap();
    let failed: Vec<&Value> = rows.iter().filter(|row| row["iterations"].is_null()).collect();
    assert!(!failed.is_empty() && failed.len() < rows.len());
    for row in failed {
        assert!(row["solve_seconds"].is_null() && row["bytes_per_digit"].is_null());
        assert!(number(row, "mean_reduction") > 0.0);
    }
    assert!(!printed.contains("NaN"));
    let none = ["--set", "stage.solve.max-iterations=1"];
    let (printed, _) = compare(folder.path(), &none);
    assert!(printed.contains("level 2: no variant converged."), "{printed}");
}

#[test]
fn stages_that_write_or_solve_before_the_levels_are_passed_over() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = repository("examples/meshes/cube.msh").display().to_string();
    let solve = "[[stage]]\nkind = \"solve\"\nfixed = [{ surface = \"x0\", value = 0 }]\n";
    let config = format!(
        "name = \"c\"\n[[stage]]\nkind = \"import\"\npath = \"{mesh}\"\n\
         [[stage]]\nkind = \"check\"\n[[stage]]\nkind = \"write\"\n{solve}\
         [[stage]]\nkind = \"subdivide\"\nlevels = 1\n{solve}"
    );
    std::fs::write(folder.path().join("c.toml"), config).unwrap();
    let printed = succeed(folder.path(), &["compare", "c.toml", "--quiet"]);
    // A source of zero has the solution zero, which cannot be carried.
    assert!(printed.contains("subdivided 1") && !printed.contains("carried"), "{printed}");
    let left: Vec<String> = std::fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    assert_eq!(left.len(), 2, "{left:?}");
}

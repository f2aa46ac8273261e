//! Every way of iterating that a config can ask for ends at the same solution, and
//! the report says which way it was.

mod common;

use std::path::Path;

use common::{code, octruss, report, stderr, succeed};
use octruss_meshio::Values;
use serde_json::{Value, json};

/// Linear functions solve both problems without loads, and linear elements hold them
/// exactly.
const FIXED: &str = "1 + 2*x - 3*y + z";

fn solution(at: &[f64; 3]) -> f64 {
    1.0 + 2.0 * at[0] - 3.0 * at[1] + at[2]
}

/// A cube of 48 tets, refined twice, with its solution prescribed all around.
fn write_config(folder: &Path, problem: &str, value: &str) {
    let mesh = octruss_mesh::shapes::kuhn_cube(2).into_raw();
    let dataset = octruss_meshio::Dataset { mesh, ..Default::default() };
    octruss_meshio::write(&folder.join("cube.vtu"), &dataset).unwrap();
    let sides = ["x0", "x1", "y0", "y1", "z0", "z1"];
    let fixed = sides.map(|side| format!("{{ surface = \"{side}\", value = {value} }}"));
    let config = format!(
        "name = \"c\"\n[[stage]]\nkind = \"import\"\npath = \"cube.vtu\"\n[[stage]]\n\
         kind = \"check\"\n[[stage]]\nkind = \"subdivide\"\nlevels = 2\nscheme = \"linear\"\n\
         [[stage]]\nkind = \"solve\"\n{problem}\nprolongation = [\"linear\"]\ntolerance = 1e-10\n\
         max-iterations = 900\nfixed = [{}]\n[[stage]]\nkind = \"write\"\nlevels = false\n",
        fixed.join(", ")
    );
    std::fs::write(folder.join("c.toml"), config).unwrap();
}

fn poisson(folder: &Path) {
    write_config(folder, "", &format!("\"{FIXED}\""));
}

/// Runs with these keys; the report of the solve and the greatest error of the field
/// over all vertices and `components`.
fn solve(folder: &Path, keys: &[(&str, &str)], components: &[f64]) -> (Value, f64) {
    let mut arguments = vec!["run".into(), "c.toml".into(), "--quiet".into()];
    for (key, value) in keys {
        arguments.extend(["--set".into(), format!("stage.solve.{key}={value}")]);
    }
    succeed(folder, &arguments);
    let out = folder.join("out/c");
    let written = octruss_meshio::read(&out.join("solution.vtu")).unwrap();
    let Values::Float(values) = &written.point_fields[0].values else { panic!() };
    assert_eq!(values.len(), 729 * components.len());
    let exact =
        written.mesh.points.iter().flat_map(|at| components.iter().map(|c| c * solution(at)));
    let error = values.iter().zip(exact).map(|(u, exact)| (u - exact).abs()).fold(0.0, f64::max);
    (report(&out)["stages"][3]["solves"][0].clone(), error)
}

const SMOOTHERS: [&str; 5] =
    ["chebyshev", "hybrid-gauss-seidel", "gauss-seidel", "coloured-gauss-seidel", "l1-jacobi"];

#[test]
fn all_combinations_agree_with_the_exact_solution_and_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    poisson(folder.path());
    for smoother in SMOOTHERS {
        for cycle in ["v", "w", "full"] {
            for method in ["cg", "cycle"] {
                for precision in ["single", "double"] {
                    let keys = [
                        ("smoother", smoother),
                        ("cycle", cycle),
                        ("method", method),
                        ("precision", precision),
                    ];
                    let (solve, error) = solve(folder.path(), &keys, &[1.0]);
                    assert!(error < 1e-6, "{keys:?}: {error}");
                    for (key, value) in keys {
                        assert_eq!(solve[key], value, "{keys:?}");
                    }
                    assert_eq!(solve["sweeps"], json!([1, 1]));
                    let degree = if smoother == "chebyshev" { json!(3) } else { Value::Null };
                    assert_eq!(solve["smoothing_degree"], degree, "{keys:?}");
                    let full = cycle == "full";
                    let transfer = if full { json!("quadratic") } else { Value::Null };
                    assert_eq!(solve["full_transfer"], transfer, "{keys:?}");
                    assert_eq!(solve["full_multigrid_residual"].is_f64(), full, "{keys:?}");
                }
            }
        }
    }
}

#[test]
fn nobody_has_to_choose() {
    let folder = tempfile::tempdir().unwrap();
    poisson(folder.path());
    let auto = ["method", "cycle", "smoother", "precision"].map(|key| (key, "auto"));
    let (asked, _) = solve(folder.path(), &auto, &[1.0]);
    let (silent, _) = solve(folder.path(), &[], &[1.0]);
    for solve in [asked, silent] {
        let told = ["method", "cycle", "smoother", "precision"].map(|key| solve[key].clone());
        assert_eq!(told, ["cg", "v", "chebyshev", "single"]);
        assert!(solve["account"].is_null());
    }
    let problem = "problem = \"elasticity\"\nmaterial = { young = 2, poisson = 0.3 }";
    write_config(folder.path(), problem, &format!("[\"{FIXED}\", 0, \"-({FIXED})\"]"));
    for account in ["false", "true"] {
        let (solve, error) = solve(folder.path(), &[("account", account)], &[1.0, 0.0, -1.0]);
        let told = ["method", "cycle", "smoother", "precision"].map(|key| solve[key].clone());
        assert_eq!(told, ["cg", "v", "hybrid-gauss-seidel", "single"]);
        assert!(error < 1e-6 && solve["iterations"].as_u64().unwrap() <= 16, "{solve}");
    }
}

#[test]
fn full_multigrid_carries_prescribed_linear_functions_exactly() {
    let folder = tempfile::tempdir().unwrap();
    poisson(folder.path());
    for transfer in ["auto", "scheme", "linear", "quadratic"] {
        for precision in ["single", "double"] {
            let keys = [("cycle", "full"), ("full-transfer", transfer), ("precision", precision)];
            let (solve, error) = solve(folder.path(), &keys, &[1.0]);
            let after = solve["full_multigrid_residual"].as_f64().unwrap();
            assert!(error < 1e-9 && after < 1e-12, "{keys:?}: {error} {after}");
            assert_eq!(
                (&solve["iterations"], &solve["residual_history"][0]),
                (&json!(0), &json!(after))
            );
            assert_eq!(
                (&solve["mean_reduction"], &solve["work_per_digit"]),
                (&json!(1.0), &json!(0.0))
            );
            let told = if transfer == "auto" { "quadratic" } else { transfer };
            assert_eq!(solve["full_transfer"], told);
        }
    }
}

#[test]
fn smooth_schemes_carry_the_solutions_of_full_multigrid() {
    let folder = tempfile::tempdir().unwrap();
    poisson(folder.path());
    let path = folder.path().join("c.toml");
    let config = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, config.replace("\"linear\"", "\"box-spline\"")).unwrap();
    let (solve, error) = solve(folder.path(), &[("cycle", "full")], &[1.0]);
    assert!(error < 1e-9, "{error}");
    assert_eq!((&solve["full_transfer"], &solve["iterations"]), (&json!("scheme"), &json!(0)));
}

#[test]
fn full_multigrid_starts_near_a_solution_that_is_not_linear() {
    let folder = tempfile::tempdir().unwrap();
    for (problem, value, components) in [
        ("", "\"exp(x)*sin(2*y) + z^2\"", 1),
        (
            "problem = \"elasticity\"\nmaterial = { young = 2, poisson = 0.3 }",
            "[\"exp(x)*sin(2*y)\", \"z^2\", \"x*y\"]",
            3,
        ),
    ] {
        write_config(folder.path(), problem, value);
        let fields = [("v", "cg"), ("full", "cg"), ("full", "cycle")].map(|(cycle, method)| {
            let keys = [("cycle", cycle), ("method", method)];
            let (solve, _) = solve(folder.path(), &keys, &vec![1.0; components]);
            let first = solve["residual_history"][0].as_f64().unwrap();
            assert!(if cycle == "full" { first < 0.1 } else { first == 1.0 }, "{keys:?}: {first}");
            let written = octruss_meshio::read(&folder.path().join("out/c/solution.vtu")).unwrap();
            let Values::Float(values) = written.point_fields[0].values.clone() else { panic!() };
            values
        });
        for other in &fields[1..] {
            let differences = fields[0].iter().zip(other).map(|(u, v)| (u - v).abs());
            assert!(differences.fold(0.0, f64::max) < 1e-8);
        }
    }
}

#[test]
fn uneven_sweeps_make_conjugate_gradients_flexible() {
    let folder = tempfile::tempdir().unwrap();
    poisson(folder.path());
    for smoother in SMOOTHERS {
        for sweeps in [[2, 1], [1, 0], [0, 1]] {
            let list = format!("[{}, {}]", sweeps[0], sweeps[1]);
            let keys = [("smoother", smoother), ("sweeps", &list)];
            let (solve, error) = solve(folder.path(), &keys, &[1.0]);
            assert!(error < 1e-6, "{keys:?}: {error}");
            assert_eq!(
                (&solve["method"], &solve["sweeps"]),
                (&json!("flexible-cg"), &json!(sweeps))
            );
        }
    }
}

#[test]
fn elastic_bodies_take_the_same_keys() {
    let folder = tempfile::tempdir().unwrap();
    let problem = "problem = \"elasticity\"\nmaterial = { young = 2, poisson = 0.3 }";
    let value = format!("[\"{FIXED}\", \"2*({FIXED})\", \"-({FIXED})\"]");
    write_config(folder.path(), problem, &value);
    for smoother in SMOOTHERS {
        for (cycle, method) in [("v", "cg"), ("w", "cycle"), ("full", "cg"), ("full", "cycle")] {
            let keys = [("smoother", smoother), ("cycle", cycle), ("method", method)];
            let (solve, error) = solve(folder.path(), &keys, &[1.0, 2.0, -1.0]);
            assert!(error < 1e-6, "{keys:?}: {error}");
            assert_eq!(solve["smoother"], smoother);
        }
    }
}

#[test]
fn wrong_choices_are_refused_where_they_stand() {
    let folder = tempfile::tempdir().unwrap();
    poisson(folder.path());
    let config = std::fs::read_to_string(folder.path().join("c.toml")).unwrap();
    for (keys, says) in [
        (
            "smoother = \"chebishev\"",
            "13:12: `smoother` in stage `solve`: unknown smoother `chebishev`; did you mean \
             `chebyshev`? (valid: auto, chebyshev, hybrid-gauss-seidel, gauss-seidel, \
             coloured-gauss-seidel, l1-jacobi)",
        ),
        ("cycle = \"f\"", "13:9: `cycle` in stage `solve`: unknown cycle `f`; did you mean `v`?"),
        (
            "method = \"gmres\"",
            "13:10: `method` in stage `solve`: unknown method `gmres` (valid: auto, cg, cycle)",
        ),
        (
            "precision = \"singel\"",
            "13:13: `precision` in stage `solve`: unknown precision `singel`; did you mean `single`?",
        ),
        (
            "smoother = \"l1-jacobi\"\nsmoothing-degree = 2",
            "14:1: stage `solve`: `smoothing-degree` belongs to smoother = \"chebyshev\", but \
             this stage smooths by \"l1-jacobi\"",
        ),
        (
            "full-transfer = \"scheme\"",
            "13:1: stage `solve`: `full-transfer` belongs to cycle = \"full\", but the cycle of \
             this stage is \"v\"",
        ),
        (
            "cycle = \"full\"\nfull-transfer = \"cubic\"",
            "14:17: `full-transfer` in stage `solve`: unknown transfer `cubic` (valid: auto, \
             scheme, linear, quadratic)",
        ),
        ("sweeps = [0, 0]", "13:10: `sweeps` in stage `solve`: expected at least one sweep"),
        (
            "sweeps = [1, 2, 3]",
            "13:10: `sweeps` in stage `solve`: expected a list of two, before and after, found 3",
        ),
        ("sweeps = 300", "13:10: `sweeps` in stage `solve`: found integer `300`, expected a whole"),
        ("account = 1", "13:11: `account` in stage `solve`: found integer `1`, expected true or"),
    ] {
        let spoilt = config.replace("\nprolongation", &format!("{keys}\nprolongation"));
        std::fs::write(folder.path().join("c.toml"), spoilt).unwrap();
        let output = octruss(folder.path(), &["run", "c.toml"]);
        let message = stderr(&output);
        assert_eq!(code(&output), 2, "{message}");
        assert!(message.starts_with(&format!("error: c.toml:{says}")), "{message}");
    }
}

#[test]
fn an_account_adds_up_and_is_printed() {
    let folder = tempfile::tempdir().unwrap();
    poisson(folder.path());
    let set = |value| ["run", "c.toml", "--set", "stage.solve.account=true", "--set", value];
    let printed = succeed(folder.path(), &set("stage.solve.sweeps=[1, 0]"));
    assert!(printed.contains("solve, linear") && printed.contains("of copy"), "{printed}");
    assert!(printed.contains("level 1 prolongation") && printed.contains("copying memory: "));
    let solve = &report(&folder.path().join("out/c"))["stages"][3]["solves"][0];
    let account = &solve["account"];
    // Two smoothed levels; nothing smooths after the correction.
    let names: Vec<&str> = account["kernels"]
        .as_array()
        .unwrap()
        .iter()
        .map(|kernel| kernel["name"].as_str().unwrap())
        .collect();
    let kernels = ["smoothing-before", "residual", "restriction", "prolongation"];
    let expected = [0, 1].map(|level| kernels.map(|kernel| format!("level-{level}-{kernel}")));
    assert_eq!(names, expected.concat());
    let number = |value: &Value| value.as_f64().unwrap();
    let copy = number(&account["copy_bytes_per_second"]);
    for kernel in account["kernels"].as_array().unwrap().iter().chain([&account["cycle"]]) {
        let rate = number(&kernel["bytes"]) / number(&kernel["seconds"]);
        assert!((number(&kernel["bytes_per_second"]) / rate - 1.0).abs() < 1e-9);
        assert!((number(&kernel["copy_fraction"]) * copy / rate - 1.0).abs() < 1e-9);
    }
    // The residual on the finest level, 7³ unknowns: rows of 4 bytes and one more,
    // each entry a number of 4 bytes and a column of 4, and three vectors.
    let nonzeros = solve["nonzeros"].as_u64().unwrap();
    let residual = &account["kernels"][1]["bytes"];
    assert_eq!(*residual, json!(4 * 344 + 8 * nonzeros + 3 * 4 * 343));
    let named = "expect={ \"solve.linear.account.level-0-residual.bytes\" = { min = 1 } }";
    succeed(folder.path(), &set(named));
}

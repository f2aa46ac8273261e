//! The guard of quality as a user meets it: on unless it is switched off.

mod common;

use common::{octruss, report, stderr, succeed};

/// Two tets that the smooth box splines flatten; see `bad_input.rs`.
const FLATTENING: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 4 0 0\n\
    3 0 4 0\n4 0 0 4\n5 -2 -6 -4\n$EndNodes\n$Elements\n2\n1 4 2 1 1 1 2 3 4\n\
    2 4 2 1 1 3 1 4 5\n$EndElements\n";

fn config(more: &str) -> String {
    format!(
        "name = \"c\"\n[[stage]]\nkind = \"import\"\npath = \"mesh.msh\"\n[[stage]]\n\
        kind = \"check\"\n[[stage]]\nkind = \"subdivide\"\nlevels = 3\ncrease-angle = 180\n{more}"
    )
}

#[test]
fn no_level_falls_below_half_of_the_worst_tet_of_the_input() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("mesh.msh"), FLATTENING).unwrap();
    for scheme in ["box-spline", "averaged", "loop-solid", "interpolatory"] {
        let text = config(&format!("scheme = \"{scheme}\"\n"));
        std::fs::write(folder.path().join("c.toml"), text).unwrap();
        let output = octruss(folder.path(), &["run", "c.toml"]);
        assert!(output.status.success(), "{}", stderr(&output));
        let levels = report(&folder.path().join("out/c"))["stages"][2]["levels"].clone();
        let floor = 0.5 * levels[0]["eta_min"].as_f64().unwrap();
        let mut pulled_back = 0;
        for level in 1..=3 {
            assert_eq!(levels[level]["guard"]["floor"].as_f64().unwrap(), floor);
            assert!(levels[level]["eta_min"].as_f64().unwrap() >= floor * (1.0 - 1e-8));
            pulled_back += levels[level]["guard"]["pulled_back"].as_u64().unwrap();
        }
        assert!(pulled_back > 0, "{scheme}");
        assert!(stderr(&output).contains("vertices pulled back to keep η above"));
    }
}

#[test]
fn the_floor_is_that_of_the_first_mesh_also_when_refining_goes_on_from_a_file() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("mesh.msh"), FLATTENING).unwrap();
    let refine = |input: &str, output: &str, levels: &str| {
        let options = ["--scheme", "box-spline", "--crease-angle", "180", "--levels", levels];
        succeed(folder.path(), &[&["refine", input, output], &options[..]].concat());
        std::fs::read(folder.path().join(output)).unwrap()
    };
    refine("mesh.msh", "once.vtu", "1");
    assert!(refine("once.vtu", "twice.vtu", "1") == refine("mesh.msh", "both.vtu", "2"));
}

#[test]
fn off_switches_the_guard_off_and_linear_needs_none() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("mesh.msh"), FLATTENING).unwrap();
    for more in ["scheme = \"interpolatory\"\nmin-quality = \"off\"\n", "scheme = \"linear\"\n"] {
        std::fs::write(folder.path().join("c.toml"), config(more)).unwrap();
        let levels = "stage.subdivide.levels=1";
        succeed(folder.path(), &["run", "c.toml", "--quiet", "--set", levels]);
        let levels = report(&folder.path().join("out/c"))["stages"][2]["levels"].clone();
        assert!(levels[1]["tets"] == 16 && levels[1]["guard"].is_null());
    }
}

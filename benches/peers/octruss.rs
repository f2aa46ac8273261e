//! Our side of the comparison that `solvers.py` beside this file makes.
//!
//! ```text
//! octruss-peer write MESH PROBLEM LEVELS FOLDER    a system and its prolongations, as NumPy's files
//! octruss-peer solve FOLDER PROLONGATION           reads and solves it; prints a line of JSON
//! ```
//!
//! MESH is a mesh file or `cube:N`, N³ cells of six tets each; PROBLEM is `poisson` or
//! `elasticity`; PROLONGATION is `linear` or `box-spline`. With 0 LEVELS there is nothing to prolong
//! between, and the matrix is all that is written.

mod arrays;
mod memory;
mod solve_system;
mod system_files;
mod write_system;

use anyhow::{Result, bail};

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        ["write", mesh, problem, levels, folder] => {
            write_system::write(mesh, problem, levels.parse()?, folder.as_ref())
        }
        ["solve", folder, prolongation] => {
            println!("{}", solve_system::solve(folder.as_ref(), prolongation)?);
            Ok(())
        }
        _ => bail!("expected `write MESH PROBLEM LEVELS FOLDER` or `solve FOLDER PROLONGATION`"),
    }
}

// Only Linux tells the peak of memory.
#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    /// The cube has 7³ free vertices inside, or all of 9³ but the 9² clamped ones.
    #[test]
    fn both_prolongations_solve_what_was_written() {
        let folder = tempfile::tempdir().unwrap();
        for (problem, unknowns) in [("poisson", 7 * 7 * 7), ("elasticity", 8 * 9 * 9 * 3)] {
            write_system::write("cube:2", problem, 2, folder.path()).unwrap();
            let solved = ["linear", "box-spline"]
                .map(|prolongation| solve_system::solve(folder.path(), prolongation).unwrap());
            for solved in &solved {
                assert_eq!(solved["unknowns"], unknowns);
                assert!(solved["relative_residual"].as_f64().unwrap() <= 1e-8);
            }
            let [linear, box_spline] = solved.map(|s| s["solution_norm"].as_f64().unwrap());
            assert!((linear - box_spline).abs() < 1e-6 * linear, "{linear} {box_spline}");
        }
    }
}

//! What the files of a stage `write` are called.

use std::path::Path;

use octruss_meshio::vtu;

/// The finest mesh with every field.
pub(super) const SOLUTION: &str = "solution.vtu";
/// The finest mesh taken apart where regions meet.
pub(super) const SIDES: &str = "solution.sides.vtu";
/// The curves and fixed points of the coarsest level.
pub(super) const FEATURES: &str = "features.vtu";
/// The list of the levels' files.
pub(super) const LEVELS: &str = "levels.pvd";

/// The file of a level, 0 the coarsest.
pub(super) fn of_level(number: usize) -> String {
    format!("level-{number}.vtu")
}

/// Whether the stage gives this name to a file besides [`SOLUTION`], which it always
/// writes.
pub(super) fn is_own(name: &str) -> bool {
    let number = name.strip_prefix("level-").and_then(|rest| rest.strip_suffix(".vtu"));
    // As it is written: without sign or leading zeros.
    let is_level = |number: &str| number.parse().is_ok_and(|n| of_level(n) == name);
    let is_surfaces = vtu::surfaces_path(Path::new(SOLUTION)) == Path::new(name);
    is_surfaces || [SIDES, FEATURES, LEVELS].contains(&name) || number.is_some_and(is_level)
}

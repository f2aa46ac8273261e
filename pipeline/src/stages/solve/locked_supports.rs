//! Remarks on surfaces to slide along whose shape, as refined, locks what should slide.

use octruss_fem::{Elasticity, Error, Ridge, curved_supports, ridges};
use octruss_mesh::{Hierarchy, Level, Scheme};

/// Remarks on curved surfaces that are held along their normals: where linear refinement left
/// facets flat, and where smooth refinement kept a ridge between two groups.
pub(super) fn locked_supports(
    problem: &Elasticity,
    hierarchy: &Hierarchy,
) -> Result<Vec<String>, Error> {
    let mut notes = Vec::new();
    if hierarchy.refinements().any(|made| made.scheme != Scheme::Linear) {
        let Level { mesh, topology, .. } = hierarchy.coarsest();
        for Ridge { surfaces, degrees } in ridges(mesh, topology, &problem.supports)? {
            let [one, other] = surfaces.map(|surface| mesh.raw().group_name(2, surface));
            notes.push(format!(
                "the surfaces `{one}` and `{other}`, both held along their normals, meet at a bend \
                 of {degrees:.0}°, which refining keeps as a ridge that locks what should slide \
                 past it; unless it is meant, leave `group-borders` of the stage `subdivide` at \
                 \"flat\" or give `group-borders = false`, and keep no curve group or lesser \
                 `crease-angle` there"
            ));
        }
    }
    if hierarchy.refinements().any(|made| made.scheme == Scheme::Linear) {
        let Level { mesh, topology, .. } = hierarchy.finest();
        for surface in curved_supports(mesh, topology, &problem.supports)? {
            let name = mesh.raw().group_name(2, surface);
            notes.push(format!(
                "the surface `{name}`, held along its normals, is curved, and refined by the \
                 scheme `linear` its facets stay flat: what should slide round it is locked; \
                 refine by `box-spline` or another smooth scheme, or mesh it finer instead"
            ));
        }
    }
    Ok(notes)
}

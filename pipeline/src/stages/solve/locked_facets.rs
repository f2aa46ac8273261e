//! A remark on curved surfaces to slide along that were refined flat.

use octruss_fem::{Elasticity, Error, curved_supports};
use octruss_mesh::{Hierarchy, Scheme};

/// Remarks on surfaces that are held along their normals and curved, but whose facets linear
/// refinement left flat.
pub(super) fn locked_facets(
    problem: &Elasticity,
    hierarchy: &Hierarchy,
) -> Result<Vec<String>, Error> {
    if hierarchy.refinements().all(|made| made.scheme != Scheme::Linear) {
        return Ok(Vec::new());
    }
    let finest = hierarchy.finest();
    let curved = curved_supports(&finest.mesh, &finest.topology, &problem.supports)?;
    let remark = |surface: &i32| {
        let name = finest.mesh.raw().group_name(2, *surface);
        format!(
            "the surface `{name}`, held along its normals, is curved, and refined by the scheme \
             `linear` its facets stay flat: what should slide round it is locked; refine by \
             `box-spline` or another smooth scheme, or mesh it finer instead"
        )
    };
    Ok(curved.iter().map(remark).collect())
}

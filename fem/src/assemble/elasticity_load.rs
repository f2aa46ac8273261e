//! What acts on an elastic body from outside: body forces, gravity, tractions,
//! pressures, and springs.

use crate::assemble::blame;
use crate::assemble::foundation::Foundation;
use crate::assemble::load::{add_at, tet_load, triangle_load};
use crate::assemble::scatter::{Scatter, Sums};
use crate::boundary::surface::{
    OutwardTriangle, check_attached, outward_triangles, tet_of, triangles_of,
};
use crate::element::p1::triangle_area;
use crate::error::Error;
use crate::problem::elasticity::{Elasticity, Stiffness, Vector};
use crate::problem::scalar::{Scalar, values_at};
use octruss_base::vector3::{IDENTITY, Vector3, add, dot3, length, outer, scale};
use octruss_mesh::{TetMesh, Topology};
use std::slice::from_ref;

/// The force on each vertex: ∫ (f + ρ g) φ + ∫ (t − p n) φ.
pub(crate) fn load_vector(
    mesh: &TetMesh,
    topology: &Topology,
    problem: &Elasticity,
) -> Result<Vec<Vector3>, Error> {
    problem.body_force.check(mesh)?;
    let mut load = volume_load(mesh, problem);
    for (surface, traction) in &problem.traction {
        check_attached(mesh, topology, *surface)?;
        for triangle in triangles_of(mesh, *surface) {
            let corners = triangle.map(|v| mesh.points()[v as usize]);
            let at = |p| values_at(traction, p);
            add_at(&mut load, triangle, triangle_load(corners, all_constant(traction), at));
        }
    }
    for (surface, pressure) in &problem.pressure {
        for OutwardTriangle { vertices, double_area } in
            outward_triangles(mesh, topology, *surface)?
        {
            let corners = vertices.map(|v| mesh.points()[v as usize]);
            let inward = scale(-1.0 / length(double_area), double_area);
            let at = |p| scale(pressure.at(p), inward);
            add_at(&mut load, vertices, triangle_load(corners, pressure.is_constant(), at));
        }
    }
    Ok(load)
}

fn volume_load(mesh: &TetMesh, problem: &Elasticity) -> Vec<Vector3> {
    let is_zero = |vector: &Vector| vector.iter().all(Scalar::is_zero);
    let massless = problem.material.all(|material| material.density.is_zero());
    let weightless = massless || is_zero(&problem.gravity);
    if problem.body_force.all(is_zero) && weightless {
        return vec![[0.0; 3]; mesh.points().len()];
    }
    let scatter = Scatter::new(mesh.tets(), mesh.points().len());
    let sums = scatter.sum(|tet| {
        let region = mesh.regions()[tet];
        let (force, density) =
            (problem.body_force.of(region), &problem.material.of(region).density);
        let is_constant = all_constant(force)
            && (weightless || (density.is_constant() && all_constant(&problem.gravity)));
        let at = |p| {
            let force = values_at(force, p);
            if weightless {
                return force;
            }
            let (density, gravity) = (density.at(p), values_at(&problem.gravity, p));
            std::array::from_fn(|k| force[k] + density * gravity[k])
        };
        tet_load(mesh.corners(tet), is_constant, at)
    });
    sums.in_order()
}

fn all_constant(vector: &Vector) -> bool {
    vector.iter().all(Scalar::is_constant)
}

/// Which load is not finite.
pub(crate) fn blame_load(mesh: &TetMesh, problem: &Elasticity) -> Result<(), Error> {
    blame::in_tets(mesh, "body force", |region| problem.body_force.of(region))?;
    blame::in_tets(mesh, "gravity", |_| &problem.gravity)?;
    blame::in_tets(mesh, "density", |region| from_ref(&problem.material.of(region).density))?;
    for (surface, traction) in &problem.traction {
        blame::on_surface(mesh, "traction", *surface, traction)?;
    }
    for (surface, pressure) in &problem.pressure {
        blame::on_surface(mesh, "pressure", *surface, from_ref(pressure))?;
    }
    Ok(())
}

/// Adds ∫ K φa φb to the couplings; returns the row sums ∫ K φa.
pub(crate) fn add_springs(
    mesh: &TetMesh,
    topology: &Topology,
    problem: &Elasticity,
    couplings: &mut Sums<9>,
) -> Result<Vec<[f64; 9]>, Error> {
    let mut foundation = Foundation::new(topology, couplings);
    for_springs(mesh, topology, problem, |_, triangle, corners, stiffness| {
        foundation.add(triangle, corners, |p| {
            let mut block = [0.0; 9];
            for (direction, k) in stiffness(p) {
                let tied = outer(scale(k, direction), direction);
                (0..9).for_each(|entry| block[entry] += tied[entry / 3][entry % 3]);
            }
            block
        });
    })?;
    Ok(foundation.into_row_sums())
}

/// Adds the forces of springs on vertices with these displacements.
pub(crate) fn add_spring_forces(
    mesh: &TetMesh,
    topology: &Topology,
    problem: &Elasticity,
    displacement: &[Vector3],
    load: &mut [Vector3],
) -> Result<(), Error> {
    for_springs(mesh, topology, problem, |_, triangle, corners, stiffness| {
        // The same rule as in the matrix: half of what acts at the midpoint of an edge
        // goes to each end.
        let share = triangle_area(corners) / 3.0;
        for (a, b) in [(0, 1), (0, 2), (1, 2)] {
            let middle = scale(0.5, add(corners[a], corners[b]));
            let [u_a, u_b] = [a, b].map(|v| displacement[triangle[v] as usize]);
            let force = spring_force(stiffness(middle), share, scale(0.5, add(u_a, u_b)));
            for vertex in [a, b] {
                let at = &mut load[triangle[vertex] as usize];
                *at = add(*at, scale(0.5, force));
            }
        }
    })
}

/// The force on what springs with these directions and stiffnesses hold over an area that
/// has moved so far.
pub(crate) fn spring_force(springs: [(Vector3, f64); 3], area: f64, moved: Vector3) -> Vector3 {
    springs
        .into_iter()
        .fold([0.0; 3], |sum, (along, k)| add(sum, scale(-area * k * dot3(along, moved), along)))
}

/// Where springs hold in which direction: a tet of the triangle, the position and
/// the direction.
pub(crate) fn spring_directions(
    mesh: &TetMesh,
    topology: &Topology,
    problem: &Elasticity,
) -> Result<Vec<(u32, Vector3, Vector3)>, Error> {
    let mut all = Vec::new();
    for_springs(mesh, topology, problem, |_, triangle, corners, stiffness| {
        let tet = tet_of(topology, triangle);
        for (a, b) in [(0, 1), (0, 2), (1, 2)] {
            let middle = std::array::from_fn(|k| 0.5 * (corners[a][k] + corners[b][k]));
            let tied = stiffness(middle).into_iter().filter(|(_, k)| *k > 0.0);
            all.extend(tied.map(|(direction, _)| (tet, middle, direction)));
        }
    })?;
    Ok(all)
}

/// Calls `each` with every triangle that has springs: the number of the entry in
/// the problem, the triangle, its corners, and a function that gives directions
/// and their stiffnesses at a position.
pub(crate) fn for_springs(
    mesh: &TetMesh,
    topology: &Topology,
    problem: &Elasticity,
    mut each: impl FnMut(usize, [u32; 3], [Vector3; 3], &dyn Fn(Vector3) -> [(Vector3, f64); 3]),
) -> Result<(), Error> {
    let points = |triangle: [u32; 3]| triangle.map(|v| mesh.points()[v as usize]);
    for (index, (surface, stiffness)) in problem.springs.iter().enumerate() {
        match stiffness {
            Stiffness::Axes(axes) => {
                check_attached(mesh, topology, *surface)?;
                check_stiffness(mesh, *surface, stiffness)?;
                for triangle in triangles_of(mesh, *surface) {
                    each(index, triangle, points(triangle), &|p| {
                        std::array::from_fn(|k| (IDENTITY[k], axes[k].at(p)))
                    });
                }
            }
            Stiffness::Normal(normal) => {
                let triangles = outward_triangles(mesh, topology, *surface)?;
                check_stiffness(mesh, *surface, stiffness)?;
                for triangle in triangles {
                    let size = length(triangle.double_area);
                    let direction = scale(1.0 / size, triangle.double_area);
                    each(index, triangle.vertices, points(triangle.vertices), &|p| {
                        [(direction, normal.at(p)), ([0.0; 3], 0.0), ([0.0; 3], 0.0)]
                    });
                }
            }
        }
    }
    Ok(())
}

fn check_stiffness(mesh: &TetMesh, surface: i32, stiffness: &Stiffness) -> Result<(), Error> {
    let scalars = match stiffness {
        Stiffness::Axes(axes) => axes.as_slice(),
        Stiffness::Normal(normal) => from_ref(normal),
    };
    for triangle in triangles_of(mesh, surface) {
        let corners = triangle.map(|v| mesh.points()[v as usize]);
        for (a, b) in [(0, 1), (0, 2), (1, 2)] {
            let middle = std::array::from_fn(|k| 0.5 * (corners[a][k] + corners[b][k]));
            let is_bad = |k: &&Scalar| !(k.at(middle) >= 0.0 && k.at(middle).is_finite());
            if let Some(bad) = scalars.iter().find(is_bad) {
                let (what, told) = ("stiffness of springs", bad.told_at(middle));
                return Err(Error::SurfaceCoefficient {
                    what,
                    surface,
                    told,
                    expected: "0 or more",
                });
            }
        }
    }
    Ok(())
}

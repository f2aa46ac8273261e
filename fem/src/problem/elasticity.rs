//! What is to be solved: small displacements of an elastic body.

use crate::problem::by_region::ByRegion;
use crate::problem::free::Free;
use crate::problem::scalar::Scalar;

/// A vector for each position: its components.
pub type Vector = [Scalar; 3];

/// −div σ(u) = f with σ = λ tr(ε) I + 2 μ ε and ε = (∇u + ∇uᵀ) / 2: linear,
/// isotropic elasticity, in whatever units fit together (N, mm, MPa and t, or
/// SI).
///
/// Surfaces are named by the tags of the mesh's triangles. Where nothing is
/// given, a surface is free of traction. Loads and springs on one surface add
/// up.
#[derive(Debug, Clone)]
pub struct Elasticity {
    /// The material of each region, its numbers taken at the centroid of each tet.
    pub material: ByRegion<Material>,
    /// Force per unit of volume.
    pub body_force: ByRegion<Vector>,
    /// Acceleration; times density it is a force per unit of volume.
    pub gravity: Vector,
    /// Force per unit of area on surfaces.
    pub traction: Vec<(i32, Vector)>,
    /// Force per unit of area against the outward normal of boundary surfaces:
    /// positive pushes into the body.
    pub pressure: Vec<(i32, Scalar)>,
    /// Elastic foundations of surfaces.
    pub springs: Vec<(i32, Stiffness)>,
    /// What is held. Where a vertex is held in one direction twice, the last
    /// listed wins.
    pub supports: Vec<Support>,
    /// What becomes of parts that can move without deforming.
    pub free: Free,
}

/// An isotropic material.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Young's modulus E > 0.
    pub young: Scalar,
    /// Poisson's ratio ν, above −1 and below 1/2. Linear tets lock, that is, come
    /// out too stiff, as it nears 1/2: from 0.45 on on a coarse mesh.
    pub poisson: Scalar,
    /// Mass per unit of volume, at least 0; only gravity and the inertia of free bodies ask
    /// for it.
    pub density: Scalar,
}

/// Force per unit of area and of displacement, against it.
#[derive(Debug, Clone)]
pub enum Stiffness {
    /// Along the coordinate axes.
    Axes(Vector),
    /// Along the outward normal of each triangle alone.
    Normal(Scalar),
}

/// A surface whose displacement is prescribed, wholly or in part.
#[derive(Debug, Clone)]
pub struct Support {
    /// The tag of its triangles.
    pub surface: i32,
    /// Which part of the displacement, and its value.
    pub held: Held,
}

/// What a support prescribes of the displacement.
#[derive(Debug, Clone)]
pub enum Held {
    /// Components along the coordinate axes; `None` is free.
    Components([Option<Scalar>; 3]),
    /// The component along the outward normal: 0 for a plane of symmetry, or to
    /// slide. All surfaces held so are one: a vertex takes the mean normal, by
    /// area, of all their triangles round it, whatever groups and supports these
    /// belong to; of these the last listed gives the value. Triangles whose
    /// normals are more than 40° apart hold it each for themselves, unless others
    /// between them tie them. The surface must be on the boundary.
    Normal(Scalar),
}

impl Held {
    /// The whole displacement is `value`.
    pub fn displacement(value: [f64; 3]) -> Self {
        Self::Components(value.map(|component| Some(component.into())))
    }
}

impl Material {
    /// A material of the same numbers everywhere, without mass.
    pub fn new(young: f64, poisson: f64) -> Self {
        Self { young: young.into(), poisson: poisson.into(), density: 0.0.into() }
    }
}

impl Elasticity {
    /// A body of one material, with no load and nothing held.
    pub fn new(material: impl Into<ByRegion<Material>>) -> Self {
        Self {
            material: material.into(),
            body_force: zero_vector().into(),
            gravity: zero_vector(),
            traction: Vec::new(),
            pressure: Vec::new(),
            springs: Vec::new(),
            supports: Vec::new(),
            free: Free::Refuse,
        }
    }
}

/// A vector of numbers.
pub fn vector(value: [f64; 3]) -> Vector {
    value.map(Scalar::from)
}

fn zero_vector() -> Vector {
    vector([0.0; 3])
}

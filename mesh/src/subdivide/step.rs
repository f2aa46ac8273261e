//! What one subdivision step is to do.

use crate::core::curve_ends::CurveEnds;
use crate::core::tet_mesh::TetMesh;
use crate::scheme::Scheme;

/// A scheme for the vertices, a diagonal for the tets, and perhaps a guard.
///
/// Scheme and diagonal are chosen apart: the weights of a scheme depend on the
/// coarse mesh alone, and the diagonals change only how the fine vertices are
/// joined. A scheme on its own is a step that inherits its diagonals, without
/// a guard.
///
/// ```
/// use octruss_mesh::{Diagonal, FeatureOptions, Hierarchy, Scheme, Step, shapes};
/// let mut levels = Hierarchy::new(shapes::five_tet_cube(), &FeatureOptions::default());
/// levels.subdivide(Scheme::LOOP_SOLID)?;
/// let diagonal = Diagonal::ShortestEachLevel;
/// levels.subdivide(Step { diagonal, ..Scheme::LOOP_SOLID.into() })?;
/// assert_eq!(levels.finest().mesh.tets().len(), 5 * 64);
/// # Ok::<(), octruss_mesh::SubdivideError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// The weights.
    pub scheme: Scheme,
    /// The connectivity.
    pub diagonal: Diagonal,
    /// Keep η above this by pulling rows back to the linear rule; `None` for
    /// no guard. A tet whose parent is below keeps the parent's quality.
    pub min_quality: Option<f64>,
    /// Whether the limit surface is to pass through the boundary vertices of the mesh
    /// that is refined first. They stay, and new ones go towards the limit of control
    /// points that are solved for; see [`crate::ControlPoints`]. Schemes that keep
    /// vertices do so anyway, and are as without.
    pub interpolate: bool,
    /// Whether vertices of curves and surfaces are put onto the limit of further steps. What
    /// these need is kept as [`crate::ControlPoints`]: a step that interpolates goes on
    /// with the same surface. Schemes that keep vertices are as without.
    pub project_limit: bool,
    /// The rule at the ends of curves; `None` for parabolas where the step interpolates,
    /// fixed ends elsewhere.
    pub curve_ends: Option<CurveEnds>,
}

impl Step {
    /// Whether new boundary vertices come from control points that are solved for.
    pub(crate) fn solves_for_control_points(&self) -> bool {
        self.interpolate && !self.scheme.keeps_vertices()
    }

    /// Whether boundary vertices are put onto the limit.
    pub(crate) fn projects(&self) -> bool {
        self.project_limit && !self.scheme.keeps_vertices()
    }

    /// Whether some weights may be negative, so that values may leave the range of their
    /// stencil: those of some schemes, of parabolas, and of rows made exact for points on
    /// a surface that was not theirs.
    pub fn overshoots(&self) -> bool {
        let keeps = self.scheme.keeps_vertices();
        let changes = self.interpolate
            || self.project_limit
            || self.resolved_curve_ends() == CurveEnds::Parabola;
        self.scheme.overshoots() || (!keeps && changes)
    }

    /// The rule at the ends of curves on a mesh: that of its control points, where the step
    /// goes on with these; else chosen or implied.
    pub fn curve_ends_on(&self, mesh: &TetMesh) -> CurveEnds {
        let recorded = mesh.features().and_then(|features| features.control_points.as_ref());
        let goes_on = recorded.filter(|_| self.solves_for_control_points() || self.projects());
        goes_on.map_or_else(|| self.resolved_curve_ends(), |points| points.curve_ends)
    }

    /// The rule at the ends of curves, chosen or implied.
    pub fn resolved_curve_ends(&self) -> CurveEnds {
        self.curve_ends.unwrap_or(match self.interpolate {
            true => CurveEnds::Parabola,
            false => CurveEnds::Fixed,
        })
    }
}

/// Which inner diagonal splits a tet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Diagonal {
    /// That of the marked pair, as handed on from the parent: keeps the regular
    /// lattice inside each initial tet.
    #[default]
    Inherit,
    /// The shortest one at every level, as in Wang's thesis; ties keep the
    /// marked pair, as does a guard whose floor its descendants would break.
    ///
    /// The parts of a tet then form no octet truss, so the averaged scheme takes
    /// each tet of the next level for a tetrahedral cell.
    ShortestEachLevel,
}

impl Diagonal {
    /// Every choice.
    pub const ALL: [Self; 2] = [Self::Inherit, Self::ShortestEachLevel];

    /// The name by which configurations and the command line call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Inherit => "inherit",
            Self::ShortestEachLevel => "shortest-each-level",
        }
    }
}

impl From<Scheme> for Step {
    fn from(scheme: Scheme) -> Self {
        Self {
            scheme,
            diagonal: Diagonal::Inherit,
            min_quality: None,
            interpolate: false,
            project_limit: false,
            curve_ends: None,
        }
    }
}

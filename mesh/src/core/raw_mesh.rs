//! A mesh as a file holds it: plain data, nothing checked.

use crate::core::control_points::ControlPoints;
use crate::core::reference_tet::CellState;

/// Points, tets and tagged simplices as a file states them, unchecked.
///
/// Indices may be out of range, tets inverted, coordinates not finite;
/// [`crate::check()`] finds out and turns a sound mesh into a
/// [`crate::TetMesh`].
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RawMesh {
    /// Vertex positions, in mesh units.
    pub points: Vec<[f64; 3]>,
    /// Four vertex numbers a tet. Positive orientation means
    /// det(x1 − x0, x2 − x0, x3 − x0) > 0; the order also says which pair of
    /// opposite edges is marked, see [`crate::reference_tet`].
    pub tets: Vec<[u32; 4]>,
    /// The region of each tet: the id of a three-dimensional [`Group`], or 0
    /// for none. As many as tets.
    pub regions: Vec<i32>,
    /// Triangles that belong to surface groups; faces of tets or standing free.
    pub triangles: Tagged<3>,
    /// Edges that belong to curve groups; edges of tets or standing free.
    pub edges: Tagged<2>,
    /// Vertices that belong to point groups.
    pub vertices: Tagged<1>,
    /// The names of regions, surfaces, curves and points.
    pub groups: Vec<Group>,
    /// Creases and corners if they were found on a coarser mesh already (then
    /// the order of the tets' vertices is a marking, too); `None` for a mesh
    /// from elsewhere.
    pub features: Option<Features>,
}

/// Simplices of one dimension with a group id each.
///
/// A simplex that belongs to two groups is listed twice, once for each. Id 0
/// means "no group" and need not be listed.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Tagged<const N: usize> {
    /// Vertex numbers; for triangles their order is the file's orientation.
    pub simplices: Vec<[u32; N]>,
    /// The group id of each simplex.
    pub tags: Vec<i32>,
}

/// A named group of simplices of one dimension (a Gmsh "physical group").
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Group {
    /// 0 points, 1 curves, 2 surfaces, 3 regions.
    pub dimension: u8,
    /// The number by which simplices refer to the group; unique in its dimension.
    pub id: i32,
    /// The name; unnamed groups need no entry, their name is their id in digits.
    pub name: String,
}

/// What subdivision keeps sharp, and how good the mesh was before: found once on
/// the coarsest mesh and inherited.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Features {
    /// Every edge of the curve stratum, ends ascending, sorted, no duplicates.
    pub creases: Vec<[u32; 2]>,
    /// Every fixed vertex besides those where three or more creases meet; sorted.
    pub corners: Vec<u32>,
    /// Surface groups whose triangles are surface strata even inside a region; sorted.
    pub surfaces: Vec<i32>,
    /// Surface groups that are mirror planes: what ends there goes on as if reflected;
    /// sorted. See [`crate::Mirrors`].
    pub mirrors: Vec<i32>,
    /// The smallest mean ratio η of the coarsest mesh, from which the floor of
    /// the guard derives; see [`crate::subdivide::guard::usual_floor`].
    pub initial_quality: Option<f64>,
    /// What each tet is in the octet truss; empty if all are tetrahedral cells,
    /// as on a mesh that was never refined.
    pub cell_states: Vec<CellState>,
    /// Whether a step of an approximating scheme has moved vertices that were to be
    /// interpolated, had they been: passing through them now would keep what it took away.
    pub smoothed: bool,
    /// What the smooth surface through the vertices of the mesh that was refined first
    /// is the limit of; `None` if none was asked for.
    pub control_points: Option<ControlPoints>,
}

impl<const N: usize> Tagged<N> {
    /// How many simplices are listed.
    pub fn len(&self) -> usize {
        self.simplices.len()
    }

    /// Whether none is listed.
    pub fn is_empty(&self) -> bool {
        self.simplices.is_empty()
    }

    /// Adds one simplex to the group `tag`.
    pub fn push(&mut self, simplex: [u32; N], tag: i32) {
        self.simplices.push(simplex);
        self.tags.push(tag);
    }

    /// The simplices with their tags, in order.
    pub fn iter(&self) -> impl Iterator<Item = ([u32; N], i32)> {
        self.simplices.iter().copied().zip(self.tags.iter().copied())
    }

    /// The ids in use, ascending, each once, without 0.
    pub fn ids(&self) -> Vec<i32> {
        distinct_ids(&self.tags)
    }
}

impl RawMesh {
    /// The ids in use in one dimension (3 regions … 0 points), ascending, without 0.
    pub fn ids(&self, dimension: u8) -> Vec<i32> {
        match dimension {
            0 => self.vertices.ids(),
            1 => self.edges.ids(),
            2 => self.triangles.ids(),
            _ => distinct_ids(&self.regions),
        }
    }

    /// The name of a group, or its id in digits when it has none.
    pub fn group_name(&self, dimension: u8, id: i32) -> String {
        self.groups
            .iter()
            .find(|group| group.dimension == dimension && group.id == id)
            .map_or_else(|| id.to_string(), |group| group.name.clone())
    }

    /// The ids of the groups called `name` in one dimension; empty if there is
    /// none. An id in digits finds an unnamed group that is in use.
    ///
    /// ```
    /// use octruss_mesh::{Group, RawMesh};
    /// let mut mesh = RawMesh::default();
    /// mesh.groups.push(Group { dimension: 2, id: 7, name: "inlet".into() });
    /// mesh.triangles.push([0, 1, 2], 9);
    /// assert_eq!(mesh.group_ids(2, "inlet"), [7]);
    /// assert_eq!(mesh.group_ids(2, "9"), [9]);
    /// assert!(mesh.group_ids(2, "outlet").is_empty());
    /// ```
    pub fn group_ids(&self, dimension: u8, name: &str) -> Vec<i32> {
        let mut ids: Vec<i32> = self
            .groups
            .iter()
            .filter(|group| group.dimension == dimension && group.name == name)
            .map(|group| group.id)
            .collect();
        if ids.is_empty()
            && let Ok(id) = name.parse::<i32>()
            && self.ids(dimension).contains(&id)
        {
            ids.push(id);
        }
        ids.sort_unstable();
        ids
    }

    /// The names one can ask for in one dimension: of every group that is
    /// named or in use, by ascending id.
    pub fn group_names(&self, dimension: u8) -> Vec<String> {
        let mut ids = self.ids(dimension);
        ids.extend(self.groups.iter().filter(|g| g.dimension == dimension).map(|g| g.id));
        ids.sort_unstable();
        ids.dedup();
        ids.into_iter().map(|id| self.group_name(dimension, id)).collect()
    }
}

fn distinct_ids(tags: &[i32]) -> Vec<i32> {
    let mut ids = Vec::new();
    let mut last = 0;
    for &tag in tags {
        if tag != last {
            ids.push(tag);
            last = tag;
        }
    }
    ids.sort_unstable();
    ids.dedup();
    ids.retain(|&id| id != 0);
    ids
}

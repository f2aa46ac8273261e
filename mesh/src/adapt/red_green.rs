//! Red-green refinement: what was split for the sake of neighbours is never split again.
//!
//! Parts of a tet that was bisected or quartered are *green*, as are their copies on finer
//! levels. Before a green tet would be split, the split that made it is undone and its
//! whole is split into eight instead (Chang's thesis, section 6.4.2, which has patterns
//! for one edge and for the three of a face; two edges, and three not in a face, are
//! bisected here as everywhere). So only children of red splits are ever split, and the
//! number of different shapes stays bounded.
//!
//! The levels above the undone split are made anew. They keep the vertices that they had,
//! but under other numbers; so edges are remembered by names that last: a vertex of the
//! first local level is called by its number, a midpoint by the names of its ends.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::adapt::closure::closed;
use crate::adapt::marked_edges::MarkedEdges;
use crate::adapt::split::split_marked;
use crate::core::reference_tet::CHILDREN;
use crate::core::topology::{Topology, ascending};
use crate::hierarchy::{Hierarchy, Level};
use crate::refinement::ancestry::SplitEdges;
use crate::subdivide::error::SubdivideError;
use crate::subdivide::step::Diagonal;

impl Hierarchy {
    /// As [`Hierarchy::split_marked`], but no part of a tet that was bisected or quartered
    /// is split further: its whole is split into eight in its place, on the level where
    /// it was split, and the levels from there on are made anew. The shapes of tets are
    /// then those of red splits and of one bisection or quartering of these, however many
    /// rounds there are. A mark on such a part is met by that.
    ///
    /// Uniform steps are not undone; the parts that they made count as red. Returns the
    /// first level that is new: what is known of levels from there on has to be carried
    /// down again.
    ///
    /// ```
    /// use octruss_mesh::{Diagonal, FeatureOptions, Hierarchy, MarkedEdges, shapes};
    /// let mut levels = Hierarchy::new(shapes::regular_tet(), &FeatureOptions::default());
    /// for first_new in [1, 1] {
    ///     let mut marks = MarkedEdges::new(&levels.finest().topology);
    ///     marks.mark_edges([0]);
    ///     assert_eq!(levels.split_red_green(&marks, Diagonal::Inherit)?, first_new);
    /// }
    /// // A half of the tet was marked: now it is split into eight.
    /// assert_eq!(levels.levels()[1].mesh.tets().len(), 8);
    /// # Ok::<(), octruss_mesh::SubdivideError>(())
    /// ```
    ///
    /// # Errors
    /// As [`split_marked`]; the hierarchy then stays as it was.
    ///
    /// # Panics
    /// If the marks are not those of the finest level.
    pub fn split_red_green(
        &mut self,
        marks: &MarkedEdges,
        diagonal: Diagonal,
    ) -> Result<usize, SubdivideError> {
        let mut local = LocalLevels::new(self);
        local.want(marks);
        let first = local.build(diagonal)?;
        let new = local.levels.split_off(first - local.first);
        self.replace_from(first, new);
        Ok(first)
    }
}

/// The ends of an edge by their names, ascending.
type Edge = [u32; 2];

/// The levels after the last uniform step, and where each is to be split.
struct LocalLevels {
    /// The number of the first of them.
    first: usize,
    levels: Vec<Arc<Level>>,
    /// The names of each level's vertices.
    names: Vec<Vec<u32>>,
    /// The name of each midpoint that there ever was, by that of its edge.
    midpoints: BTreeMap<Edge, u32>,
    /// The edges that are to be split on each level.
    wanted: Vec<BTreeSet<Edge>>,
}

impl LocalLevels {
    fn new(hierarchy: &Hierarchy) -> Self {
        let is_uniform = |&transfer: &usize| hierarchy.refinement(transfer).ancestry.is_uniform();
        let uniform = (0..hierarchy.transfers()).rev().find(is_uniform);
        let first = uniform.map_or(0, |transfer| transfer + 1);
        let levels = hierarchy.levels()[first..].to_vec();
        let names = (0..levels[0].topology.vertex_count() as u32).collect();
        let mut local = Self {
            first,
            levels,
            names: vec![names],
            midpoints: BTreeMap::new(),
            wanted: Vec::new(),
        };
        for level in 0..local.levels.len() - 1 {
            let split = local.split_edges(level + 1);
            local.wanted.push(split.into_iter().collect());
            local.name_vertices(level + 1);
        }
        local
    }

    /// Wants edges of the finest level split.
    fn want(&mut self, marks: &MarkedEdges) {
        let finest = self.levels.len() - 1;
        let topology = &self.levels[finest].topology;
        assert_eq!(marks.as_list().len(), topology.edges().len(), "the marks of the finest level");
        let edges = marks.edges().map(|edge| self.name(finest, topology.edges()[edge as usize]));
        self.wanted.push(edges.collect());
    }

    fn name(&self, level: usize, ends: [u32; 2]) -> Edge {
        ascending(ends.map(|end| self.names[level][end as usize]))
    }

    /// The edges of the level below that were split to make this one.
    fn split_edges(&self, level: usize) -> Vec<Edge> {
        let refinement = self.levels[level].refinement.as_ref().expect("it was made");
        let below = &self.levels[level - 1].topology;
        let SplitEdges::Some(edges) = &refinement.ancestry.split_edges else {
            unreachable!("levels after the last uniform step");
        };
        edges.iter().map(|&edge| self.name(level - 1, below.edges()[edge as usize])).collect()
    }

    /// Names the vertices of a level after those of the level below.
    fn name_vertices(&mut self, level: usize) {
        let mut names = self.names[level - 1].clone();
        for edge in self.split_edges(level) {
            let next = (self.names[0].len() + self.midpoints.len()) as u32;
            names.push(*self.midpoints.entry(edge).or_insert(next));
        }
        self.names.truncate(level);
        self.names.push(names);
    }

    /// Makes every level that is to change, and the one that is finer than all; the
    /// number of the first of them.
    fn build(&mut self, diagonal: Diagonal) -> Result<usize, SubdivideError> {
        let mut level = self.wanted.len() - 1;
        let mut lowest = level;
        while level < self.wanted.len() {
            let marks = self.marks(level);
            let undone = self.undone(level, &marks);
            if let Some(below) = undone.iter().map(|&(below, _)| below).min() {
                for (below, tet) in undone {
                    let edges = self.levels[below].topology.tet_edges()[tet as usize];
                    let ends = edges.map(|edge| self.levels[below].topology.edges()[edge as usize]);
                    let edges = ends.map(|ends| self.name(below, ends));
                    self.wanted[below].extend(edges);
                }
                level = below;
                lowest = lowest.min(level);
                continue;
            }
            let Level { mesh, topology, .. } = &*self.levels[level];
            let made = split_marked(mesh, topology, &marks, diagonal, self.first + level + 1)?;
            level += 1;
            // Levels above stay as they are until they are made anew in their turn.
            match self.levels.get_mut(level) {
                Some(old) => *old = Arc::new(made.into()),
                None => self.levels.push(Arc::new(made.into())),
            }
            self.name_vertices(level);
        }
        Ok(self.first + lowest + 1)
    }

    /// What is wanted of a level, closed; edges that went with what was undone are met.
    fn marks(&self, level: usize) -> MarkedEdges {
        let topology = &self.levels[level].topology;
        let wanted = &self.wanted[level];
        let mut marks = MarkedEdges::new(topology);
        let edges = (0u32..).zip(topology.edges());
        let is_wanted = |ends: &[u32; 2]| wanted.contains(&self.name(level, *ends));
        marks.mark_edges(edges.filter(|(_, ends)| is_wanted(ends)).map(|(edge, _)| edge));
        closed(topology, &marks)
    }

    /// The splits that made the green tets which these marks would split: level and whole.
    fn undone(&self, level: usize, marks: &MarkedEdges) -> BTreeSet<(usize, u32)> {
        let topology: &Topology = &self.levels[level].topology;
        let tets = (0u32..).zip(topology.tet_edges());
        let touched = tets.filter(|(_, edges)| edges.iter().any(|&edge| marks.contains(edge)));
        touched.filter_map(|(tet, _)| self.green_whole(level, tet)).collect()
    }

    /// The bisected or quartered tet that a green one is a part of, with its level.
    fn green_whole(&self, level: usize, mut tet: u32) -> Option<(usize, u32)> {
        for below in (0..level).rev() {
            let refinement = self.levels[below + 1].refinement.as_ref()?;
            tet = refinement.parent(tet);
            match refinement.children(tet).len() {
                1 => {}
                parts if parts == CHILDREN.len() => return None,
                _ => return Some((below, tet)),
            }
        }
        None
    }
}

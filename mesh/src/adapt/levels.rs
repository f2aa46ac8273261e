//! Local levels of a hierarchy.

use std::sync::Arc;

use crate::adapt::marked_edges::MarkedEdges;
use crate::adapt::split::split_marked;
use crate::hierarchy::{Hierarchy, Level};
use crate::subdivide::error::SubdivideError;
use crate::subdivide::step::Diagonal;

impl Hierarchy {
    /// Adds a level that is finer where edges of the finest level are marked, and what
    /// it takes to leave no hanging node.
    ///
    /// ```
    /// use octruss_mesh::{Diagonal, FeatureOptions, Hierarchy, MarkedEdges, Scheme, shapes};
    /// let mut levels = Hierarchy::new(shapes::kuhn_cube(2), &FeatureOptions::default());
    /// levels.subdivide(Scheme::BoxSpline)?;
    /// let mut marks = MarkedEdges::new(&levels.finest().topology);
    /// marks.mark_tets(&levels.finest().topology, [0]);
    /// levels.split_marked(&marks, Diagonal::Inherit)?;
    /// assert_eq!(levels.refinement(1).children(0), 0..8);
    /// assert!(levels.finest().mesh.tets().len() < 48 * 8 + 50);
    /// # Ok::<(), octruss_mesh::SubdivideError>(())
    /// ```
    ///
    /// # Errors
    /// As [`split_marked`]; the hierarchy then stays as it was.
    ///
    /// # Panics
    /// If the marks are not those of the finest level.
    pub fn split_marked(
        &mut self,
        marks: &MarkedEdges,
        diagonal: Diagonal,
    ) -> Result<(), SubdivideError> {
        let Level { mesh, topology, .. } = self.finest();
        let made = split_marked(mesh, topology, marks, diagonal, self.levels().len())?;
        self.replace_from(self.levels().len(), [Arc::new(made.into())]);
        Ok(())
    }
}

//! Which weights a subdivision step uses: one rule table by dimension.

/// A subdivision scheme: everything that changes the shape, as one value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scheme {
    /// Midpoints: the shape stays, the tets get smaller.
    Linear,
    /// The box-spline scheme of Chang's thesis, chapter 4: C² in the regular
    /// interior, Loop's scheme with Warren's weights on surfaces, cubic
    /// B-splines on curves.
    BoxSpline,
}

/// The weights of one rule; `own` + `each` × neighbours (for an edge 2 `own` +
/// `each` × neighbours) is one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mask {
    /// The weight of the vertex itself, or of each end of the edge.
    pub own: f64,
    /// The weight of each neighbour in the stratum; 0 if none is read.
    pub each: f64,
}

impl Mask {
    const FIXED: Self = Self { own: 1.0, each: 0.0 };
    const MIDPOINT: Self = Self { own: 0.5, each: 0.0 };
}

impl Scheme {
    /// The name by which configurations and the command line call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::BoxSpline => "box-spline",
        }
    }

    /// The rule of a vertex in a stratum of this dimension (0 to 3) with this
    /// many neighbours there.
    ///
    /// Box spline: solid 9/16 and 7/(16 m) (thesis 4.24, any valence m);
    /// surface Loop–Warren, each 3/(8 n), or 3/16 for n = 3; curve 3/4 and 1/8;
    /// point fixed.
    pub fn vertex_mask(self, dimension: u8, neighbours: usize) -> Mask {
        let n = neighbours as f64;
        match (self, dimension) {
            (Self::Linear, _) | (_, 0) => Mask::FIXED,
            (Self::BoxSpline, 1) => Mask { own: 0.75, each: 0.125 },
            // A surface needs three neighbours round a vertex.
            (Self::BoxSpline, 2) if neighbours < 3 => Mask::FIXED,
            (Self::BoxSpline, 2) => {
                let each = if neighbours == 3 { 3.0 / 16.0 } else { 3.0 / (8.0 * n) };
                Mask { own: 1.0 - n * each, each }
            }
            (Self::BoxSpline, _) => Mask { own: 9.0 / 16.0, each: 7.0 / (16.0 * n) },
        }
    }

    /// The rule of an edge in a stratum of this dimension (1 to 3) with this
    /// many neighbours there: opposite vertices on a surface, link vertices in
    /// the solid.
    ///
    /// Box spline: solid 1/4 and 1/8 round an edge of four tets (thesis 4.26),
    /// else 5/16 and 3/(8 k) (4.25); surface 3/8 and 1/8; curve the midpoint.
    pub fn edge_mask(self, dimension: u8, neighbours: usize) -> Mask {
        match (self, dimension) {
            (Self::Linear, _) | (_, 0 | 1) => Mask::MIDPOINT,
            (Self::BoxSpline, 2) => Mask { own: 3.0 / 8.0, each: 1.0 / 8.0 },
            (Self::BoxSpline, _) if neighbours == 4 => Mask { own: 1.0 / 4.0, each: 1.0 / 8.0 },
            (Self::BoxSpline, _) => Mask { own: 5.0 / 16.0, each: 3.0 / (8.0 * neighbours as f64) },
        }
    }
}

//! The limit at a vertex: position, tangents and normal by masks, the left
//! eigenvectors of the rules about it, one sector of its surface at a time.

use std::f64::consts::{PI, TAU};

use octruss_base::vector3::{Vector3, add, cross, dot3, length, scale, subtract};

use super::fan::{Fan, FanRule, middle, sum};
use crate::subdivide::rules::surface::limit_own_weight;

/// The limit surface at a vertex, as seen from one sector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CornerLimit {
    /// In mesh units.
    pub position: Vector3,
    /// Two vectors along the surface, counter-clockwise as the sector's
    /// triangles are. Their lengths are those of the masks.
    pub tangents: [Vector3; 2],
    /// The unit normal, tangents and normal right-handed; `None` where the
    /// surface has none: at cusps, and where tangents are parallel.
    pub normal: Option<Vector3>,
}

/// Products of tangents smaller than this part of their lengths are zero.
const PARALLEL: f64 = 1e-10;
/// sin(2π/6) = √3/2.
const SINE_OF_A_SIXTH: f64 = 0.866_025_403_784_438_6;
/// Steps of an iteration for eigenvectors without closed form, at most.
const STEPS: usize = 1_000;

impl CornerLimit {
    /// At the centre of a fan.
    pub(super) fn new(fan: &Fan, centre: Vector3) -> Self {
        let ring = &fan.points[..];
        let (first, last) = (ring[0], ring[ring.len() - 1]);
        match fan.rule {
            FanRule::Smooth if fan.closed => {
                let mut limit = Self::smooth(ring.iter().map(|&p| subtract(p, centre)), ring.len());
                limit.position = add(centre, limit.position);
                limit
            }
            FanRule::Smooth => dart(fan, centre),
            FanRule::Curve(ends) => {
                let position = add(scale(2.0 / 3.0, centre), scale(1.0 / 6.0, sum(&ends)));
                if !fan.closed && (ends == [first, last] || ends == [last, first]) {
                    Self::with(position, crease_tangents(ring, centre))
                } else {
                    // The curve leaves the surface here: it is a cusp or a kink.
                    Self { normal: None, ..Self::with(position, smooth_tangents(ring)) }
                }
            }
            FanRule::Fixed if fan.closed => {
                // All edges shrink by 5/8 along one direction: the tip of a cone.
                Self { normal: None, ..Self::with(centre, smooth_tangents(ring)) }
            }
            FanRule::Fixed => Self::with(centre, corner_tangents(ring, centre)),
        }
    }

    /// At a smooth vertex with a ring of n neighbours, given as differences from
    /// it, as the position is: ½ and 1/(2 n), or for n = 3 neighbours 2/5 and
    /// 1/5 (Loop's rule with Warren's weights). The tangents are eigenvectors of
    /// 3/8 + ¼ cos(2π/n), whatever the vertex weighs.
    #[inline]
    pub(super) fn smooth(ring: impl Iterator<Item = Vector3>, n: usize) -> Self {
        let [sum, cosine, sine] = waves(ring, n);
        let share = n as f64 / (limit_own_weight(n) + n as f64);
        Self::with(scale(share / n as f64, sum), [cosine, sine])
    }

    /// Looks from the other side.
    pub(super) fn reverse(&mut self) {
        self.tangents[1] = self.tangents[1].map(|x| -x);
        self.normal = self.normal.map(|normal| normal.map(|x| -x));
    }

    fn with(position: Vector3, tangents: [Vector3; 2]) -> Self {
        Self { position, tangents, normal: unit_normal(tangents) }
    }
}

/// The direction of t0 × t1, unless they are parallel.
pub(super) fn unit_normal(tangents: [Vector3; 2]) -> Option<Vector3> {
    let product = cross(tangents[0], tangents[1]);
    let size = length(product);
    let is_clear = size > PARALLEL * length(tangents[0]) * length(tangents[1]);
    is_clear.then(|| scale(1.0 / size, product))
}

/// Σ x_j, Σ cos(2πj/n) x_j and Σ sin(2πj/n) x_j.
#[inline]
fn waves(ring: impl Iterator<Item = Vector3>, n: usize) -> [Vector3; 3] {
    let (sine, cosine) = match n {
        6 => (SINE_OF_A_SIXTH, 0.5),
        n => (TAU / n as f64).sin_cos(),
    };
    let mut turn = [1.0, 1.0, 0.0];
    let mut sums = [[0.0; 3]; 3];
    for point in ring {
        for (sum, factor) in sums.iter_mut().zip(turn) {
            *sum = add(*sum, scale(factor, point));
        }
        turn = [1.0, cosine * turn[1] - sine * turn[2], sine * turn[1] + cosine * turn[2]];
    }
    sums
}

fn smooth_tangents(ring: &[Vector3]) -> [Vector3; 2] {
    let [_, cosine, sine] = waves(ring.iter().copied(), ring.len());
    [cosine, sine]
}

/// Along the curve, and across it into the sector of k triangles: for k > 1 the
/// eigenvector of 3/8 + ¼ cos(π/k), with sin(πj/k) inside.
///
/// For one triangle the curve itself bends into it: across is its second
/// difference, of eigenvalue ¼.
fn crease_tangents(ring: &[Vector3], centre: Vector3) -> [Vector3; 2] {
    let k = ring.len() - 1;
    let (first, last) = (ring[0], ring[k]);
    let along = subtract(first, last);
    let both = add(subtract(first, centre), subtract(last, centre));
    if k == 1 {
        return [along, both];
    }
    let angle = PI / k as f64;
    let cotangent = 1.0 / (0.5 * angle).tan();
    let on_curve = (angle.sin() - cotangent) / (1.0 + 2.0 * angle.cos());
    [along, add(across(ring, centre), scale(on_curve, both))]
}

/// Σ sin(πj/k) (x_j − x) over the neighbours inside a sector.
fn across(ring: &[Vector3], centre: Vector3) -> Vector3 {
    let angle = PI / (ring.len() - 1) as f64;
    let inner = ring.iter().enumerate().take(ring.len() - 1).skip(1);
    inner.fold([0.0; 3], |sum, (j, &point)| {
        add(sum, scale((angle * j as f64).sin(), subtract(point, centre)))
    })
}

/// The ends of the two curves, which make a plane of eigenvalue ½, turned so
/// that the sector lies between them; where they are parallel, one of them and
/// the direction across.
fn corner_tangents(ring: &[Vector3], centre: Vector3) -> [Vector3; 2] {
    let spokes: Vec<Vector3> = ring.iter().map(|&p| subtract(p, centre)).collect();
    let ends = [spokes[0], spokes[spokes.len() - 1]];
    if unit_normal(ends).is_none() {
        return [ends[0], across(ring, centre)];
    }
    let area = spokes.windows(2).fold([0.0; 3], |sum, w| add(sum, cross(w[0], w[1])));
    // Beyond half a turn the ends are clockwise of each other.
    if dot3(area, cross(ends[0], ends[1])) < 0.0 { [ends[1], ends[0]] } else { ends }
}

/// Where a crease runs out: its own direction, and across it the eigenvector of
/// 3/8 + ¼ cos(2π/n), n the valence; the position and the direction of the
/// crease have no closed form and are iterated.
fn dart(fan: &Fan, centre: Vector3) -> CornerLimit {
    let n = fan.points.len() - 1;
    let turn = TAU / n as f64;
    let mut odd = [0.0; 3];
    for (j, &point) in fan.points[..n].iter().enumerate() {
        odd = add(odd, scale((turn * j as f64).sin(), point));
    }
    let mut fan = fan.clone();
    fan.shift(centre);
    // Only what is alike on both sides acts on the vertex and the crease.
    let points = fan.points.clone();
    (0..=n).for_each(|j| fan.points[j] = middle(points[j], points[n - j]));
    let (mut position, mut size) = (centre, 1.0);
    let mut direction = [0.0; 3];
    for _ in 0..STEPS {
        let moved = fan.moved([0.0; 3]);
        fan = fan.refined([0.0; 3]);
        fan.shift(moved);
        position = add(position, scale(size, moved));
        // Edges halve, or nearly: doubled, they stay in range.
        fan.points.iter_mut().for_each(|p| *p = scale(2.0, *p));
        size *= 0.5;
        let next = unit(fan.points[0]);
        let change = length(subtract(next, direction));
        direction = next;
        if change < 1e-16 && size < 1e-20 {
            break;
        }
    }
    CornerLimit::with(position, [scale(length(odd), direction), odd])
}

fn unit(a: Vector3) -> Vector3 {
    let size = length(a);
    if size > 0.0 { scale(1.0 / size, a) } else { a }
}

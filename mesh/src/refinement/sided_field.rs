//! Fields that jump where regions meet: one value for each side of a vertex.
//!
//! A side is a pair of a vertex and a region that touches it. Vertices inside a
//! region have one side, those of an interface one for each region. A row of a
//! subdivision matrix is used once for each side of its vertex and reads the
//! same side everywhere: rows of the solid read their own region only, rows of
//! an interface read vertices that both regions touch, and so do those of curves
//! and points as long as the curve runs along the interface.
//!
//! A curve that pierces an interface, or a free-standing simplex, may bring a
//! vertex into a row that the side's region does not touch. There the field is
//! continued as a constant: in place of the missing value stands that of the
//! row's own vertex, or the mean of the edge's ends. Weights stay, so that a
//! constant stays a constant and no value leaves the range of its side.

use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use rayon::prelude::*;

use crate::core::raw_mesh::RawMesh;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::Topology;
use crate::refinement::ancestry::Ancestor;
use crate::refinement::carry::{Carried, Overshoot, clamp};
use crate::refinement::refinement::Refinement;
use octruss_base::chunks::map_ranges;
use octruss_base::large_array::filled;
use octruss_base::ragged::CHUNK;

/// The sides of a mesh's vertices, ordered by vertex, then by region.
///
/// A vertex that no tet uses has none.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sides {
    /// Where the sides of each vertex start; one more than vertices.
    offsets: Vec<u32>,
    vertices: Vec<u32>,
    regions: Vec<i32>,
}

impl Sides {
    /// Lists the sides of all vertices.
    pub fn new(mesh: &TetMesh) -> Self {
        let (first, mut more) = Self::some_and_others(mesh);
        // Few are left: vertices of interfaces.
        more.par_sort_unstable();
        more.dedup();
        let mut sides = Self { offsets: vec![0], vertices: Vec::new(), regions: Vec::new() };
        let mut rest = more.as_slice();
        for (v, region) in (0u32..).zip(first) {
            let (others, behind) = rest.split_at(rest.partition_point(|more| more.0 == v));
            rest = behind;
            let start = sides.regions.len();
            sides.regions.extend(region);
            sides.regions.extend(others.iter().map(|other| other.1));
            sides.regions[start..].sort_unstable();
            sides.vertices.resize(sides.regions.len(), v);
            sides.offsets.push(sides.regions.len() as u32);
        }
        sides
    }

    /// Some region of each vertex, and the others with their vertices, perhaps more
    /// than once. Which is the one depends on who comes first, all together do not.
    fn some_and_others(mesh: &TetMesh) -> (Vec<Option<i32>>, Vec<(u32, i32)>) {
        const FREE: u64 = u64::MAX;
        let code = |region: i32| u64::from(region.cast_unsigned());
        let some: Vec<_> = mesh.points().iter().map(|_| AtomicU64::new(FREE)).collect();
        let others = map_ranges(mesh.tets().len(), |tets| {
            let mut others = Vec::new();
            for (tet, &region) in mesh.tets()[tets.clone()].iter().zip(&mesh.regions()[tets]) {
                for &v in tet {
                    let slot = &some[v as usize];
                    // A plain load spares most of the costly exchanges.
                    let mut found = slot.load(Relaxed);
                    if found == FREE {
                        let taken = slot.compare_exchange(FREE, code(region), Relaxed, Relaxed);
                        found = taken.err().unwrap_or(code(region));
                    }
                    if found != code(region) {
                        others.push((v, region));
                    }
                }
            }
            others
        });
        let region = |code: AtomicU64| u32::try_from(code.into_inner()).ok().map(u32::cast_signed);
        (some.into_iter().map(region).collect(), others.concat())
    }

    /// How many sides there are.
    pub fn len(&self) -> usize {
        self.vertices.len()
    }

    /// Whether there are none, as on a mesh without tets.
    pub fn is_empty(&self) -> bool {
        self.vertices.is_empty()
    }

    /// The vertex of each side, ascending.
    pub fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    /// The region of each side.
    pub fn regions(&self) -> &[i32] {
        &self.regions
    }

    /// The numbers of the sides of a vertex, by ascending region.
    pub fn of(&self, vertex: u32) -> Range<usize> {
        self.offsets[vertex as usize] as usize..self.offsets[vertex as usize + 1] as usize
    }

    /// The number of the side of a vertex in a region, if that touches it.
    pub fn find(&self, vertex: u32, region: i32) -> Option<usize> {
        self.of(vertex).find(|&side| self.regions[side] == region)
    }

    /// The mesh with one vertex a side, so that regions no longer hang together:
    /// the same tets and region names, without other groups and features.
    pub fn split_mesh(&self, mesh: &TetMesh) -> RawMesh {
        let point = |&v: &u32| mesh.points()[v as usize];
        let tet = |(tet, &region): (&[u32; 4], &i32)| {
            tet.map(|v| self.find(v, region).expect("a tet's region touches its vertices") as u32)
        };
        RawMesh {
            points: self.vertices.iter().map(point).collect(),
            tets: mesh.tets().iter().zip(mesh.regions()).map(tet).collect(),
            regions: mesh.regions().to_vec(),
            groups: mesh.groups().iter().filter(|group| group.dimension == 3).cloned().collect(),
            ..RawMesh::default()
        }
    }

    /// A field of one tuple a vertex as one of equal sides.
    pub fn from_vertices(&self, values: &[f64], components: usize) -> Vec<f64> {
        let tuple = |&v: &u32| &values[components * v as usize..][..components];
        self.vertices.iter().flat_map(tuple).copied().collect()
    }

    /// A field of one tuple a tet as one of sides: on each the mean of the
    /// region's tets at the vertex, weighted by their volumes.
    pub fn from_tets(&self, mesh: &TetMesh, values: &[f64], components: usize) -> Vec<f64> {
        self.means(mesh, components, |tet, _| &values[components * tet..][..components])
    }

    /// A field of four tuples a tet, one a corner, as one of sides: on each the
    /// mean over the region's tets at the vertex, weighted by their volumes.
    pub fn from_corners(&self, mesh: &TetMesh, values: &[f64], components: usize) -> Vec<f64> {
        let tuple = |tet, corner| &values[components * (4 * tet + corner)..][..components];
        self.means(mesh, components, tuple)
    }

    fn means<'a>(
        &self,
        mesh: &TetMesh,
        components: usize,
        tuple: impl Fn(usize, usize) -> &'a [f64],
    ) -> Vec<f64> {
        let mut means = vec![0.0; components * self.len()];
        let mut volumes = vec![0.0; self.len()];
        for (t, (tet, &region)) in mesh.tets().iter().zip(mesh.regions()).enumerate() {
            let volume = mesh.volume(t);
            for (corner, &v) in tet.iter().enumerate() {
                let side = self.find(v, region).expect("a tet's region touches its vertices");
                volumes[side] += volume;
                // Running means: equal values give just that.
                let share = volume / volumes[side];
                let means = &mut means[components * side..][..components];
                let values = tuple(t, corner);
                means
                    .iter_mut()
                    .zip(values)
                    .for_each(|(mean, value)| *mean += share * (value - *mean));
            }
        }
        means
    }

    /// Carries a field of one tuple a side onto the sides of the finer mesh that
    /// a refinement leads to from the mesh with this topology.
    ///
    /// # Panics
    /// If `values` does not have `components` values for each side.
    pub fn carry(
        &self,
        step: (&Topology, &Refinement),
        fine: &Self,
        values: &[f64],
        components: usize,
        overshoot: Overshoot,
    ) -> Carried {
        assert_eq!(values.len(), components * self.len(), "one tuple a coarse side");
        let mut carried = filled(0.0, components * fine.len());
        if components == 0 {
            return Carried { values: carried, clamped: 0 };
        }
        let carry_side = |entries: &mut Vec<(f64, usize)>, (side, tuple): (usize, &mut [f64])| {
            let (row, region) = (fine.vertices[side], fine.regions[side]);
            self.entries(step, row, region, entries);
            let stencil = entries
                .iter()
                .map(|&(weight, side)| (weight, &values[components * side..][..components]));
            for (weight, from) in stencil.clone() {
                tuple.iter_mut().zip(from).for_each(|(sum, value)| *sum += weight * value);
            }
            match overshoot {
                Overshoot::Allow => 0,
                Overshoot::Clamp => clamp(tuple, stencil),
            }
        };
        let sides = carried.par_chunks_mut(components).with_min_len(CHUNK).enumerate();
        let clamped = sides.map_init(Vec::new, carry_side).sum();
        Carried { values: carried, clamped }
    }

    /// The entries of a row on one side, as weights and coarse sides.
    fn entries(
        &self,
        (topology, refinement): (&Topology, &Refinement),
        row: u32,
        region: i32,
        entries: &mut Vec<(f64, usize)>,
    ) {
        let (columns, weights) = refinement.field_matrix().row(row as usize);
        entries.clear();
        for (&column, &weight) in columns.iter().zip(weights) {
            match self.find(column, region) {
                Some(side) => entries.push((weight, side)),
                None => {
                    let own = match refinement.ancestry.of_vertex(row) {
                        Ancestor::Edge(edge) => topology.edges()[edge as usize],
                        _ => [row; 2],
                    };
                    // A region that touches a midpoint touches both ends.
                    let own = own.into_iter().filter_map(|v| self.find(v, region));
                    entries.extend(own.map(|side| (0.5 * weight, side)));
                }
            }
        }
    }

    /// The greatest difference of a component between two sides of one vertex;
    /// 0 where the regions meet nowhere. What is no number does not count.
    pub fn largest_jump(&self, values: &[f64], components: usize) -> f64 {
        let jump = |vertex: usize| {
            let tuples = &values[components * self.offsets[vertex] as usize
                ..components * self.offsets[vertex + 1] as usize];
            (0..components)
                .map(|component| {
                    let sides = tuples.iter().skip(component).step_by(components);
                    sides.clone().copied().fold(f64::NEG_INFINITY, f64::max)
                        - sides.copied().fold(f64::INFINITY, f64::min)
                })
                .fold(0.0, f64::max)
        };
        let vertices = (0..self.offsets.len() - 1).into_par_iter().with_min_len(CHUNK);
        vertices.map(jump).reduce(|| 0.0, f64::max)
    }
}

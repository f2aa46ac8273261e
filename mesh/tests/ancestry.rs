//! Who descends from whom, beside what a search through the whole coarse mesh
//! finds; for the red split, for splits at marked edges, and for that of one edge only.

mod common;

use std::collections::BTreeSet;

use common::random_block::blocks;
use common::random_marks::random_marks;
use octruss_mesh::{
    Ancestor, Ancestry, Diagonal, FeatureOptions, Hierarchy, Level, Lineage, RawMesh, Scheme,
    SplitEdges, Topology,
};
use proptest::prelude::*;

/// A coarse mesh and a finer one.
struct Split<'a> {
    coarse: &'a RawMesh,
    coarse_topology: &'a Topology,
    fine: &'a RawMesh,
    fine_topology: &'a Topology,
    ancestry: &'a Ancestry,
}

impl Split<'_> {
    fn check(&self) {
        self.check_vertices();
        let Self { coarse, coarse_topology, fine, fine_topology, ancestry } = self;
        let edges = ancestry.of_edges(coarse_topology, fine_topology);
        assert_eq!(edges.len(), fine_topology.edges().len());
        for (edge, found) in fine_topology.edges().iter().zip(edges) {
            assert_eq!(found, self.slow(edge));
            assert!(!matches!(found, Ancestor::Vertex(_)));
        }
        let faces = ancestry.of_faces(coarse_topology, fine_topology);
        assert_eq!(faces.len(), fine_topology.faces().len());
        for (face, found) in fine_topology.faces().iter().zip(faces) {
            assert_eq!(found, self.slow(face));
            assert!(matches!(found, Ancestor::Face(_) | Ancestor::Tet(_)));
        }
        self.check_parents(&ancestry.tets, &coarse.tets, &fine.tets);
        let (coarse_tags, fine_tags) = (&coarse.triangles, &fine.triangles);
        self.check_parents(&ancestry.triangles, &coarse_tags.simplices, &fine_tags.simplices);
        self.check_parents(&ancestry.edges, &coarse.edges.simplices, &fine.edges.simplices);
        assert_eq!(ancestry.tets.inherit(&coarse.regions, 1), fine.regions);
        assert_eq!(ancestry.triangles.inherit(&coarse_tags.tags, 1), fine_tags.tags);
        assert_eq!(ancestry.edges.inherit(&coarse.edges.tags, 1), fine.edges.tags);
    }

    /// Fine vertices stand where the midpoints were linear.
    fn check_vertices(&self) {
        assert_eq!(self.ancestry.fine_vertices(), self.fine.points.len());
        for (v, point) in (0u32..).zip(&self.fine.points) {
            let ends = self.coarse_vertices(v);
            let share = 1.0 / ends.len() as f64;
            let corners = ends.iter().map(|&end| self.coarse.points[end as usize]);
            let mean = corners.fold([0.0; 3], |sum, p| [0, 1, 2].map(|k| sum[k] + share * p[k]));
            assert!((0..3).all(|k| (mean[k] - point[k]).abs() < 1e-12));
        }
    }

    /// The coarse vertex that a fine one is, or the ends of the edge it halves.
    fn coarse_vertices(&self, fine: u32) -> Vec<u32> {
        match self.ancestry.of_vertex(fine) {
            Ancestor::Vertex(vertex) => vec![vertex],
            Ancestor::Edge(edge) => {
                assert_eq!(self.ancestry.midpoint(edge), Some(fine));
                self.coarse_topology.edges()[edge as usize].to_vec()
            }
            other => panic!("a vertex in {other:?}"),
        }
    }

    /// The first coarse edge, face or tet that has all that a fine simplex needs.
    fn slow(&self, fine: &[u32]) -> Ancestor {
        let needed: BTreeSet<u32> = fine.iter().flat_map(|&v| self.coarse_vertices(v)).collect();
        let has_all = |vertices: &[u32]| needed.iter().all(|v| vertices.contains(v));
        let edges = self.coarse_topology.edges().iter();
        let faces = self.coarse_topology.faces().iter();
        let in_edge = (0..).zip(edges).find(|(_, ends)| has_all(*ends));
        let in_face = || (0..).zip(faces).find(|(_, corners)| has_all(*corners));
        let in_tet = || (0..).zip(&self.coarse.tets).find(|(_, corners)| has_all(*corners));
        (in_edge.map(|(edge, _)| Ancestor::Edge(edge)))
            .or_else(|| in_face().map(|(face, _)| Ancestor::Face(face)))
            .or_else(|| in_tet().map(|(tet, _)| Ancestor::Tet(tet)))
            .expect("it lies somewhere")
    }

    /// Each part lies in its parent, and each parent has the parts that say so.
    fn check_parents<const N: usize>(
        &self,
        lineage: &Lineage,
        coarse: &[[u32; N]],
        fine: &[[u32; N]],
    ) {
        assert_eq!([lineage.coarse_count(), lineage.fine_count()], [coarse.len(), fine.len()]);
        for (child, vertices) in (0u32..).zip(fine) {
            let parent = lineage.parent(child);
            assert!(lineage.children(parent).contains(&child));
            let needed = vertices.iter().flat_map(|&v| self.coarse_vertices(v));
            assert!({ needed }.all(|v| coarse[parent as usize].contains(&v)));
        }
    }
}

/// The mesh with one edge halved, and with it what has the edge.
fn bisected(coarse: &RawMesh, topology: &Topology, edge: usize) -> (RawMesh, Ancestry) {
    let (ends, new) = (topology.edges()[edge], coarse.points.len() as u32);
    let [p, q] = ends.map(|v| coarse.points[v as usize]);
    let mut fine = coarse.clone();
    fine.points.push([0, 1, 2].map(|k| 0.5 * (p[k] + q[k])));
    let tets = halve(&mut fine.tets, ends, new);
    fine.regions = tets.inherit(&coarse.regions, 1);
    let triangles = halve(&mut fine.triangles.simplices, ends, new);
    fine.triangles.tags = triangles.inherit(&coarse.triangles.tags, 1);
    let edges = halve(&mut fine.edges.simplices, ends, new);
    fine.edges.tags = edges.inherit(&coarse.edges.tags, 1);
    let split_edges = SplitEdges::Some(vec![edge as u32]);
    let ancestry = Ancestry { vertices: coarse.points.len(), split_edges, tets, triangles, edges };
    (fine, ancestry)
}

fn halve<const N: usize>(simplices: &mut Vec<[u32; N]>, ends: [u32; 2], new: u32) -> Lineage {
    let (mut fine, mut parents) = (Vec::new(), Vec::new());
    for (number, simplex) in (0u32..).zip(simplices.iter()) {
        let without = |end: u32| simplex.map(|v| if v == end { new } else { v });
        if ends.iter().all(|end| simplex.contains(end)) {
            fine.extend([without(ends[1]), without(ends[0])]);
            parents.extend([number; 2]);
        } else {
            fine.push(*simplex);
            parents.push(number);
        }
    }
    *simplices = fine;
    Lineage::listed(parents)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn of_the_red_split(mesh in blocks()) {
        let mut levels = Hierarchy::new(mesh, &FeatureOptions::default());
        levels.subdivide(Scheme::Linear).expect("midpoints invert nothing");
        let Level { mesh, topology, .. } = levels.coarsest();
        Split {
            coarse: mesh.raw(),
            coarse_topology: topology,
            fine: levels.finest().mesh.raw(),
            fine_topology: &levels.finest().topology,
            ancestry: &levels.refinement(0).ancestry,
        }
        .check();
    }

    #[test]
    fn of_a_split_at_marked_edges(mesh in blocks(), seed: u64) {
        let mut levels = Hierarchy::new(mesh, &FeatureOptions::default());
        let marks = random_marks(&levels.finest().topology, seed);
        levels.split_marked(&marks, Diagonal::Inherit).expect("midpoints invert nothing");
        let Level { mesh, topology, .. } = levels.coarsest();
        Split {
            coarse: mesh.raw(),
            coarse_topology: topology,
            fine: levels.finest().mesh.raw(),
            fine_topology: &levels.finest().topology,
            ancestry: &levels.refinement(0).ancestry,
        }
        .check();
    }

    #[test]
    fn of_a_bisection(mesh in blocks(), place in 0.0..1.0) {
        let (coarse, topology) = (mesh.raw(), Topology::new(mesh.raw()));
        let edge = (place * topology.edges().len() as f64) as usize;
        let (fine, ancestry) = bisected(coarse, &topology, edge);
        Split {
            coarse,
            coarse_topology: &topology,
            fine: &fine,
            fine_topology: &Topology::new(&fine),
            ancestry: &ancestry,
        }
        .check();
    }
}

//! What hangs together by faces, and where that meets by less.

use rayon::prelude::*;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use crate::core::components::Joined;
use crate::core::reference_tet::EDGES;
use crate::core::topology::NONE;
use octruss_base::ragged::CHUNK;

/// The bodies of a mesh: tets belong to one if a way leads from one to the other through
/// faces. Several bodies may meet at edges or single vertices, which are hinges: nothing
/// there resists turning.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bodies {
    of_tets: Vec<u32>,
    first_tets: Vec<u32>,
    of_vertices: Vec<u32>,
    shared: Vec<(u32, Vec<u32>)>,
}

/// A body that meets a lower-numbered one at edges or vertices, but no face.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hinge {
    /// The two bodies, ascending.
    pub bodies: [u32; 2],
    /// The edges in common, each ascending, in ascending order.
    pub edges: Vec<[u32; 2]>,
    /// The vertices in common that are on none of these, ascending.
    pub vertices: Vec<u32>,
}

impl Bodies {
    /// The bodies of tets over `vertices` vertices; `faces` gives the two tets of each inner
    /// face, others with [`NONE`] for one that is not there.
    ///
    /// Bodies are numbered from 0 by their first tets, for any number of threads.
    pub fn new(tets: &[[u32; 4]], vertices: usize, faces: &[[u32; 2]]) -> Self {
        let joined = Joined::new(tets.len());
        let inner = faces.par_iter().with_min_len(CHUNK).filter(|[_, second]| *second != NONE);
        inner.for_each(|&[first, second]| joined.join(first, second));
        let mut of_tets = joined.lowest();
        let firsts = (0u32..).zip(&of_tets).filter(|(tet, first)| tet == *first);
        let first_tets: Vec<u32> = firsts.map(|(tet, _)| tet).collect();
        of_tets.par_iter_mut().with_min_len(CHUNK).for_each(|body| {
            *body = first_tets.partition_point(|first| first < body) as u32;
        });
        let of_vertices = lowest_at_vertices(tets, vertices, &of_tets);
        let shared = shared(tets, &of_tets, &of_vertices);
        Self { of_tets, first_tets, of_vertices, shared }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.first_tets.len()
    }

    /// The body of each tet.
    pub fn of_tets(&self) -> &[u32] {
        &self.of_tets
    }

    /// The lowest tet of each body, ascending.
    pub fn first_tets(&self) -> &[u32] {
        &self.first_tets
    }

    /// The lowest body at a vertex; none where no tet is.
    #[inline]
    pub fn lowest_at(&self, vertex: u32) -> Option<u32> {
        let body = self.of_vertices[vertex as usize];
        (body != NONE).then_some(body)
    }

    /// All bodies at a vertex, ascending.
    pub fn at(&self, vertex: u32) -> &[u32] {
        match self.shared.binary_search_by_key(&vertex, |(vertex, _)| *vertex) {
            Ok(place) => &self.shared[place].1,
            Err(_) if self.of_vertices[vertex as usize] == NONE => &[],
            Err(_) => std::slice::from_ref(&self.of_vertices[vertex as usize]),
        }
    }

    /// The vertices at which several bodies meet, ascending, with these, ascending.
    pub fn shared(&self) -> &[(u32, Vec<u32>)] {
        &self.shared
    }

    /// Where bodies meet by less than a face, ascending by bodies. Where more than two meet
    /// at one place, each with the lowest there.
    pub fn hinges(&self, tets: &[[u32; 4]]) -> Vec<Hinge> {
        let mut meetings: Vec<([u32; 2], Place)> = Vec::new();
        for (edge, bodies) in self.shared_edges(tets) {
            let pairs = bodies[1..].iter().map(|&body| ([bodies[0], body], Place::Edge(edge)));
            meetings.extend(pairs);
        }
        for (vertex, bodies) in &self.shared {
            let with_lowest = |&body: &u32| ([bodies[0], body], Place::Vertex(*vertex));
            meetings.extend(bodies[1..].iter().map(with_lowest));
        }
        meetings.sort_unstable();
        let hinge = |meetings: &[([u32; 2], Place)]| {
            let edges = meetings.iter().filter_map(|(_, place)| match place {
                Place::Edge(edge) => Some(*edge),
                Place::Vertex(_) => None,
            });
            let edges: Vec<[u32; 2]> = edges.collect();
            let vertices = meetings.iter().filter_map(|(_, place)| match place {
                Place::Vertex(vertex) => Some(*vertex),
                Place::Edge(_) => None,
            });
            let mut on_edges = edges.as_flattened().to_vec();
            on_edges.sort_unstable();
            let vertices = vertices.filter(|vertex| on_edges.binary_search(vertex).is_err());
            Hinge { bodies: meetings[0].0, vertices: vertices.collect(), edges }
        };
        meetings.chunk_by(|a, b| a.0 == b.0).map(hinge).collect()
    }

    /// The edges at which several bodies meet, ascending, with these, ascending.
    fn shared_edges(&self, tets: &[[u32; 4]]) -> Vec<([u32; 2], Vec<u32>)> {
        if self.shared.is_empty() {
            return Vec::new();
        }
        let is_shared =
            |v: u32| self.shared.binary_search_by_key(&v, |(vertex, _)| *vertex).is_ok();
        let mut edges: Vec<([u32; 2], u32)> = tets
            .par_iter()
            .zip(&self.of_tets)
            .with_min_len(CHUNK)
            .flat_map_iter(|(tet, &body)| {
                let shared = tet.map(is_shared);
                let edges = EDGES.into_iter().filter(move |[a, b]| shared[*a] && shared[*b]);
                edges.map(move |[a, b]| ([tet[a].min(tet[b]), tet[a].max(tet[b])], body))
            })
            .collect();
        edges.par_sort_unstable();
        edges.dedup();
        let same = edges.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() > 1);
        same.map(|same| (same[0].0, same.iter().map(|(_, body)| *body).collect())).collect()
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    Edge([u32; 2]),
    Vertex(u32),
}

fn lowest_at_vertices(tets: &[[u32; 4]], vertices: usize, of_tets: &[u32]) -> Vec<u32> {
    let lowest: Vec<AtomicU32> = (0..vertices).map(|_| AtomicU32::new(NONE)).collect();
    tets.par_iter().zip(of_tets).with_min_len(CHUNK).for_each(|(tet, &body)| {
        // Most are set already: reading leaves them in the other threads' caches.
        let higher = tet.iter().map(|v| &lowest[*v as usize]).filter(|at| at.load(Relaxed) > body);
        higher.for_each(|at| {
            at.fetch_min(body, Relaxed);
        });
    });
    lowest.into_iter().map(AtomicU32::into_inner).collect()
}

/// The vertices of several bodies, with these.
fn shared(tets: &[[u32; 4]], of_tets: &[u32], of_vertices: &[u32]) -> Vec<(u32, Vec<u32>)> {
    let mut others: Vec<(u32, u32)> = tets
        .par_iter()
        .zip(of_tets)
        .with_min_len(CHUNK)
        .flat_map_iter(|(tet, &body)| {
            let above = tet.iter().filter(move |v| of_vertices[**v as usize] != body);
            above.map(move |&v| (v, body))
        })
        .collect();
    others.par_sort_unstable();
    others.dedup();
    let with_lowest = |same: &[(u32, u32)]| {
        let vertex = same[0].0;
        let rest = same.iter().map(|(_, body)| *body);
        (vertex, std::iter::once(of_vertices[vertex as usize]).chain(rest).collect())
    };
    others.chunk_by(|a, b| a.0 == b.0).map(with_lowest).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::raw_mesh::RawMesh;
    use crate::core::shapes::{five_tet_cube, kuhn_cube};
    use crate::core::topology::Topology;

    /// Cubes of six tets at these places, equal points merged.
    fn cubes(places: &[[f64; 3]]) -> RawMesh {
        let mut raw = RawMesh::default();
        for place in places {
            let cube = kuhn_cube(1);
            let numbers: Vec<u32> = cube
                .points()
                .iter()
                .map(|p| {
                    let moved = [p[0] + place[0], p[1] + place[1], p[2] + place[2]];
                    let known = raw.points.iter().position(|q| *q == moved);
                    known.unwrap_or_else(|| {
                        raw.points.push(moved);
                        raw.points.len() - 1
                    }) as u32
                })
                .collect();
            raw.tets.extend(cube.tets().iter().map(|tet| tet.map(|v| numbers[v as usize])));
        }
        raw.regions = vec![0; raw.tets.len()];
        raw
    }

    fn bodies(raw: &RawMesh) -> Bodies {
        Bodies::new(&raw.tets, raw.points.len(), Topology::new(raw).face_tets())
    }

    #[test]
    fn cubes_on_a_face_are_one_body_and_on_less_a_hinge() {
        let face = cubes(&[[0.0; 3], [1.0, 0.0, 0.0]]);
        assert_eq!((bodies(&face).count(), bodies(&face).hinges(&face.tets)), (1, vec![]));

        let edge = cubes(&[[0.0; 3], [1.0, 1.0, 0.0]]);
        let found = bodies(&edge);
        assert_eq!((found.count(), found.first_tets()), (2, [0, 6].as_slice()));
        let [hinge] = &found.hinges(&edge.tets)[..] else { panic!("one hinge") };
        assert_eq!((hinge.bodies, hinge.vertices.len(), hinge.edges.len()), ([0, 1], 0, 1));
        let ends = hinge.edges[0].map(|v| edge.points[v as usize]);
        assert!(ends.contains(&[1.0, 1.0, 0.0]) && ends.contains(&[1.0, 1.0, 1.0]));
        assert_eq!(found.at(hinge.edges[0][0]), [0, 1]);
        assert_eq!((found.at(0), found.lowest_at(0)), ([0].as_slice(), Some(0)));

        let vertex = cubes(&[[0.0; 3], [1.0; 3]]);
        let [hinge] = &bodies(&vertex).hinges(&vertex.tets)[..] else { panic!("one hinge") };
        assert_eq!((hinge.edges.len(), hinge.vertices.len()), (0, 1));
        assert_eq!(vertex.points[hinge.vertices[0] as usize], [1.0; 3]);

        let apart = cubes(&[[0.0; 3], [5.0; 3]]);
        assert_eq!((bodies(&apart).count(), bodies(&apart).shared().len()), (2, 0));
    }

    #[test]
    fn a_third_body_meets_the_first_and_a_way_round_makes_one_body() {
        // Three cubes at one vertex, the last two of them on an edge.
        let three = cubes(&[[0.0; 3], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]]);
        // The second and third share a face.
        assert_eq!(bodies(&three).count(), 2);
        let chain = cubes(&[[0.0; 3], [1.0, 1.0, 0.0], [2.0, 2.0, 0.0]]);
        let pairs: Vec<_> = bodies(&chain).hinges(&chain.tets).iter().map(|h| h.bodies).collect();
        assert_eq!(pairs, [[0, 1], [1, 2]]);
        // A ring whose ends touch at an edge hangs together by faces all the way round.
        let ring = cubes(&[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]);
        assert_eq!(bodies(&ring).count(), 1);
        let unused = RawMesh { points: vec![[0.0; 3]; 9], ..five_tet_cube().into_raw() };
        assert_eq!((bodies(&unused).at(8).len(), bodies(&unused).lowest_at(8)), (0, None));
    }

    #[test]
    fn bodies_and_hinges_are_the_same_for_any_number_of_threads() {
        let place = |k: usize| [k as f64, k as f64, (k % 3) as f64];
        let chain = cubes(&(0..300).map(place).collect::<Vec<_>>());
        let with = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| (bodies(&chain), bodies(&chain).hinges(&chain.tets)))
        };
        let (found, hinges) = with(1);
        // Where the height falls by two, cubes do not touch.
        assert_eq!((found.count(), hinges.len()), (300, 200));
        assert_eq!(with(2), (found.clone(), hinges.clone()));
        assert_eq!(with(3), (found, hinges));
    }
}

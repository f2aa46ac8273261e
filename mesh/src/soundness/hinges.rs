//! Parts that hang together by edges or single vertices alone.

use crate::core::bodies::{Bodies, Hinge};
use crate::core::raw_mesh::RawMesh;
use crate::soundness::finding::{EXAMPLES, Finding, FindingKind};

/// What is to be said of hinges, if there are some; `inner_faces` are the two tets of each.
pub(crate) fn hinges(raw: &RawMesh, inner_faces: &[[u32; 2]]) -> Option<Finding> {
    let bodies = Bodies::new(&raw.tets, raw.points.len(), inner_faces);
    let hinges = bodies.hinges(&raw.tets);
    let sizes = sizes(&bodies);
    let told = |hinge: &Hinge| {
        let [one, other] = hinge.bodies.map(|body| body as usize);
        let [first, second] = [one, other].map(|body| bodies.first_tets()[body]);
        let by = [at_edges(raw, hinge), at_vertices(raw, hinge)];
        let by: Vec<String> = by.into_iter().flatten().collect();
        format!(
            "the part of {} tets from tet {first} on and that of {} from tet {second} on, at {}",
            sizes[one],
            sizes[other],
            by.join(" and ")
        )
    };
    let first = || hinges.iter().take(EXAMPLES);
    (!hinges.is_empty()).then(|| Finding {
        count: hinges.len(),
        examples: first().map(|hinge| bodies.first_tets()[hinge.bodies[1] as usize]).collect(),
        places: first().map(told).collect(),
        ..Finding::of(FindingKind::Hinges)
    })
}

/// How many tets each body has.
fn sizes(bodies: &Bodies) -> Vec<usize> {
    let mut sizes = vec![0; bodies.count()];
    bodies.of_tets().iter().for_each(|body| sizes[*body as usize] += 1);
    sizes
}

fn at_edges(raw: &RawMesh, hinge: &Hinge) -> Option<String> {
    let &[a, b] = hinge.edges.first()?;
    let [from, to] = [a, b].map(|v| told(raw.points[v as usize]));
    Some(match hinge.edges.len() {
        1 => format!("the edge of vertices {a} and {b} from {from} to {to}"),
        many => format!("{many} edges, one from vertex {a} at {from} to vertex {b} at {to}"),
    })
}

fn at_vertices(raw: &RawMesh, hinge: &Hinge) -> Option<String> {
    let &v = hinge.vertices.first()?;
    let position = told(raw.points[v as usize]);
    Some(match hinge.vertices.len() {
        1 => format!("vertex {v} at {position}"),
        many => format!("{many} single vertices, one of them {v} at {position}"),
    })
}

/// A position; `+ 0.0` makes of −0 a plain 0.
fn told(point: [f64; 3]) -> String {
    let [x, y, z] = point.map(|x| x + 0.0);
    format!("({x}, {y}, {z})")
}

#[cfg(test)]
mod tests {
    use crate::core::shapes::kuhn_cube;
    use crate::{FindingKind, RawMesh, findings};

    /// A unit cube and a second one at (1, 1, `up`), joined at equal points.
    fn two_cubes(up: f64) -> RawMesh {
        let cube = kuhn_cube(1);
        let mut raw = RawMesh { tets: cube.tets().to_vec(), ..RawMesh::default() };
        raw.points = cube.points().to_vec();
        let mut number = |p: [f64; 3]| {
            let known = raw.points.iter().position(|q| *q == p);
            known.unwrap_or_else(|| {
                raw.points.push(p);
                raw.points.len() - 1
            }) as u32
        };
        let numbers: Vec<u32> =
            cube.points().iter().map(|p| number([p[0] + 1.0, p[1] + 1.0, p[2] + up])).collect();
        raw.tets.extend(cube.tets().iter().map(|tet| tet.map(|v| numbers[v as usize])));
        raw.regions = vec![0; raw.tets.len()];
        raw
    }

    #[test]
    fn cubes_on_an_edge_or_a_vertex_are_told_with_parts_and_place() {
        let edge = &findings(&two_cubes(0.0))[..];
        let [edge] = edge else { panic!("{edge:?}") };
        assert_eq!((edge.kind, edge.count, &edge.examples[..]), (FindingKind::Hinges, 1, &[6][..]));
        assert!(!edge.kind.stops());
        let text = edge.to_string();
        assert!(
            text.starts_with(
                "1 pairs of parts that hang together by edges or single vertices only (the part of \
                 6 tets from tet 0 on and that of 6 from tet 6 on, at the edge of vertices "
            ),
            "{text}"
        );
        assert!(text.contains("(1, 1, 0)") && text.contains("(1, 1, 1)"), "{text}");
        assert!(text.contains("an elastic body turns freely"), "{text}");
        let vertex = findings(&two_cubes(1.0))[0].to_string();
        assert!(vertex.contains("from tet 6 on, at vertex 7 at (1, 1, 1)"), "{vertex}");
        assert!(findings(&two_cubes(7.0)).iter().all(|found| found.kind != FindingKind::Hinges));
    }
}

//! The elements of a file, sorted by what they are read as.

use octruss_mesh::Tagged;

use super::nodes::Nodes;
use super::scanner::Scanner;
use crate::cell_kind::{CellKind, Simplex};
use crate::mid_side::MidSide;
use crate::problem::Problem;

/// Elements by shape, nodes already numbered.
#[derive(Debug, Default)]
pub struct Elements {
    /// Corners of each tet.
    pub tets: Vec<[u32; 4]>,
    /// The tag of each tet.
    pub tet_tags: Vec<u64>,
    /// The first volume group of each tet, or 0.
    pub regions: Vec<i32>,
    /// Triangles, once for each of their groups.
    pub triangles: Tagged<3>,
    /// Lines, once for each of their groups.
    pub edges: Tagged<2>,
    /// Points, once for each of their groups.
    pub vertices: Tagged<1>,
    /// What second-order elements have besides their corners.
    pub mid_side: MidSide,
    /// How many tets are in several groups.
    pub tets_in_several_groups: usize,
    /// The groups of the last tet, when the file lists a tet once for each.
    groups_of_last: Vec<i32>,
    unsupported: Vec<(&'static CellKind, usize)>,
}

/// The type with the number that stands at `place` in the file.
pub fn element_type(
    scanner: &Scanner,
    place: usize,
    code: i32,
) -> Result<&'static CellKind, Problem> {
    CellKind::of_gmsh(code).ok_or_else(|| {
        scanner.malformed_at(
            place,
            format!(
                "{code} is not a known element type; expected simplices, such as 4 for tetrahedra"
            ),
        )
    })
}

/// Reads the node tags of one element of type `kind` into `numbers`, as node numbers.
#[inline(always)]
pub fn read_nodes(
    scanner: &mut Scanner,
    nodes: &Nodes,
    kind: &CellKind,
    tag: impl Fn(&mut Scanner) -> Result<u64, Problem>,
    numbers: &mut Vec<u32>,
) -> Result<(), Problem> {
    numbers.resize(kind.nodes, 0);
    for number in numbers.iter_mut() {
        let place = scanner.position();
        let tag = tag(scanner)?;
        *number = nodes.index(scanner, place, tag)?;
    }
    scanner.end_record("the element")
}

impl Elements {
    /// Makes room for `count` tets, a number checked against the file's size.
    pub fn reserve_tets(&mut self, count: usize) {
        self.tets.reserve(count);
        self.tet_tags.reserve(count);
        self.regions.reserve(count);
    }

    /// Takes one element in. A negative group means: in that group, the other way round.
    pub fn add(&mut self, kind: &'static CellKind, tag: u64, nodes: &[u32], groups: &[i32]) {
        match (kind.simplex, nodes) {
            (Some(Simplex::Tet), &[a, b, c, d, ..]) => self.add_tet(tag, [a, b, c, d], groups),
            (Some(Simplex::Triangle), &[a, b, c, ..]) => {
                add_tagged(&mut self.triangles, groups, [a, b, c], [a, c, b]);
            }
            (Some(Simplex::Edge), &[a, b, ..]) => {
                add_tagged(&mut self.edges, groups, [a, b], [b, a])
            }
            (Some(Simplex::Vertex), &[a, ..]) => add_tagged(&mut self.vertices, groups, [a], [a]),
            _ => return self.count_unsupported(kind),
        }
        self.mid_side.collect(kind, nodes);
    }

    fn add_tet(&mut self, tag: u64, tet: [u32; 4], groups: &[i32]) {
        self.tets.push(tet);
        self.tet_tags.push(tag);
        self.regions.push(groups.first().map_or(0, |group| group.saturating_abs()));
        self.tets_in_several_groups += usize::from(groups.len() > 1);
    }

    /// Like [`Elements::add`], for files that list an element once for each of
    /// its groups, one behind the other: such a tet is taken in once.
    pub fn add_or_merge(&mut self, kind: &'static CellKind, tag: u64, nodes: &[u32], group: i32) {
        let groups = if group == 0 { &[][..] } else { &[group] };
        if kind.simplex == Some(Simplex::Tet) {
            let again = self.tets.last().is_some_and(|last| nodes.starts_with(last));
            let known = &mut self.groups_of_last;
            // The same group twice is a duplicate tet, which checking the mesh will find.
            if again && group != 0 && !known.is_empty() && !known.contains(&group) {
                known.push(group);
                self.tets_in_several_groups += usize::from(known.len() == 2);
                return;
            }
            known.clear();
            known.extend_from_slice(groups);
        }
        self.add(kind, tag, nodes, groups);
    }

    fn count_unsupported(&mut self, kind: &'static CellKind) {
        match self.unsupported.iter_mut().find(|(known, _)| std::ptr::eq(*known, kind)) {
            Some((_, count)) => *count += 1,
            None => self.unsupported.push((kind, 1)),
        }
    }

    /// Refuses a file with elements that are not handled, naming them all.
    pub fn refuse_unsupported(&self) -> Result<(), Problem> {
        if self.unsupported.is_empty() {
            return Ok(());
        }
        let list: Vec<String> = self
            .unsupported
            .iter()
            .map(|(kind, count)| format!("{count} {}", kind.gmsh_name()))
            .collect();
        Err(Problem::unsupported(format!(
            "the mesh has {}; only tetrahedra, triangles, lines and points of first or second \
             order are read: mesh it again without recombination, with Mesh.ElementOrder = 1",
            list.join(", ")
        )))
    }
}

fn add_tagged<const N: usize>(
    tagged: &mut Tagged<N>,
    groups: &[i32],
    forward: [u32; N],
    reversed: [u32; N],
) {
    for &group in groups {
        tagged.push(if group < 0 { reversed } else { forward }, group.saturating_abs());
    }
}

//! The averaged scheme inside a solid: the mean of the three box splines of an
//! octet truss (Chang's thesis, section 4.7), generalised to irregular trusses.
//!
//! The cells are tetrahedra and octahedra; an octahedron is the four tets round
//! its diagonal, which is no edge of the truss. Neighbours along edges of the
//! truss are *hard*, vertices opposite across an octahedron *soft*. In the
//! regular truss the rules are the exact mean masks.

use super::shares::add_ends;
use crate::refinement::subdivision_matrix::Row;
use crate::subdivide::neighbourhoods::Neighbourhoods;
use crate::subdivide::octets::Octets;

/// 9/16 itself; 7/16 shared by its h hard neighbours, three parts each, and its
/// s soft ones, one part each.
pub(crate) fn vertex(near: &Neighbourhoods, octets: &Octets, vertex: u32, row: &mut Row) {
    let hard: Vec<u32> = octets.hard_neighbours(near, vertex).collect();
    let soft: Vec<u32> = octets.opposite_vertices(vertex).collect();
    let part = 7.0 / 16.0 / (3 * hard.len() + soft.len()) as f64;
    row.add(vertex, 9.0 / 16.0);
    hard.into_iter().for_each(|v| row.add(v, 3.0 * part));
    soft.into_iter().for_each(|v| row.add(v, part));
}

/// The diagonal of an octahedron: 1/6 each of its six vertices. An edge of the
/// truss: 7/24 the ends; 5/12 shared by the h hard ring vertices, four parts
/// each, and the s soft ones (two an octahedron), one part each.
pub(crate) fn edge(near: &Neighbourhoods, octets: &Octets, edge: u32, row: &mut Row) {
    if octets.is_diagonal(edge) {
        add_ends(near, edge, 1.0 / 6.0, row);
        near.link(edge).for_each(|v| row.add(v, 1.0 / 6.0));
        return;
    }
    let ring = octets.ring(near, edge);
    let part = 5.0 / 12.0 / (4 * ring.hard.len() + ring.soft.len()) as f64;
    add_ends(near, edge, 7.0 / 24.0, row);
    ring.hard.into_iter().for_each(|v| row.add(v, 4.0 * part));
    ring.soft.into_iter().for_each(|v| row.add(v, part));
}

//! What readers remark about a file: every note of every format, a sentence each.

use std::collections::BTreeSet;

/// Second-order cells lost their mid-side nodes.
pub(crate) fn mid_side_nodes(tets: usize, dropped: usize) -> String {
    format!(
        "Second-order cells, {tets} tets among them, were read as linear ones; {dropped} mid-side \
         nodes were dropped."
    )
}

/// Cells of lower dimension are in no group.
pub(crate) fn untagged(cells: usize) -> String {
    format!("{cells} triangles, lines or vertices without a tag were left out.")
}

/// A tet has one region only.
pub(crate) fn several_regions(tets: usize) -> String {
    format!(
        "{tets} tets are in several volume groups; the first one is their region, and a tet that \
         the file lists once for each was read once."
    )
}

/// Names without elements, a trap of Gmsh's.
pub(crate) fn unused_groups(groups: usize) -> String {
    format!(
        "The file names {groups} groups, but no element is in one; in MSH 2.2 Gmsh leaves the \
         groups of elements out if the option Mesh.SaveAll is 1."
    )
}

/// A field has no values on some of the nodes or tets.
pub(crate) fn missing_values(field: &str, missing: usize, count: usize, owners: &str) -> String {
    format!(
        "The field \"{field}\" has no value for {missing} of {count} {owners}; it is NaN there."
    )
}

/// A section of a file is not understood.
pub(crate) fn section(name: &str) -> String {
    format!("The section {name} was passed over.")
}

/// Sections of a file mean nothing here; of very many, some are named.
pub(crate) fn sections(names: &BTreeSet<String>) -> String {
    const NAMED: usize = 20;
    let named: Vec<&str> = names.iter().map(String::as_str).take(NAMED).collect();
    let more = match names.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    format!("The sections {}{more} were left out.", named.join(", "))
}

/// References of vertices, which most often repeat those of what they lie on.
pub(crate) fn vertex_references(vertices: usize) -> String {
    format!("The references of {vertices} vertices were left out.")
}

/// A file lacks its last word.
pub(crate) fn no_end() -> String {
    "The file does not close with End; should parts of the mesh be missing, it was cut off.".into()
}

/// An array belongs neither to points nor to cells.
pub(crate) fn whole_file_array(name: &str) -> String {
    format!("The array `{name}` of the file as a whole was left out.")
}

/// An array holds something else than numbers.
pub(crate) fn no_numbers(name: &str) -> String {
    format!("The array `{name}` holds no numbers and was left out.")
}

/// An array of single bits.
pub(crate) fn bits(name: &str) -> String {
    format!("The array `{name}` holds bits and was left out.")
}

/// Colours for values.
pub(crate) fn lookup_table(name: &str) -> String {
    format!("The lookup table `{name}` was left out.")
}

/// Vertex numbers of a file were made for another mesh.
pub(crate) fn changed_mesh() -> String {
    "The mesh was changed by another program: its tagged triangles, edges and vertices and its \
     features were left out, since their vertex numbers no longer hold."
        .into()
}

//! Tags, names and features to and from named arrays.

use std::borrow::Cow;

use bytemuck::cast_slice;
use octruss_mesh::{CellState, Features, Group, RawMesh, Tagged};

use crate::dataset::{Dataset, Field};
use crate::field_data::control_points;
use crate::field_data::side_array::{SideArray, SideArrays, SideContent, wrong};
use crate::fingerprint::fingerprint;
use crate::notes;
use crate::problem::Problem;

/// The arrays that hold the groups of a mesh. The error is a name that cannot be held.
pub(crate) fn group_arrays(groups: &[Group]) -> Result<Vec<SideArray<'_>>, String> {
    if groups.is_empty() {
        return Ok(Vec::new());
    }
    let dimensions = groups.iter().map(|group| i32::from(group.dimension)).collect();
    let ids = groups.iter().map(|group| group.id).collect();
    let mut names = Vec::new();
    for Group { name, .. } in groups {
        if name.contains('\0') {
            return Err(format!("the name {name:?} holds a zero character; rename it"));
        }
        names.extend_from_slice(name.as_bytes());
        names.push(0);
    }
    let arrays = [
        ("group_dimensions", SideContent::Ids(dimensions)),
        ("group_ids", SideContent::Ids(ids)),
        ("group_names", SideContent::Bytes(names)),
    ];
    Ok(arrays.map(|(name, content)| SideArray { name, components: 1, content }).into())
}

/// The arrays that name the derived fields, on points and on cells.
const DERIVED: [&str; 2] = ["derived_point_fields", "derived_cell_fields"];

/// The arrays that tell which fields are derived.
pub(crate) fn derived_arrays(dataset: &Dataset) -> Vec<SideArray<'_>> {
    let names = |fields: &[Field]| -> Vec<u8> {
        let derived = fields.iter().filter(|field| field.derived);
        derived.flat_map(|field| [field.name.as_bytes(), &[0]].concat()).collect()
    };
    let both = [names(&dataset.point_fields), names(&dataset.cell_fields)];
    let arrays = DERIVED.into_iter().zip(both).filter(|(_, names)| !names.is_empty());
    arrays
        .map(|(name, names)| SideArray { name, components: 1, content: SideContent::Bytes(names) })
        .collect()
}

/// Marks the fields that the file says are derived.
fn mark_derived(arrays: &impl SideArrays, dataset: &mut Dataset) -> Result<(), Problem> {
    for (array, fields) in
        DERIVED.into_iter().zip([&mut dataset.point_fields, &mut dataset.cell_fields])
    {
        let names = split_names(&arrays.bytes(array)?.unwrap_or_default())
            .ok_or_else(|| wrong(array, "a name is not UTF-8 or not ended by a zero byte"))?;
        fields.iter_mut().for_each(|field| field.derived = names.contains(&field.name));
    }
    Ok(())
}

/// The names in the bytes that [`group_arrays`] or [`derived_arrays`] made;
/// `None` if they are none.
fn split_names(bytes: &[u8]) -> Option<Vec<String>> {
    let Some(names) = bytes.strip_suffix(&[0]) else {
        return bytes.is_empty().then(Vec::new);
    };
    names.split(|&byte| byte == 0).map(|name| String::from_utf8(name.to_vec()).ok()).collect()
}

/// The array that tells whether vertex numbers still mean what they did.
const FINGERPRINT: &str = "fingerprint";

/// The arrays that hold all of a mesh besides points, tets and regions.
pub(crate) fn mesh_arrays(mesh: &RawMesh) -> Result<Vec<SideArray<'_>>, String> {
    let mut arrays = Vec::new();
    push_tagged(&mut arrays, ["triangles", "triangle_tags"], &mesh.triangles);
    push_tagged(&mut arrays, ["edges", "edge_tags"], &mesh.edges);
    push_tagged(&mut arrays, ["vertices", "vertex_tags"], &mesh.vertices);
    if let Some(features) = &mesh.features {
        arrays.extend([
            SideArray {
                name: "creases",
                components: 2,
                content: SideContent::Vertices(cast_slice(&features.creases).into()),
            },
            SideArray {
                name: "corners",
                components: 1,
                content: SideContent::Vertices((&features.corners).into()),
            },
            SideArray {
                name: "feature_surfaces",
                components: 1,
                content: SideContent::Ids(Cow::Borrowed(&features.surfaces)),
            },
        ]);
        if !features.mirrors.is_empty() {
            let content = SideContent::Ids(Cow::Borrowed(&features.mirrors));
            arrays.push(SideArray { name: "feature_mirrors", components: 1, content });
        }
        if features.smoothed {
            let content = SideContent::Bytes(vec![1]);
            arrays.push(SideArray { name: "feature_smoothed", components: 1, content });
        }
        if let Some(eta) = features.initial_quality {
            let content = SideContent::Bytes(eta.to_le_bytes().to_vec());
            arrays.push(SideArray { name: "initial_quality", components: 1, content });
        }
        if !features.cell_states.is_empty() {
            let codes = features.cell_states.iter().map(|&state| state_code(state)).collect();
            let content = SideContent::Bytes(codes);
            arrays.push(SideArray { name: "cell_states", components: 1, content });
        }
        arrays.extend(features.control_points.iter().flat_map(control_points::arrays));
    }
    if !arrays.is_empty() {
        let content = SideContent::Vertices(fingerprint(mesh).to_vec().into());
        arrays.push(SideArray { name: FINGERPRINT, components: 1, content });
    }
    arrays.extend(group_arrays(&mesh.groups)?);
    Ok(arrays)
}

/// The states of cells; a file holds their position in this list.
const CELL_STATES: [CellState; 3] =
    [CellState::Tetrahedron, CellState::QuarterRoundX0X2, CellState::QuarterRoundX1X3];

fn state_code(state: CellState) -> u8 {
    match state {
        CellState::Tetrahedron => 0,
        CellState::QuarterRoundX0X2 => 1,
        CellState::QuarterRoundX1X3 => 2,
    }
}

fn cell_states(codes: Vec<u8>) -> Result<Vec<CellState>, Problem> {
    let state = |code: u8| CELL_STATES.get(usize::from(code)).copied();
    codes
        .into_iter()
        .map(state)
        .collect::<Option<_>>()
        .ok_or_else(|| wrong("cell_states", "a state is not from 0 to 2"))
}

fn push_tagged<'a, const N: usize>(
    arrays: &mut Vec<SideArray<'a>>,
    [simplices, tags]: [&'static str; 2],
    tagged: &'a Tagged<N>,
) {
    if !tagged.is_empty() {
        let vertices = SideContent::Vertices(tagged.simplices.as_flattened().into());
        let ids = SideContent::Ids(Cow::Borrowed(&tagged.tags));
        arrays.push(SideArray { name: simplices, components: N, content: vertices });
        arrays.push(SideArray { name: tags, components: 1, content: ids });
    }
}

/// Restores what [`mesh_arrays`] wrote; of a mesh that was changed since, the
/// group names alone, with a note.
pub(crate) fn restore(arrays: &impl SideArrays, dataset: &mut Dataset) -> Result<(), Problem> {
    mark_derived(arrays, dataset)?;
    let Dataset { mesh, notes, .. } = dataset;
    mesh.groups.extend(groups(arrays)?);
    let recorded = arrays.vertices(FINGERPRINT, 1)?;
    if recorded.as_ref().is_some_and(|recorded| *recorded != fingerprint(mesh)) {
        notes.push(notes::changed_mesh());
        return Ok(());
    }
    let marks = Marks::read(arrays)?;
    // Files of the first days have no fingerprint.
    if recorded.is_none() && !marks.fit(mesh) {
        notes.push(notes::changed_mesh());
        return Ok(());
    }
    marks.add_to(mesh)
}

/// What a file says in vertex and tet numbers.
struct Marks {
    triangles: Tagged<3>,
    edges: Tagged<2>,
    vertices: Tagged<1>,
    features: Option<Features>,
}

impl Marks {
    fn read(arrays: &impl SideArrays) -> Result<Self, Problem> {
        Ok(Self {
            triangles: tagged(arrays, ["triangles", "triangle_tags"])?,
            edges: tagged(arrays, ["edges", "edge_tags"])?,
            vertices: tagged(arrays, ["vertices", "vertex_tags"])?,
            features: features(arrays)?,
        })
    }

    /// Whether all numbers are within the mesh.
    fn fit(&self, mesh: &RawMesh) -> bool {
        let within = |vertices: &[u32]| vertices.iter().all(|&v| (v as usize) < mesh.points.len());
        within(self.triangles.simplices.as_flattened())
            && within(self.edges.simplices.as_flattened())
            && within(self.vertices.simplices.as_flattened())
            && self.features.as_ref().is_none_or(|features| {
                let states = features.cell_states.len();
                within(features.creases.as_flattened())
                    && within(&features.corners)
                    && features.control_points.as_ref().is_none_or(|c| within(&c.vertices))
                    && (states == 0 || states == mesh.tets.len())
            })
    }

    fn add_to(self, mesh: &mut RawMesh) -> Result<(), Problem> {
        let states = self.features.as_ref().map_or(0, |features| features.cell_states.len());
        if states != 0 && states != mesh.tets.len() {
            let message = format!("{states} states for {} tets", mesh.tets.len());
            return Err(wrong("cell_states", message));
        }
        extend(&mut mesh.triangles, self.triangles);
        extend(&mut mesh.edges, self.edges);
        extend(&mut mesh.vertices, self.vertices);
        mesh.features = self.features;
        Ok(())
    }
}

/// The features, in the order that [`Features`] promises whatever the file's is.
fn features(arrays: &impl SideArrays) -> Result<Option<Features>, Problem> {
    let Some(creases) = arrays.vertices("creases", 2)? else { return Ok(None) };
    let creases: Vec<[u32; 2]> = tuples(&creases);
    Ok(Some(Features {
        creases: sorted(creases.into_iter().map(|[a, b]| [a.min(b), a.max(b)]).collect()),
        corners: sorted(required(arrays.vertices("corners", 1)?, "corners")?),
        surfaces: sorted(required(arrays.ids("feature_surfaces")?, "feature_surfaces")?),
        mirrors: sorted(arrays.ids("feature_mirrors")?.unwrap_or_default()),
        initial_quality: initial_quality(arrays.bytes("initial_quality")?)?,
        cell_states: cell_states(arrays.bytes("cell_states")?.unwrap_or_default())?,
        smoothed: arrays.bytes("feature_smoothed")?.is_some_and(|flag| flag == [1]),
        control_points: control_points::read(arrays)?,
    }))
}

/// A double in the file's own bytes, whatever the text around it.
fn initial_quality(bytes: Option<Vec<u8>>) -> Result<Option<f64>, Problem> {
    let Some(bytes) = bytes else { return Ok(None) };
    let eta = bytes.try_into().map(f64::from_le_bytes).ok().filter(|eta| !eta.is_nan());
    eta.map(Some).ok_or_else(|| wrong("initial_quality", "eight bytes of a number are expected"))
}

fn sorted<T: Ord>(mut list: Vec<T>) -> Vec<T> {
    list.sort_unstable();
    list.dedup();
    list
}

fn groups(arrays: &impl SideArrays) -> Result<Vec<Group>, Problem> {
    let Some(ids) = arrays.ids("group_ids")? else { return Ok(Vec::new()) };
    let dimensions = required(arrays.ids("group_dimensions")?, "group_dimensions")?;
    let names = split_names(&required(arrays.bytes("group_names")?, "group_names")?)
        .ok_or_else(|| wrong("group_names", "a name is not UTF-8 or not ended by a zero byte"))?;
    if dimensions.len() != ids.len() || names.len() != ids.len() {
        return Err(wrong(
            "group_names",
            format!("{} ids, {} dimensions, {} names", ids.len(), dimensions.len(), names.len()),
        ));
    }
    let group = |((id, dimension), name)| match u8::try_from(dimension) {
        Ok(dimension @ 0..=3) => Ok(Group { dimension, id, name }),
        _ => Err(wrong("group_dimensions", format!("{dimension} is no dimension from 0 to 3"))),
    };
    ids.into_iter().zip(dimensions).zip(names).map(group).collect()
}

fn tagged<const N: usize>(
    arrays: &impl SideArrays,
    [simplices, tags]: [&str; 2],
) -> Result<Tagged<N>, Problem> {
    let Some(vertices) = arrays.vertices(simplices, N)? else { return Ok(Tagged::default()) };
    let ids = required(arrays.ids(tags)?, tags)?;
    let simplices: Vec<[u32; N]> = tuples(&vertices);
    if ids.len() != simplices.len() {
        return Err(wrong(tags, format!("{} tags for {} simplices", ids.len(), simplices.len())));
    }
    Ok(Tagged { simplices, tags: ids })
}

fn extend<const N: usize>(tagged: &mut Tagged<N>, more: Tagged<N>) {
    tagged.simplices.extend(more.simplices);
    tagged.tags.extend(more.tags);
}

fn tuples<const N: usize>(vertices: &[u32]) -> Vec<[u32; N]> {
    vertices.as_chunks().0.to_vec()
}

fn required<T>(found: Option<T>, name: &str) -> Result<T, Problem> {
    found.ok_or_else(|| wrong(name, "the array is missing, but others that need it are there"))
}

//! Control points of a smooth surface as arrays beside the cells.

use octruss_mesh::{ControlPoints, CurveEnds, Placement};

use crate::field_data::side_array::{SideArray, SideArrays, SideContent, wrong};
use crate::problem::Problem;

/// The vertices, their control points as doubles in the file's own bytes, whatever the
/// text around them, and two bytes: how new vertices are placed, and the ends of curves.
const NAMES: [&str; 3] = ["control_vertices", "control_points", "control_placement"];

/// The placements; a file holds their position in this list.
const PLACEMENTS: [Placement; 2] = [Placement::AlongNormals, Placement::AtLimit];

/// The rules at the ends of curves, likewise.
const ENDS: [CurveEnds; 2] = [CurveEnds::Fixed, CurveEnds::Parabola];

/// The arrays that hold control points.
pub(crate) fn arrays(points: &ControlPoints) -> [SideArray<'_>; 3] {
    let coordinates = points.positions.as_flattened().iter();
    let bytes = coordinates.flat_map(|x| x.to_le_bytes()).collect();
    let codes = [code(&PLACEMENTS, points.placement), code(&ENDS, points.curve_ends)];
    let contents = [
        SideContent::Vertices((&points.vertices).into()),
        SideContent::Bytes(bytes),
        SideContent::Bytes(codes.into()),
    ];
    let [vertices, positions, codes] = contents;
    let array = |name, content| SideArray { name, components: 1, content };
    [array(NAMES[0], vertices), array(NAMES[1], positions), array(NAMES[2], codes)]
}

/// The place of a choice in the list of all.
fn code<T: PartialEq>(all: &[T], choice: T) -> u8 {
    all.iter().take_while(|other| **other != choice).count() as u8
}

/// What [`arrays`] wrote, in ascending order of the vertices whatever the file's is.
pub(crate) fn read(arrays: &impl SideArrays) -> Result<Option<ControlPoints>, Problem> {
    let [vertices, points, placement] = NAMES;
    let Some(numbers) = arrays.vertices(vertices, 1)? else { return Ok(None) };
    let positions = positions(&arrays.bytes(points)?.unwrap_or_default());
    let positions = positions.filter(|positions| positions.len() == numbers.len());
    let positions = positions.ok_or_else(|| {
        let message = format!(
            "three finite doubles of eight bytes for each of {} vertices are expected",
            numbers.len()
        );
        wrong(points, message)
    })?;
    let codes = arrays.bytes(placement)?.unwrap_or_default();
    let known = |[placed, ends]: [u8; 2]| {
        let ends = ENDS.get(usize::from(ends)).copied();
        PLACEMENTS.get(usize::from(placed)).copied().zip(ends)
    };
    let (placement, curve_ends) = <[u8; 2]>::try_from(codes)
        .ok()
        .and_then(known)
        .ok_or_else(|| wrong(placement, "two codes from 0 to 1 are expected"))?;
    let mut listed: Vec<(u32, [f64; 3])> = numbers.into_iter().zip(positions).collect();
    listed.sort_by_key(|&(vertex, _)| vertex);
    listed.dedup_by_key(|&mut (vertex, _)| vertex);
    let (vertices, positions) = listed.into_iter().unzip();
    Ok(Some(ControlPoints { vertices, positions, placement, curve_ends }))
}

/// Finite positions of three doubles each; `None` if the bytes hold something else.
fn positions(bytes: &[u8]) -> Option<Vec<[f64; 3]>> {
    let (doubles, rest) = bytes.as_chunks::<8>();
    let coordinates: Vec<f64> = doubles.iter().map(|&bytes| f64::from_le_bytes(bytes)).collect();
    let (positions, left) = coordinates.as_chunks::<3>();
    let is_whole = rest.is_empty() && left.is_empty();
    (is_whole && coordinates.iter().all(|x| x.is_finite())).then(|| positions.to_vec())
}

//! Mid-side nodes of second-order cells, which linear meshes have no use for.

use crate::dataset::Dataset;

/// Removes the points listed in `midside` that no simplex uses as a corner,
/// with their field values, and renumbers the others in their order. Numbers
/// beyond the points are left as they are, still beyond.
pub(crate) fn drop_unused(dataset: &mut Dataset, midside: &[u32]) {
    if midside.is_empty() {
        return;
    }
    let mesh = &mut dataset.mesh;
    let mut kept = vec![true; mesh.points.len()];
    let mut mark = |vertices: &[u32], keep: bool| {
        for &vertex in vertices {
            if let Some(slot) = kept.get_mut(vertex as usize) {
                *slot = keep;
            }
        }
    };
    mark(midside, false);
    mark(mesh.tets.as_flattened(), true);
    mark(mesh.triangles.simplices.as_flattened(), true);
    mark(mesh.edges.simplices.as_flattened(), true);
    mark(mesh.vertices.simplices.as_flattened(), true);

    let old: Vec<usize> = (0..kept.len()).filter(|&point| kept[point]).collect();
    let mut new = vec![0; kept.len()];
    for (number, &point) in old.iter().enumerate() {
        new[point] = number as u32;
    }
    let renumber = |vertices: &mut [u32]| {
        for vertex in vertices {
            if let Some(&number) = new.get(*vertex as usize) {
                *vertex = number;
            }
        }
    };
    renumber(mesh.tets.as_flattened_mut());
    renumber(mesh.triangles.simplices.as_flattened_mut());
    renumber(mesh.edges.simplices.as_flattened_mut());
    renumber(mesh.vertices.simplices.as_flattened_mut());
    mesh.points = old.iter().map(|&point| mesh.points[point]).collect();
    dataset.point_fields = dataset.point_fields.iter().map(|f| f.subset(&old)).collect();
}

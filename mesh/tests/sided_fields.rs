//! Fields that jump between regions, and the rows that carry them.

use octruss_mesh::{
    CheckOptions, ExtraFeatures, FeatureOptions, Hierarchy, Overshoot, RawMesh, Scheme, Sides,
    Step, TetMesh, carry_field, check, shapes,
};

/// The Kuhn cube of 4 × 4 × 4 cells with a region for each tet by its centre.
fn cube(region: impl Fn([f64; 3]) -> i32) -> RawMesh {
    let mut raw = shapes::kuhn_cube(4).into_raw();
    let centre = |tet: &[u32; 4]| {
        std::array::from_fn(|k| tet.iter().map(|&v| raw.points[v as usize][k] / 4.0).sum())
    };
    raw.regions = raw.tets.iter().map(|tet| region(centre(tet))).collect();
    raw
}

fn halves() -> RawMesh {
    cube(|[x, ..]| if x < 0.5 { 1 } else { 2 })
}

/// Three regions that meet along an edge inside the cube, bounded by lattice planes.
fn thirds() -> RawMesh {
    cube(|[x, y, _]| match (x < 0.5, y < 0.5) {
        (true, _) => 1,
        (_, true) => 2,
        _ => 3,
    })
}

/// A region that is one tet in the middle of another.
fn inclusion() -> RawMesh {
    let mut raw = cube(|_| 1);
    raw.regions[200] = 2;
    raw
}

fn sound(raw: RawMesh) -> TetMesh {
    check(raw, &CheckOptions::default()).unwrap().mesh
}

fn levels(mesh: TetMesh, step: Step, levels: usize) -> Hierarchy {
    let mut hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
    for _ in 0..levels {
        hierarchy.subdivide(step).unwrap();
    }
    hierarchy
}

/// Carries a field of sides over all levels.
fn carried(hierarchy: &Hierarchy, mut values: Vec<f64>, components: usize) -> Vec<f64> {
    for (level, refinement) in hierarchy.refinements().enumerate() {
        let [coarse, fine] = [0, 1].map(|l| Sides::new(&hierarchy.levels()[level + l].mesh));
        let step = (&hierarchy.levels()[level].topology, refinement);
        values = coarse.carry(step, &fine, &values, components, Overshoot::Allow).values;
    }
    values
}

#[test]
fn sides_are_the_pairs_of_vertices_and_regions_that_touch() {
    // The last is long enough for several threads.
    let below_zero = cube(|[x, y, z]| if x + y < z { i32::MIN } else { -1 });
    let refined = levels(sound(below_zero), Scheme::Linear.into(), 2).into_finest().mesh;
    for mesh in [halves(), thirds(), inclusion()].map(sound).into_iter().chain([refined]) {
        let mut slow: Vec<(u32, i32)> = Vec::new();
        for (tet, &region) in mesh.tets().iter().zip(mesh.regions()) {
            slow.extend(tet.map(|v| (v, region)));
        }
        slow.sort_unstable();
        slow.dedup();
        let sides = Sides::new(&mesh);
        let pairs = sides.vertices().iter().copied().zip(sides.regions().iter().copied());
        assert!(pairs.eq(slow.iter().copied()));
        for (number, (v, region)) in slow.into_iter().enumerate() {
            assert_eq!(sides.find(v, region), Some(number));
            assert!(sides.of(v).contains(&number));
        }
    }
    // 125 vertices and the 5 · 5 of the interface once more.
    assert_eq!(Sides::new(&sound(halves())).len(), 150);
    assert_eq!(Sides::new(&sound(inclusion())).len(), 129);
}

/// What makes one set of rows enough for all sides.
#[test]
fn rows_read_only_vertices_that_their_region_touches() {
    for raw in [halves(), thirds(), inclusion()] {
        for scheme in Scheme::ALL {
            for min_quality in [None, Some(0.3)] {
                let step = Step { min_quality, ..scheme.into() };
                let hierarchy = levels(sound(raw.clone()), step, 2);
                for (level, refinement) in hierarchy.refinements().enumerate() {
                    let [coarse, fine] =
                        [0, 1].map(|l| Sides::new(&hierarchy.levels()[level + l].mesh));
                    for (&row, &region) in fine.vertices().iter().zip(fine.regions()) {
                        let (columns, _) = refinement.matrix.row(row as usize);
                        let touches = |&column: &u32| coarse.find(column, region).is_some();
                        assert!(columns.iter().all(touches), "{} row {row}", scheme.name());
                    }
                }
            }
        }
    }
}

#[test]
fn constants_of_regions_stay_and_jump_undiminished() {
    for raw in [halves(), thirds(), inclusion()] {
        for scheme in Scheme::ALL {
            let hierarchy = levels(sound(raw.clone()), scheme.into(), 2);
            let of_region = |region: i32| f64::from(region * region);
            let coarse = &hierarchy.coarsest().mesh;
            let of_tets: Vec<f64> = coarse.regions().iter().map(|&r| of_region(r)).collect();
            let start = Sides::new(coarse).from_tets(coarse, &of_tets, 1);
            let values = carried(&hierarchy, start, 1);
            let sides = Sides::new(&hierarchy.finest().mesh);
            for (value, &region) in values.iter().zip(sides.regions()) {
                assert!((value - of_region(region)).abs() < 1e-13, "{value} in region {region}");
            }
            let regions = 1 + *coarse.regions().iter().max().unwrap();
            let greatest = of_region(regions - 1) - 1.0;
            assert!((sides.largest_jump(&values, 1) - greatest).abs() < 1e-13);
        }
    }
}

/// Each side by itself is what a mesh of its region alone would give: there the
/// interface is boundary, and Loop's rules are the same.
#[test]
fn a_side_equals_the_field_on_its_region_alone() {
    let whole = halves();
    let mut left = whole.clone();
    let keep: Vec<bool> = whole.regions.iter().map(|&region| region == 1).collect();
    let mut kept = keep.iter();
    left.tets.retain(|_| *kept.next().unwrap());
    left.regions.retain(|&region| region == 1);
    let in_left = |triangle: [u32; 3]| triangle.iter().all(|&v| whole.points[v as usize][0] <= 0.5);
    left.triangles = Default::default();
    for (triangle, tag) in whole.triangles.iter().filter(|&(triangle, _)| in_left(triangle)) {
        left.triangles.push(triangle, tag);
    }
    let field = |p: &[f64; 3]| [(3.0 * p[0]).sin() + p[1], p[2] * p[0]];
    for scheme in Scheme::ALL {
        let hierarchy = levels(sound(whole.clone()), scheme.into(), 2);
        let sides = Sides::new(&hierarchy.coarsest().mesh);
        // Region 2 differs by 100, which must not show in region 1.
        let start = sides.vertices().iter().zip(sides.regions()).flat_map(|(&v, &region)| {
            let jump = if region == 2 { 100.0 } else { 0.0 };
            field(&hierarchy.coarsest().mesh.points()[v as usize]).map(|value| value + jump)
        });
        let values = carried(&hierarchy, start.collect(), 2);
        let fine_sides = Sides::new(&hierarchy.finest().mesh);

        let alone = levels(sound(left.clone()), scheme.into(), 2);
        let mut expected: Vec<f64> =
            alone.coarsest().mesh.points().iter().flat_map(field).collect();
        for refinement in alone.refinements() {
            expected = refinement.matrix.apply_field(&expected, 2);
        }
        // Match by place: positions move alike.
        let place = |p: &[f64; 3]| p.map(|x| (x * 1e9).round() as i64);
        let mut of_place: Vec<([i64; 3], [f64; 2])> = (0..fine_sides.len())
            .filter(|&side| fine_sides.regions()[side] == 1)
            .map(|side| {
                let vertex = fine_sides.vertices()[side] as usize;
                let at = place(&hierarchy.finest().mesh.points()[vertex]);
                (at, [values[2 * side], values[2 * side + 1]])
            })
            .collect();
        of_place.sort_unstable_by_key(|entry| entry.0);
        assert_eq!(of_place.len(), alone.finest().mesh.points().len(), "{}", scheme.name());
        for (point, known) in alone.finest().mesh.points().iter().zip(expected.as_chunks::<2>().0) {
            let at = of_place.binary_search_by_key(&place(point), |entry| entry.0).unwrap();
            for (value, known) in of_place[at].1.iter().zip(known) {
                assert!((value - known).abs() < 1e-13, "{}: {value}, {known}", scheme.name());
            }
        }
    }
}

#[test]
fn equal_sides_stay_equal_to_the_field_at_vertices_bit_for_bit() {
    for scheme in Scheme::ALL {
        let hierarchy = levels(sound(thirds()), scheme.into(), 2);
        let start: Vec<f64> =
            hierarchy.coarsest().mesh.points().iter().map(|p| p[0].exp()).collect();
        let sides = Sides::new(&hierarchy.coarsest().mesh);
        let values = carried(&hierarchy, sides.from_vertices(&start, 1), 1);
        let mut single = start;
        for refinement in hierarchy.refinements() {
            single = refinement.matrix.apply_field(&single, 1);
        }
        let sides = Sides::new(&hierarchy.finest().mesh);
        assert_eq!(values, sides.from_vertices(&single, 1));
        assert_eq!(sides.largest_jump(&values, 1), 0.0);
    }
}

/// Two tets of a region of unlike volume at one vertex, by hand.
#[test]
fn a_side_starts_with_the_mean_weighted_by_volume() {
    let raw = RawMesh {
        points: vec![
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
            [0.0, 0.0, -3.0],
        ],
        // Volumes 1/6 and 3/6.
        tets: vec![[0, 1, 2, 3], [0, 2, 1, 4]],
        regions: vec![4, 4],
        ..RawMesh::default()
    };
    let one = sound(raw.clone());
    let sides = Sides::new(&one);
    assert_eq!(
        sides.from_tets(&one, &[8.0, 1.0, 4.0, 1.0], 2),
        [5.0, 1.0, 5.0, 1.0, 5.0, 1.0, 8.0, 1.0, 4.0, 1.0]
    );
    let two = sound(RawMesh { regions: vec![4, -1], ..raw });
    let sides = Sides::new(&two);
    // Ascending regions: −1 is the second tet.
    assert_eq!(sides.regions(), [-1, 4, -1, 4, -1, 4, 4, -1]);
    assert_eq!(sides.from_tets(&two, &[8.0, 4.0], 1), [4.0, 8.0, 4.0, 8.0, 4.0, 8.0, 8.0, 4.0]);
    assert_eq!(sides.largest_jump(&[4.0, 8.0, 4.0, 8.0, 4.0, f64::NAN, 8.0, 4.0], 1), 4.0);
    let split = sides.split_mesh(&two);
    assert_eq!(split.tets, [[1, 3, 5, 6], [0, 4, 2, 7]]);
    assert_eq!(split.points[6], [0.0, 0.0, 1.0]);
    assert!(check(split, &CheckOptions::default()).is_ok());
}

/// A crease from one region through the interface into the other: its row at the
/// interface reads a vertex on either side that the other region does not touch.
#[test]
fn where_a_curve_pierces_an_interface_each_side_is_continued_as_a_constant() {
    let vertex = |[i, j, k]: [u32; 3]| (k * 5 + j) * 5 + i;
    let [before, at, after] = [[1, 2, 2], [2, 2, 2], [3, 2, 2]].map(vertex);
    let mesh = sound(halves());
    let extra = ExtraFeatures::new(&mesh, &[[before, at], [at, after]], &[]).unwrap();
    let options = FeatureOptions { extra, ..FeatureOptions::default() };
    let mut hierarchy = Hierarchy::new(mesh, &options);
    hierarchy.subdivide(Scheme::BoxSpline).unwrap();
    let [coarse, fine] = [0, 1].map(|level| Sides::new(&hierarchy.levels()[level].mesh));
    let mut start = vec![0.0; coarse.len()];
    for (v, region, value) in [(before, 1, 8.0), (at, 1, 16.0), (at, 2, 32.0), (after, 2, 64.0)] {
        start[coarse.find(v, region).unwrap()] = value;
    }
    let step = (&hierarchy.coarsest().topology, hierarchy.refinement(0));
    let values = coarse.carry(step, &fine, &start, 1, Overshoot::Allow).values;
    // 1/8, 3/4, 1/8 with the missing neighbour equal to the vertex itself.
    assert_eq!(values[fine.find(at, 1).unwrap()], 1.0 + 14.0);
    assert_eq!(values[fine.find(at, 2).unwrap()], 28.0 + 8.0);
}

#[test]
fn clamped_values_stay_in_the_range_of_their_stencil_and_others_are_untouched() {
    // A step in the field: the interpolatory scheme overshoots beside it.
    let hierarchy = levels(sound(cube(|_| 1)), Scheme::INTERPOLATORY.into(), 1);
    let points = hierarchy.coarsest().mesh.points();
    let start: Vec<f64> =
        points.iter().flat_map(|p| [f64::from(p[0] > 0.4), f64::from(p[1] > 0.6) - 3.0]).collect();
    let matrix = &hierarchy.refinement(0).matrix;
    let free = carry_field(matrix, &start, 2, Overshoot::Allow);
    let clamped = carry_field(matrix, &start, 2, Overshoot::Clamp);
    assert_eq!(free.clamped, 0);
    assert!(free.values.iter().step_by(2).any(|&value| value > 1.01));
    let (mut changed, mut beyond_rounding) = (0, 0);
    for row in 0..matrix.rows() {
        for component in 0..2 {
            let (columns, weights) = matrix.row(row);
            let read = columns.iter().zip(weights).filter(|(_, weight)| **weight != 0.0);
            let read = read.map(|(&column, _)| start[2 * column as usize + component]);
            let low = read.clone().fold(f64::INFINITY, f64::min);
            let high = read.fold(f64::NEG_INFINITY, f64::max);
            let [was, is] = [&free, &clamped].map(|field| field.values[2 * row + component]);
            assert_eq!(is, was.clamp(low, high));
            changed += usize::from(was != is);
            beyond_rounding += usize::from((was - is).abs() > 1e-9);
        }
    }
    assert!(beyond_rounding > 10 && changed >= beyond_rounding);
    assert_eq!(clamped.clamped, beyond_rounding);
    // The same per side.
    let [coarse, fine] = [0, 1].map(|level| Sides::new(&hierarchy.levels()[level].mesh));
    let sided = coarse.from_vertices(&start, 2);
    let step = (&hierarchy.coarsest().topology, hierarchy.refinement(0));
    let carried = coarse.carry(step, &fine, &sided, 2, Overshoot::Clamp);
    assert_eq!(carried.values, fine.from_vertices(&clamped.values, 2));
    assert_eq!(carried.clamped, beyond_rounding);
}

#[test]
fn what_is_no_number_spreads_to_the_rows_that_read_it_clamped_or_not() {
    let hierarchy = levels(sound(halves()), Scheme::INTERPOLATORY.into(), 1);
    let matrix = &hierarchy.refinement(0).matrix;
    let mut start = vec![1.0; matrix.columns()];
    start[62] = f64::NAN;
    for overshoot in [Overshoot::Allow, Overshoot::Clamp] {
        let values = carry_field(matrix, &start, 1, overshoot).values;
        for (row, value) in values.iter().enumerate() {
            assert_eq!(value.is_nan(), matrix.row(row).0.contains(&62), "row {row}");
        }
    }
}

#[test]
fn vertices_outside_all_tets_have_no_side() {
    let mut raw = halves();
    let first = raw.points.len() as u32;
    raw.points.extend([[5.0, 0.0, 0.0], [6.0, 0.0, 0.0], [5.0, 1.0, 0.0]]);
    raw.triangles.push([first, first + 1, first + 2], 8);
    let hierarchy = levels(sound(raw), Scheme::BoxSpline.into(), 1);
    let sides = Sides::new(&hierarchy.coarsest().mesh);
    assert_eq!(sides.len(), 150);
    assert!(sides.of(first).is_empty() && sides.find(first, 1).is_none());
    let values = carried(&hierarchy, vec![2.0; 150], 1);
    assert_eq!(values, vec![2.0; Sides::new(&hierarchy.finest().mesh).len()]);
}

#[test]
fn the_same_bits_for_any_number_of_threads() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let hierarchy = levels(sound(thirds()), Scheme::INTERPOLATORY.into(), 2);
            let mesh = &hierarchy.coarsest().mesh;
            let of_tets: Vec<f64> = (0..mesh.tets().len()).map(|t| (t as f64).sin()).collect();
            carried(&hierarchy, Sides::new(mesh).from_tets(mesh, &of_tets, 1), 1)
        })
    };
    let one = run(1);
    assert!(one == run(2) && one == run(3));
}

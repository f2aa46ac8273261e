//! Prolongations that did not make the geometry, and their correction.

mod common;

use std::borrow::Cow;

use common::random_block::blocks;
use octruss_mesh::{
    AffineCorrection, FeatureOptions, Hierarchy, InterfaceRows, NEGLIGIBLE_DEFECT, Prolongation,
    ProlongationOptions, Scheme, Step, TetMesh, linear_matrix, shapes,
};
use proptest::prelude::*;

/// Two levels above a mesh, with quality guarded so that nothing inverts.
fn refined(mesh: TetMesh, scheme: Scheme) -> Hierarchy {
    let mut hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
    for _ in 0..2 {
        hierarchy.subdivide(Step { min_quality: Some(1e-3), ..scheme.into() }).unwrap();
    }
    hierarchy
}

fn options(scheme: Scheme, affine_correction: AffineCorrection) -> ProlongationOptions {
    ProlongationOptions { affine_correction, ..scheme.into() }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn corrected_rows_are_exact_and_of_moderate_size(mesh in blocks()) {
        for geometry in [Scheme::Linear, Scheme::BoxSpline, Scheme::INTERPOLATORY] {
            let hierarchy = refined(mesh.clone(), geometry);
            for scheme in Scheme::ALL {
                for transfer in 0..2 {
                    let plain = hierarchy.prolongation(transfer, options(scheme, AffineCorrection::Off));
                    let fixed = hierarchy.prolongation(transfer, options(scheme, AffineCorrection::On));
                    let defect = |made: &Prolongation| hierarchy.affine_defect(transfer, &made.matrix);
                    prop_assert_eq!(Some(defect(&plain)), fixed.defect_before);
                    let rest = defect(&fixed);
                    prop_assert!(rest < 1e-9, "{scheme:?} on {geometry:?}: {rest}");
                    prop_assert_eq!(fixed.corrected.left, 0);
                    for row in 0..plain.matrix.rows() {
                        let (columns, weights) = fixed.matrix.row(row);
                        prop_assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-11);
                        let size = weights.iter().map(|w| w.abs()).sum::<f64>();
                        prop_assert!(size <= 3.0 || plain.matrix.row(row) == (columns, weights));
                    }
                }
            }
        }
    }
}

#[test]
fn the_scheme_that_made_the_mesh_needs_no_correction() {
    let hierarchy = refined(shapes::five_tet_cube(), Scheme::BoxSpline);
    for correction in AffineCorrection::ALL {
        let own = hierarchy.prolongation(1, options(Scheme::BoxSpline, correction));
        let defect = hierarchy.affine_defect(1, &own.matrix);
        assert!(defect <= 1e-12, "{defect}");
        assert_eq!(own.corrected, Default::default());
        assert_eq!(*own.matrix, hierarchy.refinement(1).matrix);
    }
    let auto = hierarchy.prolongation(1, Scheme::BoxSpline);
    assert!(matches!(auto.matrix, Cow::Borrowed(_)));
}

#[test]
fn only_what_needs_it_is_corrected_automatically() {
    let flat = refined(shapes::five_tet_cube(), Scheme::Linear);
    let spline = flat.prolongation(1, Scheme::BoxSpline);
    assert!(spline.defect_before.unwrap() > 1e-3);
    assert!(flat.affine_defect(1, &spline.matrix) < NEGLIGIBLE_DEFECT);
    assert!(spline.corrected.corrected + spline.corrected.replaced > 0);
    let curved = refined(shapes::five_tet_cube(), Scheme::BoxSpline);
    // The baseline: linear interpolation stays linear, unless it is asked for.
    let linear = curved.prolongation(1, Scheme::Linear);
    assert!(curved.affine_defect(1, &linear.matrix) > 1e-3 && linear.defect_before.is_none());
    assert_eq!(*linear.matrix, linear_matrix(&curved.levels()[1].topology));
    let on = curved.prolongation(1, options(Scheme::Linear, AffineCorrection::On));
    assert!(curved.affine_defect(1, &on.matrix) < NEGLIGIBLE_DEFECT);
    assert!(on.corrected.extended > 0);
    // On the lattice of the cube the box splines are exact as they are.
    let lattice = refined(shapes::kuhn_cube(2), Scheme::Linear);
    let exact = lattice.prolongation(1, options(Scheme::BoxSpline, AffineCorrection::On));
    assert_eq!(exact.corrected, Default::default());
}

#[test]
fn a_distant_body_is_as_exact_as_a_near_one() {
    let mut far = shapes::five_tet_cube().into_raw();
    far.points.as_flattened_mut().iter_mut().for_each(|x| *x += 1e5);
    let far = octruss_mesh::check(far, &Default::default()).unwrap().mesh;
    let near = refined(shapes::five_tet_cube(), Scheme::Linear);
    let far = refined(far, Scheme::Linear);
    let [near, far] = [&near, &far].map(|levels| {
        levels.prolongation(1, options(Scheme::BoxSpline, AffineCorrection::On)).corrected
    });
    assert_eq!(near, far);
}

#[test]
fn rows_on_interfaces_can_be_linear() {
    // Two layers of cells; the interface is the plane z = 1.
    let mut raw = shapes::kuhn_box([2, 2, 2], [2.0; 3]).into_raw();
    let is_upper = |tet: &[u32; 4]| tet.iter().any(|&v| raw.points[v as usize][2] > 1.5);
    raw.regions = raw.tets.iter().map(|tet| i32::from(is_upper(tet))).collect();
    let mesh = octruss_mesh::check(raw, &Default::default()).unwrap().mesh;
    let hierarchy = refined(mesh, Scheme::Linear);
    let linear = linear_matrix(&hierarchy.levels()[1].topology);
    let [strata, interface] = InterfaceRows::ALL.map(|interface_rows| {
        let options = ProlongationOptions { interface_rows, ..Scheme::BoxSpline.into() };
        hierarchy.prolongation(1, options).matrix
    });
    for (row, [.., z]) in hierarchy.levels()[2].mesh.points().iter().enumerate() {
        let expected = if *z == 1.0 { linear.row(row) } else { strata.row(row) };
        assert_eq!(interface.row(row), expected);
    }
    assert!(strata != interface);
}

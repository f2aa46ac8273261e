//! Problems in which nothing acts are refused, and those in which something is prescribed
//! are not.

use octruss_fem::*;
use octruss_mesh::shapes::kuhn_cube;
use octruss_mesh::{FeatureOptions, Hierarchy, Scheme};

fn hierarchy() -> Hierarchy {
    let mut hierarchy = Hierarchy::new(kuhn_cube(2), &FeatureOptions::default());
    hierarchy.subdivide(Scheme::Linear).unwrap();
    hierarchy
}

/// How a problem is refused, if it is.
fn refusal<P: Problem>(problem: &P) -> Option<String> {
    let (hierarchy, options) = (hierarchy(), Options::default());
    let discrete = Discretisation::new(&hierarchy, problem, &options).unwrap();
    // A solver that is already set up refuses, too.
    let again = discrete.solver(&options).unwrap().solve(None);
    assert_eq!(again.is_err(), discrete.check_loaded().is_err());
    match discrete.solve(&options) {
        Ok(_) => None,
        Err(error) => {
            assert!(matches!(error, Error::NoLoad { .. }), "{error}");
            Some(error.to_string())
        }
    }
}

#[test]
fn heat_without_source_flux_or_temperature_is_refused() {
    let fixed = |value: f64| vec![(1, Scalar::from(value))];
    let cold = Poisson { fixed: fixed(0.0), ..Poisson::default() };
    let text = refusal(&cold).unwrap();
    assert!(text.contains("source, flux, Robin and prescribed values are all 0"), "{text}");
    // A flux of nothing, one where all is fixed, an exchange with what is at 0.
    let flux = |surface, value: f64| vec![(surface, Scalar::from(value))];
    assert!(refusal(&Poisson { flux: flux(2, 0.0), ..cold.clone() }).is_some());
    let robin = |value: f64| vec![(2, Robin { coefficient: 3.0.into(), value: value.into() })];
    assert!(refusal(&Poisson { robin: robin(0.0), fixed: vec![], ..cold.clone() }).is_some());

    assert_eq!(refusal(&Poisson { flux: flux(2, 1e-30), ..cold.clone() }), None);
    assert_eq!(refusal(&Poisson { robin: robin(1.0), fixed: vec![], ..cold.clone() }), None);
    assert_eq!(refusal(&Poisson { fixed: fixed(20.0), ..cold.clone() }), None);
    assert_eq!(refusal(&Poisson { source: 1.0.into(), ..cold }), None);

    let still = Biharmonic { source: 0.0.into(), fixed: fixed(0.0) };
    assert!(refusal(&still).is_some());
    assert_eq!(refusal(&Biharmonic { fixed: fixed(1.0), ..still }), None);
}

#[test]
fn gravity_without_a_density_is_named() {
    let clamp = |value| vec![Support { surface: 5, held: Held::displacement(value) }];
    let still =
        Elasticity { supports: clamp([0.0; 3]), ..Elasticity::new(Material::new(1.0, 0.3)) };
    let text = refusal(&still).unwrap();
    assert!(text.contains("tractions, pressures and prescribed displacements"), "{text}");
    let weightless = Elasticity { gravity: vector([0.0, 0.0, -9.81]), ..still.clone() };
    let text = refusal(&weightless).unwrap();
    assert!(text.contains("no material has any; give a density"), "{text}");
    // On the clamp it moves nothing.
    let at_clamp = vec![(5, vector([1.0, 0.0, 0.0]))];
    assert!(refusal(&Elasticity { traction: at_clamp, ..still.clone() }).is_some());

    let mut heavy = weightless;
    heavy.material.default.density = 1.0.into();
    assert_eq!(refusal(&heavy), None);
    assert_eq!(refusal(&Elasticity { supports: clamp([0.0, 0.1, 0.0]), ..still.clone() }), None);
    assert_eq!(refusal(&Elasticity { pressure: vec![(6, 1.0.into())], ..still }), None);
}

//! Every Jacobian that the paper prints, as generated from the model file against a derivation by hand
//! (`tests/src/reference/`), at random states, parameters and steps; with it the residuals and updates.
//! And what the generator says about each Jacobian as printed.

use approx::assert_abs_diff_eq;
use nalgebra::SVector;
use residua_tests::case::{self, Case, Tested};
use residua_tests::measured::Measured;
use residua_tests::number::Number;
use residua_tests::points::{Points, RandomPoint};
use residua_tests::reference::{
    Form, Scene, planar_algebra, planar_angle, planar_cayley, planar_group, planar_recursive,
    planar_reduced, spatial_cardan, spatial_group, spatial_recursive, spatial_reduced,
};

/// Operations on the longest path to an entry, generated and by hand together. Each rounds by ε/2 of the
/// terms that it adds up or multiplies, whatever their order, and [`Measured`] adds these up as `size`: so
/// two right evaluations differ by at most OPERATIONS · ε/2 · size.
const OPERATIONS: f64 = 64.0;

const POINTS: usize = 200;

fn compare(what: &str, generated: &[f64], hand: &[Measured]) {
    assert_eq!(generated.len(), hand.len(), "{what}");
    for (&generated, hand) in generated.iter().zip(hand) {
        let bound = OPERATIONS * f64::EPSILON / 2.0 * hand.size;
        assert!(generated.is_finite(), "{what}: {generated}");
        assert_abs_diff_eq!(generated, hand.value, epsilon = bound);
    }
}

fn measure<const N: usize>(values: &[f64]) -> SVector<Measured, N> {
    SVector::from_iterator(values.iter().map(|&v| Measured::constant(v)))
}

/// Compares the solver of `F`'s model and form with `F` at random points.
fn agree<F: Form<M, N>, const M: usize, const N: usize>() {
    let model = residua_models::find(F::MODEL)
        .expect("in the catalogue")
        .catalogued;
    let mut points = Points::new(2022);
    for _ in 0..POINTS {
        let point = match F::MODEL.starts_with("planar") {
            true => points.planar(M, N),
            false => points.spatial(M, N),
        };
        let RandomPoint {
            parameters,
            h,
            state,
            x,
        } = point;
        let case = Case::with_parameters(model, parameters);
        let solver = case::solver(model, F::FORM);
        let at = case.at(h, &state);
        let (mut r, mut j, mut next) = (vec![0.0; N], vec![0.0; N * N], vec![0.0; M]);
        solver.residual(&at, &x, &mut r);
        solver.jacobian(&at, &x, &mut j);
        solver.next(&at, &x, &mut next);

        let measured: Vec<_> = case
            .parameters
            .iter()
            .map(|&v| Measured::constant(v))
            .collect();
        let (scene, h) = (F::Scene::from_slice(&measured), Measured::constant(h));
        let (state, x) = (measure(&state), measure(&x));
        compare(
            "residual",
            &r,
            F::residual(&scene, h, &state, &x).as_slice(),
        );
        let by_rows = F::jacobian(&scene, h, &state, &x).transpose();
        compare("Jacobian", &j, by_rows.as_slice());
        compare("next state", &next, F::next(h, &state, &x).as_slice());
    }
}

#[test]
fn eq_43() {
    agree::<planar_angle::Next, 2, 2>();
}

#[test]
fn eq_46() {
    agree::<planar_angle::Increment, 2, 2>();
}

#[test]
fn eq_50() {
    agree::<planar_reduced::Next, 3, 3>();
}

#[test]
fn eq_53() {
    agree::<planar_reduced::Increment, 3, 3>();
}

#[test]
fn eq_56() {
    agree::<planar_recursive::Increment, 5, 5>();
}

#[test]
fn eq_60() {
    agree::<planar_group::Next, 5, 5>();
    agree::<planar_group::Increment, 5, 5>();
}

#[test]
fn eq_64() {
    agree::<planar_algebra::Next, 2, 2>();
}

#[test]
fn eq_65() {
    agree::<planar_algebra::Increment, 2, 2>();
}

/// Not printed: what Eqs. 64 and 65 become with the Cayley map for the exponential.
#[test]
fn eq_66_in_62_and_63() {
    agree::<planar_cayley::Next, 2, 2>();
    agree::<planar_cayley::Increment, 2, 2>();
}

#[test]
fn eq_73() {
    agree::<spatial_recursive::Increment, 12, 6>();
}

#[test]
fn eq_79() {
    agree::<spatial_reduced::Next, 6, 6>();
}

#[test]
fn eq_81() {
    agree::<spatial_reduced::Increment, 6, 6>();
}

#[test]
fn eq_83() {
    agree::<spatial_group::Increment, 12, 12>();
}

#[test]
fn eq_87() {
    agree::<spatial_cardan::Increment, 6, 6>();
}

/// The claims of the model files; the reasons stand beside the wrong ones.
const CLAIMS: [(&str, &str, bool); 14] = [
    ("planar_angle", "Eq. 43", true),
    ("planar_angle", "Eq. 46", true),
    ("planar_reduced", "Eq. 50", true),
    ("planar_reduced", "Eq. 53", true),
    ("planar_recursive", "Eq. 56", false),
    ("planar_recursive", "Eq. 56, e12ᵀ read as I", false),
    ("planar_group", "Eq. 60", true),
    ("planar_algebra", "Eq. 64", false),
    ("planar_algebra", "Eq. 65", false),
    ("spatial_recursive", "Eq. 73", true),
    ("spatial_reduced", "Eq. 79", true),
    ("spatial_reduced", "Eq. 81", true),
    ("spatial_group", "Eq. 83", true),
    ("spatial_cardan", "Eq. 87", false),
];

#[test]
fn right_and_wrong_as_printed() {
    for (model, label, right) in CLAIMS {
        let model = residua_models::find(model).expect("in the catalogue");
        let mut claims = model.catalogued.description.claims.iter();
        let claim = claims.find(|claim| claim.label == label).expect(label);
        assert_eq!(claim.differences.is_empty(), right, "{label}");
    }
}

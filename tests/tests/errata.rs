//! The Jacobians and residuals that the paper misprints, coded from the page by hand: each differs from what is
//! right in just the entries that the generator names, and Newton's method with it does what `residua errata`
//! says.

use nalgebra::{Const, DimMin, Matrix3, SMatrix, SVector};
use residua_tests::number::Number;
use residua_tests::printed::{all, named, rows, unequal, verdict};
use residua_tests::reference::{
    Form, Planar, Scene, Spatial, part, planar_algebra, planar_recursive, spatial_cardan,
    spatial_group, tile,
};
use residua_tools::errata::Verdict;
use residua_tools::errata::newton::Plan;

/// As in `residua_tools::errata::newton`: both loops stop at the same corrections.
const TOLERANCE: f64 = 1e-12;
const MOST_ITERATIONS: usize = 100;

/// Printed with e12ᵀ = (1, 1): rows of one number where two belong.
#[test]
fn eq_56_has_blocks_that_do_not_fit() {
    let verdict = verdict("planar_recursive", "jacobian", "Eq. 56");
    let misfits = verdict
        .differences
        .iter()
        .filter(|d| d.entry.starts_with("block"));
    assert_eq!(misfits.count(), 4);
    assert!(verdict.newton.is_none(), "nothing to code");
}

/// A printed Jacobian or residual in place of that of `$own`.
macro_rules! printed {
    ($name:ident: $own:ty, $scene:ident, $m:literal, $n:literal, $residual:expr, $jacobian:expr) => {
        struct $name;
        impl Form<$m, $n> for $name {
            type Scene<T: Number> = $scene<T>;
            const MODEL: &'static str = <$own as Form<$m, $n>>::MODEL;
            const FORM: &'static str = <$own as Form<$m, $n>>::FORM;
            fn residual<T: Number>(
                p: &$scene<T>,
                h: T,
                s: &SVector<T, $m>,
                x: &SVector<T, $n>,
            ) -> SVector<T, $n> {
                $residual(p, h, s, x)
            }
            fn jacobian<T: Number>(
                p: &$scene<T>,
                h: T,
                s: &SVector<T, $m>,
                x: &SVector<T, $n>,
            ) -> SMatrix<T, $n, $n> {
                $jacobian(p, h, s, x)
            }
            fn guess<T: Number>(s: &SVector<T, $m>) -> SVector<T, $n> {
                <$own as Form<$m, $n>>::guess(s)
            }
            fn next<T: Number>(h: T, s: &SVector<T, $m>, x: &SVector<T, $n>) -> SVector<T, $m> {
                <$own as Form<$m, $n>>::next(h, s, x)
            }
        }
    };
}

type Column<T, const N: usize> = SVector<T, N>;
type Square<T, const N: usize> = SMatrix<T, N, N>;

/// The sine of the mean angle for its cosine.
fn sine<T: Number>(p: &Planar<T>, h: T, mut j: Square<T, 2>, mean: T) -> Square<T, 2> {
    j[(0, 1)] = h * p.weight / T::constant(2.0) * mean.sin_cos().0;
    j
}

fn eq_64<T: Number>(p: &Planar<T>, h: T, s: &Column<T, 2>, x: &Column<T, 2>) -> Square<T, 2> {
    let j = planar_algebra::Next::jacobian(p, h, s, x);
    sine(p, h, j, (x[1] + s[1]) / T::constant(2.0))
}

fn eq_65<T: Number>(p: &Planar<T>, h: T, s: &Column<T, 2>, x: &Column<T, 2>) -> Square<T, 2> {
    let j = planar_algebra::Increment::jacobian(p, h, s, x);
    sine(p, h, j, s[1] + x[1] / T::constant(2.0))
}

/// h(Γb − e2) for −h(Γb + e2).
fn eq_56<T: Number>(p: &Planar<T>, h: T, s: &Column<T, 5>, x: &Column<T, 5>) -> Square<T, 5> {
    let mut j = planar_recursive::Increment::jacobian(p, h, s, x);
    j[(1, 0)] = h * x[3];
    j[(2, 0)] = h * (x[4] - T::one());
    j
}

/// 4 in every entry of T4 for 4I: the change is 4(E − I) with E full of ones.
fn spread<T: Number>() -> Matrix3<T> {
    (Matrix3::from_element(T::one()) - Matrix3::identity()) * T::constant(4.0)
}

fn eq_82<T: Number>(p: &Spatial<T>, h: T, s: &Column<T, 12>, x: &Column<T, 12>) -> Column<T, 12> {
    let mut r = spatial_group::Increment::residual(p, h, s, x);
    for (row, unknown) in [(3, 9), (6, 6), (9, 3)] {
        let more = spread() * part::<T, 3, 12>(x, unknown);
        let sum = part::<T, 3, 12>(&r, row) + more;
        r.fixed_rows_mut::<3>(row).copy_from(&sum);
    }
    r
}

fn eq_83_for_82<T: Number>(
    p: &Spatial<T>,
    h: T,
    s: &Column<T, 12>,
    x: &Column<T, 12>,
) -> Square<T, 12> {
    let (o, e) = (Matrix3::zeros(), spread());
    let more = tile([[o, o, o, o], [o, o, o, e], [o, o, e, o], [o, e, o, o]]);
    spatial_group::Increment::jacobian(p, h, s, x) + more
}

/// The columns of Γ1 and Γ3 exchanged.
fn eq_83<T: Number>(p: &Spatial<T>, h: T, s: &Column<T, 12>, x: &Column<T, 12>) -> Square<T, 12> {
    let mut j = spatial_group::Increment::jacobian(p, h, s, x);
    for k in 0..3 {
        j.swap_columns(3 + k, 9 + k);
    }
    j
}

printed!(Eq64: planar_algebra::Next, Planar, 2, 2, planar_algebra::Next::residual, eq_64);
printed!(Eq65: planar_algebra::Increment, Planar, 2, 2, planar_algebra::Increment::residual, eq_65);
printed!(Eq56: planar_recursive::Increment, Planar, 5, 5, planar_recursive::Increment::residual, eq_56);
printed!(Eq82: spatial_group::Increment, Spatial, 12, 12, eq_82, eq_83_for_82);
printed!(Eq83: spatial_group::Increment, Spatial, 12, 12, spatial_group::Increment::residual, eq_83);
printed!(Eq87: spatial_cardan::Increment, Spatial, 6, 6, spatial_cardan::Increment::residual, spatial_cardan::Printed::jacobian);

/// Corrections of each step that converges, and the last state.
fn run<F: Form<M, N>, const M: usize, const N: usize>() -> (Vec<usize>, Vec<f64>)
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let model = residua_models::find(F::MODEL)
        .expect("in the catalogue")
        .catalogued;
    let count =
        |list: &[residua::description::Variable]| list.iter().map(|v| v.rows * v.cols).sum();
    let mut parameters = vec![0.0; count(model.description.parameters)];
    model.model.defaults(&mut parameters);
    let mut start = vec![0.0; count(model.description.states)];
    model.model.start(&parameters, &mut start);
    let (plan, scene) = (Plan::default(), F::Scene::from_slice(&parameters));
    let mut state = SVector::<f64, M>::from_column_slice(&start);
    let mut counts = Vec::new();
    'steps: for _ in 0..plan.steps {
        let mut x = F::guess(&state);
        for iteration in 1..=MOST_ITERATIONS {
            let r = F::residual(&scene, plan.h, &state, &x);
            let Some(correction) = F::jacobian(&scene, plan.h, &state, &x).lu().solve(&r) else {
                break 'steps;
            };
            x -= correction;
            let scale: f64 = state.amax().max(x.amax()).max(1.0);
            if correction.amax() <= TOLERANCE * scale {
                state = F::next(plan.h, &state, &x);
                counts.push(iteration);
                continue 'steps;
            }
        }
        break;
    }
    (counts, state.as_slice().to_vec())
}

/// Newton's method coded by hand goes as `errata` reports.
fn goes_as_reported<F: Form<M, N>, const M: usize, const N: usize>(verdict: &Verdict)
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let (counts, end) = run::<F, M, N>();
    let label = &verdict.label;
    let comparison = verdict.newton.as_ref().expect(label);
    assert_eq!(comparison.printed.steps, counts.len(), "{label}");
    assert_eq!(
        comparison.printed.failure.is_none(),
        counts.len() == Plan::default().steps,
        "{label}"
    );
    assert_eq!(comparison.right.steps, Plan::default().steps, "{label}");
    let mean = counts.iter().sum::<usize>() as f64 / counts.len().max(1) as f64;
    // The last correction may fall on either side of the tolerance by rounding, in a few steps.
    assert!(
        (comparison.printed.mean_iterations - mean).abs() < 0.1,
        "{label}: {mean}"
    );
    let states = comparison.printed.states.last().expect("the start");
    for (reported, by_hand) in states.iter().zip(&end) {
        // A hundred steps, each solved to 1e-12.
        assert!(
            (reported - by_hand).abs() < 1e-9,
            "{label}: {reported} {by_hand}"
        );
    }
}

/// The entries in which a printed Jacobian differs from the right one, at a point without symmetry.
fn jacobian_differs<F: Form<M, N>, R: Form<M, N>, const M: usize, const N: usize>(
    verdict: &Verdict,
) {
    let numbers = |scale: f64| move |i: usize| (scale * (i as f64 + 1.0)).sin();
    let parameters: Vec<f64> = (0..14).map(|i| 1.5 + numbers(0.7)(i)).collect();
    let (p, q) = (
        F::Scene::from_slice(&parameters),
        R::Scene::from_slice(&parameters),
    );
    let (s, x) = (
        SVector::from_fn(|i, _| numbers(1.3)(i)),
        SVector::from_fn(|i, _| numbers(2.1)(i)),
    );
    let printed = rows(&F::jacobian::<f64>(&p, 0.3, &s, &x));
    let right = rows(&R::jacobian::<f64>(&q, 0.3, &s, &x));
    named(verdict, N, &unequal(&printed, &right));
}

#[test]
fn eqs_64_and_65_print_a_sine_for_a_cosine() {
    let eq_64 = verdict("planar_algebra", "jacobian", "Eq. 64");
    jacobian_differs::<Eq64, planar_algebra::Next, 2, 2>(&eq_64);
    goes_as_reported::<Eq64, 2, 2>(&eq_64);
    let eq_65 = verdict("planar_algebra", "jacobian", "Eq. 65");
    jacobian_differs::<Eq65, planar_algebra::Increment, 2, 2>(&eq_65);
    goes_as_reported::<Eq65, 2, 2>(&eq_65);
}

#[test]
fn eq_56_has_a_wrong_sign() {
    let eq_56 = verdict("planar_recursive", "jacobian", "Eq. 56, e12ᵀ read as I");
    jacobian_differs::<Eq56, planar_recursive::Increment, 5, 5>(&eq_56);
    goes_as_reported::<Eq56, 5, 5>(&eq_56);
}

#[test]
fn eq_82_adds_a_number_to_a_matrix() {
    let verdict = verdict("spatial_group", "residual", "Eq. 82");
    let places: Vec<usize> = verdict.differences.iter().map(|d| d.row).collect();
    assert_eq!(places, (4..=12).collect::<Vec<_>>());
    // With ω = 0 the matrix T4 of fours has rank 1.
    goes_as_reported::<Eq82, 12, 12>(&verdict);
}

#[test]
fn eq_83_read_in_the_order_of_the_text_has_its_columns_exchanged() {
    let label = "Eq. 83, columns in the order of the text: ω, Γ3, Γ2, Γ1";
    let verdict = verdict("spatial_group", "jacobian", label);
    jacobian_differs::<Eq83, spatial_group::Increment, 12, 12>(&verdict);
    goes_as_reported::<Eq83, 12, 12>(&verdict);
}

#[test]
fn eqs_86_and_87_are_those_of_another_order() {
    let eq_86 = verdict("spatial_cardan", "residual", "Eq. 86");
    let places: Vec<usize> = eq_86.differences.iter().map(|d| d.row).collect();
    assert_eq!(places, (1..=6).collect::<Vec<_>>());
    goes_as_reported::<spatial_cardan::Printed, 6, 6>(&eq_86);
    let eq_87 = verdict("spatial_cardan", "jacobian", "Eq. 87");
    jacobian_differs::<Eq87, spatial_cardan::Increment, 6, 6>(&eq_87);
    goes_as_reported::<Eq87, 6, 6>(&eq_87);
    let all = all("spatial_cardan");
    let of_printed = all
        .claims
        .iter()
        .find(|c| c.of.is_some())
        .expect("Eq. 87 of Eq. 86");
    assert!(of_printed.right, "the exact derivative of what is printed");
    goes_as_reported::<spatial_cardan::Printed, 6, 6>(of_printed);
}

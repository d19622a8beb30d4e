//! Time per step, us and the alternatives, in one process on the same trajectories:
//! `cargo bench -p residua-tests --bench steps`. Ratios are what counts; they are to the first row.
//!
//! | row | what it is |
//! |---|---|
//! | by hand | nalgebra with the Jacobian derived by hand, static LU, no tricks |
//! | nalgebra | the same with the generated dense pair |
//! | num-dual | the same with the Jacobian by forward-mode dual numbers, a pass per unknown |
//! | dense | our stepper on all unknowns |
//! | structured | our stepper, as it comes |
//! | scene | our stepper of a scene of the model |
//!
//! All iterate from the known state, or from what they extrapolate, to corrections below 1e-12; end states are compared
//! before anything is timed.

use nalgebra::{Const, DimMin};
use num_dual::Dual64;
use residua::{Model, Record, Settings, Solvable, Stepper, Strategy, System};
use residua_models::dsl as models;
use residua_tests::race::{Lane, race};
use residua_tests::reference::{
    Form, nalgebra_step, planar_algebra, planar_angle, planar_cayley, planar_group,
    planar_recursive, planar_reduced, spatial_cardan, spatial_group, spatial_recursive,
    spatial_reduced,
};
use residua_tests::rivals::{Number, Pair, Straightforward};
use std::hint::black_box;

/// Steps per sample, from the start of the run: 50 s.
const STEPS: u64 = 5000;

/// The same for motions so wild that roundings part the lanes in that time.
const BRIEF: u64 = 1000;

/// The paper's finer step, s.
const H: f64 = 0.01;

/// m, J, ρ and g of the scene `paper_spatial`.
const ISOTROPIC: [f64; 14] = [
    10.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.7, 9.81,
];

/// m, J, ρ and g of the scene `spatial_asymmetric`.
const ASYMMETRIC: [f64; 14] = [
    10.0, 1.0, 0.0, 0.0, 0.0, 2.8, 0.0, 0.0, 0.0, 2.0, 0.0, 0.1, 0.7, 9.81,
];

fn main() {
    // Cargo passes `--bench`, and tests of benches nothing: then a round is enough.
    let rounds = if std::env::args().any(|a| a == "--bench") {
        41
    } else {
        1
    };
    by_hand::<models::planar_angle::Next, planar_angle::Next, 2, 2>(rounds);
    by_hand::<models::planar_angle::Increment, planar_angle::Increment, 2, 2>(rounds);
    by_hand::<models::planar_reduced::Next, planar_reduced::Next, 3, 3>(rounds);
    by_hand::<models::planar_reduced::Increment, planar_reduced::Increment, 3, 3>(rounds);
    by_hand::<models::planar_recursive::Increment, planar_recursive::Increment, 5, 5>(rounds);
    by_hand::<models::planar_group::Next, planar_group::Next, 5, 5>(rounds);
    by_hand::<models::planar_group::Increment, planar_group::Increment, 5, 5>(rounds);
    by_hand::<models::planar_algebra::Next, planar_algebra::Next, 2, 2>(rounds);
    by_hand::<models::planar_algebra::Increment, planar_algebra::Increment, 2, 2>(rounds);
    by_hand::<models::planar_cayley::Next, planar_cayley::Next, 2, 2>(rounds);
    by_hand::<models::planar_cayley::Increment, planar_cayley::Increment, 2, 2>(rounds);
    by_hand::<models::spatial_recursive::Increment, spatial_recursive::Increment, 12, 6>(rounds);
    by_hand::<models::spatial_reduced::Next, spatial_reduced::Next, 6, 6>(rounds);
    by_hand::<models::spatial_reduced::Increment, spatial_reduced::Increment, 6, 6>(rounds);
    by_hand::<models::spatial_group::Increment, spatial_group::Increment, 12, 12>(rounds);
    by_hand::<models::spatial_cardan::Increment, spatial_cardan::Increment, 6, 6>(rounds);
    scene::<models::planar_group::Next, models::paper_planar::Next, planar_group::Next, 5, 5>(
        "scene paper_planar",
        &[2.0, 0.48, 0.6, 9.81],
        &[1.0],
        in_the_plane,
        rounds,
    );
    scene::<
        models::spatial_group::Increment,
        models::paper_spatial::Increment,
        spatial_group::Increment,
        12,
        12,
    >(
        "scene paper_spatial",
        &ISOTROPIC,
        &[0.0; 2],
        in_space,
        rounds,
    );
    scene::<
        models::spatial_group::Increment,
        models::spatial_asymmetric::Increment,
        spatial_group::Increment,
        12,
        12,
    >(
        "scene spatial_asymmetric",
        &ASYMMETRIC,
        &[0.5, -0.5, 0.4],
        in_space,
        rounds,
    );
    generated::<models::double_planar::Increment, 4>("double_planar increment", BRIEF, rounds);
    generated::<models::elastic::Increment, 4>("elastic increment", BRIEF, rounds);
    generated::<models::spherical::Increment, 6>("spherical increment", STEPS, rounds);
    generated::<models::lattice::Increment, 12>("lattice increment", BRIEF, rounds);
}

/// The model `S` and the form `F` of it coded by hand, on the run of its scene `C`, with the parameters of that; and the
/// fewest unknowns that anybody codes by hand. What is kept of the angular velocity is compared.
fn scene<S, C, F, const M: usize, const N: usize>(
    title: &str,
    parameters: &'static [f64],
    rates: &'static [f64],
    reduced: fn(&[f64], &[f64]) -> Vec<f64>,
    rounds: usize,
) where
    S: Rivalled<N> + 'static,
    C: Solvable<f64> + 'static,
    F: Form<M, N> + 'static,
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let from = |lane: fn() -> Vec<f64>| move || lane()[..rates.len()].to_vec();
    let by_hand = move || {
        let (parameters, start) = whole::<S>(parameters, rates);
        by_hand_run::<F, M, N>(parameters.to_array().as_ref(), start.to_array().as_ref())
    };
    let fewest = move || {
        let (parameters, start) = whole::<S>(parameters, rates);
        reduced(parameters.to_array().as_ref(), start.to_array().as_ref())
    };
    let whole = move || {
        let (parameters, start) = whole::<S>(parameters, rates);
        run::<S>(parameters, start, Strategy::Core, STEPS)
    };
    let lanes = vec![
        Lane::new("by hand", move || by_hand()[..rates.len()].to_vec()),
        Lane::new("reduced", move || fewest()[..rates.len()].to_vec()),
        Lane::new("structured", move || whole()[..rates.len()].to_vec()),
        Lane::new("scene", from(|| stepper::<C>(Strategy::Core, STEPS))),
    ];
    race(title, STEPS, rounds, lanes);
}

/// The planar pendulum by 3 unknowns, from the state of the complete group: ω and two rows, of which the last is Γ.
fn in_the_plane(parameters: &[f64], state: &[f64]) -> Vec<f64> {
    let start = [state[0], state[3], state[4]];
    by_hand_run::<planar_reduced::Next, 3, 3>(parameters, &start)
}

/// The pendulum in space by 6 unknowns, from the state of the complete group: ω and three rows, of which the last is Γ.
fn in_space(parameters: &[f64], state: &[f64]) -> Vec<f64> {
    let start = [&state[..3], &state[9..]].concat();
    by_hand_run::<spatial_reduced::Increment, 6, 6>(parameters, &start)
}

/// The parameters and the start of the model, some of them others.
fn whole<S: System<f64>>(
    parameters: &[f64],
    rates: &[f64],
) -> (
    <S::Model as Model<f64>>::Parameters,
    <S::Model as Model<f64>>::State,
) {
    let mut own = <S::Model as Model<f64>>::Parameters::default().to_array();
    own.as_mut().copy_from_slice(parameters);
    let own = Record::from_array(own);
    let mut start = S::Model::start(&own).to_array();
    start.as_mut()[..rates.len()].copy_from_slice(rates);
    (own, Record::from_array(start))
}

/// The form `F`, coded by hand, and the generated solver `S` of the same equations.
fn by_hand<S: Rivalled<N> + 'static, F: Form<M, N> + 'static, const M: usize, const N: usize>(
    rounds: usize,
) where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let steps = STEPS;
    let first = Lane::new("by hand", || {
        let parameters = <<S as System<f64>>::Model as Model<f64>>::Parameters::default();
        let start = <S as System<f64>>::Model::start(&parameters).to_array();
        let parameters = parameters.to_array();
        by_hand_run::<F, M, N>(parameters.as_ref(), start.as_ref())
    });
    let lanes = [first].into_iter().chain(ours::<S, N>(steps)).collect();
    race(&format!("{} {}", F::MODEL, F::FORM), steps, rounds, lanes);
}

fn by_hand_run<F: Form<M, N>, const M: usize, const N: usize>(
    parameters: &[f64],
    start: &[f64],
) -> Vec<f64>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let (parameters, start) = (black_box(parameters), black_box(start));
    let mut stepper = nalgebra_step::Stepper::<F, M, N>::new(parameters, start, black_box(H));
    for _ in 0..STEPS {
        stepper.step().expect("Newton converges");
    }
    stepper.state().to_vec()
}

/// A model that nobody has coded by hand.
fn generated<S: Rivalled<N> + 'static, const N: usize>(title: &str, steps: u64, rounds: usize)
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    race(title, steps, rounds, ours::<S, N>(steps));
}

/// A generated solver that all lanes can run.
trait Rivalled<const N: usize>: Solvable<f64> + Pair<f64, N> + Pair<Dual64, N> {}
impl<S: Solvable<f64> + Pair<f64, N> + Pair<Dual64, N>, const N: usize> Rivalled<N> for S {}

fn ours<S: Rivalled<N> + 'static, const N: usize>(steps: u64) -> Vec<Lane>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    vec![
        Lane::new("nalgebra", move || straightforward::<S, f64, N>(steps)),
        Lane::new("num-dual", move || straightforward::<S, Dual64, N>(steps)),
        Lane::new("dense", move || stepper::<S>(Strategy::Full, steps)),
        Lane::new("structured", move || stepper::<S>(Strategy::Core, steps)),
    ]
}

fn straightforward<S: Pair<T, N>, T: Number, const N: usize>(steps: u64) -> Vec<f64>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let mut rival = Straightforward::<S, T, N>::new(H);
    for _ in 0..steps {
        rival.step().expect("Newton converges");
    }
    rival.state()
}

fn stepper<S: Solvable<f64>>(strategy: Strategy, steps: u64) -> Vec<f64> {
    let parameters = <S::Model as Model<f64>>::Parameters::default();
    run::<S>(parameters, S::Model::start(&parameters), strategy, steps)
}

fn run<S: Solvable<f64>>(
    parameters: <S::Model as Model<f64>>::Parameters,
    start: <S::Model as Model<f64>>::State,
    strategy: Strategy,
    steps: u64,
) -> Vec<f64> {
    let settings = Settings {
        strategy,
        ..Settings::default()
    };
    let (parameters, start) = (black_box(parameters), black_box(start));
    let stepper = Stepper::<S>::new(parameters, start, black_box(H)).expect("a valid run");
    let mut stepper = stepper.with_settings(settings);
    stepper.advance(steps).expect("Newton converges");
    stepper.state_array().as_ref().to_vec()
}

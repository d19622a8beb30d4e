//! Time per step and trajectory of ensembles on one thread: the generated solver in lanes against straightforward
//! nalgebra with the Jacobian derived by hand (`tests/src/reference/`), on the paper's models at h = 0.01 s.
//!
//! All trajectories start differently, so that nothing can be computed once for several. Both sides run the same ones,
//! and their end states are compared before anything is timed.

use nalgebra::{Const, DimMin};
use rayon::{ThreadPool, ThreadPoolBuilder};
use residua::erased::Sample;
use residua::{Ensemble, Fleet, Model, Record, Settings, System, Wide};
use residua_models::dsl as models;
use residua_tests::reference::{
    Form, nalgebra_step, planar_angle, planar_group, planar_reduced, spatial_cardan, spatial_group,
    spatial_reduced,
};
use residua_tools::race::{Lane, agree, race};
use std::convert::Infallible;
use std::hint::black_box;
use std::sync::Mutex;

/// Trajectories of the ensemble: some groups.
const TRAJECTORIES: usize = 256;

/// Trajectories of the rival, which takes each for the same time.
const OF_RIVAL: usize = 4;

/// Steps of each, long enough for the start not to count.
const STEPS: u64 = 2000;

/// The paper's finer step, s.
const H: f64 = 0.01;

/// Largest difference of the end states, for numbers of order one: rounding, grown over 20 s.
const AGREEMENT: f64 = 1e-8;

type OfModel<S> = <S as System<f64>>::Model;

/// Parameters and start state of a trajectory: those of the file, and the first state, an angular velocity, moved on.
fn given<S: Wide>(trajectory: usize) -> (Vec<f64>, Vec<f64>) {
    let parameters = <OfModel<S> as Model<f64>>::Parameters::default();
    let mut start = OfModel::<S>::start(&parameters).to_array();
    start.as_mut()[0] += 1e-3 * trajectory as f64;
    let parameters = parameters.to_array().as_ref().to_vec();
    (parameters, start.as_ref().to_vec())
}

/// The end states of all trajectories.
fn ensemble<S: Wide + 'static>(pool: &ThreadPool) -> Vec<Vec<f64>> {
    let ends = Mutex::new(vec![Vec::new(); TRAJECTORIES]);
    let fill = |trajectory: usize, parameters: &mut [f64], start: &mut [f64]| {
        let given = given::<S>(trajectory);
        parameters.copy_from_slice(&given.0);
        start.copy_from_slice(&given.1);
    };
    let observer = |trajectory: usize, sample: Sample| {
        ends.lock().expect("no panic")[trajectory] = sample.state.to_vec();
    };
    let fleet = Fleet {
        trajectories: 0..TRAJECTORIES,
        fill: &fill,
        h: black_box(H),
        t0: 0.0,
        steps: STEPS,
        every: 0,
        settings: Settings::default(),
        observer: &observer,
    };
    let outcomes = pool
        .install(|| Ensemble::<S>::NEW.fly(&fleet))
        .expect("a valid run");
    assert!(outcomes.iter().all(|outcome| outcome.error.is_none()));
    ends.into_inner().expect("no panic")
}

fn rival<S: Wide, F: Form<M, N>, const M: usize, const N: usize>(count: usize) -> Vec<Vec<f64>>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let run = |trajectory| {
        let (parameters, start) = given::<S>(trajectory);
        let mut stepper = nalgebra_step::Stepper::<F, M, N>::new(&parameters, &start, black_box(H));
        for _ in 0..STEPS {
            black_box(stepper.step()).expect("Newton converges");
        }
        stepper.state().to_vec()
    };
    (0..count).map(run).collect()
}

/// Times the generated solver `S` and the form `F`, which must be the same equations.
fn compare<S: Wide + 'static, F: Form<M, N>, const M: usize, const N: usize>(rounds: u64)
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let pool = ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .expect("a thread");
    let ours = |trajectories: usize| {
        let ends = ensemble::<S>(&pool).into_iter().take(trajectories);
        ends.flatten().collect::<Vec<_>>()
    };
    let (all, few) = (TRAJECTORIES, OF_RIVAL);
    let theirs = |trajectories| rival::<S, F, M, N>(trajectories).concat();
    assert!(agree(&theirs(all), &ours(all), AGREEMENT), "{}", F::MODEL);
    let of = |trajectories: usize| trajectories as f64 * STEPS as f64;
    let mut lanes = [
        Lane::<Infallible>::new("lanes", of(all), || Ok(ours(few))),
        Lane::new("nalgebra", of(few), || Ok(theirs(few))),
    ];
    let paces = race(&mut lanes, AGREEMENT, rounds);
    let paces = paces.unwrap_or_else(|unfair| panic!("{}: {unfair}", F::MODEL));
    let [lanes, nalgebra] = [0, 1].map(|lane| paces[lane].median * 1e9);
    println!(
        "{} {}: {lanes:.2} ns in lanes, {nalgebra:.0} ns by nalgebra, {:.0} times",
        F::MODEL,
        F::FORM,
        nalgebra / lanes
    );
}

fn main() {
    // Cargo passes `--bench`, and tests of benches nothing: then a round is enough.
    let rounds = if std::env::args().any(|a| a == "--bench") {
        11
    } else {
        1
    };
    compare::<models::planar_angle::Increment, planar_angle::Increment, 2, 2>(rounds);
    compare::<models::planar_reduced::Next, planar_reduced::Next, 3, 3>(rounds);
    compare::<models::planar_reduced::Increment, planar_reduced::Increment, 3, 3>(rounds);
    compare::<models::planar_group::Increment, planar_group::Increment, 5, 5>(rounds);
    compare::<models::spatial_reduced::Increment, spatial_reduced::Increment, 6, 6>(rounds);
    compare::<models::spatial_group::Increment, spatial_group::Increment, 12, 12>(rounds);
    compare::<models::spatial_cardan::Increment, spatial_cardan::Increment, 6, 6>(rounds);
}

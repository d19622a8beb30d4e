//! Time per step of each of the paper's models: the generated stepper against straightforward nalgebra with
//! the Jacobian derived by hand (`tests/src/reference/`), on the paper's runs at h = 0.01 s.
//!
//! Both run the same trajectory from the same start; their end states are compared before anything is timed.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use nalgebra::{Const, DimMin};
use residua::{Model, Record, Solvable, Stepper};
use residua_models::dsl as models;
use residua_tests::reference::{
    Form, nalgebra_step, planar_algebra, planar_angle, planar_cayley, planar_group,
    planar_recursive, planar_reduced, spatial_cardan, spatial_group, spatial_recursive,
    spatial_reduced,
};
use std::hint::black_box;

/// Steps per sample, from the start of the run: long enough for the setup not to count.
const STEPS: u64 = 500;

/// The paper's finer step, s.
const H: f64 = 0.01;

/// Largest difference of the end states, for numbers of order one: rounding, grown over 5 s.
const AGREEMENT: f64 = 1e-9;

fn generated<S: Solvable<f64>>() -> Stepper<S> {
    let parameters = <S::Model as Model<f64>>::Parameters::default();
    let start = S::Model::start(&parameters);
    Stepper::new(black_box(parameters), black_box(start), black_box(H)).expect("a valid run")
}

fn by_hand<S: Solvable<f64>, F: Form<M, N>, const M: usize, const N: usize>()
-> nalgebra_step::Stepper<F, M, N>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let parameters = <S::Model as Model<f64>>::Parameters::default();
    let start = S::Model::start(&parameters).to_array();
    let parameters = parameters.to_array();
    let (parameters, start) = (black_box(parameters.as_ref()), black_box(start.as_ref()));
    nalgebra_step::Stepper::new(parameters, start, black_box(H))
}

fn run_generated<S: Solvable<f64>>(stepper: &mut Stepper<S>) {
    for _ in 0..STEPS {
        black_box(stepper.step()).expect("Newton converges");
    }
}

fn run_by_hand<F: Form<M, N>, const M: usize, const N: usize>(
    stepper: &mut nalgebra_step::Stepper<F, M, N>,
) where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    for _ in 0..STEPS {
        black_box(stepper.step()).expect("Newton converges");
    }
}

/// Times the generated solver `S` and the form `F`, which must be the same equations.
fn compare<S: Solvable<f64>, F: Form<M, N>, const M: usize, const N: usize>(c: &mut Criterion)
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let (mut ours, mut theirs) = (generated::<S>(), by_hand::<S, F, M, N>());
    run_generated(&mut ours);
    run_by_hand(&mut theirs);
    for (a, b) in ours.state_array().as_ref().iter().zip(theirs.state()) {
        // Written so that a NaN fails.
        assert!((a - b).abs() <= AGREEMENT, "{}: {a} and {b}", F::MODEL);
    }

    let mut group = c.benchmark_group(format!("{} {}", F::MODEL, F::FORM));
    group.throughput(Throughput::Elements(STEPS));
    group.bench_function("generated", |b| {
        b.iter_batched_ref(generated::<S>, run_generated, BatchSize::SmallInput);
    });
    group.bench_function("nalgebra", |b| {
        b.iter_batched_ref(by_hand::<S, F, M, N>, run_by_hand, BatchSize::SmallInput);
    });
    group.finish();
}

fn planar(c: &mut Criterion) {
    compare::<models::planar_angle::Next, planar_angle::Next, 2, 2>(c);
    compare::<models::planar_angle::Increment, planar_angle::Increment, 2, 2>(c);
    compare::<models::planar_reduced::Next, planar_reduced::Next, 3, 3>(c);
    compare::<models::planar_reduced::Increment, planar_reduced::Increment, 3, 3>(c);
    compare::<models::planar_recursive::Increment, planar_recursive::Increment, 5, 5>(c);
    compare::<models::planar_group::Next, planar_group::Next, 5, 5>(c);
    compare::<models::planar_group::Increment, planar_group::Increment, 5, 5>(c);
    compare::<models::planar_algebra::Next, planar_algebra::Next, 2, 2>(c);
    compare::<models::planar_algebra::Increment, planar_algebra::Increment, 2, 2>(c);
    compare::<models::planar_cayley::Next, planar_cayley::Next, 2, 2>(c);
    compare::<models::planar_cayley::Increment, planar_cayley::Increment, 2, 2>(c);
}

fn spatial(c: &mut Criterion) {
    compare::<models::spatial_recursive::Increment, spatial_recursive::Increment, 12, 6>(c);
    compare::<models::spatial_reduced::Next, spatial_reduced::Next, 6, 6>(c);
    compare::<models::spatial_reduced::Increment, spatial_reduced::Increment, 6, 6>(c);
    compare::<models::spatial_group::Increment, spatial_group::Increment, 12, 12>(c);
    compare::<models::spatial_cardan::Increment, spatial_cardan::Increment, 6, 6>(c);
}

criterion_group!(benches, planar, spatial);
criterion_main!(benches);

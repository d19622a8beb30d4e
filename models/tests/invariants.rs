//! What the schemes keep in long runs: quadratic invariants to rounding, other energies without a trend, and the way back.

#[path = "support/body.rs"]
mod body;

use body::asymmetric;
use residua::Collocated;
use residua::Collocation;
use residua::Composed;
use residua::Ends;
use residua::Explicit;
use residua::Integration;
use residua::Method;
use residua::Model;
use residua::Record;
use residua_models::dsl::planar_angle;
use residua_models::dsl::planar_reduced;
use residua_models::dsl::spatial_group;
use residua_models::dsl::spatial_reduced;

/// Steps of a run in every check, and in those that are asked for.
const STEPS: u32 = 100_000;
const MANY_STEPS: u32 = 1_000_000;

/// Five steps in a radian of the fastest motion here: far from where errors of the schemes would be rounding.
const STEP: f64 = 0.05;

/// Each step rounds once, as sums are compensated, and n roundings walk by √n ε of the terms that an invariant sums up; four
/// standard deviations are exceeded by one walk in ten thousand. A trend of a tenth of an ε per step is three times that
/// after 10⁵ steps.
fn rounding(step: u32) -> f64 {
    let steps = f64::from(step).max(64.0);
    4.0 * f64::EPSILON * steps.sqrt()
}

/// A run with steps of length `STEP`.
fn run<S: Method<f64>>(
    parameters: <S::Model as Model<f64>>::Parameters,
    start: <S::Model as Model<f64>>::State,
) -> Integration<S, f64> {
    Integration::new(parameters, start, STEP).expect("finite numbers")
}

/// The file's parameters and start.
fn by_file<M: Model<f64>>() -> (M::Parameters, M::State) {
    let parameters = M::Parameters::default();
    (parameters, M::start(&parameters))
}

/// The largest error of any invariant, in units of `size` and of what [`rounding`] allows.
fn worst<S: Method<f64>>(
    (parameters, start): (
        <S::Model as Model<f64>>::Parameters,
        <S::Model as Model<f64>>::State,
    ),
    size: f64,
    steps: u32,
) -> f64 {
    let mut run = run::<S>(parameters, start);
    let is_kept: Vec<bool> = S::Model::DESCRIPTION
        .outputs
        .iter()
        .flat_map(|o| vec![o.invariant; o.variable.rows * o.variable.cols])
        .collect();
    let before = run.outputs().to_array();
    let mut worst = 0.0_f64;
    for step in 1..=steps {
        run.step().expect("a step of a regular motion");
        let now = run.outputs().to_array();
        let pairs = now.as_ref().iter().zip(before.as_ref()).zip(&is_kept);
        for ((now, before), _) in pairs.filter(|(_, kept)| **kept) {
            worst = worst.max((now - before).abs() / (size * rounding(step)));
        }
    }
    worst
}

/// The invariants of three models, all of them quadratic: energy and |Γ|² in the plane, and in space with the vertical
/// momentum; RᵀR = I, so that R stays on the group. The sizes are those of the largest terms, m g l = 11.8 and m g |ρ| = 68.7.
fn quadratic<P, S, G>(name: &str, steps: u32)
where
    P: Method<f64, Model = planar_reduced::Model>,
    S: Method<f64, Model = spatial_reduced::Model>,
    G: Method<f64, Model = spatial_group::Model>,
{
    let all = [
        worst::<P>(by_file::<planar_reduced::Model>(), 12.0, steps),
        worst::<S>(asymmetric(), 69.0, steps),
        worst::<G>(by_file::<spatial_group::Model>(), 69.0, steps),
    ];
    println!("{name}: {all:?} of what rounding may take");
    assert!(all.iter().all(|worst| *worst <= 1.0), "{name}: {all:?}");
}

type Gauss<M, const S: usize> = Collocation<M, S, f64>;
type Composition<M, const S: usize> = Composed<Collocation<M, 1, f64>, S, f64>;

fn quadratic_by_gauss<const S: usize>(steps: u32) {
    use planar_reduced::Model as P;
    use spatial_group::Model as G;
    use spatial_reduced::Model as R;
    quadratic::<Gauss<P, S>, Gauss<R, S>, Gauss<G, S>>(&format!("gauss{S}"), steps);
}

fn quadratic_by_composition<const S: usize>(steps: u32) {
    use planar_reduced::Model as P;
    use spatial_group::Model as G;
    use spatial_reduced::Model as R;
    let name = format!("{S} midpoint rules");
    quadratic::<Composition<P, S>, Composition<R, S>, Composition<G, S>>(&name, steps);
}

#[test]
fn gauss_keeps_quadratic_invariants_to_rounding() {
    quadratic_by_gauss::<1>(STEPS);
    quadratic_by_gauss::<2>(STEPS);
    quadratic_by_gauss::<3>(STEPS);
    quadratic_by_gauss::<5>(STEPS);
    quadratic_by_gauss::<8>(STEPS);
}

#[test]
fn compositions_of_gauss_keep_quadratic_invariants_to_rounding() {
    // A step of theirs is as many of midpoint rules.
    quadratic_by_composition::<5>(STEPS / 5);
    quadratic_by_composition::<9>(STEPS / 10);
    quadratic_by_composition::<15>(STEPS / 20);
}

/// `cargo test --release -p residua-models --test invariants -- --ignored --nocapture`
#[test]
#[ignore = "takes minutes"]
fn gauss_keeps_quadratic_invariants_over_a_million_steps() {
    quadratic_by_gauss::<1>(MANY_STEPS);
    quadratic_by_gauss::<2>(MANY_STEPS);
    quadratic_by_gauss::<8>(MANY_STEPS);
    quadratic_by_composition::<5>(MANY_STEPS);
}

/// What a scheme makes of a conserved quantity that it does not keep.
#[derive(Debug)]
struct Drift {
    /// Half of what it swings by, in the first part of the run.
    swing: f64,
    /// How far the mean of the last part is from that of the first, in swings.
    shift: f64,
    /// The largest swing of a part over the least one.
    growth: f64,
}

/// Parts of a run that are compared.
const PARTS: usize = 10;

/// Where an output is in a model whose outputs are all scalars.
fn scalar_output<M: Model<f64>>(name: &str) -> usize {
    let mut outputs = M::DESCRIPTION.outputs.iter();
    let found = outputs.position(|o| o.variable.name == name);
    found.expect("an output of that name")
}

/// The output `index` of a run.
fn drift<S: Method<f64>>(index: usize, steps: u32) -> Drift {
    let (parameters, start) = by_file::<S::Model>();
    let mut run = run::<S>(parameters, start);
    let [mut means, mut swings] = [[0.0_f64; PARTS]; 2];
    let n = steps / PARTS as u32;
    for (mean, swing) in means.iter_mut().zip(&mut swings) {
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for _ in 0..n {
            run.step().expect("a step of a regular motion");
            let value = run.outputs().to_array().as_ref()[index];
            (least, most) = (least.min(value), most.max(value));
            *mean += value / f64::from(n);
        }
        *swing = (most - least) / 2.0;
    }
    let most = swings.iter().fold(0.0_f64, |a, b| a.max(*b));
    let least = swings.iter().fold(f64::INFINITY, |a, b| a.min(*b));
    Drift {
        swing: swings[0],
        shift: (means[PARTS - 1] - means[0]).abs() / swings[0],
        growth: most / least,
    }
}

/// Parts end anywhere in a swing: of the first and last one of 400 swings or more up to two count for their means.
const ENDS: f64 = 2.0 / 400.0;

/// The energy of the pendulum in its angle, m g l cos θ in it, is not quadratic: it swings by some hᵖ and has no trend (Hairer,
/// Lubich and Wanner, *Geometric Numerical Integration*, IX.8.1, for symplectic schemes). That of Runge–Kutta has.
fn energy_swings(steps: u32) {
    use planar_angle::Model as M;
    let index = scalar_output::<M>("energy");
    let all = [
        ("midpoint", drift::<Gauss<M, 1>>(index, steps)),
        ("gauss2", drift::<Gauss<M, 2>>(index, steps)),
        ("gauss3", drift::<Gauss<M, 3>>(index, steps)),
        ("composition4", drift::<Composition<M, 5>>(index, steps)),
        ("trapezoidal", drift::<Ends<M, f64>>(index, steps)),
    ];
    let explicit = drift::<Explicit<M, f64>>(index, steps);
    for (name, drift) in &all {
        println!("{name}: {drift:?}");
        // A hundred times the rounding of the run and more: it is the scheme that is looked at.
        assert!(drift.swing > 1e-11, "{name}: {drift:?}");
        assert!(drift.shift < ENDS, "{name}: {drift:?}");
        assert!(drift.growth < 1.01, "{name}: {drift:?}");
    }
    assert!(explicit.shift > 1.0, "rk4: {explicit:?}");
}

#[test]
fn energy_has_no_trend() {
    energy_swings(STEPS);
}

/// `cargo test --release -p residua-models --test invariants -- --ignored --nocapture`
#[test]
#[ignore = "takes minutes"]
fn energy_has_no_trend_over_a_million_steps() {
    energy_swings(MANY_STEPS);
}

/// The trapezoidal rule does not keep |Γ|², but is conjugate to one that does: what it loses in one swing comes back.
#[test]
fn the_trapezoidal_rule_loses_nothing_for_good() {
    use planar_reduced::Model as M;
    let index = scalar_output::<M>("norm_squared");
    let drift = drift::<Ends<M, f64>>(index, STEPS);
    // Some h²ω²/8.
    assert!(drift.swing > 1e-6 && drift.swing < 1e-2, "{drift:?}");
    assert!(drift.shift < ENDS && drift.growth < 1.01, "{drift:?}");
}

/// How far a run of a hundred steps forth and a hundred back ends from its start.
fn way_back<S: Method<f64, Model: Collocated<f64>>>(
    parameters: <S::Model as Model<f64>>::Parameters,
    start: <S::Model as Model<f64>>::State,
) -> f64 {
    let mut forth = run::<S>(parameters, start);
    forth.advance(100).expect("steps of a regular motion");
    let mut back = Integration::<S, f64>::new(parameters, forth.state(), -STEP).expect("numbers");
    back.advance(100).expect("steps of a regular motion");
    let (start, end) = (start.to_array(), back.state_array());
    let pairs = start.as_ref().iter().zip(end.as_ref());
    pairs.fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

/// Symmetric schemes come back to rounding, which the motion stretches by less than a hundred; Runge–Kutta does not.
#[test]
fn symmetric_schemes_find_the_way_back() {
    use spatial_reduced::Model as M;
    let (parameters, start) = asymmetric::<f64>();
    let all = [
        ("midpoint", way_back::<Gauss<M, 1>>(parameters, start)),
        ("gauss2", way_back::<Gauss<M, 2>>(parameters, start)),
        ("gauss5", way_back::<Gauss<M, 5>>(parameters, start)),
        ("gauss8", way_back::<Gauss<M, 8>>(parameters, start)),
        ("trapezoidal", way_back::<Ends<M, f64>>(parameters, start)),
        (
            "composition4",
            way_back::<Composition<M, 5>>(parameters, start),
        ),
        (
            "composition6",
            way_back::<Composition<M, 9>>(parameters, start),
        ),
        (
            "composition8",
            way_back::<Composition<M, 15>>(parameters, start),
        ),
    ];
    for (name, off) in all {
        println!("{name}: {off:e}");
        assert!(off < 100.0 * rounding(200), "{name}: {off:e}");
    }
    let explicit = way_back::<Explicit<M, f64>>(parameters, start);
    assert!(explicit > 1e-6, "rk4: {explicit:e}");
}

//! Every model of the catalogue at its limits, in short; and a solver that is wrong, which must be found.

use residua::description::Solver;
use residua::erased::{AnySolver, Observer, Point, Run, Sample};
use residua::{Fleet, InvalidRun, Outcome, RunError, Statistics};
use residua_models::find;
use residua_tools::stress::{Case, Kind, Verdict, cases, judge, twins};

mod support;

#[test]
fn nothing_is_silently_wrong() {
    let shown = support::succeed("stress --short").stdout;
    let total = shown.lines().last().unwrap();
    let runs: usize = total.split(' ').next().unwrap().parse().unwrap();
    assert!(runs > 2000, "{total}");
    assert!(total.ends_with(" 0 wrong (!)"), "{total}");
}

/// A solver that gives another state than it has computed.
struct Off<'a> {
    solver: &'a dyn AnySolver,
    /// From that step on.
    step: u64,
    /// By that much of its first component.
    share: f64,
}

impl AnySolver for Off<'_> {
    fn solver(&self) -> &'static Solver {
        self.solver.solver()
    }
    fn guess(&self, at: &Point, out: &mut [f64]) {
        self.solver.guess(at, out);
    }
    fn residual(&self, at: &Point, x: &[f64], out: &mut [f64]) {
        self.solver.residual(at, x, out);
    }
    fn jacobian(&self, at: &Point, x: &[f64], out: &mut [f64]) {
        self.solver.jacobian(at, x, out);
    }
    fn dual_jacobian(&self, at: &Point, x: &[f64], out: &mut [f64]) {
        self.solver.dual_jacobian(at, x, out);
    }
    fn next(&self, at: &Point, x: &[f64], out: &mut [f64]) {
        self.solver.next(at, x, out);
    }
    fn simulate(&self, run: &Run, observer: &mut Observer) -> Result<Statistics, RunError> {
        self.solver.simulate(run, &mut |sample| {
            let mut state = sample.state.to_vec();
            if sample.step >= self.step {
                state[0] *= 1.0 + self.share;
            }
            observer(Sample {
                state: &state,
                ..sample
            })
        })
    }
    fn simulate_in_single(
        &self,
        run: &Run,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError> {
        self.solver.simulate_in_single(run, observer)
    }
    fn fly(&self, fleet: &Fleet) -> Result<Vec<Outcome>, InvalidRun> {
        self.solver.fly(fleet)
    }
}

#[test]
fn a_digit_that_is_wrong_is_found() {
    for name in [
        "planar_reduced",
        "spatial_group",
        "elastic",
        "spatial_recursive",
        "spatial_top",
    ] {
        let entry = find(name).unwrap();
        for (solver, twin) in &twins(entry) {
            let cases = cases(entry.catalogued, 0);
            let plain = cases
                .iter()
                .find(|case| case.kind == Kind::Step && case.h == 1e-3);
            let plain = plain.unwrap();
            assert_eq!(judge(*solver, twin, plain, 10), Verdict::Right, "{name}");
            let mut case = plain.clone();
            // Not from rest, where the first component stays 0.
            case.start[0] += 0.3;
            if entry.catalogued.description.scene.is_none() {
                assert_eq!(judge(*solver, twin, &case, 10), Verdict::Right, "{name}");
                let off = Off {
                    solver: *solver,
                    step: 4,
                    share: 1e-8,
                };
                match judge(&off, twin, &case, 10) {
                    Verdict::Wrong(wrong) => assert_eq!((wrong.step, wrong.component), (3, 0)),
                    verdict => panic!("{name}: {verdict:?}"),
                }
            }
        }
    }
}

#[test]
fn input_that_is_not_finite_is_refused() {
    let entry = find("planar_angle").unwrap();
    for (solver, twin) in &twins(entry) {
        let cases = cases(entry.catalogued, 0);
        let cases: Vec<&Case> = cases.iter().filter(|c| c.kind == Kind::NotFinite).collect();
        assert_eq!(cases.len(), 3 * (1 + 4 + 2) + 1);
        for case in cases {
            assert_eq!(judge(*solver, twin, case, 3), Verdict::Refused);
        }
    }
}

use super::{MAX_POINTS, Trace};
use residua::description::{Description, Variable};

static ONE_STATE: Description = Description {
    name: "one",
    doc: "",
    parameters: &[],
    states: &[Variable {
        name: "q",
        ascii: "q",
        rows: 1,
        cols: 1,
        unit: "1",
        dimensionless: true,
        doc: "",
    }],
    outputs: &[],
    solvers: &[],
    claims: &[],
    requirements: &[],
    has_flow: false,
    no_series: None,
    counts: &[],
    operations: 0,
    scene: None,
};

fn points(rows: u64, value: impl Fn(u64) -> f64) -> Vec<(f64, f64)> {
    let mut trace = Trace::new(&ONE_STATE, rows);
    (0..rows).for_each(|i| trace.push(i as f64, &[value(i)]));
    trace.into_panels().remove(0).curves.remove(0).points
}

#[test]
fn short_runs_are_kept_whole() {
    assert_eq!(points(1000, |i| i as f64).len(), 1000);
}

#[test]
fn long_runs_keep_their_peaks_and_their_start() {
    let rows = 1_000_000;
    let peak = 654_321;
    let thinned = points(rows, |i| if i == peak { 9.0 } else { (i as f64).sin() });
    assert!(thinned.len() as u64 <= MAX_POINTS + 3, "{}", thinned.len());
    assert!(thinned.contains(&(peak as f64, 9.0)));
    assert_eq!(thinned[0], (0.0, 0.0));
    assert!(thinned.is_sorted_by(|a, b| a.0 < b.0));
}

#[test]
fn values_that_are_not_finite_leave_a_gap() {
    assert_eq!(points(3, |i| if i == 1 { f64::NAN } else { 1.0 }).len(), 2);
}

//! `residua bench precision`, as users run it, and what its diagrams are made of.

mod support;

use residua_tools::precision::{
    Budget, Given, Ladders, OURS, Problem, Row, contestants, measure, picture, read,
};
use serde_json::Value;
use std::fs;
use support::{assert_refused, folder, residua, succeed};

/// One run of each kind: the errors count here, not the times.
const BRIEF: Budget = Budget {
    runs: 1,
    together: 1.0,
    longest: 1.0,
};

const LADDERS: Ladders = Ladders {
    steps: (0.5, 0.01),
    tolerances: (1e-4, 1e-10),
};

fn problem(scene: &str, until: f64, models: &[&str]) -> Problem {
    let given = Given::named(scene, Some(until)).unwrap();
    let models: Vec<String> = models.iter().map(ToString::to_string).collect();
    Problem::new(scene, given, &models).unwrap()
}

fn rows(problem: &Problem, ladders: &Ladders) -> Vec<Row> {
    let contestants = contestants(problem, ladders);
    measure(problem, &contestants, &BRIEF, &mut |_, _| {})
}

/// The study finds that motion without symmetry; errors between these are neither rounding nor so large that the
/// leading term is hidden.
///
/// In double precision higher orders fall from where the leading term is hidden to rounding within two halvings, and no slope
/// can be read off. `orders` and `taylor` measure them all to ±0.25 in double-double numbers; here they must get there.
#[test]
fn errors_fall_with_the_order_of_the_scheme() {
    const SEEN: std::ops::Range<f64> = 1e-12..1e-3;
    const HIGH: usize = 6;
    /// Rounding of 25 000 steps, magnified by a swing up to 163°.
    const THERE: f64 = 1e-10;
    let problem = problem("planar-large", 5.0, &["planar_angle"]);
    // Low orders are there with short steps only.
    let ladders = Ladders {
        steps: (0.5, 2e-4),
        ..LADDERS
    };
    let rows = rows(&problem, &ladders);
    let (mut judged, mut all) = (Vec::new(), Vec::new());
    for contestant in contestants(&problem, &ladders) {
        let Some(order) = contestant.order else {
            continue;
        };
        let scheme = &contestant.scheme;
        all.push(scheme.clone());
        let own = rows
            .iter()
            .filter(|row| row.by == OURS && row.scheme == *scheme);
        let own: Vec<f64> = own.map(|row| row.trajectory).collect();
        if order > HIGH {
            let last = own[own.len() - 1];
            // A NaN fails.
            assert!(last <= THERE, "{scheme}: {own:?}");
            judged.push(scheme.clone());
            continue;
        }
        let own: Vec<f64> = own.into_iter().filter(|e| SEEN.contains(e)).collect();
        let [coarse, .., fine] = own[..] else {
            continue;
        };
        // Over all halvings: a single one can start or end where the leading term passes zero.
        let slope = (coarse / fine).log2() / (own.len() - 1) as f64;
        println!("{scheme}: {slope:.2} of {order}");
        // Coarse steps are not yet where the leading term is alone.
        let order = order as f64;
        let theory = order - 0.5..order + 1.0;
        assert!(
            theory.contains(&slope),
            "{scheme}: {slope} of {order}, {own:?}"
        );
        judged.push(scheme.clone());
    }
    let left: Vec<&String> = all.iter().filter(|all| !judged.contains(all)).collect();
    assert!(left.is_empty(), "not judged: {left:?}");
}

#[test]
fn tolerances_are_met_within_what_the_motion_magnifies() {
    let problem = problem("planar-paper", 10.0, &["planar_angle"]);
    for row in rows(&problem, &LADDERS)
        .iter()
        .filter(|row| row.by == OURS && row.tolerance.is_some())
    {
        // Errors of five periods of a swing add up, no more.
        let (tolerance, error) = (row.tolerance.unwrap(), row.trajectory);
        assert!(
            error <= 1e3 * tolerance,
            "{} {}: {error:e} for {tolerance:e}",
            row.by,
            row.scheme
        );
    }
}

#[test]
fn formulations_of_a_scene_are_the_models_that_take_its_motion() {
    let names = |scene: &str| {
        let problem = problem(scene, 2.0, &[]);
        let names = problem.formulations.iter().map(|of| of.name());
        names.collect::<Vec<_>>()
    };
    let planar = names("paper_planar");
    for model in [
        "paper_planar",
        "planar_angle",
        "planar_reduced",
        "planar_group",
    ] {
        assert!(planar.contains(&model), "{model} of {planar:?}");
    }
    let spatial = names("spatial-asymmetric");
    for model in ["spatial_group", "spatial_cardan", "spatial_asymmetric"] {
        assert!(spatial.contains(&model), "{model} of {spatial:?}");
    }
    assert!(!spatial.contains(&"paper_spatial"), "{spatial:?}");
    // A model of which there is no other, and of which nobody has a closed form.
    assert_eq!(names("lattice"), ["lattice"]);
}

#[test]
fn exact_ends_are_the_same_by_series_and_by_extrapolation() {
    // From the study's scene in closed form, and from the model of that motion by its own flow.
    let closed = problem("planar-paper", 10.0, &["planar_angle"]);
    let extrapolated = problem("planar_angle", 10.0, &["planar_angle"]);
    for (a, b) in closed.exact.state.iter().zip(&extrapolated.exact.state) {
        // Both are rounded once; the sizes are below 1.
        assert!((a - b).abs() <= 2e-16, "{a} and {b}");
    }
}

#[test]
fn lanes_that_fail_leave_gaps() {
    let line = "bench precision elastic --set c=1e6 --schemes rk4,next --until 1 --step 0.1..0.001 --runs 1 --quiet";
    let out = folder("precision_gaps");
    succeed(&format!("{line} --out {}", out.display()));
    let rows = read(fs::File::open(out.join("elastic.csv")).unwrap()).unwrap();
    let failed = rows.iter().filter(|row| !row.failure.is_empty());
    assert!(failed.clone().any(|row| row.scheme == "rk4"), "{rows:?}");
    for row in failed {
        assert!(row.seconds.is_nan() && row.trajectory.is_nan() && row.energy.is_nan());
    }
    let svg = fs::read_to_string(out.join("elastic.svg")).unwrap();
    roxmltree::Document::parse(&svg).unwrap();
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
}

#[test]
fn command_writes_a_table_a_picture_and_a_description() {
    let out = folder("precision");
    let line = "bench precision planar-paper --models planar_angle,planar_reduced --schemes rk4,gauss4,gauss8,adaptive-gauss8,next";
    let rest = "--until 5 --step 1..0.01 --tolerance 1e-3..1e-9 --runs 3";
    let outcome = succeed(&format!("{line} {rest} --out {}", out.display()));
    assert!(
        outcome.stderr.is_empty(),
        "no terminal, no progress: {}",
        outcome.stderr
    );
    let text = outcome.stdout;
    for part in [
        "elliptic functions",
        "for 10⁻³ on this scene use ",
        "for 10⁻⁹ on this scene use ",
        "µs",
    ] {
        assert!(text.contains(part), "no `{part}` in\n{text}");
    }
    let rows = read(fs::File::open(out.join("planar-paper.csv")).unwrap()).unwrap();
    let steps = rows
        .iter()
        .filter(|row| row.scheme == "rk4" && row.model == "planar_angle");
    let steps: Vec<f64> = steps.filter_map(|row| row.step).collect();
    // 5 s/2ᵏ between 1 s and 0.01 s.
    assert_eq!(steps, [3, 4, 5, 6, 7, 8].map(|k| 5.0 / f64::from(1 << k)));
    let tolerances = rows.iter().filter_map(|row| row.tolerance);
    assert!(
        tolerances.clone().any(|t| t == 1e-3)
            && tolerances.clone().all(|t| (1e-9..=1e-3).contains(&t))
    );
    assert!(
        rows.iter()
            .all(|row| row.failure.is_empty() == (row.seconds > 0.0))
    );
    assert!(
        rows.iter()
            .filter(|row| row.seconds > 0.0)
            .all(|row| row.runs >= 1)
    );

    let svg = fs::read_to_string(out.join("planar-paper.svg")).unwrap();
    let svg = roxmltree::Document::parse(&svg).unwrap();
    let texts: Vec<&str> = svg.descendants().filter_map(|node| node.text()).collect();
    for part in [
        "trajectory error",
        "phase error",
        "energy error",
        "constraint error",
        "time [s]",
    ] {
        assert!(
            texts.iter().any(|text| text.contains(part)),
            "no `{part}` in {texts:?}"
        );
    }
    let json = fs::read_to_string(out.join("planar-paper.json")).unwrap();
    let json: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["parameters"]["J"][0], 0.48);
    assert_eq!(json["start"]["omega"][0], 1.0);
}

#[test]
fn pictures_have_a_panel_per_kind_of_error_that_there_is() {
    let problem = problem("planar_angle", 1.0, &["planar_angle"]);
    let ladders = Ladders {
        steps: (0.25, 0.1),
        ..LADDERS
    };
    let picture = picture(&problem, &rows(&problem, &ladders));
    // An angle has no constraint to violate.
    assert_eq!(picture.panels.len(), 3);
}

#[test]
fn bad_input_is_refused() {
    let refused = [
        (
            "planar-lrge",
            &[
                "no scene or model `planar-lrge`",
                "did you mean `planar-large`?",
            ][..],
        ),
        (
            "planar-large --models spatial_group",
            &["`spatial_group` does not take the motion of `planar-large`"],
        ),
        (
            "planar-large --models spatial_grup",
            &["no model `spatial_grup`", "did you mean `spatial_group`?"],
        ),
        (
            "planar-large --schemes rk5",
            &["no formulation has a scheme `rk5`", "rk4"],
        ),
        (
            "planar-large --until -1",
            &["the end time is -1, not a positive number"],
        ),
        (
            "planar-large --limit 0",
            &["the time limit is 0, not a positive number"],
        ),
        ("planar-large --step 0.1", &["write FROM..TO"]),
        ("planar-large --step 0.1..1", &["the coarsest comes first"]),
        (
            "planar-large --step 1.1e-3..1.0e-3 --schemes rk4 --models planar_angle",
            &["no T/2ᵏ of T = 50 is between"],
        ),
        (
            "planar-large --tolerance 1e-3..1e-20",
            &["tolerances go from below 1 to 1e-16"],
        ),
        (
            "planar-large --set m=3",
            &["`planar-large` has values of its own"],
        ),
        ("planar_angle --set q=3", &["no parameter `q`"]),
        (
            "planar_angle --start ω=0",
            &["nothing moves in `planar_angle`"],
        ),
        ("", &["required arguments"]),
    ];
    for (line, parts) in refused {
        assert_refused(&residua(&format!("bench precision {line}")), 2, parts);
    }
}

//! Figures 5 to 17: the planar pendulum over 50 s.

use super::Extra;
use super::Line;
use super::Plan;
use super::check::Check;
use crate::report::runs::Method;
use crate::report::runs::Wanted;

/// The run of the paper, s.
pub const UNTIL: f64 = 50.0;

const ALL: (f64, f64) = (0.0, UNTIL);
const FIRST: (f64, f64) = (0.0, 5.0);
const LAST: (f64, f64) = (45.0, UNTIL);

/// Step of Figures 5 to 8.
pub const COARSE: f64 = 0.1;
/// Step of Figures 10 and 11.
const MIDDLE: f64 = 0.02;
/// The larger and the smaller step of Figure 12.
const LARGE: f64 = 0.05;
const SMALL: f64 = 0.01;

const WHY_LAST: &str = "The paper names no window; the last 5 s of the 50 s show the most.";

fn why_coarse() -> String {
    format!(
        "The paper gives no h. At small h Runge–Kutta 4 loses less in 50 s than a line is wide (verdict and table of \
         Figure 5), so what the paper describes needs a large one: {COARSE} s, which it uses in 3D."
    )
}

fn why_middle() -> String {
    format!(
        "The paper gives no h. At {MIDDLE} s the curves still coincide in the first 5 s and part visibly in the last \
         5 s, as the text says; at {LARGE} s they part in the first 5 s already."
    )
}

fn why_small_last() -> String {
    format!(
        "The paper gives neither h nor window: h = {SMALL} s, at which its next figures call the results good, and the \
         last 5 s, which show the most."
    )
}

const ANGLE: &[&str] = &["θ", "ω"];

fn line(label: &'static str, model: &'static str, form: &'static str, step: f64) -> Line {
    let method = Method::Newton(form);
    Line {
        label,
        run: Wanted {
            model,
            method,
            step,
            until: UNTIL,
        },
    }
}

/// The angle model by Runge–Kutta 4.
pub fn runge_kutta(step: f64) -> Wanted {
    Wanted {
        model: "planar_angle",
        method: Method::RungeKutta4,
        step,
        until: UNTIL,
    }
}

/// The angle model by Eq. 42.
pub fn difference(step: f64) -> Wanted {
    line("", "planar_angle", "next", step).run
}

fn rk4_and_difference() -> Vec<Line> {
    let rk4 = Line {
        label: "Runge–Kutta 4",
        run: runge_kutta(COARSE),
    };
    vec![
        rk4,
        line("difference, Eq. 42", "planar_angle", "next", COARSE),
    ]
}

fn forms(model: &'static str, labels: [&'static str; 2], step: f64) -> Vec<Line> {
    vec![
        line(labels[0], model, "next", step),
        line(labels[1], model, "increment", step),
    ]
}

fn plan(
    number: u8,
    title: &'static str,
    curves: Vec<Line>,
    window: (f64, f64),
    choice: impl Into<String>,
    extra: Extra,
    check: Check,
) -> Plan {
    Plan {
        number,
        title,
        curves,
        quantities: ANGLE,
        window,
        choice: choice.into(),
        extra,
        check,
    }
}

/// The figures.
pub fn plans() -> Vec<Plan> {
    let angle = ["Eq. 42", "Eq. 45"];
    let reduced = ["Eq. 49", "Eq. 52"];
    let group = ["Eq. 58", "Eq. 59"];
    let algebra = ["Eq. 62", "Eq. 63"];
    let both = || {
        vec![
            line("reduced, Eq. 49", "planar_reduced", "next", MIDDLE),
            line("angle, Eq. 42", "planar_angle", "next", MIDDLE),
        ]
    };
    let steps = vec![
        line("h = 0.05 s", "planar_reduced", "next", LARGE),
        line("h = 0.01 s", "planar_reduced", "next", SMALL),
    ];
    let recursive = vec![line(
        "recursive, Eq. 55",
        "planar_recursive",
        "increment",
        SMALL,
    )];
    let one_algebra = vec![line("algebra, Eq. 62", "planar_algebra", "next", SMALL)];
    vec![
        plan(
            5,
            "Runge–Kutta 4 and the difference method over 50 s",
            rk4_and_difference(),
            ALL,
            why_coarse(),
            Extra::Amplitude,
            Check::Damping,
        ),
        plan(
            6,
            "Runge–Kutta 4 and the difference method, first 5 s",
            rk4_and_difference(),
            FIRST,
            why_coarse(),
            Extra::Error,
            Check::FirstSeconds,
        ),
        plan(
            7,
            "Runge–Kutta 4 and the difference method, last 5 s",
            rk4_and_difference(),
            LAST,
            why_coarse(),
            Extra::Error,
            Check::LastSeconds,
        ),
        plan(
            8,
            "The two difference forms of the angle model",
            forms("planar_angle", angle, COARSE),
            LAST,
            why_coarse(),
            Extra::Forms,
            Check::Forms,
        ),
        plan(
            9,
            "The two difference forms in reduced attitude",
            forms("planar_reduced", reduced, SMALL),
            LAST,
            why_small_last(),
            Extra::Forms,
            Check::Forms,
        ),
        plan(
            10,
            "Reduced attitude and angle against the exact solution, first 5 s",
            both(),
            FIRST,
            why_middle(),
            Extra::Error,
            Check::CoincideFirst,
        ),
        plan(
            11,
            "Reduced attitude and angle against the exact solution, last 5 s",
            both(),
            LAST,
            why_middle(),
            Extra::Error,
            Check::PartLast,
        ),
        plan(
            12,
            "Reduced attitude with two time steps",
            steps,
            LAST,
            WHY_LAST,
            Extra::Error,
            Check::Steps,
        ),
        plan(
            13,
            "The recursive method against the exact solution",
            recursive,
            LAST,
            WHY_LAST,
            Extra::Error,
            Check::CoincideLast,
        ),
        plan(
            14,
            "The two difference forms of the complete group, h = 0.05 s",
            forms("planar_group", group, LARGE),
            LAST,
            "",
            Extra::Forms,
            Check::GroupForms,
        ),
        plan(
            15,
            "The complete group against the exact solution, h = 0.01 s",
            forms("planar_group", group, SMALL),
            LAST,
            WHY_LAST,
            Extra::Error,
            Check::CoincideLast,
        ),
        plan(
            16,
            "The two difference forms in the Lie algebra",
            forms("planar_algebra", algebra, SMALL),
            LAST,
            why_small_last(),
            Extra::Forms,
            Check::Forms,
        ),
        plan(
            17,
            "The Lie algebra against the exact solution",
            one_algebra,
            LAST,
            WHY_LAST,
            Extra::Error,
            Check::CoincideLast,
        ),
    ]
}

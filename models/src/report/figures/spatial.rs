//! Figures 18 to 27: the 3D pendulum over 100 s.

use super::Extra;
use super::Line;
use super::Plan;
use super::check::Check;
use crate::report::runs::Method;
use crate::report::runs::Wanted;

/// The run of the paper, [s].
const UNTIL: f64 = 100.0;
const LAST: (f64, f64) = (95.0, UNTIL);

const VELOCITY: &[&str] = &["ω.x", "ω.y", "ω.z"];

const WHY_VERTICAL: &str = "The paper does not say which attitude it plots: the vertical in the body frame, \
    which is what Eq. 70 solves for.";
const WHY_WINDOW: &str = "The paper names no window; the last 5 s of the 100 s, as in Figures 18 and 19. The \
    run with h = 0.01 s is added to judge what is said of the time step.";
const WHY_ROW: &str = "The paper names no window and does not say what the attitude of an axis is: the last \
    5 s, and the row of R that belongs to the axis, an unknown of Eq. 82. The run with h = 0.01 s is added to \
    judge what is said of the time step.";
const WHY_CARDAN: &str = "The paper names no window; the last 5 s of the 100 s. Eq. 86 is used in the order \
    of rotations that the paper's start has, not in that of its misprint.";

fn line(label: &'static str, model: &'static str, step: f64) -> Line {
    let form = match model {
        "spatial_reduced" => "next",
        _ => "increment",
    };
    Line {
        label,
        run: Wanted {
            model,
            method: Method::Newton(form),
            step,
            until: UNTIL,
        },
    }
}

fn plan(
    number: u8,
    title: &'static str,
    curves: Vec<Line>,
    quantities: &'static [&'static str],
    choice: &'static str,
    check: Check,
) -> Plan {
    Plan {
        number,
        title,
        curves,
        quantities,
        window: LAST,
        choice,
        extra: Extra::None,
        check,
    }
}

/// The complete group by Eq. 82.
pub fn group(step: f64) -> Wanted {
    line("", "spatial_group", step).run
}

/// The figures.
pub fn plans() -> Vec<Plan> {
    let recursive = || vec![line("Eq. 70, h = 0.05 s", "spatial_recursive", 0.05)];
    let reduced = || {
        vec![
            line("h = 0.1 s", "spatial_reduced", 0.1),
            line("h = 0.01 s", "spatial_reduced", 0.01),
        ]
    };
    let group = || {
        vec![
            line("h = 0.1 s", "spatial_group", 0.1),
            line("h = 0.01 s", "spatial_group", 0.01),
        ]
    };
    let cardan = || {
        vec![
            line("h = 0.01 s", "spatial_cardan", 0.01),
            line("h = 0.005 s", "spatial_cardan", 0.005),
        ]
    };
    let (stable, steps) = (Check::Stable, Check::StableAndSteps);
    let vertical = &["vertical.x", "vertical.y", "vertical.z"];
    let reduced_vertical = &["Γ.x", "Γ.y", "Γ.z"];
    let (x, y, z) = (
        &["Γ1.x", "Γ1.y", "Γ1.z"],
        &["Γ2.x", "Γ2.y", "Γ2.z"],
        &["Γ3.x", "Γ3.y", "Γ3.z"],
    );
    let angles = &["θx", "θy", "θz"];
    vec![
        plan(
            18,
            "Angular velocity, recursive form",
            recursive(),
            VELOCITY,
            "",
            stable,
        ),
        plan(
            19,
            "Attitude, recursive form",
            recursive(),
            vertical,
            WHY_VERTICAL,
            stable,
        ),
        plan(
            20,
            "Angular velocity, reduced attitude (Eq. 77)",
            reduced(),
            VELOCITY,
            WHY_WINDOW,
            steps,
        ),
        plan(
            21,
            "Attitude, reduced attitude",
            reduced(),
            reduced_vertical,
            WHY_WINDOW,
            steps,
        ),
        plan(
            22,
            "Angular velocity, complete group (Eq. 82)",
            group(),
            VELOCITY,
            WHY_WINDOW,
            steps,
        ),
        plan(
            23,
            "Attitude of the x axis, complete group",
            group(),
            x,
            WHY_ROW,
            steps,
        ),
        plan(
            24,
            "Attitude of the y axis, complete group",
            group(),
            y,
            WHY_ROW,
            steps,
        ),
        plan(
            25,
            "Attitude of the z axis, complete group",
            group(),
            z,
            WHY_ROW,
            steps,
        ),
        plan(
            26,
            "Angular velocity, Cardan angles (Eq. 86)",
            cardan(),
            VELOCITY,
            WHY_CARDAN,
            Check::Cardan,
        ),
        plan(
            27,
            "Attitude, Cardan angles",
            cardan(),
            angles,
            WHY_CARDAN,
            Check::Cardan,
        ),
    ]
}

//! Figures 18 to 27: the 3D pendulum over 100 s.

use super::Extra;
use super::Line;
use super::Plan;
use super::check::Check;
use crate::report::runs::Method;
use crate::report::runs::Wanted;

/// The run of the paper, s.
const UNTIL: f64 = 100.0;
const LAST: (f64, f64) = (95.0, UNTIL);

const VELOCITY: &[&str] = &["ω.x", "ω.y", "ω.z"];

const WHY_VERTICAL: &str = "The paper does not say which attitude it plots: the vertical in the body frame, \
    which is what Eq. 70 solves for.";
const WHY_CARDAN: &str = "The paper names no window; the last 5 s of the 100 s. The curves are those of Eq. 86 \
    brought into the order R = Rx Ry Rz of the paper’s start; Eq. 86 as printed is for the order R = Rz Ry Rx, and \
    stands in the table of Figure 26.";

/// Steps of Figures 18 and 19, and of 20 to 25 with the finer one that is compared.
const RECURSIVE: f64 = 0.05;
const COARSE: f64 = 0.1;
const FINE: f64 = 0.01;

fn why_window() -> String {
    format!(
        "The paper names no window; the last 5 s of the 100 s, as in Figures 18 and 19. The run with h = {FINE} s is \
         added to judge what is said of the time step."
    )
}

fn why_row() -> String {
    format!(
        "The paper names no window and does not say what the attitude of an axis is: the last 5 s, and the row of R \
         that belongs to the axis, an unknown of Eq. 82. The run with h = {FINE} s is added to judge what is said of \
         the time step."
    )
}

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
    choice: impl Into<String>,
    check: Check,
) -> Plan {
    Plan {
        number,
        title,
        curves,
        quantities,
        window: LAST,
        choice: choice.into(),
        extra: Extra::None,
        check,
    }
}

/// The complete group by Eq. 82.
pub fn group(step: f64) -> Wanted {
    line("", "spatial_group", step).run
}

/// The Cardan angles: by Eq. 86 as printed, which is for R = Rz Ry Rx, or in the order R = Rx Ry Rz.
pub fn cardan(as_printed: bool, step: f64) -> Wanted {
    let model = match as_printed {
        true => "spatial_cardan_zyx",
        false => "spatial_cardan",
    };
    line("", model, step).run
}

/// The figures.
pub fn plans() -> Vec<Plan> {
    let recursive = || vec![line("Eq. 70, h = 0.05 s", "spatial_recursive", RECURSIVE)];
    let reduced = || {
        vec![
            line("h = 0.1 s", "spatial_reduced", COARSE),
            line("h = 0.01 s", "spatial_reduced", FINE),
        ]
    };
    let group = || {
        vec![
            line("h = 0.1 s", "spatial_group", COARSE),
            line("h = 0.01 s", "spatial_group", FINE),
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
            why_window(),
            steps,
        ),
        plan(
            21,
            "Attitude, reduced attitude",
            reduced(),
            reduced_vertical,
            why_window(),
            steps,
        ),
        plan(
            22,
            "Angular velocity, complete group (Eq. 82)",
            group(),
            VELOCITY,
            why_window(),
            steps,
        ),
        plan(
            23,
            "Attitude of the x axis, complete group",
            group(),
            x,
            why_row(),
            steps,
        ),
        plan(
            24,
            "Attitude of the y axis, complete group",
            group(),
            y,
            why_row(),
            steps,
        ),
        plan(
            25,
            "Attitude of the z axis, complete group",
            group(),
            z,
            why_row(),
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

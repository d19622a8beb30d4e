//! Figures 5 to 27 of the paper: what each shows, computed again, and whether what is said of it holds.
//!
//! Comes in: the lists in `planar` and `spatial`. Goes out: a section with a part for each figure.

mod check;
mod draw;
mod planar;
mod spatial;

use super::measure::Measure;
use super::page::Block;
use super::page::Cell;
use super::page::Data;
use super::page::Section;
use super::page::Table;
use super::runs::Method;
use super::runs::Recording;
use super::runs::RunError;
use super::runs::Runs;
use super::runs::Wanted;
use check::Check;
use indicatif::ProgressBar;

/// A figure of the paper.
struct Plan {
    /// As the paper counts.
    number: u8,
    /// What it shows, in our words.
    title: &'static str,
    /// The curves, in legend order.
    curves: Vec<Line>,
    /// Columns of the runs, a panel for each.
    quantities: &'static [&'static str],
    /// From and to, [s].
    window: (f64, f64),
    /// Why this step and this window, where the paper does not give them.
    choice: &'static str,
    /// What one more panel shows.
    extra: Extra,
    /// What judges the figure.
    check: Check,
}

/// A curve.
#[derive(Clone)]
struct Line {
    label: &'static str,
    run: Wanted,
}

/// What a panel below the others shows.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Extra {
    /// Nothing.
    None,
    /// The first quantity less its exact value.
    Error,
    /// The amplitude of the swing through each state.
    Amplitude,
    /// The first quantity of the second run less that of the first.
    Forms,
}

/// A curve with its data.
struct Drawn<'a> {
    line: &'a Line,
    made: &'a Recording,
    exact: &'a Recording,
}

/// A figure with its data.
struct Scene<'a> {
    plan: &'a Plan,
    curves: Vec<Drawn<'a>>,
    measures: Vec<Measure>,
}

/// The section with all figures.
pub fn section(progress: &ProgressBar) -> Result<Section, RunError> {
    let plans: Vec<Plan> = planar::plans()
        .into_iter()
        .chain(spatial::plans())
        .collect();
    let wanted: Vec<Wanted> = plans
        .iter()
        .flat_map(|plan| plan.curves.iter().map(|line| line.run))
        .collect();
    progress.inc_length(plans.len() as u64);
    let runs = Runs::make(&wanted, progress)?;
    let mut parts = Vec::new();
    for plan in &plans {
        parts.push(part(&scene(plan, &runs)?)?);
        progress.inc(1);
    }
    Ok(Section {
        id: "figures".to_owned(),
        title: "Figures 5 to 27".to_owned(),
        blocks: introduction(),
        parts,
    })
}

fn introduction() -> Vec<Block> {
    let texts = [
        "Every figure of Section 6, with the quantities and windows that caption and text name. Pale bands \
         are the exact solution, the “standard results” of the paper. Equations have the numbers printed \
         beside them; the text of the paper often counts one higher.",
        "Two curves coincide here while they differ by less than a hundredth of the range of the exact \
         angle, the width of a line in a plot. The lag is how much later than in the exact solution the \
         last full swing ends. Amplitude is that of the swing through the state, averaged over the last \
         5 s; energy is a share of what the swing has above rest.",
    ];
    texts.map(|text| Block::Text(text.to_owned())).into()
}

fn scene<'a>(plan: &'a Plan, runs: &'a Runs) -> Result<Scene<'a>, RunError> {
    let (mut curves, mut measures) = (Vec::new(), Vec::new());
    for line in &plan.curves {
        let made = runs.get(&line.run);
        let exact = runs.exact(&line.run);
        measures.push(Measure::of(&line.run, made, exact)?);
        curves.push(Drawn { line, made, exact });
    }
    Ok(Scene {
        plan,
        curves,
        measures,
    })
}

fn part(scene: &Scene<'_>) -> Result<Section, RunError> {
    let number = scene.plan.number;
    let mut blocks = vec![Block::Figure(draw::figure(scene)?), facts(scene)];
    blocks.extend(check::check(scene)?);
    blocks.push(Block::Table(table(scene)));
    Ok(Section {
        id: format!("figure-{number}"),
        title: format!("Figure {number}. {}", scene.plan.title),
        blocks,
        parts: Vec::new(),
    })
}

fn facts(scene: &Scene<'_>) -> Block {
    let (from, to) = scene.plan.window;
    let mut facts = vec![("Window".to_owned(), format!("{from} s to {to} s"))];
    for Drawn { line, made, .. } in &scene.curves {
        let how = describe(&line.run);
        let failed = made.failure.as_ref();
        let ended = failed.map_or(String::new(), |failure| format!("; ended early: {failure}"));
        facts.push((line.label.to_owned(), how + &ended));
    }
    if !scene.plan.choice.is_empty() {
        facts.push(("Our choice".to_owned(), scene.plan.choice.to_owned()));
    }
    Block::Facts(facts)
}

/// `planar_angle, solved for next, h = 0.1 s, 50 s`
fn describe(run: &Wanted) -> String {
    let Wanted {
        model, step, until, ..
    } = run;
    let method = match run.method {
        Method::Newton(form) => format!("solved for {form}"),
        Method::RungeKutta4 => "continuous equations by Runge–Kutta 4".to_owned(),
    };
    format!("{model}, {method}, h = {step} s, to {until} s")
}

/// The runs of a figure against the exact solution.
fn table(scene: &Scene<'_>) -> Table {
    let number = scene.plan.number;
    let planar = scene.curves.iter().all(|c| c.line.run.is_planar());
    let mut head = vec![
        "curve",
        "h [s]",
        "off, first 5 s [rad]",
        "off, last 5 s [rad]",
        "off, last 5 s [% of range]",
        "coincides until [s]",
        "lag [s]",
        "amplitude [%]",
        "energy error",
    ];
    if !planar {
        head.push("ω off its axis");
    }
    head.push("iterations");
    let mut data = Data::new(&head);
    for (curve, measure) in scene.curves.iter().zip(&scene.measures) {
        let mut row: Vec<Cell> = vec![
            curve.line.label.into(),
            Cell::given(measure.run.step),
            measure.first.into(),
            measure.last.into(),
            (100.0 * measure.last_share()).into(),
            measure.coincides_until.into(),
            measure.lag.into(),
            Cell::number(100.0 * measure.amplitude_change, 2),
            Cell::number(measure.energy_error, 2),
        ];
        if !planar {
            row.push(Cell::number(measure.off_axis, 2));
        }
        let implicit = measure.iterations > 0.0;
        row.push(implicit.then_some(measure.iterations).into());
        data.row(row);
    }
    Table {
        csv: format!("figure-{number:02}-numbers"),
        caption: format!(
            "Figure {number} in numbers: each curve against the exact solution over the whole run; iterations are Newton’s per step."
        ),
        data,
    }
}

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
    /// From and to, s.
    window: (f64, f64),
    /// Why this step and this window, where the paper does not give them.
    choice: String,
    /// What one more panel shows.
    extra: Extra,
    /// What judges the figure.
    check: Check,
}

impl Plan {
    /// It says the same as `other` of the same runs.
    fn says_of(&self, other: &Plan) -> bool {
        let runs = |plan: &Plan| plan.curves.iter().map(|line| line.run).collect::<Vec<_>>();
        self.check == other.check && runs(self) == runs(other)
    }
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
    for (i, plan) in plans.iter().enumerate() {
        let same = plans[..i].iter().find(|earlier| earlier.says_of(plan));
        let earlier = same.map(|earlier| earlier.number);
        parts.push(part(&scene(plan, &runs)?, earlier)?);
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
         5 s; energy is a share of what the swing has above rest. In space, tilt is the angle of the pendulum in \
         the vertical plane that it starts in, the one angle of the exact swing; how far it has left this plane \
         is told by the part of ω across the axis of the exact swing, as a share of the largest ω.",
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

/// The part of a figure; `earlier` is the number of one that says the same of the same runs.
fn part(scene: &Scene<'_>, earlier: Option<u8>) -> Result<Section, RunError> {
    let number = scene.plan.number;
    let mut blocks = vec![Block::Figure(draw::figure(scene)?), facts(scene)];
    let said = check::check(scene)?;
    blocks.extend(match earlier {
        Some(earlier) => check::repeated(said, earlier),
        None => said,
    });
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
        facts.push(("Our choice".to_owned(), scene.plan.choice.clone()));
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
    let mut head = vec!["curve", "h [s]"];
    head.extend(match planar {
        true => [
            "off, first 5 s [rad]",
            "off, last 5 s [rad]",
            "off, last 5 s [% of range]",
            "coincides until [s]",
        ],
        false => [
            "tilt off, first 5 s [rad]",
            "tilt off, last 5 s [rad]",
            "tilt off, last 5 s [% of range]",
            "tilt coincides until [s]",
        ],
    });
    head.extend(["lag [s]", "lag [periods]", "amplitude [%]", "energy error"]);
    if !planar {
        head.extend(["ω off its axis", "plane off by 1 % from [s]"]);
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
            (measure.lag / measure.period).into(),
            Cell::number(100.0 * measure.amplitude_change, 2),
            Cell::number(measure.energy_error, 2),
        ];
        if !planar {
            row.push(Cell::number(measure.off_axis, 2));
            row.push(measure.plane_lost().into());
        }
        let implicit = measure.iterations > 0.0;
        row.push(implicit.then_some(measure.iterations).into());
        data.row(row);
    }
    Table {
        csv: format!("figure-{number:02}-numbers"),
        caption: format!(
            "Figure {number} in numbers: each curve against the exact solution over the whole run; iterations are Newton’s per \
             step. From a lag of half a period on, the distance in % of the range tells no more how far apart the \
             curves are: the lag in periods does."
        ),
        data,
    }
}

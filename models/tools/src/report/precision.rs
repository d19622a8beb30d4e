//! Time against error: short work–precision diagrams of a motion in the plane, one in space and a stiff one.

use super::page::Block;
use super::page::Cell;
use super::page::Data;
use super::page::Diagram;
use super::page::Section;
use super::page::Table;
use super::runs::RunError;
use crate::precision::Budget;
use crate::precision::Given;
use crate::precision::Kind;
use crate::precision::LEVELS;
use crate::precision::Ladders;
use crate::precision::Problem;
use crate::precision::Row;
use crate::precision::Unsolvable;
use crate::precision::contestants;
use crate::precision::measure;
use crate::precision::name;
use crate::precision::picture;
use crate::precision::verdicts;
use indicatif::ProgressBar;

/// Motions and the models that take them here, one scheme of the paper among them, but for the last: a spring so stiff that
/// explicit schemes crawl where implicit ones stride.
const MOTIONS: [(&str, &[&str]); 3] = [
    ("planar-large", &["planar_angle", "planar_reduced"]),
    ("spatial-asymmetric", &["spatial_reduced", "spatial_cardan"]),
    ("elastic_stiff", &["elastic"]),
];

/// Ends of the motions, s.
const UNTIL: f64 = 10.0;

/// Steps and tolerances: from those that lose the motion to rounding.
const LADDERS: Ladders = Ladders {
    steps: (0.5, 1e-3),
    tolerances: (1e-3, 1e-13),
};

/// A page is made in a minute: few of the runs of `residua bench precision`, and short ones.
const BUDGET: Budget = Budget {
    runs: 3,
    together: 0.004,
    longest: 0.003,
};

/// The section.
///
/// # Errors
/// Motions that have no exact end, of which there are none here.
pub fn section(progress: &ProgressBar) -> Result<Section, RunError> {
    let text = "Every scheme that can be made of the equations of motion, on models of the same motion: how long it takes, and how \
                far from the exact motion it ends. Schemes with equal steps take those of T/2ᵏ, those that choose their steps \
                powers of ten as tolerances. Times are the shortest of a few runs on the machine that made this page; \
                `residua bench precision` takes more of them.";
    let mut blocks = vec![Block::Text(text.to_owned())];
    for (scene, models) in MOTIONS {
        blocks.extend(motion(scene, models, progress).map_err(unsolvable)?);
    }
    Ok(Section {
        id: "precision".to_owned(),
        title: "Time against error".to_owned(),
        blocks,
        parts: Vec::new(),
    })
}

fn unsolvable(why: Unsolvable) -> RunError {
    RunError::Precision(why.to_string())
}

fn motion(scene: &str, models: &[&str], progress: &ProgressBar) -> Result<[Block; 2], Unsolvable> {
    let given = Given::named(scene, Some(UNTIL))?;
    let models: Vec<String> = models.iter().map(ToString::to_string).collect();
    let problem = Problem::new(scene, given, &models)?;
    let all = contestants(&problem, &LADDERS);
    progress.inc_length(1);
    let rows = measure(&problem, &all, &BUDGET, &mut |_, _| {});
    progress.inc(1);
    let diagram = Diagram {
        csv: format!("precision-{scene}"),
        caption: format!("Time against error: {}.", problem.caption),
        plot: picture(&problem, &rows),
        data: data(&rows),
    };
    Ok([Block::Diagram(diagram), Block::Table(fastest(scene, &rows))])
}

fn data(rows: &[Row]) -> Data {
    let kinds = Kind::ALL.map(Kind::title);
    let mut head = vec!["scheme", "model", "step [s]", "tolerance", "time [s]"];
    head.extend(kinds);
    let mut data = Data::new(&head);
    for row in rows {
        let mut cells = vec![
            Cell::Code(row.scheme.clone()),
            Cell::Code(row.model.clone()),
            row.step.into(),
            row.tolerance.into(),
            row.seconds.into(),
        ];
        cells.extend(Kind::ALL.map(|kind| row.error(kind).into()));
        data.row(cells);
    }
    data
}

fn fastest(scene: &str, rows: &[Row]) -> Table {
    let mut data = Data::new(&[
        "error of the end",
        "fastest that chooses its steps",
        "time [µs]",
        "fastest with equal steps",
        "time [µs]",
    ]);
    for verdict in verdicts(rows, Kind::Trajectory, &LEVELS) {
        let cells = |row: Option<&Row>| match row {
            Some(row) => [Cell::Text(name(row)), (1e6 * row.seconds).into()],
            None => [Cell::Empty, Cell::Empty],
        };
        let [ours, time] = cells(verdict.ours);
        let [fixed, its_time] = cells(verdict.fixed);
        data.row([Cell::given(verdict.level), ours, time, fixed, its_time]);
    }
    Table {
        csv: format!("precision-{scene}-fastest"),
        caption: format!("The fastest schemes in {scene} that end with an error no larger."),
        data,
    }
}

//! What was measured, as rows of a table.

use super::meter::Errors;
use serde::Deserialize;
use serde::Serialize;
use std::io;

/// Whose schemes ours are.
pub const OURS: &str = "residua";

/// A run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Row {
    /// The motion.
    pub scene: String,
    /// The formulation.
    pub model: String,
    /// The scheme.
    pub scheme: String,
    /// Whose it is.
    pub by: String,
    /// Its step, s, if that was given.
    pub step: Option<f64>,
    /// Its tolerance, if that was given.
    pub tolerance: Option<f64>,
    /// The shortest time, s. NaN for runs that fail.
    pub seconds: f64,
    /// The runs that it is the shortest of.
    pub runs: usize,
    /// Steps that were taken.
    pub steps: u64,
    /// Iterations or evaluations of the flow.
    pub evaluations: u64,
    /// As in [`Errors`].
    pub trajectory: f64,
    /// As in [`Errors`].
    pub phase: f64,
    /// As in [`Errors`].
    pub energy: f64,
    /// As in [`Errors`].
    pub constraint: f64,
    /// As in [`Errors`].
    pub momentum: f64,
    /// Why there is nothing.
    pub failure: String,
}

/// A kind of error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// [`Errors::trajectory`]
    Trajectory,
    /// [`Errors::phase`]
    Phase,
    /// [`Errors::energy`]
    Energy,
    /// [`Errors::constraint`]
    Constraint,
    /// [`Errors::momentum`]
    Momentum,
}

impl Kind {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Trajectory,
        Self::Phase,
        Self::Energy,
        Self::Constraint,
        Self::Momentum,
    ];

    /// What it is.
    pub fn title(self) -> &'static str {
        match self {
            Self::Trajectory => "trajectory error at the end, relative",
            Self::Phase => "phase error at the end [s]",
            Self::Energy => "largest energy error, relative",
            Self::Constraint => "largest constraint error, relative",
            Self::Momentum => "largest error of other invariants, relative",
        }
    }
}

impl Row {
    /// Its error of a kind.
    pub fn error(&self, kind: Kind) -> f64 {
        match kind {
            Kind::Trajectory => self.trajectory,
            Kind::Phase => self.phase,
            Kind::Energy => self.energy,
            Kind::Constraint => self.constraint,
            Kind::Momentum => self.momentum,
        }
    }

    /// With these errors.
    pub fn with(mut self, errors: Errors) -> Self {
        self.trajectory = errors.trajectory;
        self.phase = errors.phase;
        self.energy = errors.energy;
        self.constraint = errors.constraint;
        self.momentum = errors.momentum;
        self
    }

    /// The same scheme on the same formulation.
    pub fn is_of_lane(&self, other: &Row) -> bool {
        let lane = |row: &Self| (row.by.clone(), row.scheme.clone(), row.model.clone());
        lane(self) == lane(other)
    }

    /// It is one of ours.
    pub fn is_ours(&self) -> bool {
        self.by == OURS
    }
}

/// Writes the rows as CSV.
///
/// # Errors
/// Where `to` fails.
pub fn write(rows: &[Row], to: impl io::Write) -> Result<(), csv::Error> {
    let mut writer = csv::Writer::from_writer(to);
    for row in rows {
        writer.serialize(row)?;
    }
    writer.flush()?;
    Ok(())
}

/// Reads rows that [`write()`] or another program has written.
///
/// # Errors
/// Where there is something else.
pub fn read(from: impl io::Read) -> Result<Vec<Row>, csv::Error> {
    csv::Reader::from_reader(from).deserialize().collect()
}

//! What is done with a catalogue of models: runs beside exact motions, stress, time against error, misprints, the report.

pub mod columns;
pub mod errata;
pub mod notation;
pub mod plot;
pub mod precision;
pub mod race;
pub mod replay;
pub mod report;
pub mod stress;
pub mod study;

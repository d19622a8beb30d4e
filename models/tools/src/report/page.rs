//! A page as data: titled sections of text, figures, tables and verdicts.
//!
//! Comes in: what a part of the report has to say, in these types. Goes out: one HTML file that needs
//! nothing else, and a CSV file beside it for every figure and table. All text is plain and is escaped
//! where it is written, so nothing in it can break the page.

use super::html;
use crate::notation::number;
use crate::notation::rounded;
use crate::plot;
use std::fs;
use std::io;
use std::path::Path;

/// The report.
pub struct Page {
    /// Above everything and in the window's title.
    pub title: String,
    /// What the page is, in a sentence or two.
    pub lead: String,
    /// In reading order.
    pub sections: Vec<Section>,
}

/// A titled part, of a page or of a section.
pub struct Section {
    /// Its anchor, unique in the page: lower-case letters, digits and `-`.
    pub id: String,
    /// Its heading.
    pub title: String,
    /// What it says.
    pub blocks: Vec<Block>,
    /// Subsections, after the blocks.
    pub parts: Vec<Section>,
}

/// A piece of a section.
pub enum Block {
    /// A paragraph.
    Text(String),
    /// Points.
    List(Vec<String>),
    /// Preformatted text.
    Code(String),
    /// Terms and what they stand for.
    Facts(Vec<(String, String)>),
    /// A plot.
    Figure(Figure),
    /// Panels with logarithmic axes.
    Diagram(Diagram),
    /// Numbers.
    Table(Table),
    /// A long table, closed until it is asked for; not in print.
    Folded(Table),
    /// A statement, judged.
    Verdict(Verdict),
}

/// A plot and its data.
pub struct Figure {
    /// Stem of its CSV file.
    pub csv: String,
    /// Below the plot.
    pub caption: String,
    /// The picture, without a header.
    pub plot: plot::Figure,
    /// Curves may lie on each other: from the second on they are dashed.
    pub overlay: bool,
    /// What is plotted, at full resolution.
    pub data: Data,
}

/// Panels with logarithmic axes, and their data.
pub struct Diagram {
    /// Stem of its CSV file.
    pub csv: String,
    /// Below the picture.
    pub caption: String,
    /// The picture.
    pub plot: plot::Logarithmic,
    /// What is plotted.
    pub data: Data,
}

/// The rows of a CSV file.
pub struct Data {
    /// Names of the columns.
    pub head: Vec<String>,
    /// As many cells in each.
    pub rows: Vec<Vec<Cell>>,
}

/// A table; columns that hold numbers only are aligned on the right.
pub struct Table {
    /// Stem of its CSV file.
    pub csv: String,
    /// Above the table.
    pub caption: String,
    /// The columns and the rows.
    pub data: Data,
}

/// An entry of a table.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Nothing.
    Empty,
    /// Words.
    Text(String),
    /// A name or formula as a program writes it.
    Code(String),
    /// A number, in full in the CSV file and to some significant digits on the page.
    Number {
        /// All of it.
        value: f64,
        /// How many the page shows; 0 for as many as it takes, up to six.
        digits: usize,
    },
    /// A count.
    Count(u64),
    /// A judgement.
    Judgement(Judgement),
}

/// Whether a statement is true.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Judgement {
    /// It is.
    Holds,
    /// It is not.
    DoesNotHold,
    /// It is, under a condition.
    HoldsWhen,
}

/// A statement, judged.
pub struct Verdict {
    /// The outcome.
    pub judgement: Judgement,
    /// Who says what, and where.
    pub statement: String,
    /// The numbers behind the outcome; for [`Judgement::HoldsWhen`], the condition first.
    pub reason: String,
}

impl Judgement {
    /// `holds`, `does not hold`, `holds when`
    pub fn words(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::DoesNotHold => "does not hold",
            Self::HoldsWhen => "holds when",
        }
    }

    /// [`Self::Holds`] if `it_does`.
    pub fn of(it_does: bool) -> Self {
        if it_does {
            Self::Holds
        } else {
            Self::DoesNotHold
        }
    }
}

/// Digits of a number of which nothing else is said.
const DIGITS: usize = 3;

impl Cell {
    /// A number shown to `digits` significant digits.
    pub fn number(value: f64, digits: usize) -> Self {
        Self::Number { value, digits }
    }

    /// A number that somebody chose, shown as it was typed.
    pub fn given(value: f64) -> Self {
        Self::Number { value, digits: 0 }
    }

    /// What the page shows.
    pub fn shown(&self) -> String {
        match self {
            Self::Empty => String::new(),
            Self::Text(text) | Self::Code(text) => text.clone(),
            Self::Number { value, digits: 0 } => number(*value),
            Self::Number { value, digits } => rounded(*value, *digits),
            Self::Count(count) => count.to_string(),
            Self::Judgement(judgement) => judgement.words().to_owned(),
        }
    }

    /// What the CSV file holds: numbers with the digits that bring the same number back.
    fn written(&self) -> String {
        match self {
            Self::Number { value, .. } => format!("{value:?}"),
            other => other.shown(),
        }
    }

    /// It belongs on the right of its column.
    pub(super) fn is_number(&self) -> bool {
        matches!(self, Self::Number { .. } | Self::Count(_))
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Self::number(value, DIGITS)
    }
}

impl From<u64> for Cell {
    fn from(count: u64) -> Self {
        Self::Count(count)
    }
}

impl From<Judgement> for Cell {
    fn from(judgement: Judgement) -> Self {
        Self::Judgement(judgement)
    }
}

impl<T: Into<Cell>> From<Option<T>> for Cell {
    fn from(cell: Option<T>) -> Self {
        cell.map_or(Self::Empty, Into::into)
    }
}

impl Data {
    /// No rows yet.
    pub fn new(head: &[&str]) -> Self {
        Self {
            head: head.iter().map(ToString::to_string).collect(),
            rows: Vec::new(),
        }
    }

    /// Adds a row.
    pub fn row(&mut self, cells: impl IntoIterator<Item = Cell>) {
        self.rows.push(cells.into_iter().collect());
    }

    fn write(&self, path: &Path) -> io::Result<()> {
        let mut writer = csv::Writer::from_path(path)?;
        writer.write_record(&self.head)?;
        for row in &self.rows {
            writer.write_record(row.iter().map(Cell::written))?;
        }
        writer.flush()
    }
}

impl Page {
    /// Writes `index.html` and the CSV files into a folder, which is made if need be.
    pub fn write(&self, folder: &Path) -> io::Result<()> {
        fs::create_dir_all(folder)?;
        let parts = self.sections.iter().flat_map(|section| &section.parts);
        for block in self.sections.iter().chain(parts).flat_map(|s| &s.blocks) {
            let (csv, data) = match block {
                Block::Figure(figure) => (&figure.csv, &figure.data),
                Block::Diagram(diagram) => (&diagram.csv, &diagram.data),
                Block::Table(table) | Block::Folded(table) => (&table.csv, &table.data),
                _ => continue,
            };
            data.write(&folder.join(format!("{csv}.csv")))?;
        }
        let html = html::html(self).map_err(io::Error::other)?;
        fs::write(folder.join("index.html"), html)
    }
}

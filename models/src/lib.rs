//! The catalogue: every model file and every scene file in `models/dsl/`, compiled.
//!
//! The build script lists the folder, so a new file appears here, in the command and in the generic
//! tests by itself. Each file is a module of the same name; [`CATALOGUE`] holds the models and [`SCENES`] the scenes.
//!
//! ```
//! let pendulum = residua_models::find("planar_reduced").unwrap();
//! assert_eq!(pendulum.catalogued.description.states.len(), 2);
//! ```

// Model files spell names as papers do: ρ beside p, ν beside v, and ℓ where l reads as 1.
#![allow(
    confusable_idents,
    mixed_script_confusables,
    uncommon_codepoints,
    reason = "model files use Greek letters beside Latin ones on purpose"
)]

pub mod effort;
pub mod exact;
#[cfg(feature = "rivals")]
pub mod rivals;
pub mod values;

use ::residua::Catalogued;
use ::std::fmt;

pub use dsl::CATALOGUE;
pub use dsl::SCENES;

/// The models, each a module of the name of its file.
pub mod dsl {
    include!(concat!(env!("OUT_DIR"), "/catalogue.rs"));
}

/// A model file or a scene file and what became of it.
#[derive(Clone, Copy)]
pub struct Entry {
    /// The compiled model.
    pub catalogued: &'static Catalogued,
    /// The text of its file.
    pub source: &'static str,
    /// Its continuous equations with twice the digits.
    pub extended: Option<&'static dyn exact::Extended>,
    /// Its continuous equations, integrated by others.
    #[cfg(feature = "rivals")]
    pub rivals: Option<&'static dyn rivals::Rivals>,
}

impl Entry {
    /// The stem of its file.
    pub fn name(&self) -> &'static str {
        self.catalogued.description.name
    }
}

/// The model or scene called `name`.
pub fn find(name: &str) -> Result<&'static Entry, UnknownModel> {
    let mut all = CATALOGUE.iter().chain(SCENES);
    let known = all.clone().find(|entry| entry.name() == name);
    known.ok_or_else(|| UnknownModel {
        name: name.to_owned(),
        nearest: nearest(name, all.by_ref().map(Entry::name)),
    })
}

/// There is no such model or scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownModel {
    /// What was asked for.
    pub name: String,
    /// The name that was probably meant.
    pub nearest: Option<String>,
}

impl fmt::Display for UnknownModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "there is no model `{}`", self.name)
    }
}

impl ::std::error::Error for UnknownModel {}

/// Similarity (Jaro–Winkler, 0 to 1) from which a name counts as a misspelling of another. Higher
/// misses typing errors, lower suggests what nobody meant.
const SIMILAR: f64 = 0.8;

/// The candidate most like `name`, if one is like it at all.
pub fn nearest<'n>(name: &str, candidates: impl IntoIterator<Item = &'n str>) -> Option<String> {
    let candidates = candidates.into_iter().map(|c| (c, c));
    ::residua_codegen::similar::most_similar(name, candidates, SIMILAR).map(ToOwned::to_owned)
}

//! A motion, its exact end, and the models that take it.

use super::given::Given;
use crate::study;
use crate::study::Case;
use crate::study::Correspondence;
use crate::study::Course;
use crate::study::Piece;
use crate::study::largest_size;
use residua::erased::AnyFlow;
use residua::erased::Sample;
use residua::erased::Scheme;
use residua_models::Entry;
use residua_models::UnknownModel;
use residua_models::exact::Invalid;
use residua_models::exact::Reference;
use residua_models::find;
use residua_models::values::size;
use std::fmt;
use std::ops::ControlFlow;

/// Steps of the run that tells how fast a motion is, and states of it that are looked at.
const LOOKS: (u64, u64) = (1 << 14, 64);

/// Change of the state, relative to its size, in the longest step of the reference. Shorter steps cost more, and so do
/// longer ones, which need more columns of the extrapolation.
const LONGEST: f64 = 1.5;

/// Parts of that step that are tried where it is too long, one after the other, and how often.
const SHORTER: f64 = 1.0 / 16.0;
const STIFF: u32 = 3;

/// A motion that every formulation is to follow.
pub struct Problem {
    /// Of the scene or model.
    pub name: String,
    /// What it is.
    pub caption: String,
    /// Its end, s.
    pub until: f64,
    /// The exact state of `reference` there, and how sure it is.
    pub exact: Reference,
    /// Where the exact state is from.
    pub source: &'static str,
    /// What the exact motion is given in.
    pub reference: Case,
    /// The largest size of the variable that each component of the reference's state belongs to.
    pub scales: Vec<f64>,
    /// The motion about its end.
    pub piece: Piece,
    /// Models that take it, those that were asked for.
    pub formulations: Vec<Formulation>,
}

/// A model that takes the motion.
pub struct Formulation {
    /// The model with parameters and start.
    pub case: Case,
    /// Its entry in the catalogue.
    pub entry: &'static Entry,
    /// Which of its signals are which of the reference.
    pub alike: Correspondence,
}

/// Why there is nothing to measure.
#[derive(Debug, PartialEq)]
pub enum Unsolvable {
    /// There is no such scene or model.
    UnknownScene(UnknownModel),
    /// There is no such model.
    UnknownModel(UnknownModel),
    /// The model has no continuous equations.
    WithoutFlow(String),
    /// A model that was asked for does not take this motion.
    OtherMotion {
        /// The model.
        model: String,
        /// The scene.
        scene: String,
        /// The models that do.
        of: Vec<&'static str>,
    },
    /// Nothing changes, or the motion cannot be followed.
    NoMotion(String),
    /// There is no exact motion.
    Invalid(Invalid),
}

impl Problem {
    /// The motion `given` under the name of its scene, by the `models` that are named, or by all.
    ///
    /// # Errors
    /// Where a model does not take the motion, or there is no exact one to compare with.
    pub fn new(name: &str, given: Given, models: &[String]) -> Result<Self, Unsolvable> {
        let Given {
            reference, until, ..
        } = given;
        for model in models {
            find(model).map_err(Unsolvable::UnknownModel)?;
        }
        let own = reference.model.description.name;
        let flow = reference.model.flow;
        let flow = flow.ok_or_else(|| Unsolvable::WithoutFlow(own.to_owned()))?;
        let here = Course::new(&reference, until);
        let generic = given.scene.as_ref().map(study::Scene::generic);
        let there =
            |case: &Case| generic.map(|scene| Course::new(&scene.set(case.model), scene.until));
        let of_reference: Vec<Course> = [Some(here), there(&reference)]
            .into_iter()
            .flatten()
            .collect();
        let mut formulations = Vec::new();
        for case in given.candidates {
            let model = case.model.description.name;
            if case.model.flow.is_none() {
                continue;
            }
            // A scene of the catalogue is made for one motion.
            let is_scene = case.model.description.scene.is_some();
            let course = Course::new(&case, until);
            let alike = match there(&case).filter(|_| !is_scene) {
                Some(there) => {
                    Correspondence::new(&[&of_reference[0], &of_reference[1]], &[&course, &there])
                }
                None => Correspondence::new(&[&of_reference[0]], &[&course]),
            };
            if let (false, Ok(entry)) = (alike.pairs.is_empty(), find(model)) {
                formulations.push(Formulation { case, entry, alike });
            }
        }
        let of: Vec<&str> = formulations.iter().map(Formulation::name).collect();
        if of.is_empty() {
            return Err(Unsolvable::NoMotion(name.to_owned()));
        }
        if let Some(model) = models.iter().find(|model| !of.contains(&model.as_str())) {
            return Err(Unsolvable::OtherMotion {
                model: model.clone(),
                scene: name.to_owned(),
                of,
            });
        }
        formulations
            .retain(|of| models.is_empty() || models.iter().any(|model| model == of.name()));
        let (rate, scales) = extent(&reference, flow, until);
        let (exact, source) = exact(&reference, rate, until, given.scene.as_ref())?;
        let sizes = of_reference[0].scales();
        let piece = Piece::new(&reference, &exact.state, until, sizes);
        Ok(Self {
            name: name.to_owned(),
            caption: given.caption,
            until,
            source,
            scales,
            piece: piece.ok_or_else(|| Unsolvable::NoMotion(name.to_owned()))?,
            exact,
            reference,
            formulations,
        })
    }
}

impl Formulation {
    /// The name of the model.
    pub fn name(&self) -> &'static str {
        self.case.model.description.name
    }
}

/// The exact state of the reference: that of the study's scene where it has one, else by its own flow with twice the
/// digits.
fn exact(
    reference: &Case,
    rate: f64,
    until: f64,
    scene: Option<&study::Scene>,
) -> Result<(Reference, &'static str), Unsolvable> {
    if let Some(scene) = scene.filter(|scene| scene.system == study::System::Planar) {
        let state = scene.exact_end(reference).map_err(Unsolvable::Invalid)?;
        let error = f64::EPSILON / 2.0;
        return Ok((Reference { state, error }, "elliptic functions"));
    }
    let name = reference.model.description.name;
    let extended = find(name).ok().and_then(|entry| entry.extended);
    let extended = extended.ok_or_else(|| Unsolvable::WithoutFlow(name.to_owned()))?;
    let Case {
        parameters, start, ..
    } = reference;
    let mut longest = (LONGEST / rate).min(until);
    let mut exact = extended.solve(parameters, start, until, longest);
    for _ in 0..STIFF {
        // Where the motion is slow beside what a stiff flow does to neighbours of it.
        let Err(Invalid::NotConverged { .. }) = exact else {
            break;
        };
        longest *= SHORTER;
        exact = extended.solve(parameters, start, until, longest);
    }
    let exact = exact.map_err(Unsolvable::Invalid)?;
    Ok((exact, "extrapolation with 31 digits"))
}

/// The largest change of a variable per time, relative to its largest size, 1/s, and that size for each component.
fn extent(case: &Case, flow: &dyn AnyFlow, until: f64) -> (f64, Vec<f64>) {
    let (steps, looks) = LOOKS;
    let mut run = case.run(until / steps as f64, steps);
    run.every = steps / looks;
    let mut states = Vec::new();
    // A run that breaks off tells about its beginning.
    let _ = flow.simulate(Scheme::RungeKutta4, &run, &mut |sample: Sample<'_>| {
        states.push((sample.t, sample.state.to_vec()));
        ControlFlow::Continue(())
    });
    let mut rates = vec![0.0; case.start.len()];
    let rates: Vec<Vec<f64>> = states
        .iter()
        .map(|(t, state)| {
            flow.flow(&case.parameters, *t, state, &mut rates);
            rates.clone()
        })
        .collect();
    let mut fastest = 1.0 / until;
    let mut scales = Vec::new();
    let mut offset = 0;
    for state in case.model.description.states {
        let own = offset..offset + size(state);
        offset = own.end;
        let sizes = states
            .iter()
            .map(|(_, state)| largest_size(&state[own.clone()]));
        let changes = rates.iter().map(|rates| largest_size(&rates[own.clone()]));
        let (size, change) = (sizes.fold(0.0, f64::max), changes.fold(0.0, f64::max));
        if size > 0.0 && (change / size).is_finite() {
            fastest = f64::max(fastest, change / size);
        }
        scales.extend(own.map(|_| if size > 0.0 { size } else { 1.0 }));
    }
    (fastest, scales)
}

impl fmt::Display for Unsolvable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownScene(unknown) => {
                write!(f, "there is no scene or model `{}`", unknown.name)
            }
            Self::UnknownModel(unknown) => unknown.fmt(f),
            Self::WithoutFlow(name) => {
                write!(f, "`{name}` has no continuous equations to be exact about")
            }
            Self::OtherMotion { model, scene, of } => write!(
                f,
                "`{model}` does not take the motion of `{scene}`, only {}",
                of.join(", ")
            ),
            Self::NoMotion(name) => {
                write!(f, "nothing moves in `{name}`, or it cannot be followed")
            }
            Self::Invalid(invalid) => invalid.fmt(f),
        }
    }
}

impl std::error::Error for Unsolvable {}

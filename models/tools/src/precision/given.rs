//! A motion as its scene gives it, and the models that may take it.

use super::problem::Unsolvable;
use crate::study;
use crate::study::Case;
use crate::study::are_kin;
use residua::Catalogued;
use residua::description::Variable;
use residua_models::CATALOGUE;
use residua_models::Entry;
use residua_models::SCENES;
use residua_models::UnknownModel;
use residua_models::find;
use residua_models::nearest;
use residua_models::values;
use residua_models::values::size;

/// End of the motion of a model that no scene gives one, s.
const UNTIL: f64 = 10.0;

/// Parameters and rates of a motion, whatever the variables.
pub struct Given {
    /// The model whose variables the exact motion is given in.
    pub reference: Case,
    /// The end, s.
    pub until: f64,
    /// What it is.
    pub caption: String,
    /// Models that may take it.
    pub(super) candidates: Vec<Case>,
    /// The study's scene, which has an exact motion of its own.
    pub(super) scene: Option<study::Scene>,
}

impl Given {
    /// The scene or model of that name, to its own end or another.
    ///
    /// # Errors
    /// Where there is none.
    pub fn named(name: &str, until: Option<f64>) -> Result<Self, Unsolvable> {
        match study::SCENES.iter().find(|scene| scene.name == name) {
            Some(scene) => Self::of_study(scene, until),
            None => {
                let entry = find_scene(name)?;
                Ok(Self::of_case(Case::of_file(entry.catalogued), until))
            }
        }
    }

    fn of_study(scene: &study::Scene, until: Option<f64>) -> Result<Self, Unsolvable> {
        let until = until.unwrap_or(scene.until);
        let scene = study::Scene { until, ..*scene };
        let reference = scene.of_reference().map_err(Unsolvable::UnknownScene)?;
        let mut candidates = scene.cases();
        candidates.extend(scenes_of(&reference, scene.rates));
        Ok(Self {
            reference,
            until,
            caption: scene.caption.to_owned(),
            candidates,
            scene: Some(scene),
        })
    }

    /// The motion of a model from any start, to the end that its scene gives it or another.
    pub fn of_case(reference: Case, until: Option<f64>) -> Self {
        let description = reference.model.description;
        let (name, scene) = (description.name, description.scene);
        let rates: Vec<f64> = named_states(&reference)
            .filter(|(state, _)| state.unit.contains("/s"))
            .flat_map(|(_, values)| values.to_vec())
            .collect();
        let mut candidates = vec![reference.clone()];
        if let Ok(base) = find(scene.map_or(name, |scene| scene.model)) {
            let base = whole(base.catalogued, &reference);
            let models = CATALOGUE.iter().map(|entry| entry.catalogued);
            let kin = models.filter(|model| are_kin(model, base.model));
            let others = kin.filter(|model| model.description.name != name);
            candidates.extend(others.map(|model| {
                match model.description.name == base.model.description.name {
                    true => base.clone(),
                    false => {
                        Case::with_parameters(model, base.parameters.clone()).with_rates(&rates)
                    }
                }
            }));
            let scenes = scenes_of(&base, &rates);
            candidates.extend(scenes.filter(|case| case.model.description.name != name));
        }
        Self {
            reference,
            until: until.unwrap_or_else(|| scene.map_or(UNTIL, |scene| scene.until)),
            caption: description
                .doc
                .lines()
                .next()
                .unwrap_or_default()
                .trim()
                .to_owned(),
            candidates,
            scene: None,
        }
    }
}

fn find_scene(name: &str) -> Result<&'static Entry, Unsolvable> {
    let scenes = study::SCENES.iter().map(|scene| scene.name);
    let entries = CATALOGUE.iter().chain(SCENES).map(Entry::name);
    find(name).map_err(|unknown| {
        let nearest = nearest(name, scenes.chain(entries));
        Unsolvable::UnknownScene(UnknownModel { nearest, ..unknown })
    })
}

/// The model that a scene is of, with the parameters of the scene and those start values that it has.
fn whole(base: &'static Catalogued, scene: &Case) -> Case {
    let mut parameters = values::defaults(base);
    let fixed = scene
        .model
        .description
        .scene
        .map_or(&[][..], |scene| scene.fixed);
    let mut offset = 0;
    for parameter in base.description.parameters {
        let own = offset..offset + size(parameter);
        offset = own.end;
        if let Some(fixed) = fixed.iter().find(|fixed| fixed.name == parameter.name) {
            parameters[own].copy_from_slice(fixed.values);
        } else if let Some(values) = parameter_of(scene, parameter) {
            parameters[own].copy_from_slice(values);
        }
    }
    let mut case = Case::with_parameters(base, parameters);
    let mut offset = 0;
    for state in base.description.states {
        let own = offset..offset + size(state);
        offset = own.end;
        let given = named_states(scene).find(|(other, _)| other.name == state.name);
        if let Some((_, values)) = given.filter(|(_, values)| values.len() == own.len()) {
            case.start[own].copy_from_slice(values);
        }
    }
    case
}

/// The scenes of the models that are kin to that of `base`, those with its parameters.
fn scenes_of<'a>(base: &'a Case, rates: &'a [f64]) -> impl Iterator<Item = Case> + 'a {
    let scenes = SCENES.iter().map(|entry| entry.catalogued);
    scenes.filter_map(move |model| {
        let scene = model.description.scene?;
        let of = find(scene.model).ok()?.catalogued;
        let same = scene.fixed.iter().all(|fixed| {
            let mut parameters = base.model.description.parameters.iter();
            let parameter = parameters.find(|parameter| parameter.name == fixed.name);
            parameter.and_then(|parameter| parameter_of(base, parameter)) == Some(fixed.values)
        });
        if !same || !are_kin(of, base.model) {
            return None;
        }
        let own = model.description.parameters.iter();
        let own = own.filter_map(|parameter| parameter_of(base, parameter));
        let own: Vec<f64> = own.flatten().copied().collect();
        Some(Case::with_parameters(model, own).with_rates(rates))
    })
}

fn parameter_of<'a>(case: &'a Case, parameter: &Variable) -> Option<&'a [f64]> {
    let mut offset = 0;
    for own in case.model.description.parameters {
        let range = offset..offset + size(own);
        offset = range.end;
        if own.name == parameter.name && range.len() == size(parameter) {
            return case.parameters.get(range);
        }
    }
    None
}

fn named_states(case: &Case) -> impl Iterator<Item = (&'static Variable, &[f64])> {
    let mut rest = case.start.as_slice();
    case.model.description.states.iter().map(move |state| {
        let (own, others) = rest.split_at(size(state));
        rest = others;
        (state, own)
    })
}

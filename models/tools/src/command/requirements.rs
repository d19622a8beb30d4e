//! What is said of data that do not meet what their model file requires.

use residua::Catalogued;
use residua::description::Requirement;

/// The requirements that these data do not meet.
pub fn unmet(
    model: &Catalogued,
    parameters: &[f64],
    h: f64,
    start: &[f64],
) -> impl Iterator<Item = usize> {
    let all = 0..model.description.requirements.len();
    all.filter(move |&i| !model.model.meets(i, parameters, h, start))
}

/// `the mass is not positive: m > 0 (line 23 of pendulum.model)`
pub fn text(model: &Catalogued, requirement: usize) -> String {
    let description = model.description;
    let file = description.scene.map_or(description.name, |s| s.model);
    let Requirement {
        text,
        otherwise,
        line,
    } = &description.requirements[requirement];
    format!("{otherwise}: {text} (line {line} of {file}.model)")
}

/// Trajectories of a sweep that do not meet a requirement.
pub struct Unmet {
    counts: Vec<usize>,
}

impl Unmet {
    /// None so far.
    pub fn new(model: &Catalogued) -> Self {
        Self {
            counts: vec![0; model.description.requirements.len()],
        }
    }

    /// Takes in one more with these parameters and this start, if there is anything to ask.
    pub fn take(
        &mut self,
        model: &Catalogued,
        fill: impl FnOnce() -> (Vec<f64>, Vec<f64>),
        h: f64,
    ) {
        if self.counts.is_empty() {
            return;
        }
        let (parameters, start) = fill();
        for requirement in unmet(model, &parameters, h, &start) {
            self.counts[requirement] += 1;
        }
    }

    /// Warns of those that there are among `all`.
    pub fn warn(&self, model: &Catalogued, all: usize) {
        for (requirement, count) in self.counts.iter().enumerate().filter(|c| *c.1 > 0) {
            let text = text(model, requirement);
            tell!("warning: in {count} of {all} trajectories {text}");
        }
    }
}

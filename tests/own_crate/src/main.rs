//! A pendulum in a project of its own: one model file, one dependency, no build script.
//!
//! Prints time, angle and energy of a run.

// rustc's look-alike lints read the model file too.
#![allow(confusable_idents, mixed_script_confusables)]

mod pendulum {
    use residua::model;
    include!("pendulum.model");
}

use pendulum::{Increment, Model, Parameters};
use residua::{Model as _, Stepper};
use std::error::Error;

/// Time step, [s].
const STEP: f64 = 0.01;

fn main() -> Result<(), Box<dyn Error>> {
    let parameters = Parameters {
        l: 1.0,
        ..Parameters::default()
    };
    let start = Model::start(&parameters);
    let mut stepper = Stepper::<Increment>::new(parameters, start, STEP)?;
    for _ in 0..1000 {
        stepper.step()?;
        let (t, state) = (stepper.t(), stepper.state());
        let energy = Model::outputs(&parameters, STEP, t, &state).energy;
        println!("{t} {} {energy}", state.theta);
    }
    Ok(())
}

#[cfg(test)]
mod tests;

//! Steps of two models in `f32`, where a panic does not link.
#![no_std]
#![no_main]
// rustc reads the model files too.
#![allow(confusable_idents, mixed_script_confusables, uncommon_codepoints)]

use core::hint::black_box;
use core::panic::PanicInfo;
use residua::{Model as _, Stepper};

/// One unknown is iterated on.
mod planar {
    use residua::model;
    include!("../../../models/dsl/planar_reduced.model");
}

/// Four, with `sin` and `cos`.
mod elastic {
    use residua::model;
    include!("../../../models/dsl/elastic.model");
}

unsafe extern "C" {
    /// Nowhere: what can panic does not link.
    fn a_step_can_panic() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    // SAFETY: there is no such function, so that no program that could call it exists.
    unsafe { a_step_can_panic() }
}

/// The end of a hundred steps, or NaN.
fn planar() -> f32 {
    let parameters = black_box(planar::Parameters::<f32>::default());
    let start = planar::Model::start(&parameters);
    let Ok(mut stepper) = Stepper::<planar::Increment, f32>::new(parameters, start, 0.01) else {
        return f32::NAN;
    };
    for _ in 0..100 {
        if stepper.step().is_err() {
            return f32::NAN;
        }
    }
    stepper.state().omega
}

fn elastic() -> f32 {
    let parameters = black_box(elastic::Parameters::<f32>::default());
    let start = elastic::Model::start(&parameters);
    let Ok(mut stepper) = Stepper::<elastic::Increment, f32>::new(parameters, start, 0.01) else {
        return f32::NAN;
    };
    for _ in 0..100 {
        if stepper.step().is_err() {
            return f32::NAN;
        }
    }
    stepper.state().r
}

/// The linker starts here.
#[unsafe(no_mangle)]
pub extern "C" fn _start() -> ! {
    black_box(planar() + elastic());
    loop {}
}

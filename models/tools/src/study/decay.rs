//! How an error shrinks with the step.

use serde::Serialize;
use std::fmt;

/// A slope below this does not vanish with the step: the lowest order of a useful scheme is 1.
const LOWEST_ORDER: f64 = 0.5;

/// Errors for h, h/2, …
#[derive(Clone, Debug, Serialize)]
pub struct Decay {
    /// Coarsest step first.
    pub errors: Vec<f64>,
    /// p of error ~ hᵖ; none if the errors are rounding.
    pub order: Option<f64>,
}

impl Decay {
    /// `floor` is the size of rounding.
    pub fn new(errors: &[f64], floor: f64) -> Self {
        let order = match errors {
            // An infinite floor is no rounding.
            [_, .., last] if *last <= floor && floor.is_finite() => None,
            // Of NaN too, which is no rounding.
            [first, .., last] => {
                let halvings = (errors.len() - 1) as f64;
                Some((first / last).log2() / halvings)
            }
            _ => None,
        };
        Self {
            errors: errors.to_vec(),
            order,
        }
    }

    /// The errors go to zero with the step.
    pub fn vanishes(&self) -> bool {
        self.order.is_none_or(|order| order > LOWEST_ORDER)
    }
}

/// `order 2.00 (1.0e-3, 2.5e-4)`
impl fmt::Display for Decay {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let errors: Vec<_> = self.errors.iter().map(|e| format!("{e:.1e}")).collect();
        match self.order {
            Some(order) => write!(f, "order {order:.2} ({})", errors.join(", ")),
            None => write!(f, "exact to rounding ({})", errors.join(", ")),
        }
    }
}

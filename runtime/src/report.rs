//! What steps report when they succeed, and the corrections that led there.

/// Why an iterate was accepted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Success {
    /// The last correction was within the tolerance.
    Converged,
    /// Corrections stopped shrinking at the level of rounding errors, above the tolerance asked for.
    AtFloor,
}

/// One accepted step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Report {
    /// Newton corrections; 0 for explicit methods.
    pub iterations: usize,
    /// Why the last iterate was accepted.
    pub success: Success,
}

impl Report {
    /// Accepted after so many corrections.
    pub(crate) fn converged(iterations: usize) -> Self {
        Self {
            iterations,
            success: Success::Converged,
        }
    }
}

/// What a run has cost so far, failed steps included.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Accepted steps.
    pub steps: u64,
    /// Newton corrections applied, each of one residual, one Jacobian and one linear system, or sweeps over the stages of a
    /// scheme.
    pub iterations: u64,
    /// Residuals evaluated besides, to judge a correction.
    pub residuals: u64,
    /// Jacobians of the continuous equations, for stiff stages.
    pub jacobians: u64,
    /// Evaluations of the continuous equations.
    pub flows: u64,
    /// Steps for which the core failed or could not be trusted, so that all unknowns were iterated on.
    pub fallbacks: u64,
    /// Steps that failed and were taken as shorter ones.
    pub halved: u64,
    /// Steps that ended at the rounding floor, above the tolerance.
    pub at_floor: u64,
    /// Steps that a step-size control has taken, of which outputs are interpolated.
    pub accepted: u64,
    /// Steps that it has tried in vain.
    pub rejected: u64,
}

/// Corrections that a [`History`] keeps.
const KEPT: usize = 12;

/// The last corrections of one step, each relative to the unknowns it corrects. Single precision is enough
/// to read how they shrink.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct History {
    iterations: usize,
    sizes: [f32; KEPT],
}

impl History {
    /// Adds the size of a correction and drops the oldest if there is no room.
    pub fn push(&mut self, size: f64) {
        if self.iterations >= KEPT {
            self.sizes.rotate_left(1);
        }
        self.sizes[self.iterations.min(KEPT - 1)] = size as f32;
        self.iterations += 1;
    }

    /// Corrections made, whether kept or not.
    pub fn iterations(&self) -> usize {
        self.iterations
    }

    /// The last 12 corrections or fewer, oldest first.
    pub fn sizes(&self) -> &[f32] {
        &self.sizes[..self.iterations.min(KEPT)]
    }
}

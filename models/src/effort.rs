//! What integrators are asked for and answer, whoever wrote them.

/// What a run took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Effort {
    /// Steps, accepted ones.
    pub steps: u64,
    /// Iterations of implicit schemes, or evaluations of the flow where a scheme counts those.
    pub evaluations: u64,
}

/// Takes states on the way.
pub type Visit<'v> = &'v mut (dyn FnMut(&[f64]) + 'v);

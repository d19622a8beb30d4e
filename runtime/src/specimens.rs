//! Systems written by hand, for tests.

#[allow(
    missing_docs,
    reason = "it stands for a generated module, and its docs are at the top"
)]
pub(crate) mod pendulum;
pub(crate) mod root;

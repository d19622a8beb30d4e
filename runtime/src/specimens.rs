//! Systems written by hand, for tests.

#[allow(missing_docs, reason = "it stands for a generated module")]
pub(crate) mod pendulum;
pub(crate) mod root;

//! The proc-macro door to the generator.

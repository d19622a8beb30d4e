//! `--over NAME=FROM..TO:COUNT`: what is swept, and the grid of all combinations.

use crate::assignment::{Assignment, Target, component_of};
use crate::expression::{Symbol, evaluate};
use crate::failure::Failure;
use residua::description::Description;
use std::fmt;
use std::str::FromStr;

/// `NAME=FROM..TO:COUNT`, as given.
#[derive(Clone, Debug)]
pub struct Over {
    target: Target_,
    assignment: Assignment,
    from: String,
    to: String,
    count: usize,
}

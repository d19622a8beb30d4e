//! Schemes under study: how far from the exact motion, what they keep, and which of them are the same.
//!
//! Nothing here knows a model by name. Models of one physical system are those with the same parameters;
//! what a component of a model *is* shows in its course along the continuous equations ([`Correspondence`]),
//! so names of states and scalings of equations do not matter.

mod case;
mod conservation;
mod decay;
mod distance;
mod maps;
mod method;
mod piece;
mod scene;
mod schemes;
mod signals;
mod trial;

pub use case::Case;
pub use conservation::Conservation;
pub use conservation::Kept;
pub use conservation::conservation;
pub use conservation::term_size;
pub use decay::Decay;
pub use distance::largest_difference;
pub use distance::largest_size;
pub use maps::Map;
pub use maps::same_maps;
pub use method::Method;
pub use piece::Piece;
pub use scene::SCENES;
pub use scene::Scene;
pub use scene::System;
pub use scene::are_kin;
pub use schemes::Found;
pub use schemes::Row;
pub use schemes::schemes;
pub use signals::Correspondence;
pub use signals::Course;
pub use signals::Signals;
pub use trial::Trial;
pub use trial::Watched;

//! [`Scene`]: everything that a comparison depends on but the machine, as data in a TOML file.
//!
//! 1. [`file`](mod@file): a file is read; unknown keys and values of a wrong type are refused with their line.
//! 2. [`limits`]: every value is within its range, and the whole small enough to be run.
//! 3. [`sweep`]: options are given the values that they declare worth comparing.
//! 4. [`cells`]: methods and their options are looked up in the registry; lists of values become one cell for each.
//!
//! [`Profile`] names the built-in scenes, `scenes/*.toml`.

pub mod cells;
pub mod error;
pub mod file;
pub mod limits;
pub mod model;
pub mod profile;
pub mod sweep;

pub use cells::MethodChoice;
pub use error::{SceneError, SceneFault};
pub use model::{
    BUILTIN, CoherenceSpec, MeshSpec, MethodSpec, OptionSpread, PathKind, PathSpec, PenSpec, PictureSpec,
    ProjectionKind, Scene,
};
pub use profile::Profile;

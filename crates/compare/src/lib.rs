#![doc = include_str!("../README.md")]
//!
//! # In the order of a comparison
//!
//! 1. [`scene`]: what is compared, seen how and measured how thoroughly, as data. [`options`]: of methods.
//! 2. [`registry`]: the methods, as a value that callers extend. [`drawing`]: frames of any of them.
//! 3. [`camera_path`]: views around a mesh.
//! 4. [`truth`]: the true visible lines of a view, and its true filled picture.
//! 5. [`metrics`]: a picture scored against the truth. [`cost`]: preparation and frames. [`interval`]: how sure medians and means are.
//!    [`coherence`]: what a sequence of pictures does that the truth does not.
//! 6. [`runner`]: methods with their options x meshes, along one path; yields [cells](record::Cell). [`machine`]: where they
//!    were made.
//!    [`sweep`]: the cells shared among processes and machines, and kept over interruptions.
//! 7. [`pareto`]: which methods are worth their time. [`picture`]: where a picture and the truth differ.
//! 8. [`scaling`]: how extraction times grow with the mesh, beside those of other tools.
//! 9. [`recommend`]: which method to use on a mesh, within an error and a time, promised and checked.
//! 10. [`report`]: files for people and programs.
//! 11. [`foreign`]: what other programs drew, scored against the same truth.
//!
//! [`plot`]: what charts as SVG are made of.
//! [`result_directory`]: how directories of results are written.

pub mod camera_path;
pub mod coherence;
pub mod cost;
pub mod drawing;
pub mod foreign;
pub mod interval;
pub mod machine;
pub mod metrics;
pub mod options;
pub mod pareto;
pub mod picture;
pub mod plot;
pub mod recommend;
pub mod record;
pub mod registry;
pub mod report;
pub mod result_directory;
pub mod runner;
pub mod scaling;
pub mod scene;
pub mod sweep;
pub mod truth;

pub use drawing::{FrameStyle, Ground, render_method};
pub use record::Cell;
pub use registry::{Entry, Registry};
pub use runner::{CompareConfig, CompareError, Comparison, LeftOut, NamedMesh, PictureSet, Subject, run};
pub use scene::{MethodChoice, Profile, Scene, SceneError};

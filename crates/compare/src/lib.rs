//! Runs silhouette methods over meshes and camera paths, measures what they cost and how good their pictures are, and
//! writes a report.
//!
//! In the order of a comparison:
//!
//! 1. [`registry`]: the one list of methods. [`drawing`]: frames of any of them.
//! 2. [`camera_path`]: views around a mesh.
//! 3. [`truth`]: the true visible lines of a view.
//! 4. [`metrics`]: a picture scored against the truth. [`cost`]: preparation and frames.
//! 5. [`runner`]: methods x meshes x views; yields [`record`]s. [`machine`]: where they were made.
//! 6. [`pareto`]: which methods are worth their time. [`picture`]: where a picture and the truth differ.
//! 7. [`scaling`]: how extraction times grow with the mesh, beside those of other tools.
//! 8. [`report`]: files for people and programs.
//!
//! [`plot`]: what charts as SVG are made of.
//! [`result_directory`]: how directories of results are written.
//!
//! ```no_run
//! use silhouette_compare::{CompareConfig, NamedMesh, Profile, report, run};
//! use silhouette_core::{NoProgress, PreparedMesh, TriangleMesh};
//! use silhouette_render::{AdapterChoice, Gpu};
//! use std::sync::Arc;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # let mesh = TriangleMesh::new(vec![], vec![])?;
//! let gpu = Gpu::new(AdapterChoice::Any)?;
//! let meshes = [NamedMesh { name: "model".to_owned(), mesh: Arc::new(PreparedMesh::new(mesh)) }];
//! let comparison = run(&CompareConfig::new(Profile::Quick), &meshes, &gpu, &NoProgress)?;
//! report::write(&comparison, "report".as_ref())?;
//! # Ok(())
//! # }
//! ```

pub mod camera_path;
pub mod cost;
pub mod drawing;
pub mod machine;
pub mod metrics;
pub mod pareto;
pub mod picture;
pub mod plot;
pub mod record;
pub mod registry;
pub mod report;
pub mod result_directory;
pub mod runner;
pub mod scaling;
pub mod truth;

pub use drawing::{FrameStyle, render_method};
pub use record::{Profile, Record};
pub use runner::{CompareConfig, CompareError, Comparison, LeftOut, MethodChoice, NamedMesh, PictureSet, run};

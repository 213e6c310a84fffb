//! R. Raskar and M. Cohen, "Image precision silhouette edges", 1999: the frame rates of section 5, and what they do not tell.
//!
//! The paper prints frames a second with and without silhouettes on three models that cannot be had. Frame times over
//! plain rendering stand beside its ratios, on built-in meshes of the same size and on any mesh that is named. The paper
//! measures no picture; every variant's width, what it misses, what it adds and what shows through stand here, and on
//! spheres beside what the geometry predicts.
//!
//! 1. [`variants`]: what is drawn. [`printed`]: what is printed.
//! 2. [`picture`]: one variant's picture of a view, scored. [`timed`]: frames over plain ones. [`measure`]: all of it.
//! 3. [`derived`]: widths that follow from the geometry. [`spheres`]: spheres from many sides. [`lost`]: faces that a picture is
//!    too coarse for. [`soup`]: triangles whose winding says nothing.
//! 4. [`rows`]: the figures. [`table`]: for a terminal. [`chart`]: widths and what shows through. [`page`]: for a browser.
//!    [`write`](mod@write): as files.

pub mod chart;
pub mod derived;
pub mod lost;
pub mod measure;
pub mod page;
pub mod picture;
pub mod printed;
pub mod rows;
pub mod soup;
pub mod spheres;
pub mod table;
pub mod timed;
pub mod variants;
pub mod write;

pub use measure::{MeshResult, Reproduction, VariantResult, run};
pub use write::write;

//! The matrix of extremes: what every method does with every hostile input, measured, and what it is expected to do.
//!
//! | step | holds |
//! |---|---|
//! | [`scene`] | a mesh, a camera, depths, formats, a model matrix and options: what a method is given |
//! | [`row`] | an extreme: its scene, the plain scene that it is compared with, and the expected outcomes |
//! | [`families`] | all rows, a file per family |
//! | [`edges`], [`curves`], [`pictures`] | what a method yields for a scene, and how far it is from the truth |
//! | [`cell`] | the outcome of one method at one extreme |
//! | [`matrix`] | every row times every method; a panic stays in its cell |
//! | [`growth`] | how errors grow, beside naive 32-bit arithmetic, as charts |
//! | [`page`] | `docs/STABILITY.md` |
//! | [`show`] | the pictures behind the table, as files |
//!
//! `cargo run -p silhouette-extremes` writes the page anew; the tests of this package fail where an outcome is not the expected one
//! or the page says something else.

#![allow(clippy::missing_panics_doc, reason = "for tests: a panic is caught in its cell")]

pub mod cell;
pub mod curves;
pub mod edges;
pub mod families;
pub mod growth;
pub mod matrix;
pub mod meshes;
pub mod page;
pub mod pictures;
pub mod row;
pub mod scene;
pub mod show;
pub mod truth;

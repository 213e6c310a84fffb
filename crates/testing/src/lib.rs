//! What the tests of several silhouette crates need: meshes, views, random numbers, skips.
//!
//! For tests only: crates name it under `[dev-dependencies]`, and it is never published. A test asks for meshes by
//! property and for views by purpose, so that it says what it is about:
//!
//! ```
//! use silhouette_core::{FaceFacings, SilhouetteEdges, Topology, Viewpoint};
//! use silhouette_testing::{directions, zoo};
//!
//! for (name, mesh) in zoo::closed() {
//!     let topology = Topology::new(&mesh);
//!     for direction in directions::spread(5) {
//!         let facings = FaceFacings::new(&mesh, &Viewpoint::Orthographic { toward_viewer: direction.as_vec3() });
//!         let edges = SilhouetteEdges::of(&topology, &facings);
//!         assert_eq!(edges.boundary(&topology).count(), 0, "{name} has no boundary");
//!     }
//! }
//! ```
//!
//! | module | holds |
//! |---|---|
//! | [`zoo`] | built-in and defective meshes, by property |
//! | [`real_meshes`](mod@real_meshes) | the meshes in the folder that `SILHOUETTES_MODELS` names |
//! | [`edits`] | moved, joined, perforated, turned over: meshes made of others |
//! | [`strategies`] | meshes and viewpoints for proptest |
//! | [`lattice_scenes`] | small random scenes at whole coordinates, where ties are the rule |
//! | [`mutations`] | ways in which files go bad |
//! | [`pace`] | how long work goes on without asking whether it should |
//! | [`random`] | seeded random numbers |
//! | [`directions`] | directions spread over the sphere, along axes, one per octant |
//! | [`views`] | cameras that frame a mesh, orbits, viewpoints that are hard to get right |
//! | [`prepare`](mod@prepare) | a prepared mesh, an artefact, a method with its defaults, options that prepare quickly |
//! | [`integers`] | silhouette edges by unbounded integers, the oracle of exact methods |
//! | [`edges`] | end points and lengths of edges in double precision |
//! | [`progress`] | progress that cancels |
//! | [`threads`] | work in a pool of a given size |
//! | [`skip`] | the line that says that a test did not run |
//! | `gpu`, with feature `gpu` | the device that the tests of a process share |
//!
//! # Unit tests of `silhouette-core` and `silhouette-render`
//!
//! Cargo builds those crates twice for their own unit tests: as the crate under test, and as a dependency of this one. The
//! types of the two builds differ, so that a unit test inside `src/` cannot pass a mesh from here to the code around it.
//! Tests under `tests/` can.
//!
//! # Panics
//!
//! Functions panic wherever a test would: on the name of a shape that does not exist, on a mesh that cannot be framed.

#![allow(clippy::missing_panics_doc, reason = "a test fails by panicking; see the crate's documentation")]

pub mod directions;
pub mod edges;
pub mod edits;
#[cfg(feature = "gpu")]
pub mod gpu;
pub mod integers;
pub mod lattice_scenes;
pub mod mutations;
pub mod pace;
pub mod prepare;
pub mod progress;
pub mod random;
pub mod real_meshes;
pub mod skip;
pub mod strategies;
pub mod threads;
pub mod views;
pub mod zoo;

#[cfg(feature = "gpu")]
pub use gpu::{gpu_or_skip, shared_gpu_or_skip};
pub use progress::Cancelling;
pub use random::Random;
pub use real_meshes::{real_mesh, real_meshes};
pub use skip::skipped;
pub use threads::with_threads;
pub use zoo::builtin;

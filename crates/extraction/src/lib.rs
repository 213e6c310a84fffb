#![doc = include_str!("../README.md")]
//!
//! # Which method
//!
//! | method | cost per view | choose it when |
//! |---|---|---|
//! | [`BruteForce`] | O(F + S log S) | you want the plainest code that is right: it is the oracle of all other methods |
//! | [`BruteForceSimd`] | O(F + S), 10 bytes per face | the mesh moves, or is small, or a view is seen once |
//! | [`ClusterCones`] | about O(sqrt F) | the mesh stays and is seen from many viewpoints |
//! | [`Randomized`] | O(probes + S) | missing some small loops is a fair price for not looking at every face |
//!
//! All but the last are exact: they yield the same edges. [`FacePatches`] is the data that the second and third share.

pub mod brute_force;
pub mod brute_force_simd;
pub mod cluster_cones;
mod cones;
mod edge_order;
mod kernels;
mod loop_scratch;
mod patches;
pub mod randomized;
mod sweep;

pub use brute_force::BruteForce;
pub use brute_force_simd::BruteForceSimd;
pub use cluster_cones::ClusterCones;
pub use patches::FacePatches;
pub use randomized::{Randomized, RandomizedOptions};

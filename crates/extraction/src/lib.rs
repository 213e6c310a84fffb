//! Silhouette edges of a triangle mesh, found in object space.
//!
//! | method | cost a view | choose it when |
//! |---|---|---|
//! | [`BruteForce`] | O(F + S log S) | you want the plainest code that is right: it is the oracle of all other methods |
//! | [`BruteForceSimd`] | O(F + S), 10 bytes a face | the mesh moves, or is small, or a view is seen once |
//! | [`ClusterCones`] | about O(sqrt F) | the mesh stays and is seen from many viewpoints |

mod brute_force;
mod brute_force_simd;
mod cluster_cones;
mod cones;
mod edge_order;
mod patches;
mod sweep;

pub use brute_force::BruteForce;
pub use brute_force_simd::BruteForceSimd;
pub use cluster_cones::ClusterCones;
pub use patches::FacePatches;

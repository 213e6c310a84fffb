//! Silhouette edges of a triangle mesh, found in object space.
//!
//! | method | cost a view | choose it when |
//! |---|---|---|
//! | [`BruteForce`] | O(F + S log S) | you want the plainest code that is right: it is the oracle of all other methods |

mod brute_force;

pub use brute_force::BruteForce;

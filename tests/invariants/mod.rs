//! What holds of silhouettes in every view of every mesh: properties that no other test states, and a check of the index
//! `docs/INVARIANTS.md`, which names the tests of all of them.

mod index;
mod of_curves;
mod of_loops;
mod of_textures;
mod of_views;

//! The tracker against brute force, over orbits, jumps and hard places, and what it tells besides loops.

mod orbits;
mod scenes;

//! The tracker against brute force, over orbits, jumps and hard places, and what it tells besides loops.

mod allocations;
mod as_printed;
mod budget;
mod claims;
mod counted;
mod defects;
mod exact;
mod fallbacks;
mod identity;
mod moving;
mod orbits;
mod scenes;
mod stress;

//! Every method against brute force: the exact ones edge for edge and loop for loop.

mod allocations;
mod exactness;
mod loops;
mod moving;
mod random;

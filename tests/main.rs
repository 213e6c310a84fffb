//! Tests that need more than one crate, in one binary: one link step.

mod analytic;
mod cancelling;
mod cut_sets;
mod errors;
mod exactness;
mod lesser_devices;
mod measures;
mod oracle;
mod publishing;
mod seen;
mod tidy;

//! Tests that need more than one crate, in one binary: one link step.

#![allow(clippy::print_stderr, reason = "tests report what they measured")]

mod analytic;
mod cancelling;
mod cut_sets;
mod errors;
mod exact;
mod exactness;
mod invariance;
mod invariants;
mod lesser_devices;
mod measures;
mod oracle;
mod publishing;
mod seen;
mod tidy;

//! Skips that can be seen.

/// Says on stderr that a test, or a part of it, did not run, and why.
#[allow(clippy::print_stderr, reason = "a skip must be seen")]
pub fn skipped(test: &str, why: &str) {
    eprintln!("skipped {test}: {why}");
}

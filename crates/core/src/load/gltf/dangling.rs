//! The refusal of an index that leads out of an array of the document.

use crate::load::error::Problem;

/// An index into an array of the document that has only `count` elements.
pub(super) fn dangling(array: &'static str, count: usize) -> Problem {
    Problem::Expected { expected: "an index within its array", found: format!("one beyond the {count} {array}") }
}

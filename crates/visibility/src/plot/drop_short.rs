//! Step 7, drop short: paths that would be no more than a dot are left out.

use super::paths::Paths;

/// What was left out.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
pub struct Dropped {
    /// How many paths.
    pub paths: u64,
    /// Their length in page units.
    pub length: f64,
}

impl Dropped {
    /// Adds what was left out elsewhere.
    pub(super) fn add(&mut self, other: Self) {
        self.paths += other.paths;
        self.length += other.length;
    }
}

/// Drops paths shorter than `min_length` (page units), and at 0 those without length. O(points).
pub fn drop_short(paths: &Paths, min_length: f64) -> (Paths, Dropped) {
    let (mut kept, mut dropped) = (Paths::default(), Dropped::default());
    for path in paths.iter() {
        let length = path.length();
        if length >= min_length && length > 0.0 {
            kept.push(path);
        } else {
            dropped.paths += 1;
            dropped.length += length;
        }
    }
    (kept, dropped)
}

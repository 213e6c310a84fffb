//! [`LineCache`]: lines found before, for the same mesh, camera and options.

use crate::finder::LineFinder;
use crate::line_error::LineError;
use crate::lines::Lines;
use crate::options::LineOptions;
use silhouette_core::{Camera, Progress};
use std::collections::VecDeque;
use std::sync::Arc;

/// Remembers the lines of the last views, whatever scenes they were of.
///
/// Scenes are told apart by a 128-bit hash of positions, triangles, objects, labels and curves
/// ([`LineScene::fingerprint`](crate::LineScene::fingerprint)), cameras and options by equality. Nothing else decides what
/// the lines are.
#[derive(Debug)]
pub struct LineCache {
    capacity: usize,
    /// The latest last.
    entries: VecDeque<Entry>,
}

#[derive(Debug)]
struct Entry {
    fingerprint: u128,
    camera: Camera,
    options: LineOptions,
    lines: Arc<Lines>,
}

impl LineCache {
    /// A cache of at most `capacity` results; the one that was not asked for longest gives way.
    pub fn new(capacity: usize) -> Self {
        Self { capacity, entries: VecDeque::with_capacity(capacity.min(64)) }
    }

    /// The lines of a view, found now if they are not remembered. O(capacity) for lines that are.
    ///
    /// # Errors
    /// [`LineError`]; nothing is remembered of a search that failed.
    pub fn find(
        &mut self,
        finder: &mut LineFinder,
        camera: &Camera,
        options: &LineOptions,
        progress: &dyn Progress,
    ) -> Result<Arc<Lines>, LineError> {
        let fingerprint = finder.scene().fingerprint();
        let is_same =
            |entry: &Entry| entry.fingerprint == fingerprint && entry.camera == *camera && entry.options == *options;
        let remembered = self.entries.iter().position(is_same).and_then(|place| self.entries.remove(place));
        let entry = match remembered {
            Some(entry) => entry,
            None => {
                let lines = Arc::new(finder.find(camera, options, progress)?);
                Entry { fingerprint, camera: *camera, options: options.clone(), lines }
            }
        };
        let lines = Arc::clone(&entry.lines);
        self.entries.push_back(entry);
        while self.entries.len() > self.capacity {
            self.entries.pop_front();
        }
        Ok(lines)
    }

    /// Number of results that are remembered.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether nothing is remembered.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }
}

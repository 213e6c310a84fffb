//! [`History`]: frame times and errors of the last frames of a pane.

use std::collections::VecDeque;

/// How many frames are remembered.
pub const REMEMBERED: usize = 300;

/// Frame times and errors of the last frames of a pane, by the number of the frame.
#[derive(Debug, Clone, Default)]
pub struct History {
    times: VecDeque<(u64, f64)>,
    errors: VecDeque<(u64, f64)>,
}

impl History {
    /// A frame was drawn.
    pub fn drawn(&mut self, frame: u64, frame_ms: f64) {
        push(&mut self.times, frame, frame_ms);
    }

    /// A frame was measured.
    pub fn measured(&mut self, frame: u64, error: f64) {
        push(&mut self.errors, frame, error);
    }

    /// Forgets errors, which another method or option makes incomparable.
    pub fn clear(&mut self) {
        *self = Self::default();
    }

    /// Frame times in milliseconds.
    pub fn times(&self) -> Vec<[f64; 2]> {
        points(&self.times)
    }

    /// Errors, as far as frames were measured.
    pub fn errors(&self) -> Vec<[f64; 2]> {
        points(&self.errors)
    }

    /// The middle of the frame times, in milliseconds.
    pub fn median_ms(&self) -> Option<f64> {
        let mut sorted: Vec<f64> = self.times.iter().map(|&(_, time)| time).collect();
        sorted.sort_by(f64::total_cmp);
        sorted.get(sorted.len() / 2).copied()
    }
}

fn push(values: &mut VecDeque<(u64, f64)>, frame: u64, value: f64) {
    if values.len() == REMEMBERED {
        values.pop_front();
    }
    values.push_back((frame, value));
}

fn points(values: &VecDeque<(u64, f64)>) -> Vec<[f64; 2]> {
    values.iter().map(|&(frame, value)| [frame as f64, value]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_frames_are_remembered() {
        let mut history = History::default();
        assert_eq!(history.median_ms(), None);
        (0..1000).for_each(|frame| history.drawn(frame, frame as f64));
        history.measured(7, 0.5);
        assert_eq!(
            (history.times().len(), history.times()[0], history.errors()),
            (REMEMBERED, [700.0; 2], vec![[7.0, 0.5]])
        );
        assert_eq!(history.median_ms(), Some(850.0));
        history.clear();
        assert!(history.times().is_empty() && history.errors().is_empty());
    }
}

//! [`PublishedRates`]: frame rates that a method's publication prints.

/// A frame rate that the publication of a method prints beside that of another method, so that a comparison can set its own ratio
/// beside the printed one.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct PublishedRate {
    /// The model and its size, as printed: `Bunny, 69,451 faces`.
    pub model: &'static str,
    /// What was set, as printed: `N = 0.5`. Empty where there is nothing to set.
    pub setting: &'static str,
    /// Frames per second of the method, above 0.
    pub fps: f64,
    /// Frames per second of [`PublishedRates::against`], above 0.
    pub against_fps: f64,
}

/// A table of frame rates that the publication of a method prints.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct PublishedRates {
    /// Where they stand, and on which machine they were measured: `Hall 2003, on a Pentium III of 650 MHz`.
    pub place: &'static str,
    /// Name of the method of this workspace that stands for what the publication compares with.
    pub against: &'static str,
    /// The rows, in the order in which they are printed.
    pub rows: &'static [PublishedRate],
}

impl PublishedRate {
    /// A row of a table.
    pub const fn new(model: &'static str, setting: &'static str, fps: f64, against_fps: f64) -> Self {
        Self { model, setting, fps, against_fps }
    }

    /// How many times as many frames per second as the method that it is set beside: above 1 where it is faster.
    pub fn speed_up(&self) -> f64 {
        self.fps / self.against_fps
    }
}

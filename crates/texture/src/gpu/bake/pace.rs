//! [`Pace`]: how much work a dispatch may hold, so that none keeps a device busy for long.

use std::time::Duration;

/// What a dispatch should take: far below the seconds after which some systems reset a device, far above the cost of a dispatch.
const WANTED: Duration = Duration::from_millis(250);

/// Fewest and most elements per dispatch.
const RANGE: [u32; 2] = [1 << 10, 1 << 22];

/// The number of elements of the next dispatch, by the time that the last one took.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pace {
    elements: u32,
}

impl Default for Pace {
    fn default() -> Self {
        Self { elements: RANGE[0] * 2 }
    }
}

impl Pace {
    pub fn elements(&self) -> u32 {
        self.elements
    }

    /// Takes note of a dispatch of so many elements. Grows at most twofold, as samples differ in cost, and shrinks at once.
    pub fn note(&mut self, elements: u32, took: Duration) {
        let fit = f64::from(elements) * WANTED.as_secs_f64() / took.as_secs_f64().max(1e-9);
        let [least, most] = RANGE;
        // A short dispatch says little about a long one: it may only make the next one longer if it was full.
        let largest = if elements < self.elements { self.elements } else { self.elements.saturating_mul(2).min(most) };
        self.elements = (fit as u32).clamp(least, largest);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dispatches_come_close_to_the_wanted_time() {
        for per_second in [3.0e3, 1.0e5, 1.0e9] {
            let mut pace = Pace::default();
            for _ in 0..20 {
                pace.note(pace.elements(), Duration::from_secs_f64(f64::from(pace.elements()) / per_second));
            }
            let wanted = (per_second * 0.25).clamp(f64::from(RANGE[0]), f64::from(RANGE[1]));
            assert!((f64::from(pace.elements()) / wanted - 1.0).abs() < 0.01, "{per_second}: {}", pace.elements());
        }
    }

    #[test]
    fn a_dispatch_that_was_not_full_does_not_make_the_next_one_longer() {
        let mut pace = Pace::default();
        let before = pace.elements();
        pace.note(before - 1, Duration::from_micros(1));
        assert_eq!(pace.elements(), before);
        pace.note(10, Duration::from_secs(1));
        assert_eq!(pace.elements(), RANGE[0]);
    }
}

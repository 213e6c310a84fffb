//! Time that threads have run: what a frame costs, however many other programs share the cores. Known on Linux.

use std::time::Duration;

/// What the scheduler says of a thread.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ThreadTime {
    /// How long it ran.
    pub ran: Duration,
    /// How long it could have run and waited for a core.
    pub waited: Duration,
}

impl ThreadTime {
    /// Of the calling thread so far, where that is known.
    pub fn now() -> Option<Self> {
        Self::of_text(&std::fs::read_to_string("/proc/thread-self/schedstat").ok()?)
    }

    fn of_text(text: &str) -> Option<Self> {
        let mut numbers = text.split_whitespace().map_while(|word| word.parse().ok()).map(Duration::from_nanos);
        Some(Self { ran: numbers.next()?, waited: numbers.next()? })
    }

    /// What has been added since `earlier`.
    #[must_use]
    pub fn since(self, earlier: Self) -> Self {
        Self { ran: self.ran.saturating_sub(earlier.ran), waited: self.waited.saturating_sub(earlier.waited) }
    }
}

/// How long all threads of this process ran so far, in steps of 10 ms, where that is known.
pub fn process_time() -> Option<Duration> {
    of_stat(&std::fs::read_to_string("/proc/self/stat").ok()?)
}

/// Linux states the fields of `stat` in hundredths of a second.
const TICK: Duration = Duration::from_millis(10);

/// User and system time: the 14th and 15th fields, of which the second, in parentheses, may hold anything.
fn of_stat(text: &str) -> Option<Duration> {
    let mut fields = text.rsplit_once(')')?.1.split_whitespace().skip(11).map_while(|field| field.parse::<u32>().ok());
    let ticks = fields.next()?.saturating_add(fields.next()?);
    Some(TICK * ticks)
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_testing::skipped;

    #[test]
    fn fields_are_found() {
        let text = "7 (a) b) S 1 7 7 0 -1 4194560 99 0 0 0 123 45 0 0 20 0 1 0 5 6 7";
        assert_eq!(of_stat(text), Some(Duration::from_millis(1680)));
        assert_eq!(of_stat("7 (a) S 1 2"), None);
        let time = ThreadTime { ran: Duration::from_nanos(120), waited: Duration::from_nanos(30) };
        assert_eq!(ThreadTime::of_text("120 30 4\n"), Some(time));
        assert_eq!(ThreadTime::of_text("120"), None);
    }

    #[test]
    fn time_that_a_thread_ran_is_counted() {
        let (Some(before), Some(_)) = (ThreadTime::now(), process_time()) else {
            return skipped("time_that_a_thread_ran_is_counted", "this system has no /proc");
        };
        let mut sum = 0_u64;
        while ThreadTime::now().unwrap().since(before).ran < Duration::from_millis(5) {
            sum = (0..10_000).fold(sum, |sum, number| sum.wrapping_mul(31).wrapping_add(number));
        }
        assert!(ThreadTime::now().unwrap().ran > before.ran, "{sum}");
    }
}

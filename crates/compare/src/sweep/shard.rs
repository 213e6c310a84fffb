//! [`Shard`]: the cells that one of several processes measures.

use std::fmt;
use std::num::NonZeroU32;
use std::str::FromStr;

/// One of several processes that share the cells of a comparison, each taking every so many-th.
///
/// The number of a cell alone decides, so that no process has to know of another; shards may take different times.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// From 0, below `count`.
    index: u32,
    count: NonZeroU32,
}

/// A text is no shard.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("expected a shard such as 1/4 to 4/4, not '{text}'")]
pub struct ParseShardError {
    /// The text.
    pub text: String,
}

/// The variables that Slurm sets for each job of an array.
const SLURM: [&str; 4] =
    ["SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX", "SLURM_ARRAY_TASK_COUNT"];

impl Shard {
    /// All cells.
    pub const WHOLE: Self = Self { index: 0, count: NonZeroU32::MIN };

    /// Whether a cell is one of this shard's.
    pub fn holds(self, cell: usize) -> bool {
        cell % self.count.get() as usize == self.index as usize
    }

    /// What Slurm says of a job in an array whose numbers are consecutive; `None` outside of one. `variable` is the environment.
    ///
    /// # Errors
    /// [`ParseShardError`]: the numbers leave gaps, as `--array=0-10:2` does, or are no numbers.
    pub fn of_slurm(variable: impl Fn(&str) -> Option<String>) -> Result<Option<Self>, ParseShardError> {
        let [id, first, last, count] = SLURM.map(variable);
        let (Some(id), Some(count)) = (id, count) else { return Ok(None) };
        let first = first.unwrap_or_else(|| "0".to_owned());
        let shard = || {
            let (first, count) = (first.parse().ok()?, count.parse().ok()?);
            // With gaps the numbers reach farther than there are jobs.
            let reach = last
                .as_ref()
                .map_or(Some(count), |last| last.parse::<u32>().ok()?.checked_sub(first)?.checked_add(1))?;
            let index = id.parse::<u32>().ok()?.checked_sub(first)?;
            Self::new(index, count).filter(|_| reach == count)
        };
        let text = || format!("job {id} of an array of {count} from {first} on");
        shard().map(Some).ok_or_else(|| ParseShardError { text: text() })
    }

    fn new(index: u32, count: u32) -> Option<Self> {
        let count = NonZeroU32::new(count)?;
        (index < count.get()).then_some(Self { index, count })
    }
}

impl FromStr for Shard {
    type Err = ParseShardError;

    /// Reads `1/4` to `4/4`.
    fn from_str(text: &str) -> Result<Self, ParseShardError> {
        let shard = || {
            let (number, count) = text.split_once('/')?;
            Self::new(number.parse::<u32>().ok()?.checked_sub(1)?, count.parse().ok()?)
        };
        shard().ok_or_else(|| ParseShardError { text: text.to_owned() })
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index + 1, self.count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cell_is_of_exactly_one_shard() {
        for count in 1..7 {
            let shards: Vec<Shard> = (1..=count).map(|number| format!("{number}/{count}").parse().unwrap()).collect();
            for cell in 0..20 {
                assert_eq!(shards.iter().filter(|shard| shard.holds(cell)).count(), 1, "{cell} of {count}");
            }
        }
        assert_eq!("1/1".parse(), Ok(Shard::WHOLE));
        assert_eq!("3/4".parse::<Shard>().unwrap().to_string(), "3/4");
    }

    #[test]
    fn what_is_no_shard_is_refused() {
        for text in ["", "1", "0/4", "5/4", "1/0", "-1/4", "1/4/2", "a/b", "1.5/4"] {
            assert!(text.parse::<Shard>().is_err(), "{text}");
        }
    }

    #[test]
    fn slurm_numbers_jobs_from_anywhere() {
        let job = |id: &str, first: &str, last: &str, count: &str| {
            let values = [id, first, last, count].map(str::to_owned);
            Shard::of_slurm(|name| SLURM.iter().position(|&known| known == name).map(|at| values[at].clone()))
        };
        assert_eq!(job("0", "0", "3", "4"), Ok(Some("1/4".parse().unwrap())));
        assert_eq!(job("13", "10", "13", "4"), Ok(Some("4/4".parse().unwrap())));
        for gap in ["0", "2", "8"] {
            assert!(job(gap, "0", "10", "6").is_err(), "numbers with gaps");
        }
        assert!(job("x", "0", "3", "4").is_err());
        assert_eq!(Shard::of_slurm(|_| None), Ok(None));
    }
}

//! The numbers of threads that are measured.

use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

/// A number of threads, waiting for work.
pub struct Threads {
    pub count: u32,
    pool: ThreadPool,
}

impl Threads {
    pub fn new(count: u32) -> Result<Self, ThreadPoolBuildError> {
        Ok(Self { count, pool: ThreadPoolBuilder::new().num_threads(count as usize).build()? })
    }

    /// Runs `work` on one of the threads; what it does in parallel is shared with the others.
    pub fn install<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        self.pool.install(work)
    }
}

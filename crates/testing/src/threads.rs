//! Work in a pool of a given size.

/// Runs `work` in a pool of `count` threads: parallel loops inside it use no others.
pub fn with_threads<T: Send>(count: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap().install(work)
}

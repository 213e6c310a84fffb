//! The GPU that tests draw with, and a visible skip where there is none.

use crate::skip::skipped;
use silhouette_render::{AdapterChoice, Gpu};
use std::sync::{Arc, OnceLock};

/// One device for all tests of a process: devices that are created at once crash some drivers.
static GPU: OnceLock<Result<Arc<Gpu>, String>> = OnceLock::new();

/// The device that the tests of this process share, on the adapter that the environment names; or `None`, after a line on
/// stderr that `test` was skipped.
///
/// # Panics
/// If there is no adapter and `SILHOUETTES_GPU=require` is set, so that a machine meant to test the GPU cannot skip in
/// silence.
pub fn gpu_or_skip(test: &str) -> Option<&'static Gpu> {
    shared_gpu_or_skip(test).map(|gpu| &**gpu)
}

/// The same for what shares its device among threads.
///
/// # Panics
/// As [`gpu_or_skip`].
pub fn shared_gpu_or_skip(test: &str) -> Option<&'static Arc<Gpu>> {
    let open = || AdapterChoice::from_env().and_then(Gpu::new).map(Arc::new).map_err(|error| error.to_string());
    let gpu = GPU.get_or_init(open);
    match gpu {
        Ok(gpu) => Some(gpu),
        Err(error) => {
            let required = std::env::var_os("SILHOUETTES_GPU").is_some_and(|value| value == "require");
            assert!(!required, "{test}: SILHOUETTES_GPU=require, but {error}");
            skipped(test, error);
            None
        }
    }
}

//! A device for tests, with a visible skip where there is none.

use crate::adapter_choice::AdapterChoice;
use crate::gpu::Gpu;
use std::sync::OnceLock;

/// One device for all tests of a process: devices that are created at once crash some drivers.
static GPU: OnceLock<Result<Gpu, String>> = OnceLock::new();

/// The shared device, or `None` after a line on stderr that `test` was skipped.
///
/// # Panics
/// Without an adapter if `SILHOUETTES_GPU=require`, so that a machine meant to test the GPU cannot skip silently.
#[allow(clippy::print_stderr, reason = "a skipped test has to be seen")]
pub fn gpu_or_skip(test: &str) -> Option<&'static Gpu> {
    let gpu = GPU.get_or_init(|| AdapterChoice::from_env().and_then(Gpu::new).map_err(|error| error.to_string()));
    match gpu {
        Ok(gpu) => Some(gpu),
        Err(error) => {
            let required = std::env::var_os("SILHOUETTES_GPU").is_some_and(|value| value == "require");
            assert!(!required, "{test}: SILHOUETTES_GPU=require, but {error}");
            eprintln!("skipped {test}: {error}");
            None
        }
    }
}

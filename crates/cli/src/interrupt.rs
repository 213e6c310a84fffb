//! Ctrl-C: the first one asks the work to stop, so that nothing half-written stays behind; the second one ends the process at
//! once.

use std::sync::atomic::{AtomicBool, Ordering};

static ASKED: AtomicBool = AtomicBool::new(false);
static WAITS: AtomicBool = AtomicBool::new(false);

/// Exit code of a command that was interrupted, as shells have it for SIGINT.
pub const EXIT_CODE: u8 = 130;

/// Listens for Ctrl-C, termination and the end of the terminal, from now on.
pub fn listen() {
    let stop = || {
        if ASKED.swap(true, Ordering::Relaxed) || WAITS.load(Ordering::Relaxed) {
            std::process::exit(EXIT_CODE.into());
        }
    };
    // Fails where a handler is there already; the default then ends the process.
    let _ = ctrlc::try_set_handler(stop);
}

/// Does what waits for others, for input that does not come for example: Ctrl-C then ends the process at once.
pub fn while_waiting<T>(wait: impl FnOnce() -> T) -> T {
    WAITS.store(true, Ordering::Relaxed);
    let result = wait();
    WAITS.store(false, Ordering::Relaxed);
    result
}

/// Whether the work was asked to stop.
pub fn is_asked() -> bool {
    ASKED.load(Ordering::Relaxed)
}

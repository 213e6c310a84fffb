//! Mesa's Vulkan driver asks a display server which device to list first, and writes to stderr where there is no server to be found.
//! The lines are no concern of this program's user, and a variable of the environment keeps Mesa from asking.

/// Where Mesa would write such lines, starts the program anew in this process, with the variable set. Call it before there are threads
/// or open files.
///
/// A process cannot change its own environment safely once it may have threads, and `exec` changes it while there is one.
#[cfg(target_os = "linux")]
pub fn silence() {
    use std::os::unix::process::CommandExt;

    const ASKS_NOBODY: &str = "NODEVICE_SELECT";
    let is_set = |name: &str| std::env::var_os(name).is_some();
    if is_set("XDG_RUNTIME_DIR") || is_set(ASKS_NOBODY) {
        return;
    }
    let mut arguments = std::env::args_os();
    if let (Ok(program), Some(name)) = (std::env::current_exe(), arguments.next()) {
        // Returns where it fails only: the lines then appear.
        let _ = std::process::Command::new(program).arg0(name).args(arguments).env(ASKS_NOBODY, "1").exec();
    }
}

/// Nothing: Mesa asks on Linux alone.
#[cfg(not(target_os = "linux"))]
pub fn silence() {}

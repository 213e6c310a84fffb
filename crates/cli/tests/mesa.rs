//! What Mesa writes to stderr does not reach the user.

use std::process::Command;

#[test]
fn no_line_of_the_driver_s_reaches_the_user() {
    for arguments in [&["doctor"][..], &["render", "builtin:cube", "--method", "no-such", "-o", "x.png"]] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_silhouettes"));
        command.args(arguments).env_remove("XDG_RUNTIME_DIR").env_remove("NODEVICE_SELECT");
        let output = command.output().unwrap();
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert!(!stderr.contains("XDG_RUNTIME_DIR"), "{stderr}");
        // The program began anew with the same arguments.
        let expected = if arguments[0] == "doctor" { !output.stdout.is_empty() } else { stderr.contains("no-such") };
        assert!(expected, "{arguments:?}: {stderr}");
    }
}

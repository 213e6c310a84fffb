//! Parses and validates the resolved text of a stage.

use naga::valid::{Capabilities, ValidationFlags, Validator};

/// Checks a stage with naga: that its text is valid WGSL and has an entry point.
///
/// # Errors
/// The path of the stage and naga's message. Its lines are those of the resolved text, of which `resolved_path` names the file.
pub fn validate(path: &str, text: &str, resolved_path: &str) -> Result<(), String> {
    let module = naga::front::wgsl::parse_str(text)
        .map_err(|error| format!("{path}: {}", error.emit_to_string_with_path(text, resolved_path)))?;
    if module.entry_points.is_empty() {
        return Err(format!("{path} has no entry point, and no stage imports it"));
    }
    Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .map_err(|error| format!("{path}: {}", error.emit_to_string_with_path(text, resolved_path)))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::validate;

    #[test]
    fn a_broken_stage_is_refused_with_its_file_and_the_reason() {
        let check = |text| validate("crate/stage.wgsl", text, "out/stage.wgsl");
        assert_eq!(check("@compute @workgroup_size(1) fn main() {}"), Ok(()));
        for (text, reason) in [
            ("@compute @workgroup_size(1) fn main() { let a = b; }", "b"),
            ("@compute @workgroup_size(1) fn main() { let a: u32 = 1.5; }", "u32"),
            ("@vertex fn main() {}", "main"),
            ("const A: u32 = 1u;", "no entry point"),
        ] {
            let message = check(text).unwrap_err();
            assert!(message.starts_with("crate/stage.wgsl") && message.contains(reason), "{text}: {message}");
        }
        let message = check("\nfn main() { let a = b; }").unwrap_err();
        assert!(message.contains("out/stage.wgsl:2"), "the place: {message}");
    }
}

//! What a build without some of the formats says.
#![cfg(not(feature = "obj"))]

use silhouette_core::NoProgress;
use silhouette_core::load::{Format, read};

#[test]
fn a_format_that_is_switched_off_names_its_feature() {
    let line = read(Format::Obj, "a.obj", b"v 0 0 0", &NoProgress).unwrap_err().to_string();
    assert_eq!(line, "a.obj: this build does not read OBJ; enable the cargo feature `obj` of silhouette-core");
}

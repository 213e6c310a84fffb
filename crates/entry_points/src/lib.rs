//! What arbitrary bytes must not break: one function per way in, called by the fuzz targets of `fuzz/` and, over seeds, changed
//! seeds and random bytes, by the property tests of this crate.
//!
//! | function | bytes become |
//! |---|---|
//! | [`mesh_files`] | a format, options, a file of that format; then welded, healed, turned, inspected, drawn |
//! | [`siltex`] | a silhouette texture, with its checksums as they are or set right |
//! | [`text`] | a command line, a scene, options of methods, lengths, pages, colours, planes, shapes |
//! | [`triangles`] | vertices, indices that may be none, viewpoints: every extractor against the definition |
//! | [`drawing`] | vertices, triangles, a camera, which lines and pens: visible lines in every file format |
//! | [`foreign`] | a drawing by another program: SVG, JSON or PNG |
//!
//! Each panics where something is broken, and says in its documentation what holds otherwise. What stands before the file itself are
//! printable characters, so that seeds can be read and changed by hand.
//!
//! [`seeds`] makes inputs that each function gets far with; `cargo run -p silhouette-entry-points --example write_seeds` writes them
//! to `data/seeds`.

#![allow(clippy::missing_panics_doc, reason = "an entry point fails by panicking; see the crate's documentation")]

mod bytes;
mod drawing;
mod foreign;
mod mesh_files;
pub mod seeds;
mod siltex;
mod text;
mod triangles;

pub use drawing::drawing;
pub use foreign::foreign;
pub use mesh_files::mesh_files;
pub use siltex::siltex;
pub use text::text;
pub use triangles::triangles;

/// An entry point: whether it was given something that it accepts.
pub type EntryPoint = fn(&[u8]) -> bool;

/// Every entry point by its name, which is that of its fuzz target and of its folder of seeds.
pub const ALL: [(&str, EntryPoint); 6] = [
    ("mesh_files", mesh_files),
    ("siltex", siltex),
    ("text", text),
    ("triangles", triangles),
    ("drawing", drawing),
    ("foreign", foreign),
];

/// Holds an error's message to the rule for what is printed as it is: one line that says something.
fn check_line(message: &str) {
    assert!(!message.trim().is_empty() && !message.contains(char::is_control), "no single line: {message:?}");
}

/// Holds an error's message to the rule for what quotes what it was given, which the command line escapes: it says something.
fn check_message(message: &str) {
    assert!(!message.trim().is_empty(), "an error without a message");
}

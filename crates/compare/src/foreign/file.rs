//! [`read`]: a file, by the ending of its name.

use super::edge_list::{self, Claims, EdgeList};
use super::error::{ForeignError, ForeignFault};
use super::trace::Frame;
use super::{Drawing, picture, svg};
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Most bytes of a file: some millions of points as text.
pub const MAX_BYTES: u64 = 1 << 26;

/// What a file holds of a view.
#[derive(Debug, Clone, PartialEq)]
pub struct ForeignFile {
    /// What it draws.
    pub drawing: Drawing,
    /// What it says about where it comes from.
    pub claims: Claims,
    /// What its user should know.
    pub notes: Vec<String>,
}

/// Reads a file of at most [`MAX_BYTES`]: lines from `.json` and `.svg`, a picture from `.png`. O(bytes).
///
/// # Errors
/// [`ForeignError`] names the file, the place in it and what would fit.
pub fn read(path: &Path, frame: Frame) -> Result<ForeignFile, ForeignError> {
    read_file(path, frame).map_err(|fault| fault.in_file(path))
}

fn read_file(path: &Path, frame: Frame) -> Result<ForeignFile, ForeignFault> {
    let ending = path.extension().unwrap_or_default();
    let is = |known: &str| ending.eq_ignore_ascii_case(known);
    if !["json", "svg", "png"].iter().any(|known| is(known)) {
        return Err(ForeignFault::UnknownEnding);
    }
    let mut bytes = Vec::new();
    File::open(path)?.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(ForeignFault::TooLong { limit: MAX_BYTES });
    }
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    if is("json") {
        let EdgeList { drawing, claims, notes } = edge_list::read(text, frame)?;
        return Ok(ForeignFile { drawing, claims, notes });
    }
    let (drawing, notes) = if is("svg") {
        let (lines, notes) = svg::read(text, frame)?;
        (Drawing::Lines(lines), notes)
    } else {
        let picture = picture::read(&bytes, frame.size)?;
        let notes = picture::note(&picture).into_iter().collect();
        (Drawing::Picture(picture), notes)
    };
    Ok(ForeignFile { drawing, claims: Claims::default(), notes })
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Frame = Frame { size: [20, 10], pen_width_px: 2.0 };

    #[test]
    fn files_are_read_by_their_ending_and_faults_name_them() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        std::fs::write(path("a.JSON"), "\u{feff}{\"edges\":[[0,1]]}").unwrap();
        std::fs::write(
            path("a.svg"),
            r#"<svg xmlns="http://www.w3.org/2000/svg"><path stroke="red" d="M1 1 9 9"/></svg>"#,
        )
        .unwrap();
        std::fs::write(path("a.pdf"), "%PDF").unwrap();
        assert_eq!(read(&path("a.JSON"), FRAME).unwrap().drawing, Drawing::Edges(vec![[0, 1]]));
        assert!(matches!(read(&path("a.svg"), FRAME).unwrap().drawing, Drawing::Lines(lines) if lines.len() == 1));
        for (name, expected) in
            [("a.pdf", "unknown form; lines are read from .json and .svg"), ("b.png", "No such file")]
        {
            let message = read(&path(name), FRAME).unwrap_err().to_string();
            assert!(message.contains(&format!("{name}: {expected}")), "{message}");
        }
        let long = File::create(path("long.json")).unwrap();
        long.set_len(MAX_BYTES + 1).unwrap();
        assert!(read(&path("long.json"), FRAME).unwrap_err().to_string().contains("longer than 67108864 bytes"));
    }
}

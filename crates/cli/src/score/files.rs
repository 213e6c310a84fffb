//! Which file shows which frame.

use crate::failure::Failure;
use std::path::{Path, PathBuf};

/// What stands for the number of a frame in the name of a file.
const FRAME: &str = "{frame}";

/// A file that shows a frame.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FileOfView {
    /// Index of the frame among the scored ones.
    pub view: usize,
    /// The file.
    pub path: PathBuf,
}

/// Pairs files with frames: those of `--frame` in order, or all scored ones. Each frame has one file at most.
pub fn of_views(lines: &[PathBuf], asked: &[u32], scored: &[u32]) -> Result<Vec<FileOfView>, Failure> {
    let known = || scored.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
    let mut views = Vec::new();
    for &frame in asked {
        let Some(view) = scored.iter().position(|&scored| scored == frame) else {
            return Err(Failure::Input(format!("--frame {frame}: is no scored frame; there are {}", known())));
        };
        if views.contains(&view) {
            return Err(Failure::Input(format!("--frame {frame}: is there twice; give one file per frame")));
        }
        views.push(view);
    }
    if views.is_empty() {
        views.extend(0..scored.len());
    }
    let paths: Vec<PathBuf> = match lines {
        [pattern] if has_frame(pattern) => views.iter().map(|&view| with_frame(pattern, scored[view])).collect(),
        files if files.iter().any(|file| has_frame(file)) => {
            return Err(Failure::Input(format!("--lines: a name with {FRAME} stands for all files; give no other")));
        }
        files => files.to_vec(),
    };
    if paths.len() != views.len() {
        let (files, frames) = (paths.len(), views.len());
        let of = if asked.is_empty() { format!("scored frames ({})", known()) } else { "--frame".to_owned() };
        return Err(Failure::Input(format!(
            "--lines: {files} files for {frames} {of}; give --frame N for each file, or one name with {FRAME} in it"
        )));
    }
    Ok(views.into_iter().zip(paths).map(|(view, path)| FileOfView { view, path }).collect())
}

/// The name of the program that wrote a file, as far as its name says: what is before the ending, without the frame.
pub fn program(first: &Path) -> String {
    let stem = first.file_stem().unwrap_or_default().to_string_lossy();
    let bare = stem.replace(FRAME, "");
    let bare = bare.trim_matches(|letter: char| !letter.is_alphanumeric());
    if bare.is_empty() { stem.into_owned() } else { bare.to_owned() }
}

fn has_frame(path: &Path) -> bool {
    path.to_str().is_some_and(|path| path.contains(FRAME))
}

fn with_frame(path: &Path, frame: u32) -> PathBuf {
    path.to_string_lossy().replace(FRAME, &frame.to_string()).into()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn paired(lines: &[&str], asked: &[u32]) -> Result<Vec<(usize, String)>, String> {
        let lines: Vec<PathBuf> = lines.iter().map(PathBuf::from).collect();
        match of_views(&lines, asked, &[2, 7, 12]) {
            Ok(files) => Ok(files.into_iter().map(|file| (file.view, file.path.display().to_string())).collect()),
            Err(Failure::Input(message)) => Err(message),
            Err(other) => panic!("{other:?}"),
        }
    }

    #[test]
    fn files_go_with_frames_in_order() {
        let pairs = |pairs: &[(usize, &str)]| Ok(pairs.iter().map(|&(view, path)| (view, path.to_owned())).collect());
        assert_eq!(paired(&["a", "b", "c"], &[]), pairs(&[(0, "a"), (1, "b"), (2, "c")]));
        assert_eq!(paired(&["a", "b"], &[12, 2]), pairs(&[(2, "a"), (0, "b")]));
        assert_eq!(paired(&["d/f-{frame}.svg"], &[]), pairs(&[(0, "d/f-2.svg"), (1, "d/f-7.svg"), (2, "d/f-12.svg")]));
        assert_eq!(paired(&["{frame}.png"], &[7]), pairs(&[(1, "7.png")]));
    }

    #[test]
    fn what_does_not_pair_is_refused_with_what_would() {
        let refused = |lines: &[&str], asked: &[u32]| paired(lines, asked).unwrap_err();
        assert_eq!(
            refused(&["a"], &[]),
            "--lines: 1 files for 3 scored frames (2, 7, 12); give --frame N for each file, or one name with {frame} in it"
        );
        assert!(refused(&["a", "b"], &[7]).starts_with("--lines: 2 files for 1 --frame;"));
        assert!(refused(&["a"], &[3]).contains("--frame 3: is no scored frame; there are 2, 7, 12"));
        assert!(refused(&["a", "b"], &[7, 7]).contains("--frame 7: is there twice"));
        assert!(refused(&["a", "{frame}"], &[2, 7]).contains("stands for all files"));
    }

    #[test]
    fn programs_are_called_as_their_files() {
        let names = ["out/line-art-{frame}.svg", "{frame}.json", "a.b.png"].map(|path| program(path.as_ref()));
        assert_eq!(names, ["line-art", "{frame}", "a.b"]);
    }
}

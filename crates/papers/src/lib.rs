#![doc = include_str!("../README.md")]
//!
//! # Adding a paper
//! A paper is one folder and one line of [`ALL`]. Its folder holds the printed numbers, the variants, the measurement, and
//! the [`Table`]s that it fills; it exports one [`Paper`]. Everything else is derived from the tables here:
//!
//! 1. [`table`]: columns, rows, and cells with our value, the paper's, and whether the two are [`Comparable`].
//! 2. [`figure`]: each cell as rows of `tables.jsonl` and `tables.csv`.
//! 3. [`terminal`]: the tables as text. [`chart`]: the tables as SVG. [`picture`]: what was drawn. [`page`]: all of it for a browser.
//! 4. [`files`]: a directory that appears as a whole.
//!
//! [`paper`]: what a paper supplies, what it gets for a run, and what the run yields. [`error`]: how a run fails.

pub mod chart;
mod directions;
mod drawings;
pub mod error;
pub mod figure;
pub mod files;
pub mod hall_2003;
mod label;
pub mod page;
pub mod paper;
pub mod picture;
pub mod raskar_cohen_1999;
pub mod table;
pub mod terminal;
pub mod wang_2008;
pub mod wu_2006;
pub mod zink;

pub use error::{Cause, PaperError};
pub use figure::Figure;
pub use files::{check_target, write};
pub use paper::{Measured, Paper, Reproduction, Run};
pub use picture::Picture;
pub use silhouette_compare::result_directory::WriteError;
pub use table::{Cell, Column, Comparable, Range, Row, Table};

/// Every paper, in the order of publication. To add one, add a line.
pub static ALL: [&Paper; 5] =
    [&raskar_cohen_1999::PAPER, &hall_2003::PAPER, &wu_2006::PAPER, &zink::PAPER, &wang_2008::PAPER];

/// The paper of this [name](Paper::name).
pub fn find(name: &str) -> Option<&'static Paper> {
    ALL.into_iter().find(|paper| paper.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::shapes;

    #[test]
    fn papers_are_found_by_unique_names_and_have_meshes_to_fall_back_on() {
        for paper in ALL {
            assert!(std::ptr::eq(find(paper.name).unwrap(), paper), "{}", paper.name);
            assert!(!paper.default_meshes.is_empty());
            for name in paper.default_meshes {
                assert!(shapes::by_name(name.strip_prefix("builtin:").unwrap()).is_ok(), "{name}");
            }
        }
        assert!(find("all").is_none(), "the command line's word for every paper");
    }
}

//! The parts of the documentation that are made: tables of methods, of what they cost and of where they err, and the gallery.
//!
//! `cargo run -p silhouette-docs` writes them anew, `-- --check` only says whether they are up to date, as a test does. Between two
//! marks, which Markdown does not show, stands what is made; what stands around them is written by hand.
//!
//! | step | makes |
//! |---|---|
//! | [`methods`] | tables of methods and the gallery's text, from [`MethodInfo`](silhouette_core::MethodInfo) and what methods can do |
//! | [`extraction_times`], [`line_errors`], [`coherence`] | tables of measurements, from `docs/results` |
//! | [`pictures`] | the gallery's pictures, on demand |
//! | [`region`] | the file in which they stand |

pub mod coherence;
pub mod extraction_times;
pub mod line_errors;
pub mod methods;
pub mod number;
pub mod pictures;
pub mod region;
pub mod results;

use region::RegionError;
use results::ResultError;
use silhouette_compare::registry::Registry;
use std::path::{Path, PathBuf};

/// Why documentation could not be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DocsError {
    /// Results could not be read.
    #[error(transparent)]
    Results(#[from] ResultError),
    /// A file has no place for what is made, or half of one.
    #[error("{}: {cause}", file.display())]
    Region {
        /// The file.
        file: PathBuf,
        /// What is wrong with it.
        cause: RegionError,
    },
    /// A file could not be read or written.
    #[error("{}: {cause}", file.display())]
    File {
        /// The file.
        file: PathBuf,
        /// Why.
        cause: std::io::Error,
    },
}

/// A file of the documentation as it should be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Made {
    /// The file.
    pub file: PathBuf,
    /// What it holds.
    pub committed: String,
    /// What it should hold.
    pub made: String,
}

impl Made {
    /// Whether the file is as it should be.
    pub fn is_up_to_date(&self) -> bool {
        self.committed == self.made
    }
}

/// Every file below `root`, the project's, of which parts are made.
///
/// # Errors
/// [`DocsError`].
pub fn make(root: &Path) -> Result<Vec<Made>, DocsError> {
    let registry = Registry::builtin();
    let entries = registry.entries();
    let readme = [("methods", methods::overview(entries, "docs/"))];
    let page = [
        ("methods", methods::costs(entries)),
        ("gallery", methods::gallery(entries)),
        ("extraction times", extraction_times::table(root)?),
        ("line errors", line_errors::table(root)?),
        ("coherence", coherence::table(root)?),
    ];
    Ok(vec![made(root.join("README.md"), &readme)?, made(root.join("docs/METHODS.md"), &page)?])
}

fn made(file: PathBuf, regions: &[(&str, String)]) -> Result<Made, DocsError> {
    let committed = match std::fs::read_to_string(&file) {
        Ok(text) => text,
        Err(cause) => return Err(DocsError::File { file, cause }),
    };
    let mut made = committed.clone();
    for (name, contents) in regions {
        made = match region::replaced(&made, name, contents) {
            Ok(text) => text,
            Err(cause) => return Err(DocsError::Region { file, cause }),
        };
    }
    Ok(Made { file, committed, made })
}

/// Writes the files that are not up to date and yields them.
///
/// # Errors
/// [`DocsError`].
pub fn write(root: &Path) -> Result<Vec<PathBuf>, DocsError> {
    let mut written = Vec::new();
    for Made { file, committed, made } in make(root)? {
        if committed != made {
            std::fs::write(&file, made).map_err(|cause| DocsError::File { file: file.clone(), cause })?;
            written.push(file);
        }
    }
    Ok(written)
}

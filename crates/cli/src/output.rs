//! Output files: written beside their place, moved there when complete, so that a failed run leaves nothing behind.

use crate::failure::Failure;
use std::io::Write;
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// Where a result goes. Made before the work starts, so that an unwritable place fails at once.
pub enum Output {
    /// To standard output.
    Stdout,
    /// To a file.
    File {
        /// Its final place.
        path: PathBuf,
        /// The same folder, another name; removed when dropped.
        beside: NamedTempFile,
    },
}

impl Output {
    /// An output at `path`, or on standard output where there is none.
    pub fn create(path: Option<&Path>) -> Result<Self, Failure> {
        let Some(path) = path else { return Ok(Self::Stdout) };
        if path.is_dir() {
            return Err(Failure::Input(format!("{}: is a directory; name a file", path.display())));
        }
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let mut builder = tempfile::Builder::new();
        builder.prefix(".silhouettes-").suffix(".part");
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let beside = builder.tempfile_in(folder).map_err(|error| cannot_write(path, &error))?;
        Ok(Self::File { path: path.to_owned(), beside })
    }

    /// Writes the whole result.
    pub fn write(self, bytes: &[u8]) -> Result<(), Failure> {
        match self {
            Self::Stdout => match std::io::stdout().lock().write_all(bytes) {
                // A reader such as `head` that has seen enough is no failure.
                Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
                result => result.map_err(|error| Failure::Run(format!("standard output: {error}"))),
            },
            Self::File { path, mut beside } => {
                beside.write_all(bytes).map_err(|error| cannot_write(&path, &error))?;
                beside.persist(&path).map_err(|error| cannot_write(&path, &error.error))?;
                Ok(())
            }
        }
    }
}

fn cannot_write(path: &Path, error: &std::io::Error) -> Failure {
    Failure::Input(format!("{}: cannot be written ({error}); choose a place that can", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_appears_whole_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.json");
        drop(Output::create(Some(&path)).unwrap());
        assert_eq!(folder.path().read_dir().unwrap().count(), 0);
        Output::create(Some(&path)).unwrap().write(b"whole").unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"whole");
        assert_eq!(folder.path().read_dir().unwrap().count(), 1);
        assert!(Output::create(Some(folder.path())).is_err());
        assert!(Output::create(Some(&folder.path().join("missing/x.json"))).is_err());
    }
}

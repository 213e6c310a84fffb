//! Output files: written beside their place, moved there when complete, so that a failed run leaves nothing behind.

use crate::failure::Failure;
use crate::mesh_argument::MeshArgument;
use crate::observer;
use std::io::Write;
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// Where a result goes. Made before the work starts, so that an unwritable place fails at once.
#[derive(Debug)]
pub enum Output {
    /// To standard output.
    Stdout,
    /// To a file at this path.
    File(PathBuf),
}

impl Output {
    /// An output at `path`, or on standard output where there is none, that is none of the files `inputs`.
    pub fn create(path: Option<&Path>, inputs: &[MeshArgument]) -> Result<Self, Failure> {
        let Some(path) = path else { return Ok(Self::Stdout) };
        // A link stays a link: what it points to is replaced.
        let path = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        if path.is_dir() {
            return Err(Failure::Input(format!("{}: is a directory; name a file", path.display())));
        }
        if path.exists() && !path.is_file() {
            return Err(Failure::Input(format!("{}: is no regular file; name another place", path.display())));
        }
        if inputs
            .iter()
            .filter_map(MeshArgument::path)
            .any(|input| input.canonicalize().is_ok_and(|input| input == path))
        {
            return Err(Failure::Input(format!("{}: is the input; name another place", path.display())));
        }
        // Proves that the place can be written to; dropped, so that a run that is killed leaves nothing.
        beside(&path)?;
        Ok(Self::File(path))
    }

    /// Writes the whole result.
    pub fn write(self, bytes: &[u8]) -> Result<(), Failure> {
        match self {
            Self::Stdout => match std::io::stdout().lock().write_all(bytes) {
                // A reader such as `head` that has seen enough is no failure.
                Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
                result => result.map_err(|error| Failure::Run(format!("standard output: {error}"))),
            },
            Self::File(path) => {
                if let Some(observer) = observer::current() {
                    observer.check()?;
                }
                let mut beside = beside(&path)?;
                beside.write_all(bytes).map_err(|error| cannot_write(&path, &error))?;
                beside.persist(&path).map_err(|error| cannot_write(&path, &error.error))?;
                Ok(())
            }
        }
    }
}

/// Fails, before a long run, where nothing can be written to a path whose missing folders would be made.
pub fn check_writable(path: &Path) -> Result<(), Failure> {
    let existing = path.ancestors().skip(1).find(|folder| folder.as_os_str().is_empty() || folder.exists());
    let folder = existing.filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    tempfile::tempdir_in(folder).map(drop).map_err(|error| cannot_write(path, &error))
}

/// A temporary file in the same folder, removed when dropped.
fn beside(path: &Path) -> Result<NamedTempFile, Failure> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".silhouettes-").suffix(".part");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder).map_err(|error| cannot_write(path, &error))
}

/// The error's kind alone: its text may name a temporary path that the user has never heard of.
fn cannot_write(path: &Path, error: &std::io::Error) -> Failure {
    Failure::Input(format!("{}: cannot be written ({}); name a place that can be", path.display(), error.kind()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_appears_whole_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.json");
        drop(Output::create(Some(&path), &[]).unwrap());
        assert_eq!(folder.path().read_dir().unwrap().count(), 0);
        Output::create(Some(&path), &[]).unwrap().write(b"whole").unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"whole");
        assert_eq!(folder.path().read_dir().unwrap().count(), 1);
        assert!(Output::create(Some(folder.path()), &[]).is_err());
        assert!(Output::create(Some(&folder.path().join("missing/x.json")), &[]).is_err());
    }
}

//! A directory that appears as a whole, and replaces only what an earlier run has written.

use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};
use tempfile::TempDir;

/// What a directory of results holds; one kind never replaces another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DirectoryKind {
    /// What it is called, `report` for example.
    pub noun: &'static str,
    /// Name of the file that marks a directory as one of this kind and lists what was written to it.
    pub marker: &'static str,
}

/// Why a directory of results could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DirectoryError {
    /// The path does not name a directory that can be created: `/`, `.` or `..`.
    #[error("{}: give the {noun} a directory of its own, for example {noun}", path.display())]
    NoName {
        /// The path.
        path: PathBuf,
        /// What was to be written.
        noun: &'static str,
    },
    /// Something exists there that is of another kind.
    #[error("{}: exists and is no {noun} of this program; choose another directory or move it away", path.display())]
    NotOurs {
        /// The path.
        path: PathBuf,
        /// What was to be written.
        noun: &'static str,
    },
    /// An earlier one exists there, with a file in it that no run has written.
    #[error("{}: lies in the {noun} that would be replaced; move it away", path.display())]
    ForeignFile {
        /// The file.
        path: PathBuf,
        /// What was to be written.
        noun: &'static str,
    },
    /// An earlier one exists there, whose list of files names something that does not lie in it.
    #[error("{}: lists '{name}', which lies outside of the {noun}; choose another directory or move it away", path.display())]
    Outside {
        /// The list.
        path: PathBuf,
        /// What it names.
        name: String,
        /// What was to be written.
        noun: &'static str,
    },
    /// A file could not be read or written.
    #[error("{}: {cause}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        cause: io::Error,
    },
}

/// Contents of a [marker](DirectoryKind::marker).
#[derive(Debug, Serialize, Deserialize)]
struct Manifest {
    /// Version of the package that wrote it.
    version: String,
    /// Every file but the marker: paths relative to the directory, `/` between parts.
    files: BTreeSet<String>,
}

/// What is where a directory is to be.
enum Existing {
    Nothing,
    EmptyDirectory,
    Earlier(Manifest),
}

impl DirectoryKind {
    /// Whether a directory of this kind may be written to `directory`: nothing there, an empty directory, or an earlier
    /// one without any file of somebody else's. Ask before a long run; writing asks again.
    ///
    /// # Errors
    /// [`DirectoryError`] says what is in the way.
    pub fn check_target(self, directory: &Path) -> Result<(), DirectoryError> {
        examine(&plain(directory), self).map(drop)
    }
}

/// The path without separators and dots at its end, so that it can be renamed.
fn plain(directory: &Path) -> PathBuf {
    directory.components().collect()
}

fn examine(directory: &Path, kind: DirectoryKind) -> Result<Existing, DirectoryError> {
    let DirectoryKind { noun, marker } = kind;
    if directory.file_name().is_none() {
        return Err(DirectoryError::NoName { path: directory.to_owned(), noun });
    }
    let metadata = match fs::symlink_metadata(directory) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Existing::Nothing),
        other => other.map_err(at(directory))?,
    };
    let not_ours = || DirectoryError::NotOurs { path: directory.to_owned(), noun };
    if !metadata.is_dir() {
        return Err(not_ours());
    }
    if fs::read_dir(directory).map_err(at(directory))?.next().is_none() {
        return Ok(Existing::EmptyDirectory);
    }
    let manifest = fs::read(directory.join(marker)).ok().and_then(|text| serde_json::from_slice(&text).ok());
    let manifest: Manifest = manifest.ok_or_else(not_ours)?;
    if let Some(name) = manifest.files.iter().find(|name| !lies_inside(name)) {
        return Err(DirectoryError::Outside { path: directory.join(marker), name: name.clone(), noun });
    }
    match find_foreign(directory, "", &manifest, marker)? {
        Some(path) => Err(DirectoryError::ForeignFile { path, noun }),
        None => Ok(Existing::Earlier(manifest)),
    }
}

/// Whether a name of a manifest stays below the directory that it is joined to, wherever that lies.
fn lies_inside(name: &str) -> bool {
    let mut parts = Path::new(name).components().peekable();
    parts.peek().is_some() && parts.all(|part| matches!(part, Component::Normal(_)))
}

/// A file below `directory` that the manifest does not list.
fn find_foreign(
    directory: &Path,
    prefix: &str,
    manifest: &Manifest,
    marker: &str,
) -> Result<Option<PathBuf>, DirectoryError> {
    for entry in fs::read_dir(directory).map_err(at(directory))? {
        let entry = entry.map_err(at(directory))?;
        let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
        let kind = entry.file_type().map_err(at(directory))?;
        let inside = format!("{name}/");
        let foreign = if kind.is_dir() && manifest.files.iter().any(|file| file.starts_with(&inside)) {
            find_foreign(&entry.path(), &inside, manifest, marker)?
        } else {
            let ours = kind.is_file() && (name == marker || manifest.files.contains(&name));
            (!ours).then(|| entry.path())
        };
        if foreign.is_some() {
            return Ok(foreign);
        }
    }
    Ok(None)
}

fn at(path: &Path) -> impl Fn(io::Error) -> DirectoryError {
    let path = path.to_owned();
    move |cause| DirectoryError::Io { path: path.clone(), cause }
}

/// A directory under construction beside its final place; removed again unless [`commit`](Self::commit) is called.
pub struct StagedDirectory {
    kind: DirectoryKind,
    target: PathBuf,
    staging: TempDir,
    files: BTreeSet<String>,
}

/// Why a directory of results could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// The directory could not be written.
    #[error(transparent)]
    Directory(#[from] DirectoryError),
    /// What a file is to hold cannot be written down.
    #[error("{file}: {cause}")]
    Form {
        /// The file's name in the directory.
        file: String,
        /// Why.
        cause: io::Error,
    },
}

/// The contents of a file, or why there are none.
///
/// # Errors
/// [`WriteError::Form`] names the file.
pub fn formed<T>(file: &str, contents: io::Result<T>) -> Result<T, WriteError> {
    contents.map_err(|cause| WriteError::Form { file: file.to_owned(), cause })
}

impl StagedDirectory {
    /// Creates the directory beside `target`, whose parents are created where they are missing.
    ///
    /// # Errors
    /// [`DirectoryError`]: something is in the way of `target`, or the directory cannot be created.
    pub fn begin(target: &Path, kind: DirectoryKind) -> Result<Self, DirectoryError> {
        let target = plain(target);
        examine(&target, kind)?;
        if let Some(parent) = target.parent().filter(|parent| !parent.as_os_str().is_empty()) {
            fs::create_dir_all(parent).map_err(at(parent))?;
        }
        let staging = beside(&target, ".partial")?;
        Ok(Self { kind, target, staging, files: BTreeSet::new() })
    }

    /// Writes the file that will be at this path, `/` between parts, in the finished directory.
    ///
    /// # Errors
    /// [`DirectoryError::Io`], with the path in the finished directory: nobody has heard of the one beside it.
    pub fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), DirectoryError> {
        let path = self.staging.path().join(name);
        let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
        folder.and_then(|()| fs::write(&path, bytes)).map_err(at(&self.target.join(name)))?;
        self.files.insert(name.to_owned());
        Ok(())
    }

    /// Puts the directory in its place. An earlier one is moved aside first and removed afterwards, file by file as its
    /// own manifest lists them.
    ///
    /// # Errors
    /// [`DirectoryError`]; what was at the place before is still there, or beside it, named `.old`, where only its removal failed.
    pub fn commit(mut self) -> Result<(), DirectoryError> {
        let manifest =
            Manifest { version: env!("CARGO_PKG_VERSION").to_owned(), files: std::mem::take(&mut self.files) };
        let marker = self.kind.marker;
        let text = serde_json::to_vec_pretty(&manifest).map_err(|error| at(&self.target.join(marker))(error.into()))?;
        self.write(marker, &text)?;

        let put_in_place = || fs::rename(self.staging.path(), &self.target).map_err(at(&self.target));
        match examine(&self.target, self.kind)? {
            Existing::Nothing => put_in_place(),
            Existing::EmptyDirectory => {
                fs::remove_dir(&self.target).map_err(at(&self.target))?;
                put_in_place()
            }
            Existing::Earlier(old) => {
                // A name that nothing has, which the earlier directory then takes.
                let free = beside(&self.target, ".old")?;
                let aside = free.path().to_owned();
                free.close().map_err(at(&aside))?;
                fs::rename(&self.target, &aside).map_err(at(&self.target))?;
                if let Err(error) = put_in_place() {
                    fs::rename(&aside, &self.target).map_err(at(&aside))?;
                    return Err(error);
                }
                remove(&aside, &old, self.kind)
            }
        }
    }
}

/// An empty directory beside a path, of a name that nothing had: `.NAME.RANDOM.what`. Removed when dropped.
fn beside(path: &Path, what: &str) -> Result<TempDir, DirectoryError> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    let prefix = format!(".{name}.");
    builder.prefix(&prefix).suffix(what);
    // As any new directory's: by default temporary ones are private.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o777));
    builder.tempdir_in(parent).map_err(at(path))
}

/// Removes the files that a manifest lists, then the directories that are empty.
fn remove(directory: &Path, manifest: &Manifest, kind: DirectoryKind) -> Result<(), DirectoryError> {
    let mut folders = BTreeSet::new();
    for name in manifest.files.iter().map(String::as_str).chain([kind.marker]) {
        let path = directory.join(name);
        match fs::remove_file(&path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(at(&path)(error)),
            _ => folders.extend(Path::new(name).ancestors().skip(1).map(|folder| directory.join(folder))),
        }
    }
    // A folder sorts before what it holds.
    for folder in folders.iter().rev() {
        fs::remove_dir(folder).map_err(at(folder))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const REPORT: DirectoryKind = DirectoryKind { noun: "report", marker: "silhouettes-report.json" };
    const OTHER: DirectoryKind = DirectoryKind { noun: "table", marker: "silhouettes-table.json" };

    fn write_report(target: &Path, text: &str) -> Result<(), DirectoryError> {
        let mut staged = StagedDirectory::begin(target, REPORT)?;
        for name in ["page.txt", "images/one.txt"] {
            staged.write(name, text.as_bytes())?;
        }
        staged.commit()
    }

    #[test]
    fn a_report_appears_and_is_replaced() {
        let dir = tempfile::tempdir().unwrap();
        let target = dir.path().join("deep/report");
        for text in ["first", "second"] {
            REPORT.check_target(&target).unwrap();
            write_report(&target, text).unwrap();
            assert_eq!(fs::read_to_string(target.join("images/one.txt")).unwrap(), text);
        }
        assert_eq!(fs::read_dir(dir.path().join("deep")).unwrap().count(), 1, "nothing is left beside it");
        let empty = dir.path().join("empty");
        fs::create_dir(&empty).unwrap();
        write_report(&empty, "third").unwrap();
    }

    #[test]
    fn nothing_of_a_user_is_touched() {
        let dir = tempfile::tempdir().unwrap();
        let foreign = dir.path().join("photos");
        fs::create_dir(&foreign).unwrap();
        fs::write(foreign.join("a.jpg"), "mine").unwrap();
        assert!(matches!(write_report(&foreign, "x"), Err(DirectoryError::NotOurs { .. })));
        let file = foreign.join("a.jpg");
        assert!(matches!(REPORT.check_target(&file), Err(DirectoryError::NotOurs { .. })));

        let report = dir.path().join("report");
        write_report(&report, "first").unwrap();
        for note in ["note.txt", "images/note.txt", "other/note.txt"] {
            let note = report.join(note);
            fs::create_dir_all(note.parent().unwrap()).unwrap();
            fs::write(&note, "mine").unwrap();
            assert!(matches!(write_report(&report, "second"), Err(DirectoryError::ForeignFile { .. })), "{note:?}");
            assert_eq!(fs::read_to_string(&note).unwrap(), "mine");
            assert_eq!(fs::read_to_string(report.join("page.txt")).unwrap(), "first");
            fs::remove_file(&note).unwrap();
            let _ = fs::remove_dir(note.parent().unwrap());
        }
        write_report(&report, "second").unwrap();
    }

    #[test]
    fn one_kind_does_not_replace_another() {
        let dir = tempfile::tempdir().unwrap();
        let target = dir.path().join("report");
        write_report(&target, "first").unwrap();
        let error = OTHER.check_target(&target).unwrap_err().to_string();
        assert!(error.contains("is no table of this program"), "{error}");
        assert!(StagedDirectory::begin(&target, OTHER).is_err());
        REPORT.check_target(&target).unwrap();
    }

    #[test]
    fn a_failed_run_leaves_nothing_half_written() {
        let dir = tempfile::tempdir().unwrap();
        let target = dir.path().join("report");
        let mut staged = StagedDirectory::begin(&target, REPORT).unwrap();
        staged.write("page.txt", b"half").unwrap();
        // A file cannot have one below it.
        let error = staged.write("page.txt/below.txt", b"more").unwrap_err().to_string();
        assert!(error.starts_with(target.join("page.txt/below.txt").to_str().unwrap()), "{error}");
        drop(staged);
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0);
    }

    /// What a manifest names is removed when the directory is replaced.
    #[test]
    fn a_list_that_names_files_elsewhere_is_refused_and_they_stay() {
        let dir = tempfile::tempdir().unwrap();
        let (report, victim) = (dir.path().join("report"), dir.path().join("victim.txt"));
        fs::write(&victim, "mine").unwrap();
        for name in ["../victim.txt", victim.to_str().unwrap(), "images/../../victim.txt", "./../victim.txt", ""] {
            fs::create_dir_all(&report).unwrap();
            let manifest = Manifest { version: String::new(), files: BTreeSet::from([name.to_owned()]) };
            fs::write(report.join(REPORT.marker), serde_json::to_vec(&manifest).unwrap()).unwrap();
            let error = REPORT.check_target(&report).unwrap_err();
            assert!(matches!(error, DirectoryError::Outside { .. }), "{name}: {error}");
            assert!(write_report(&report, "second").is_err());
            assert_eq!(fs::read_to_string(&victim).unwrap(), "mine", "{name}");
            assert!(report.join(REPORT.marker).exists(), "nothing was touched");
        }
    }

    #[test]
    fn what_an_earlier_process_left_is_in_nobody_s_way() {
        let dir = tempfile::tempdir().unwrap();
        let target = dir.path().join("report");
        for stale in ["partial", "old"] {
            let stale = dir.path().join(format!(".report.{}.{stale}", std::process::id()));
            fs::create_dir(&stale).unwrap();
            fs::write(stale.join("page.txt"), "half").unwrap();
        }
        write_report(&target, "first").unwrap();
        write_report(&target, "second").unwrap();
        assert_eq!(fs::read_to_string(target.join("page.txt")).unwrap(), "second");
    }

    #[test]
    fn dots_and_separators_at_the_end_of_a_path_mean_nothing() {
        let dir = tempfile::tempdir().unwrap();
        for path in ["report/.", "report/", "report/./"] {
            let target = dir.path().join(path);
            REPORT.check_target(&target).unwrap();
            write_report(&target, path).unwrap();
            assert_eq!(fs::read_to_string(dir.path().join("report/page.txt")).unwrap(), path);
        }
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
    }

    #[test]
    fn paths_without_a_name_are_refused() {
        for path in ["/", "..", "", ".", "report/.."] {
            assert!(matches!(REPORT.check_target(Path::new(path)), Err(DirectoryError::NoName { .. })), "{path}");
        }
    }
}

//! [`CellStore`]: a directory of finished cells.

use super::key::Key;
use crate::machine::RunDescription;
use crate::metrics::PictureKind;
use crate::record::Cell;
use crate::runner::{LeftOut, Outcome, PictureSet};
use serde::{Deserialize, Serialize};
use silhouette_render::Image;
use std::ffi::OsStr;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;
use tempfile::NamedTempFile;

/// A directory of the finished cells of one comparison: `sweep.json` holds its [`Key`], `0007.json` with three pictures each cell.
/// `refined-DIGEST` are directories of cells that were [added](super::refine) to it.
///
/// Every file appears as a whole. A cell is there once its JSON is, which is written last; so any number of processes may share a
/// directory, and one that is killed leaves nothing that another would take for a cell.
#[derive(Debug)]
pub struct CellStore {
    folder: PathBuf,
    key: Key,
}

/// Why a directory of finished cells cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StoreError {
    /// Nothing is there.
    #[error("{}: there is no such folder; name one that `compare --shard` wrote", path.display())]
    Missing {
        /// The directory.
        path: PathBuf,
    },
    /// Something else is there.
    #[error("{}: exists and holds no cells of a comparison; name another directory", path.display())]
    NotOurs {
        /// The directory.
        path: PathBuf,
    },
    /// Cells of another comparison are there.
    #[error(
        "{}: holds cells of another comparison: its {difference} differs; name another directory", path.display()
    )]
    OtherKey {
        /// The directory.
        path: PathBuf,
        /// What differs.
        difference: &'static str,
    },
    /// What the directory says of its cells is damaged, or of another version of this program.
    #[error("{}: {reason}; remove the directory, or name another", path.display())]
    Key {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// A file of a cell is damaged.
    #[error("{}: {reason}; remove it and measure again", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// A file cannot be read or written.
    #[error("{}: {cause}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        cause: io::Error,
    },
}

/// A finished cell.
#[derive(Debug)]
pub struct Kept {
    /// By what it was measured.
    pub run: RunDescription,
    /// How long that took, wall time.
    pub took: Duration,
    /// What was measured.
    pub outcome: Outcome,
}

/// The JSON of a cell.
#[derive(Serialize, Deserialize)]
struct CellFile {
    run: RunDescription,
    took_ms: u64,
    cell: Option<Cell>,
    /// Which frame the pictures are of.
    pictured: Option<u32>,
    left_out: Option<LeftOut>,
}

const KEY: &str = "sweep.json";
const NESTED: &str = "refined-";
const PICTURES: [&str; 3] = ["drawn", "truth", "difference"];

impl CellStore {
    /// Opens a directory of cells of this comparison, or makes one.
    ///
    /// # Errors
    /// [`StoreError`]: something else is there, cells of another comparison are, or it cannot be written to.
    pub fn open(folder: &Path, key: Key) -> Result<Self, StoreError> {
        fs::create_dir_all(folder).map_err(at(folder))?;
        let path = folder.join(KEY);
        if !path.exists() {
            let others = fs::read_dir(folder).map_err(at(folder))?.flatten().any(|entry| !is_part(&entry.file_name()));
            // Another process may have made it just now.
            if others && !path.exists() {
                return Err(StoreError::NotOurs { path: folder.to_owned() });
            }
            let text = serde_json::to_vec_pretty(&key).map_err(|error| at(&path)(error.into()))?;
            // Of several processes that begin at once, one is the first.
            let file = part(&path, &text)?;
            match file.persist_noclobber(&path) {
                Err(error) if error.error.kind() != io::ErrorKind::AlreadyExists => {
                    return Err(at(&path)(error.error.kind().into()));
                }
                _ => {}
            }
        }
        let found = read_key(folder)?;
        if let Some(difference) = difference(&found, &key) {
            return Err(StoreError::OtherKey { path: folder.to_owned(), difference });
        }
        Ok(Self { folder: folder.to_owned(), key })
    }

    /// Opens a directory that holds cells already.
    ///
    /// # Errors
    /// [`StoreError`]: it holds none, or cannot be read.
    pub fn existing(folder: &Path) -> Result<Self, StoreError> {
        Ok(Self { folder: folder.to_owned(), key: read_key(folder)? })
    }

    /// Opens a directory of cells that are added to this comparison, within its own; see [`open`](Self::open).
    ///
    /// # Errors
    /// [`StoreError`].
    pub fn nested(&self, key: Key) -> Result<Self, StoreError> {
        Self::open(&self.folder.join(format!("{NESTED}{}", key.digest())), key)
    }

    /// The key of its comparison.
    pub fn key(&self) -> &Key {
        &self.key
    }

    /// The error of a key that holds what it must not.
    pub(super) fn damaged(&self, error: &serde_json::Error) -> StoreError {
        StoreError::Key { path: self.folder.join(KEY), reason: error.to_string() }
    }

    /// Where it is.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Whether a cell is finished.
    pub fn holds(&self, cell: usize) -> bool {
        self.json(cell).exists()
            && (PICTURES.iter().all(|name| self.picture(cell, name).exists()) || self.is_left_out(cell))
    }

    /// Whether a cell is finished and has no pictures, since its method is not defined for its mesh.
    fn is_left_out(&self, cell: usize) -> bool {
        let file = fs::read(self.json(cell)).ok().and_then(|text| serde_json::from_slice::<CellFile>(&text).ok());
        file.is_some_and(|file| file.left_out.is_some())
    }

    /// Number of finished cells.
    pub fn count(&self) -> usize {
        (0..self.key.cells()).filter(|&cell| self.holds(cell)).count()
    }

    /// Writes a finished cell, measured by `run`, with the time that this took.
    ///
    /// # Errors
    /// [`StoreError::Io`].
    pub fn put(&self, index: usize, run: &RunDescription, took: Duration, outcome: &Outcome) -> Result<(), StoreError> {
        let path = self.json(index);
        let (run, took_ms) = (run.clone(), u64::try_from(took.as_millis()).unwrap_or(u64::MAX));
        let file = match outcome {
            Outcome::Measured { cell, pictures } => {
                for (name, image) in PICTURES.iter().zip([&pictures.drawn, &pictures.truth, &pictures.difference]) {
                    let path = self.picture(index, name);
                    let png = image.to_png().map_err(|error| at(&path)(io::Error::other(error)))?;
                    write_whole(&path, &png)?;
                }
                let cell = Some((**cell).clone());
                CellFile { run, took_ms, cell, pictured: Some(pictures.frame), left_out: None }
            }
            Outcome::LeftOut(left_out) => {
                CellFile { run, took_ms, cell: None, pictured: None, left_out: Some(left_out.clone()) }
            }
        };
        let text = serde_json::to_vec(&file).map_err(|error| at(&path)(error.into()))?;
        write_whole(&path, &text)
    }

    /// Reads a finished cell.
    ///
    /// # Errors
    /// [`StoreError::Damaged`], [`StoreError::Io`].
    pub fn read(&self, index: usize) -> Result<Kept, StoreError> {
        let path = self.json(index);
        let damaged = |reason: &str| StoreError::Damaged { path: path.clone(), reason: reason.to_owned() };
        let text = fs::read(&path).map_err(at(&path))?;
        let file: CellFile = serde_json::from_slice(&text).map_err(|error| damaged(&error.to_string()))?;
        let took = Duration::from_millis(file.took_ms);
        let run = file.run.clone();
        let outcome = match file {
            CellFile { cell: Some(cell), pictured: Some(frame), .. } => {
                let expected = &self.key.methods[index % self.key.methods.len()];
                let mesh = &self.key.meshes[index / self.key.methods.len()];
                if cell.method != expected.name || cell.mesh.name != mesh.name {
                    return Err(damaged("holds another cell"));
                }
                let pictures = self.pictures(index, &cell, frame)?;
                Outcome::Measured { cell: Box::new(cell), pictures: Box::new(pictures) }
            }
            CellFile { left_out: Some(left_out), .. } => Outcome::LeftOut(left_out),
            _ => return Err(damaged("holds neither a cell nor why there is none")),
        };
        Ok(Kept { run, took, outcome })
    }

    /// Removes the cells, those that were added, and the directory where nothing else is in it.
    ///
    /// # Errors
    /// [`StoreError::Io`].
    pub fn remove(self) -> Result<(), StoreError> {
        for cell in 0..self.key.cells() {
            for path in PICTURES.map(|name| self.picture(cell, name)).into_iter().chain([self.json(cell)]) {
                remove_file(&path)?;
            }
        }
        for entry in fs::read_dir(&self.folder).map_err(at(&self.folder))?.flatten() {
            if entry.file_name().to_str().is_some_and(|name| name.starts_with(NESTED)) {
                match Self::existing(&entry.path()) {
                    // Of a process that was killed before it wrote what the directory is for.
                    Err(StoreError::NotOurs { .. }) => remove_unfinished(&entry.path())?,
                    nested => nested?.remove()?,
                }
            }
        }
        remove_file(&self.folder.join(KEY))?;
        remove_unfinished(&self.folder)
    }

    fn pictures(&self, index: usize, cell: &Cell, frame: u32) -> Result<PictureSet, StoreError> {
        let read = |name: &str| {
            let path = self.picture(index, name);
            let png = fs::read(&path).map_err(at(&path))?;
            Image::from_png(&png).map_err(|error| StoreError::Damaged { path, reason: error.to_string() })
        };
        let picture: PictureKind = cell.picture;
        Ok(PictureSet {
            mesh: cell.mesh.name.clone(),
            method: cell.method.clone(),
            options: cell.options.clone(),
            picture,
            frame,
            drawn: read(PICTURES[0])?,
            truth: read(PICTURES[1])?,
            difference: read(PICTURES[2])?,
        })
    }

    fn json(&self, cell: usize) -> PathBuf {
        self.folder.join(format!("{cell:04}.json"))
    }

    fn picture(&self, cell: usize, name: &str) -> PathBuf {
        self.folder.join(format!("{cell:04}-{name}.png"))
    }
}

fn read_key(folder: &Path) -> Result<Key, StoreError> {
    let path = folder.join(KEY);
    let text = match fs::read(&path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound && folder.is_dir() => {
            return Err(StoreError::NotOurs { path: folder.to_owned() });
        }
        // A file stands there.
        Err(error) if error.kind() == io::ErrorKind::NotADirectory => {
            return Err(StoreError::NotOurs { path: folder.to_owned() });
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            return Err(StoreError::Missing { path: folder.to_owned() });
        }
        other => other.map_err(at(&path))?,
    };
    let damaged = |error: serde_json::Error| StoreError::Key { path: path.clone(), reason: error.to_string() };
    serde_json::from_slice(&text).map_err(damaged)
}

/// Removes what a process that was killed was writing, and the directory where nothing else is in it.
fn remove_unfinished(folder: &Path) -> Result<(), StoreError> {
    for entry in fs::read_dir(folder).map_err(at(folder))?.flatten() {
        if is_part(&entry.file_name()) {
            remove_file(&entry.path())?;
        }
    }
    match fs::remove_dir(folder) {
        Err(error) if error.kind() != io::ErrorKind::DirectoryNotEmpty => Err(at(folder)(error)),
        _ => Ok(()),
    }
}

/// In what two keys differ first.
pub(super) fn difference(one: &Key, other: &Key) -> Option<&'static str> {
    if one.program != other.program {
        Some("program")
    } else if one.meshes != other.meshes {
        Some("list of meshes, or what they hold,")
    } else if one.methods != other.methods {
        Some("list of methods with their options")
    } else if one.scene != other.scene {
        Some("scene")
    } else {
        None
    }
}

/// How files are named that are being written.
const PART: [&str; 2] = [".cell-", ".part"];

fn is_part(name: &OsStr) -> bool {
    name.to_str().is_some_and(|name| name.starts_with(PART[0]) && name.ends_with(PART[1]))
}

/// Writes a file beside its place and moves it there.
fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), StoreError> {
    part(path, bytes)?.persist(path).map_err(|error| at(path)(error.error.kind().into()))?;
    Ok(())
}

/// A file beside its place, written.
fn part(path: &Path, bytes: &[u8]) -> Result<NamedTempFile, StoreError> {
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(PART[0]).suffix(PART[1]);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    // The text of an error about a temporary file names that file, of which nobody has heard.
    let failed = |error: io::Error| at(path)(error.kind().into());
    let mut file = builder.tempfile_in(folder).map_err(failed)?;
    file.write_all(bytes).map_err(failed)?;
    Ok(file)
}

fn remove_file(path: &Path) -> Result<(), StoreError> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(at(path)(error)),
        _ => Ok(()),
    }
}

fn at(path: &Path) -> impl Fn(io::Error) -> StoreError {
    let path = path.to_owned();
    move |cause| StoreError::Io { path: path.clone(), cause }
}

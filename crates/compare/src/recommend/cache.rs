//! [`Cache`]: notebooks kept between runs, a file each, so that a second question about the same mesh is answered at once.
//!
//! What was measured is reused only where everything that decides it is the same: the mesh's contents, the goal, how views are seen, the
//! program to its last build, the machine and the adapter. Limits are not among it.

use super::goal::Goal;
use super::notebook::Notebook;
use super::views::Setting;
use crate::machine::{AdapterRecord, describe_machine, describe_program};
use crate::runner::NamedMesh;
use crate::sweep::key::contents;
use serde::{Deserialize, Serialize};
use silhouette_render::Gpu;
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

/// Everything that decides what is measured.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct CacheKey {
    /// Number of vertices, of faces, and a checksum.
    mesh: [u64; 3],
    goal: Goal,
    setting: String,
    program: String,
    /// Bytes of the program's file and when it was written, in milliseconds: builds of one commit may differ.
    file: [u64; 2],
    machine: String,
    adapter: Option<AdapterRecord>,
}

impl CacheKey {
    /// The key of this program on this machine. O(V + F).
    pub fn new(mesh: &NamedMesh, goal: Goal, setting: &Setting, gpu: Option<&Gpu>) -> Self {
        Self {
            mesh: contents(mesh.mesh.mesh(), mesh.mesh.feature_edges()),
            goal,
            setting: format!("{setting:?}"),
            program: describe_program(),
            file: program_file().unwrap_or_default(),
            machine: describe_machine(),
            adapter: gpu.map(|gpu| gpu.adapter().into()),
        }
    }

    fn file_name(&self) -> String {
        let text = serde_json::to_vec(self).unwrap_or_default();
        format!("{}-{:08x}.json", self.goal.name(), crc32fast::hash(&text))
    }
}

fn program_file() -> Option<[u64; 2]> {
    let file = std::env::current_exe().and_then(std::fs::metadata).ok()?;
    let written = file.modified().ok()?.duration_since(UNIX_EPOCH).ok()?;
    Some([file.len(), written.as_millis() as u64])
}

/// A folder of notebooks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cache(PathBuf);

#[derive(Serialize, Deserialize)]
struct File<K, N> {
    key: K,
    notebook: N,
}

/// Why a notebook could not be read, so that everything is measured anew.
#[derive(Debug, thiserror::Error)]
#[error("{}: {cause}; everything is measured anew", path.display())]
pub struct Unreadable {
    /// The file.
    path: PathBuf,
    /// What is wrong with it.
    cause: io::Error,
}

impl Cache {
    /// Notebooks in this folder, which is made when one is written.
    pub fn in_folder(folder: impl Into<PathBuf>) -> Self {
        Self(folder.into())
    }

    /// The user's own: `silhouettes/recommend` in `XDG_CACHE_HOME`, `~/.cache`, or `LOCALAPPDATA`, by the environment's variables;
    /// `None` where none is set to an absolute path.
    pub fn of_user(variable: impl Fn(&str) -> Option<OsString>) -> Option<Self> {
        let folder = |name: &str| variable(name).map(PathBuf::from).filter(|path| path.is_absolute());
        let home = || folder("HOME").map(|home| home.join(".cache"));
        let base = folder("XDG_CACHE_HOME").or_else(home).or_else(|| folder("LOCALAPPDATA"))?;
        Some(Self(base.join("silhouettes").join("recommend")))
    }

    /// Where the notebook of a key is kept.
    pub fn path(&self, key: &CacheKey) -> PathBuf {
        self.0.join(key.file_name())
    }

    /// The notebook of a key; an empty one where there is none.
    ///
    /// # Errors
    /// [`Unreadable`]: there is a file that cannot be read or is damaged.
    pub fn load(&self, key: &CacheKey) -> Result<Notebook, Unreadable> {
        let path = self.path(key);
        let text = match std::fs::read(&path) {
            Err(cause) if cause.kind() == io::ErrorKind::NotFound => return Ok(Notebook::default()),
            read => read.map_err(|cause| Unreadable { path: path.clone(), cause })?,
        };
        let file: File<CacheKey, Notebook> =
            serde_json::from_slice(&text).map_err(|cause| Unreadable { path, cause: cause.into() })?;
        let is_sound = file.notebook.is_sound(key.goal.metrics().len());
        // Another key under the same checksum, or errors of other numbers: of no use, and overwritten.
        Ok(if file.key == *key && is_sound { file.notebook } else { Notebook::default() })
    }

    /// Keeps a notebook: written beside its place and moved there, so that no half of one is ever read.
    ///
    /// # Errors
    /// The folder or file cannot be written.
    pub fn store(&self, key: &CacheKey, notebook: &Notebook) -> io::Result<()> {
        std::fs::create_dir_all(&self.0)?;
        let mut file = tempfile::NamedTempFile::new_in(&self.0)?;
        file.write_all(&serde_json::to_vec(&File { key, notebook })?)?;
        file.persist(self.path(key)).map(drop).map_err(|error| error.error)
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::super::meter::Sample;
    use super::super::notebook::Page;
    use super::super::views::Purpose;
    use super::*;
    use crate::scene::Profile;
    use silhouette_core::{PreparedMesh, shapes};
    use std::sync::Arc;

    fn mesh(shape: &str) -> NamedMesh {
        NamedMesh { name: shape.to_owned(), mesh: Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap())) }
    }

    fn key(shape: &str, goal: Goal) -> CacheKey {
        CacheKey::new(&mesh(shape), goal, &Setting::from(&Profile::Quick.scene()), None)
    }

    fn notebook(errors: usize) -> Notebook {
        let samples = vec![Sample { ms: 0.1 + 0.2, errors: vec![0.3; errors] }];
        let page = Page { method: "m".to_owned(), samples: [(Purpose::Promise, samples)].into(), ..Page::default() };
        Notebook { pages: vec![page], answered: Vec::new() }
    }

    #[test]
    fn a_notebook_is_found_by_what_decides_it_and_by_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache::in_folder(folder.path().join("deep/er"));
        let (torus, written) = (key("torus", Goal::Loops), notebook(3));
        assert_eq!(cache.load(&torus).unwrap(), Notebook::default());
        cache.store(&torus, &written).unwrap();
        assert_eq!(cache.load(&torus).unwrap(), written);
        let mut wide = Setting::from(&Profile::Quick.scene());
        wide.size[0] += 1;
        let wide = CacheKey::new(&mesh("torus"), Goal::Loops, &wide, None);
        for other in [key("torus", Goal::Lines), key("cube", Goal::Loops), wide] {
            assert_eq!(cache.load(&other).unwrap(), Notebook::default(), "{other:?}");
        }
        // A mesh of another name is the same mesh.
        let renamed = NamedMesh { name: "other".to_owned(), ..mesh("torus") };
        assert_eq!(CacheKey::new(&renamed, Goal::Loops, &Setting::from(&Profile::Quick.scene()), None), torus);
    }

    #[test]
    fn a_damaged_file_is_reported_and_written_anew() {
        let folder = tempfile::tempdir().unwrap();
        let (cache, torus) = (Cache::in_folder(folder.path()), key("torus", Goal::Loops));
        cache.store(&torus, &notebook(3)).unwrap();
        let whole = std::fs::read(cache.path(&torus)).unwrap();
        std::fs::write(cache.path(&torus), &whole[..whole.len() / 2]).unwrap();
        let message = cache.load(&torus).unwrap_err().to_string();
        assert!(message.contains("loops-") && message.contains("measured anew"), "{message}");
        cache.store(&torus, &notebook(3)).unwrap();
        assert_eq!(cache.load(&torus).unwrap(), notebook(3));
        // Errors of another number would be read as others than they are.
        cache.store(&torus, &notebook(2)).unwrap();
        assert_eq!(cache.load(&torus).unwrap(), Notebook::default());
        assert_eq!(folder.path().read_dir().unwrap().count(), 1, "nothing is left beside it");
    }

    #[test]
    fn the_folder_follows_the_environment() {
        let of = |set: &'static [(&str, &str)]| {
            let found = move |name: &str| set.iter().find(|(key, _)| *key == name).map(|(_, value)| value.into());
            Cache::of_user(found).map(|cache| cache.folder().to_owned())
        };
        let end = Path::new("silhouettes/recommend");
        assert_eq!(of(&[("XDG_CACHE_HOME", "/x"), ("HOME", "/h")]), Some(Path::new("/x").join(end)));
        assert_eq!(of(&[("XDG_CACHE_HOME", "not/absolute"), ("HOME", "/h")]), Some(Path::new("/h/.cache").join(end)));
        assert_eq!(of(&[]), None);
    }
}

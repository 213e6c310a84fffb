//! Measured meshes as files that other tools read: binary little-endian PLY, with the mesh's name in rows as a comment.

use silhouette_core::{TriangleMesh, load};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Why a mesh was not exported.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    #[error("{}: {source}", path.display())]
    Io { path: PathBuf, source: io::Error },
    #[error("{}: two meshes of this run have this name; export them in two runs, to two folders", path.display())]
    SameName { path: PathBuf },
}

/// A folder of exported meshes.
pub struct Export {
    folder: PathBuf,
    /// Files of this run.
    written: BTreeSet<PathBuf>,
}

impl Export {
    /// Makes the folder where there is none.
    pub fn to(folder: &Path) -> Result<Self, ExportError> {
        fs::create_dir_all(folder).map_err(|source| ExportError::Io { path: folder.to_owned(), source })?;
        Ok(Self { folder: folder.to_owned(), written: BTreeSet::new() })
    }

    /// Writes a mesh, replacing the file of an earlier run once the new one is complete.
    ///
    /// # Panics
    /// If the file, read again, is another mesh: peers would measure something else.
    pub fn write(&mut self, name: &str, mesh: &TriangleMesh) -> Result<(), ExportError> {
        let path = self.folder.join(file_name(name));
        if !self.written.insert(path.clone()) {
            return Err(ExportError::SameName { path });
        }
        let beside = path.with_extension("ply.part");
        let written = File::create(&beside)
            .and_then(|file| write_ply(name, mesh, BufWriter::new(file)))
            .and_then(|()| fs::rename(&beside, &path));
        written.map_err(|source| {
            // The first failure is the one to tell of.
            let _ = fs::remove_file(&beside);
            ExportError::Io { path: path.clone(), source }
        })?;
        assert!(load::load(&path).is_ok_and(|read| read == *mesh), "{}: not the mesh written", path.display());
        Ok(())
    }
}

/// `builtin-blob-1000.ply` for `builtin:blob:1000`: what every file system takes.
fn file_name(name: &str) -> String {
    let plain = |c: char| if c.is_alphanumeric() || "+-._".contains(c) { c } else { '-' };
    name.chars().map(plain).chain(".ply".chars()).collect()
}

fn write_ply(name: &str, mesh: &TriangleMesh, mut out: impl Write) -> io::Result<()> {
    writeln!(out, "ply\nformat binary_little_endian 1.0")?;
    writeln!(out, "comment mesh {}", name.replace(char::is_control, " "))?;
    writeln!(out, "element vertex {}", mesh.vertex_count())?;
    writeln!(out, "property float x\nproperty float y\nproperty float z")?;
    writeln!(out, "element face {}", mesh.face_count())?;
    writeln!(out, "property list uchar uint vertex_indices\nend_header")?;
    for position in mesh.positions() {
        for coordinate in position.to_array() {
            out.write_all(&coordinate.to_le_bytes())?;
        }
    }
    for triangle in mesh.triangles() {
        out.write_all(&[3])?;
        for vertex in triangle {
            out.write_all(&vertex.to_le_bytes())?;
        }
    }
    out.flush()
}

//! [`Format`]: the formats, their extensions and cargo features.

use std::fmt;
use std::path::Path;

/// A file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Wavefront OBJ, cargo feature `obj`.
    Obj,
    /// Stanford PLY, text or binary, cargo feature `ply`.
    Ply,
    /// Geomview OFF, text, cargo feature `off`.
    Off,
    /// STL, text or binary, cargo feature `stl`.
    Stl,
    /// glTF 2.0, text or GLB (distinguished by their first bytes), cargo feature `gltf`.
    Gltf,
}

impl Format {
    /// The extensions that [`Format::of`] knows, each with its dot.
    pub const EXTENSIONS: [&'static str; 6] = [".obj", ".ply", ".off", ".stl", ".gltf", ".glb"];

    /// The format that a path's extension names, upper or lower case.
    pub fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        Some(match extension.as_str() {
            "obj" => Self::Obj,
            "ply" => Self::Ply,
            "off" => Self::Off,
            "stl" => Self::Stl,
            "gltf" | "glb" => Self::Gltf,
            _ => return None,
        })
    }

    /// The cargo feature of `silhouette-core` that reads the format.
    pub const fn feature(self) -> &'static str {
        match self {
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Off => "off",
            Self::Stl => "stl",
            Self::Gltf => "gltf",
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Obj => "OBJ",
            Self::Ply => "PLY",
            Self::Off => "OFF",
            Self::Stl => "STL",
            Self::Gltf => "glTF",
        })
    }
}

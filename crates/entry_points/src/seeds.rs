//! Inputs of which each entry point makes something, made here and by nobody else: what fuzzing begins with.

mod drawings;
mod gltf;
mod meshes;
mod texts;
mod textures;
mod triangles;

/// A seed: its name, which is that of its file, and its bytes.
pub type Seed = (String, Vec<u8>);

/// The seeds of an entry point, by its name.
///
/// # Panics
/// If there is no such entry point.
pub fn of(entry_point: &str) -> Vec<Seed> {
    match entry_point {
        "mesh_files" => meshes::seeds(),
        "siltex" => textures::seeds(),
        "text" => texts::seeds(),
        "triangles" => triangles::seeds(&[]),
        "drawing" => triangles::seeds(&triangles::VIEW_AND_PENS),
        "foreign" => drawings::seeds(),
        _ => panic!("{entry_point}: there is no such entry point"),
    }
}

/// A seed of a name and bytes.
fn seed(name: &str, bytes: impl AsRef<[u8]>) -> Seed {
    (name.to_owned(), bytes.as_ref().to_vec())
}

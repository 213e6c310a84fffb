//! Meshes named on the command line: files, or `builtin:NAME`.

use crate::bake;
use crate::failure::{Failure, note};
use crate::interrupt;
use crate::mesh_argument::MeshArgument;
use crate::winding::Winding;
use silhouette_compare::registry::Entry;
use silhouette_compare::runner::NamedMesh;
use silhouette_core::load::{self, Format, LabelledMesh, Note};
use silhouette_core::origin::largest_rounding;
use silhouette_core::prepared::Artefact;
use silhouette_core::weld::weld_within;
use silhouette_core::{PreparedMesh, Progress, TriangleMesh, VertexId, shapes};
use silhouette_texture::siltex::{self, Metadata};
use silhouette_texture::{SilhouetteTexture, Textures};
use std::fmt::Display;
use std::io::Read as _;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Most bytes of a file, all over the process.
static MOST_BYTES: AtomicU64 = AtomicU64::new(u64::MAX);

/// Sets the most bytes that are read of any file of a mesh, from now on.
pub fn limit_bytes(most: u64) {
    MOST_BYTES.store(most, Ordering::Relaxed);
}

fn most_bytes() -> u64 {
    MOST_BYTES.load(Ordering::Relaxed)
}

/// What is said of a file that is too long.
fn too_long(name: impl Display) -> Failure {
    Failure::Input(format!("{name}: has more than {} bytes; raise --limit-bytes", most_bytes()))
}

/// Loads a file, with the feature edges that it states, or generates a built-in shape.
pub fn mesh(argument: &MeshArgument, winding: Winding, progress: &dyn Progress) -> Result<NamedMesh, Failure> {
    labelled(argument, winding, progress).map(|(name, loaded)| prepared(name, loaded))
}

/// The same, with what the reader of the file noted instead of printing it.
pub fn mesh_with_notes(argument: &MeshArgument, progress: &dyn Progress) -> Result<(NamedMesh, Vec<Note>), Failure> {
    let (name, mut loaded) = silently_labelled(argument, progress)?;
    let notes = std::mem::take(&mut loaded.notes);
    Ok((prepared(name, loaded), notes))
}

/// A mesh with its name, from which methods are prepared.
pub fn prepared(name: String, loaded: LabelledMesh) -> NamedMesh {
    let feature_edges = loaded.feature_edges.iter().map(|edge| edge.map(VertexId::new)).collect();
    NamedMesh { name, mesh: Arc::new(PreparedMesh::new(loaded.mesh).with_feature_edges(feature_edges)) }
}

/// The same with vertices joined that are no farther apart than a distance, if there is one.
pub fn welded(
    argument: &MeshArgument,
    distance: Option<f32>,
    winding: Winding,
    progress: &dyn Progress,
) -> Result<NamedMesh, Failure> {
    let (name, mut loaded) = labelled(argument, Winding::AsItIs, progress)?;
    if let Some(distance) = distance {
        weld(&mut loaded, distance)?;
    }
    winding.apply(&name, &mut loaded, progress)?;
    Ok(prepared(name, loaded))
}

/// Joins vertices no farther apart than a distance; feature edges are then between the joined ones.
pub fn weld(loaded: &mut LabelledMesh, distance: f32) -> Result<(), Failure> {
    let welded = weld_within(&loaded.mesh, distance).map_err(|error| Failure::Input(format!("--weld: {error}")))?;
    let is_left = |mesh: &TriangleMesh| mesh.triangles().iter().any(|[a, b, c]| a != b && b != c && c != a);
    if is_left(&loaded.mesh) && !is_left(&welded.mesh) {
        let mend = "give less than the length of edges";
        return Err(Failure::Input(format!(
            "--weld: within {distance} of each other lie corners of every face; {mend}"
        )));
    }
    let edges = loaded.feature_edges.iter().map(|edge| edge.map(|vertex| welded.vertex_of[vertex as usize]));
    loaded.feature_edges = edges.filter(|[a, b]| a != b).map(|[a, b]| [a.min(b), a.max(b)]).collect();
    loaded.feature_edges.sort_unstable();
    loaded.feature_edges.dedup();
    loaded.mesh = welded.mesh;
    Ok(())
}

/// What `method` is to draw: one mesh, or several as one, each with its own vertices and edges. A `.siltex` file, too, is a mesh for
/// methods that draw silhouette textures, that of its hull.
pub fn drawable(
    arguments: &[MeshArgument],
    method: &Entry,
    winding: Winding,
    progress: &dyn Progress,
) -> Result<NamedMesh, Failure> {
    if let Some((argument, path)) = arguments.iter().find_map(|argument| Some((argument, argument.texture()?))) {
        return match arguments.len() {
            1 => check_drawn_by(argument, method).and_then(|()| hull_of_file(argument, path)),
            _ => Err(Failure::Input(format!("{argument}: a silhouette texture is drawn alone; name no other mesh"))),
        };
    }
    let mut parts =
        arguments.iter().map(|argument| labelled(argument, winding, progress)).collect::<Result<Vec<_>, _>>()?;
    if parts.len() == 1 {
        let (name, loaded) = parts.remove(0);
        return Ok(prepared(name, loaded));
    }
    let name = parts.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>().join(", ");
    let meshes: Vec<&TriangleMesh> = parts.iter().map(|(_, loaded)| &loaded.mesh).collect();
    let mesh = TriangleMesh::of_parts(&meshes).map_err(Failure::input)?;
    for (name, loaded) in parts.iter().filter(|(_, loaded)| loaded.mesh.origin() != mesh.origin()) {
        note_rounding(name, &loaded.mesh.relative_to(mesh.origin()).map_err(Failure::input)?);
    }
    let (mut feature_edges, mut first) = (Vec::new(), 0);
    for (_, loaded) in &parts {
        feature_edges.extend(loaded.feature_edges.iter().map(|edge| edge.map(|vertex| vertex + first)));
        first += loaded.mesh.vertex_count() as u32;
    }
    Ok(prepared(name, LabelledMesh { mesh, labels: None, feature_edges, notes: Vec::new(), parts: None }))
}

/// One mesh for whatever method may come, or the hull of a silhouette texture. Its faces are turned or noted as `winding` says.
pub fn one(argument: &MeshArgument, winding: Winding, progress: &dyn Progress) -> Result<NamedMesh, Failure> {
    match argument.texture() {
        Some(path) => hull_of_file(argument, path),
        None => mesh(argument, winding, progress),
    }
}

/// That a method draws what an argument names: some draw silhouette textures, the others do not.
pub fn check_drawn_by(argument: &MeshArgument, method: &Entry) -> Result<(), Failure> {
    if argument.texture().is_none() || method.info().needs.contains(&Textures::NAME) {
        return Ok(());
    }
    Err(Failure::Input(format!(
        "{argument}: --method {} draws no silhouette textures; choose texture, texture-lines or normal-map-hull",
        method.info().name
    )))
}

fn hull_of_file(argument: &MeshArgument, path: &Path) -> Result<NamedMesh, Failure> {
    if path.metadata().is_ok_and(|metadata| metadata.len() > most_bytes()) {
        return Err(too_long(argument));
    }
    let siltex::Siltex { texture, metadata, .. } = siltex::read(path).map_err(Failure::input)?;
    Ok(hull_of_texture(file_name(path), &Arc::new(texture), &metadata))
}

/// The hull of a silhouette texture as a mesh that methods draw by that texture.
pub fn hull_of_texture(name: String, texture: &Arc<SilhouetteTexture>, metadata: &Metadata) -> NamedMesh {
    let hull = texture.parts().hull.mesh().as_ref().clone().with_origin(bake::origin(metadata));
    let mesh = PreparedMesh::new(hull).with_artefact(Textures::given(Arc::clone(texture)));
    NamedMesh { name, mesh: Arc::new(mesh) }
}

fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}

/// The same, with what the file calls its parts: by their materials and groups. Prints what the reader noted.
fn labelled(
    argument: &MeshArgument,
    winding: Winding,
    progress: &dyn Progress,
) -> Result<(String, LabelledMesh), Failure> {
    let (name, mut loaded) = silently_labelled(argument, progress)?;
    for about_file in &loaded.notes {
        note(format_args!("{argument}: {about_file}"));
    }
    winding.apply(&name, &mut loaded, progress)?;
    Ok((name, loaded))
}

/// The same, as it is wound, and with what the reader noted instead of printing it.
pub fn silently_labelled(argument: &MeshArgument, progress: &dyn Progress) -> Result<(String, LabelledMesh), Failure> {
    match argument {
        MeshArgument::Builtin(shape) => {
            let mesh = shapes::by_name(shape).map_err(|error| Failure::Input(format!("{argument}: {error}")))?;
            let loaded = LabelledMesh { mesh, labels: None, parts: None, feature_edges: Vec::new(), notes: Vec::new() };
            Ok((argument.to_string(), loaded))
        }
        MeshArgument::StandardInput => {
            let name = argument.to_string();
            let mut bytes = Vec::new();
            let mut some = std::io::stdin().lock().take(most_bytes().saturating_add(1));
            let read = interrupt::while_waiting(|| some.read_to_end(&mut bytes));
            read.map_err(|error| Failure::Input(format!("{name}: {error}; name a file")))?;
            if bytes.len() as u64 > most_bytes() {
                return Err(too_long(name));
            }
            let loaded = load::read_labelled(format_of(&bytes), &name, &bytes, progress)?;
            Ok((name, loaded))
        }
        MeshArgument::File(path) => {
            let loaded = load::load_labelled_within(path, most_bytes(), progress);
            let loaded = loaded.map_err(|error| match error.problem {
                load::Problem::TooLong { .. } => too_long(argument),
                _ => error.into(),
            })?;
            Ok((file_name(path), loaded))
        }
    }
}

/// Share of a mesh's extent by which rounding may move its vertices without a note.
const NOTED_ROUNDING: f64 = 1e-4;

/// Notes that a mesh, moved to count from an origin that it shares with others, is rounded by much of its extent.
pub fn note_rounding(name: &str, moved: &TriangleMesh) {
    let extent = moved.bounds().map_or(0.0, |bounds| (bounds.max - bounds.min).max_element());
    let rounding = largest_rounding(moved);
    if rounding > NOTED_ROUNDING * extent {
        note(format_args!(
            "{name}: is rounded by up to {rounding:.1e} beside meshes so far from it; draw it by itself"
        ));
    }
}

/// Whether an argument names a mesh that is there: a file, a built-in shape or standard input.
pub fn names_mesh(argument: &MeshArgument) -> bool {
    argument.path().is_none_or(Path::exists)
}

/// The format that a file without a name begins as; OBJ, which has no sign of its own, where it is none of the others.
fn format_of(bytes: &[u8]) -> Format {
    const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";
    let text = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes).trim_ascii_start();
    let word = text.split(u8::is_ascii_whitespace).next().unwrap_or_default().to_ascii_lowercase();
    // Binary STL has a head of 80 bytes, then the number of its triangles, of 50 bytes each.
    let count = bytes.get(80..84).and_then(|count| count.try_into().ok()).map(u32::from_le_bytes);
    let is_binary_stl = count.is_some_and(|count| bytes.len() as u64 == 84 + 50 * u64::from(count));
    // Letters of what vertices carry stand before the keyword of OFF, counts may stand against it.
    let carried = word.iter().take_while(|letter| b"stcn4".contains(letter)).count();
    match &word[..] {
        _ if is_binary_stl => Format::Stl,
        b"ply" => Format::Ply,
        word if word.starts_with(b"gltf") || word.starts_with(b"{") => Format::Gltf,
        word if word.starts_with(b"solid") => Format::Stl,
        word if word[carried..].starts_with(b"off") => Format::Off,
        _ => Format::Obj,
    }
}

/// Loads all that are named, or `defaults` where none is.
pub fn meshes(
    arguments: &[MeshArgument],
    defaults: &[&str],
    winding: Winding,
    progress: &dyn Progress,
) -> Result<Vec<NamedMesh>, Failure> {
    let defaults: Vec<MeshArgument> = defaults.iter().copied().map(MeshArgument::from).collect();
    let named = if arguments.is_empty() { &defaults[..] } else { arguments };
    let mut meshes = named.iter().map(|argument| mesh(argument, winding, progress)).collect::<Result<Vec<_>, _>>()?;
    tell_apart(&mut meshes, named);
    Ok(meshes)
}

/// Loads all that are named, each with the labels of its faces.
pub fn labelled_meshes(
    arguments: &[MeshArgument],
    progress: &dyn Progress,
) -> Result<Vec<(String, LabelledMesh)>, Failure> {
    arguments.iter().map(|argument| labelled(argument, Winding::AsItIs, progress)).collect()
}

/// Different files of the same name go by their paths, as they were given.
fn tell_apart(meshes: &mut [NamedMesh], arguments: &[MeshArgument]) {
    let names: Vec<_> = meshes.iter().map(|mesh| mesh.name.clone()).collect();
    for (mesh, argument) in meshes.iter_mut().zip(arguments) {
        let mut others = names.iter().zip(arguments).filter(|&(_, other)| other != argument);
        if others.any(|(name, _)| *name == mesh.name) {
            mesh.name = argument.to_string();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::NoProgress;

    #[test]
    fn feature_edges_of_a_file_reach_the_prepared_mesh() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("bent.obj");
        let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
        std::fs::write(&path, format!("{square}s 1\nf 1 2 3\ns 2\nf 1 3 4\n")).unwrap();
        let loaded = mesh(&path.into_os_string().into(), Winding::AsItIs, &NoProgress).unwrap();
        assert_eq!(loaded.mesh.feature_edges(), [[VertexId::new(0), VertexId::new(2)]]);
    }

    #[test]
    fn formats_of_standard_input_are_known_by_their_first_bytes() {
        for (text, format) in [
            ("ply\nformat ascii 1.0", Format::Ply),
            ("OFF\n3 1 0", Format::Off),
            ("NOFF 3 1 0", Format::Off),
            ("OFF8 6 0", Format::Off),
            ("solid x\nfacet", Format::Stl),
            ("\u{feff}SOLID x\nfacet", Format::Stl),
            ("\u{feff}ply\n", Format::Ply),
            ("STOFF\n", Format::Off),
            ("#OFFICE export\nv 0 0 0", Format::Obj),
            ("  {\"asset\":{}}", Format::Gltf),
            ("glTF\u{2}\0\0\0", Format::Gltf),
            ("# made by hand\nv 0 0 0", Format::Obj),
            ("", Format::Obj),
        ] {
            assert_eq!(format_of(text.as_bytes()), format, "{text}");
        }
        let mut binary = b"solid, but binary".to_vec();
        binary.resize(84 + 50, 0);
        binary[80] = 1;
        assert_eq!(format_of(&binary), Format::Stl);
    }

    #[test]
    fn only_files_of_the_same_name_go_by_their_paths() {
        let mesh = Arc::new(PreparedMesh::new(TriangleMesh::new(vec![], vec![]).unwrap()));
        let named = |name: &str| NamedMesh { name: name.to_owned(), mesh: Arc::clone(&mesh) };
        let mut meshes = [named("m.obj"), named("x.obj"), named("m.obj")];
        tell_apart(&mut meshes, &["a/m.obj", "a/x.obj", "b/m.obj"].map(MeshArgument::from));
        assert_eq!(meshes.map(|mesh| mesh.name), ["a/m.obj", "x.obj", "b/m.obj"]);
    }
}

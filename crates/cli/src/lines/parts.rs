//! `--only`, `--without`, `--mask` and `--layers`: parts of meshes by their names.

use super::arguments::PartArguments;
use crate::failure::Failure;
use crate::input;
use silhouette_core::load::{self, LabelledMesh, Part};
use silhouette_core::{FaceId, Progress, TriangleMesh};
use silhouette_visibility::LineScene;
use silhouette_visibility::plot::LayersBy;
use std::collections::{BTreeSet, HashMap};

/// Most names that an error lists.
const MOST_LISTED: usize = 20;

/// What parts are called in layers, and which of them are masks.
#[derive(Debug, Default)]
pub struct Parts {
    /// What the parts are called, in the order of the files, whether they are drawn or not.
    names: Vec<String>,
    /// Which part it is, by its mesh and its name.
    numbers: HashMap<(usize, String), u32>,
    /// Names of masks.
    masks: Vec<String>,
    /// From this mesh on, all are masks.
    first_mask: usize,
}

/// Leaves out the parts that are not to be drawn, and adds the files that are masks. Layers are `whole` files, or parts of them.
pub fn select(
    meshes: &mut Vec<(String, LabelledMesh)>,
    arguments: &PartArguments,
    whole: bool,
    progress: &dyn Progress,
) -> Result<Parts, Failure> {
    let known = names(meshes);
    for (option, names) in [("--only", &arguments.only), ("--without", &arguments.without)] {
        if let Some(unknown) = names.iter().find(|name| !known.contains(*name)) {
            return Err(unknown_name(option, unknown, &known, ""));
        }
    }
    let mut parts = Parts { first_mask: meshes.len(), ..Parts::default() };
    if LayersBy::from(arguments.layers) != LayersBy::Kind {
        parts.number(meshes, whole);
    }
    for (name, loaded) in &mut *meshes {
        let (only, without) = (called(&arguments.only, name, loaded), called(&arguments.without, name, loaded));
        let is_kept: Vec<bool> = (0..loaded.mesh.face_count())
            .map(|face| (arguments.only.is_empty() || only(face)) && !without(face))
            .collect();
        drop((only, without));
        keep(loaded, &is_kept);
    }
    if meshes.iter().all(|(_, loaded)| loaded.mesh.face_count() == 0) {
        let options = if arguments.only.is_empty() { "--without leaves" } else { "--only and --without leave" };
        return Err(Failure::Input(format!("{options} nothing to draw; name fewer parts")));
    }
    for mask in &arguments.mask {
        if known.contains(mask) {
            parts.masks.push(mask.clone());
        } else if input::names_mesh(&mask.as_str().into()) {
            meshes.extend(input::labelled_meshes(&[mask.as_str().into()], progress)?);
        } else {
            return Err(unknown_name("--mask", mask, &known, ", and no such file"));
        }
    }
    Ok(parts)
}

impl Parts {
    /// Numbers the parts of the meshes in their order.
    fn number(&mut self, meshes: &[(String, LabelledMesh)], whole: bool) {
        for (mesh, (file, loaded)) in meshes.iter().enumerate() {
            let names = labels(file, loaded);
            let mut last = None;
            for face in 0..loaded.mesh.face_count() {
                let name = if whole { file } else { names(face) };
                if last.replace(name) != Some(name) && !self.numbers.contains_key(&(mesh, name.to_owned())) {
                    self.numbers.insert((mesh, name.to_owned()), self.names.len() as u32);
                    let is_whole = meshes.len() == 1 || name == file;
                    self.names.push(if is_whole { name.to_owned() } else { format!("{file} {name}") });
                }
            }
        }
    }

    /// What the parts are called, where layers are parts.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// For each face of the meshes whether it is a mask; `None` where none is.
    pub fn masks(&self, meshes: &[(String, LabelledMesh)]) -> Option<Vec<bool>> {
        let mut is_mask = Vec::new();
        for (mesh, (name, loaded)) in meshes.iter().enumerate() {
            let is_called = called(&self.masks, name, loaded);
            is_mask.extend((0..loaded.mesh.face_count()).map(|face| mesh >= self.first_mask || is_called(face)));
        }
        is_mask.contains(&true).then_some(is_mask)
    }

    /// For each mesh whether all of it is a mask.
    pub fn masked_files(&self, meshes: &[(String, LabelledMesh)]) -> Result<Vec<bool>, Failure> {
        let is_masked = |(mesh, (name, loaded)): (usize, &(String, LabelledMesh))| {
            let is_called = called(&self.masks, name, loaded);
            let count = (0..loaded.mesh.face_count()).filter(|&face| is_called(face)).count();
            match count {
                _ if mesh >= self.first_mask => Ok(true),
                0 => Ok(false),
                count if count == loaded.mesh.face_count() => Ok(true),
                _ => Err(Failure::Input(format!(
                    "{name}: with --smooth, --mask takes whole files; leave out one of them"
                ))),
            }
        };
        meshes.iter().enumerate().map(is_masked).collect()
    }

    /// The scene with parts as its objects, where layers are parts.
    pub fn as_objects(&self, scene: LineScene, meshes: &[(String, LabelledMesh)]) -> Result<LineScene, Failure> {
        if self.names.is_empty() {
            return Ok(scene);
        }
        let mut objects = Vec::new();
        for (mesh, (file, loaded)) in meshes.iter().enumerate() {
            let names = labels(file, loaded);
            let mut last = None;
            for face in 0..loaded.mesh.face_count() {
                let name = names(face);
                let number = || self.numbers.get(&(mesh, name.to_owned())).copied().unwrap_or(0);
                let number = last.filter(|(last, _)| *last == name).map_or_else(number, |(_, number)| number);
                last = Some((name, number));
                objects.push(number);
            }
        }
        scene.with_objects(objects).map_err(Failure::input)
    }
}

/// The faces of a scene that are no masks, as a scene of their own.
pub fn without_masks(scene: &LineScene, is_mask: &[bool]) -> Result<LineScene, Failure> {
    let mesh = scene.mesh().mesh();
    let drawn = mesh.triangles().iter().zip(is_mask).filter(|(_, is_mask)| !**is_mask);
    let drawn = TriangleMesh::new(mesh.positions().to_vec(), drawn.map(|(corners, _)| *corners).collect());
    let drawn = drawn.map_err(Failure::input)?.with_origin(mesh.origin());
    LineScene::of_meshes(&[&drawn]).map_err(Failure::input)
}

/// All names of parts, and of the meshes.
fn names(meshes: &[(String, LabelledMesh)]) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for (file, loaded) in meshes {
        names.insert(file.clone());
        let parts = loaded.parts.iter().flat_map(load::Parts::as_slice);
        names.extend(parts.flat_map(|part| part.names.iter().cloned()));
    }
    names
}

/// Whether a face of a mesh belongs to a part of one of these names.
fn called<'a>(wanted: &[String], file: &str, loaded: &'a LabelledMesh) -> impl Fn(usize) -> bool + use<'a> {
    let wants = |name: &str| wanted.iter().any(|wanted| wanted == name);
    let all = wants(file);
    let of_part =
        loaded.parts.as_ref().map(|parts| (parts, parts.named(|part| part.names.iter().any(|name| wants(name)))));
    move |face| {
        all || of_part
            .as_ref()
            .is_some_and(|(parts, named)| parts.of(FaceId::from_usize(face)).is_some_and(|part| named[part as usize]))
    }
}

/// What the part of a face is called in layers: by its own name, or by that of what it belongs to, or of the file.
fn labels<'a>(file: &'a str, loaded: &'a LabelledMesh) -> impl Fn(usize) -> &'a str {
    let parts = loaded.parts.as_ref().map(|parts| {
        let mut names: Vec<&str> = Vec::new();
        let own = |part: &'a Part| part.names.first().map(String::as_str);
        for part in parts.as_slice() {
            names.push(own(part).unwrap_or_else(|| part.parent.map_or(file, |parent| names[parent as usize])));
        }
        (parts, names)
    });
    move |face| {
        let of_part = |(parts, names): &(&load::Parts, Vec<&'a str>)| {
            parts.of(FaceId::from_usize(face)).map(|part| names[part as usize])
        };
        parts.as_ref().and_then(of_part).unwrap_or(file)
    }
}

/// Leaves out faces of a mesh; vertices stay.
fn keep(loaded: &mut LabelledMesh, is_kept: &[bool]) {
    if !is_kept.contains(&false) {
        return;
    }
    let faces = || is_kept.iter().enumerate().filter_map(|(face, is_kept)| is_kept.then_some(face));
    let triangles: Vec<[u32; 3]> = faces().map(|face| loaded.mesh.triangles()[face]).collect();
    if let Some(labels) = &mut loaded.labels {
        *labels = faces().map(|face| labels[face]).collect();
    }
    if let Some(parts) = &mut loaded.parts {
        *parts = parts.of_faces(faces().map(FaceId::from_usize));
    }
    let mesh = TriangleMesh::new(loaded.mesh.positions().to_vec(), triangles);
    loaded.mesh = mesh.expect("some faces of a mesh are a mesh").with_origin(loaded.mesh.origin());
}

fn unknown_name(option: &str, name: &str, known: &BTreeSet<String>, also: &str) -> Failure {
    let listed: Vec<&str> = known.iter().take(MOST_LISTED).map(String::as_str).collect();
    let more = known.len() - listed.len();
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    Failure::Input(format!("{option} {name}: no part of that name{also}; there are {}{more}", listed.join(", ")))
}

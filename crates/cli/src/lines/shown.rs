//! [`Shown`]: the meshes of a drawing, and what is done to them before lines are found.

use super::arguments::{HealDistance, LinesArguments};
use super::parts::{self, Parts};
use super::section;
use crate::failure::{Failure, note};
use crate::input;
use silhouette_core::heal::{NEAR_SHARE, heal_t_junctions};
use silhouette_core::load::LabelledMesh;
use silhouette_core::mesh::Bounds;
use silhouette_core::origin::common_origin;
use silhouette_core::{Progress, TriangleMesh};
use silhouette_visibility::LineScene;

/// What is drawn: meshes whose parts were chosen, and that were welded, healed, turned and cut open.
pub struct Shown {
    /// The meshes' names, for errors.
    pub names: String,
    pub meshes: Vec<(String, LabelledMesh)>,
    pub parts: Parts,
    /// What the meshes span together but for masks, before they are cut.
    pub bounds: Bounds,
    pub scene: LineScene,
    /// For each face whether it is a mask, where there are some.
    pub masks: Option<Vec<bool>>,
    /// What of the scene is no mask, where there are some.
    pub drawn: Option<LineScene>,
}

impl Shown {
    /// What the options make of some meshes.
    pub fn of(
        mut meshes: Vec<(String, LabelledMesh)>,
        arguments: &LinesArguments,
        progress: &dyn Progress,
    ) -> Result<Self, Failure> {
        let parts = change(&mut meshes, arguments, progress)?;
        let names = meshes.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>().join(", ");
        let bounds = bounds(&meshes, parts.masks(&meshes).as_deref());
        let bounds = bounds.ok_or_else(|| {
            let all_masked = meshes.iter().any(|(_, loaded)| loaded.mesh.face_count() > 0);
            let reason =
                if all_masked { "--mask hides all that could be drawn; name fewer parts" } else { "has no face" };
            Failure::Input(format!("{names}: {reason}"))
        })?;
        let section_edges = section::cut(&mut meshes, arguments.sections(), &names)?;
        let scene = scene_of(&meshes, arguments.wants_materials(), &names)?;
        let scene = scene.with_section_edges(section_edges).map_err(Failure::input)?;
        let masks = parts.masks(&meshes);
        let drawn = masks.as_ref().map(|masks| parts::without_masks(&scene, masks)).transpose()?;
        Ok(Self { names, meshes, parts, bounds, scene, masks, drawn })
    }

    /// The scene with parts as its objects, and with masks.
    pub fn masked_scene(&self) -> Result<LineScene, Failure> {
        let scene = self.parts.as_objects(self.scene.clone(), &self.meshes)?;
        match &self.masks {
            Some(masks) => scene.with_masks(masks.clone()).map_err(Failure::input),
            None => Ok(scene),
        }
    }
}

/// What the options make of one mesh: some of its parts, welded, healed, turned, cut open.
pub fn changed(
    name: &str,
    loaded: LabelledMesh,
    arguments: &LinesArguments,
    progress: &dyn Progress,
) -> Result<LabelledMesh, Failure> {
    let mut meshes = vec![(name.to_owned(), loaded)];
    change(&mut meshes, arguments, progress)?;
    section::cut(&mut meshes, arguments.sections(), name)?;
    // Files that are masks follow it.
    Ok(meshes.swap_remove(0).1)
}

/// What the meshes span together but for masks, before they are cut, so that pictures with and without a section lie upon each
/// other.
fn bounds(meshes: &[(String, LabelledMesh)], is_mask: Option<&[bool]>) -> Option<Bounds> {
    let faces = meshes.iter().flat_map(|(_, loaded)| {
        let positions = loaded.mesh.positions();
        loaded.mesh.triangles().iter().map(move |corners| corners.map(|vertex| positions[vertex as usize]))
    });
    let drawn: Vec<_> = faces.enumerate().filter(|(face, _)| !is_mask.is_some_and(|masks| masks[*face])).collect();
    Bounds::of(drawn.iter().flat_map(|(_, corners)| *corners))
}

/// Chooses parts of meshes, welds, heals and turns them as far as that is asked for; yields what their parts are.
fn change(
    meshes: &mut Vec<(String, LabelledMesh)>,
    arguments: &LinesArguments,
    progress: &dyn Progress,
) -> Result<Parts, Failure> {
    let parts = parts::select(meshes, &arguments.parts, arguments.smooth, progress)?;
    if let Some(distance) = arguments.weld {
        meshes.iter_mut().try_for_each(|(_, loaded)| input::weld(loaded, distance))?;
    }
    if let Some(distance) = arguments.heal {
        // Their vertices get other numbers, and no line is drawn along them.
        meshes.iter_mut().for_each(|(_, loaded)| loaded.feature_edges.clear());
        for (name, loaded) in &mut *meshes {
            heal(name, loaded, distance)?;
        }
    }
    // One camera sees them all.
    let origin = common_origin(meshes.iter().map(|(_, loaded)| &loaded.mesh));
    for (name, loaded) in meshes.iter_mut().filter(|(_, loaded)| loaded.mesh.origin() != origin) {
        loaded.mesh = loaded.mesh.relative_to(origin).map_err(Failure::input)?;
        input::note_rounding(name, &loaded.mesh);
    }
    // Lines are right whichever way faces point, and so are their kinds.
    let winding = arguments.orient.winding(false);
    for (name, loaded) in &mut *meshes {
        winding.apply(name, loaded, progress)?;
    }
    Ok(parts)
}

/// Mends the T-junctions of a mesh.
fn heal(name: &str, loaded: &mut LabelledMesh, distance: HealDistance) -> Result<(), Failure> {
    let distance = match distance {
        HealDistance::Units(distance) => distance,
        HealDistance::Auto => {
            let extent = loaded.mesh.bounds().map_or(0.0, |bounds| (bounds.max - bounds.min).max_element());
            (extent * NEAR_SHARE) as f32
        }
    };
    let healed = heal_t_junctions(&loaded.mesh, distance);
    let healed = healed.map_err(|error| Failure::Input(format!("--heal: {error}")))?;
    if healed.mesh.face_count() == 0 && loaded.mesh.face_count() > 0 {
        return Err(Failure::Input(format!(
            "--heal: no face of {name} is higher than {distance}; give a smaller distance"
        )));
    }
    if healed.divided > 0 {
        note(format!("{name}: edges divided at T-junctions: {}", healed.divided));
    }
    if let Some(labels) = &mut loaded.labels {
        *labels = healed.face_of.iter().map(|face| labels[face.index()]).collect();
    }
    if let Some(parts) = &mut loaded.parts {
        *parts = parts.of_faces(healed.face_of.iter().copied());
    }
    loaded.mesh = healed.mesh;
    Ok(())
}

/// All meshes as one scene, with the labels of their faces if borders between them are wanted.
fn scene_of(meshes: &[(String, LabelledMesh)], wants_labels: bool, names: &str) -> Result<LineScene, Failure> {
    let only: Vec<&TriangleMesh> = meshes.iter().map(|(_, loaded)| &loaded.mesh).collect();
    let scene = LineScene::of_meshes(&only).map_err(Failure::input)?;
    if !wants_labels {
        return Ok(scene);
    }
    if meshes.iter().all(|(_, loaded)| loaded.labels.is_none()) {
        note(format!("{names}: all faces are of one material and group; --materials adds no line"));
    }
    // Faces of different meshes have no edge in common, so that their labels may be equal.
    let labels = meshes.iter().flat_map(|(_, loaded)| {
        let none = || vec![0; loaded.mesh.face_count()];
        loaded.labels.clone().unwrap_or_else(none)
    });
    scene.with_labels(labels.collect()).map_err(Failure::input)
}

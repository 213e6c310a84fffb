//! `lines --section`: meshes are cut open before their lines are found.

use crate::failure::{Failure, note};
use silhouette_core::VertexId;
use silhouette_core::load::LabelledMesh;
use silhouette_visibility::{SectionPlane, SectionedMesh};

/// Cuts the meshes by each plane; yields the edges along which they were cut, as edges of all meshes set one after another.
/// `names` are the meshes' names, for errors.
pub fn cut(
    meshes: &mut [(String, LabelledMesh)],
    planes: &[SectionPlane],
    names: &str,
) -> Result<Vec<[VertexId; 2]>, Failure> {
    for plane in planes {
        if !meshes.iter().any(|(_, loaded)| plane.takes_from(&loaded.mesh)) {
            note(format!("{names}: --section {plane} takes nothing away; the plane does not pass through it, or the normal points away"));
        }
    }
    let (mut edges, mut first) = (Vec::new(), 0);
    for (_, loaded) in meshes.iter_mut() {
        edges.extend(cut_one(loaded, planes)?.into_iter().map(|ends| ends.map(|end| VertexId::new(end.get() + first))));
        // Beyond 32 bits the sum wraps, and the size check of the whole refuses the scene.
        first = first.wrapping_add(loaded.mesh.vertex_count() as u32);
    }
    let is_empty = meshes.iter().all(|(_, loaded)| loaded.mesh.face_count() == 0);
    if let (true, Some(plane)) = (is_empty, planes.last()) {
        let mend = "turn its normal round, as it points to what is taken away";
        return Err(Failure::Input(format!("{names}: --section {plane} leaves nothing; {mend}")));
    }
    Ok(edges)
}

fn cut_one(loaded: &mut LabelledMesh, planes: &[SectionPlane]) -> Result<Vec<[VertexId; 2]>, Failure> {
    let mut sectioned = SectionedMesh::whole(loaded.mesh.clone());
    for plane in planes {
        sectioned = sectioned.cut(plane).map_err(Failure::input)?;
    }
    if let Some(labels) = &mut loaded.labels {
        *labels = sectioned.face_of.iter().map(|face| labels[face.index()]).collect();
    }
    loaded.mesh = sectioned.mesh;
    Ok(sectioned.edges)
}

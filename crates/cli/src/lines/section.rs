//! `lines --section`: meshes are cut open before their lines are found.

use super::arguments::SectionArgument;
use crate::failure::{Failure, note};
use silhouette_core::VertexId;
use silhouette_core::glam::DVec3;
use silhouette_core::load::LabelledMesh;
use silhouette_visibility::SectionedMesh;

/// Cuts the meshes by each plane; yields the edges along which they were cut, as edges of all meshes set one after another.
/// `names` are the meshes' names, for errors.
pub fn cut(
    meshes: &mut [(String, LabelledMesh)],
    planes: &[SectionArgument],
    names: &str,
) -> Result<Vec<[VertexId; 2]>, Failure> {
    if planes.is_empty() {
        return Ok(Vec::new());
    }
    let mut parts: Vec<_> = meshes.iter().map(|(_, loaded)| SectionedMesh::whole(loaded.mesh.clone())).collect();
    let origin = meshes.first().map_or(DVec3::ZERO, |(_, loaded)| loaded.mesh.origin());
    for argument in planes {
        let beyond = || Failure::Input(format!("--section {argument}: lies beyond 32 bits as seen from the meshes"));
        let plane = &argument.seen_from(origin).ok_or_else(beyond)?;
        // What is cut has fewer faces or more vertices.
        let size = |parts: &[SectionedMesh]| -> Vec<[usize; 2]> {
            parts.iter().map(|part| [part.mesh.face_count(), part.mesh.vertex_count()]).collect()
        };
        let before = size(&parts);
        parts = parts.into_iter().map(|part| part.cut(plane)).collect::<Result<_, _>>().map_err(Failure::input)?;
        if size(&parts) == before {
            note(format!("{names}: --section {argument} takes nothing away: all lies on the side that stays"));
        }
        if parts.iter().all(|part| part.mesh.face_count() == 0) {
            let mend = "its normal points to what is taken away; move the plane or turn its normal round";
            return Err(Failure::Input(format!("{names}: --section {argument} leaves nothing: {mend}")));
        }
    }
    let (mut edges, mut first) = (Vec::new(), 0_u32);
    for ((_, loaded), part) in meshes.iter_mut().zip(parts) {
        // Beyond 32 bits the sum wraps, and the size check of the whole refuses the scene.
        let of_scene = |end: VertexId| VertexId::new(end.get().wrapping_add(first));
        edges.extend(part.edges.iter().map(|ends| ends.map(of_scene)));
        first = first.wrapping_add(part.mesh.vertex_count() as u32);
        if let Some(labels) = &mut loaded.labels {
            *labels = part.face_of.iter().map(|face| labels[face.index()]).collect();
        }
        if let Some(parts) = &mut loaded.parts {
            *parts = parts.of_faces(part.face_of.iter().copied());
        }
        loaded.mesh = part.mesh;
    }
    Ok(edges)
}

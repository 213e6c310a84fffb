//! [`mesh_files`].

use crate::check_line;
use silhouette_core::heal::heal_t_junctions;
use silhouette_core::id::FaceId;
use silhouette_core::inside_out::{inside_out_faces, turned};
use silhouette_core::inspect::inspect;
use silhouette_core::load::{Format, LabelledMesh, read_labelled};
use silhouette_core::subdivide::loop_subdivision;
use silhouette_core::weld::{weld_exact, weld_within};
use silhouette_core::{FaceFacings, NoProgress, SilhouetteEdges, Topology, TriangleMesh, Viewpoint};

/// The letter that a format begins with.
pub(crate) const FORMATS: [(u8, Format); 5] =
    [(b'o', Format::Obj), (b'p', Format::Ply), (b'f', Format::Off), (b's', Format::Stl), (b'g', Format::Gltf)];

/// Most faces with which more is done than reading.
const FEW_FACES: usize = 2000;

/// Reads a file: the first byte is a letter of its format, the second what is done to the mesh, the rest the file.
///
/// Each triangle names vertices that exist, each position is finite, and each list has an entry per face; an error is one line that
/// names the file. Welding, healing, turning and subdividing leave a mesh that can be inspected and looked at.
pub fn mesh_files(bytes: &[u8]) -> bool {
    let [format, option, file @ ..] = bytes else { return false };
    let Some((_, format)) = FORMATS.into_iter().find(|(letter, _)| letter == format) else { return false };
    match read_labelled(format, "fuzzed", file, &NoProgress) {
        Err(error) => {
            let message = error.to_string();
            check_line(&message);
            assert!(message.starts_with("fuzzed"), "{message}");
            false
        }
        Ok(labelled) => {
            check_labelled(&labelled);
            if labelled.mesh.face_count() <= FEW_FACES {
                process(&labelled.mesh, *option);
            }
            true
        }
    }
}

fn check_labelled(LabelledMesh { mesh, labels, parts, feature_edges, notes }: &LabelledMesh) {
    check_mesh(mesh);
    assert!(mesh.face_count() > 0, "a file without faces is refused");
    assert!(labels.as_ref().is_none_or(|labels| labels.len() == mesh.face_count()), "labels for other faces");
    if let Some(parts) = parts {
        let known = parts.as_slice().len();
        for face in (0..mesh.face_count()).map(FaceId::from_usize) {
            assert!(parts.of(face).is_none_or(|part| (part as usize) < known), "a part that is not there");
        }
        parts.named(|part| part.names.is_empty());
    }
    assert!(feature_edges.is_sorted(), "feature edges are sorted");
    assert!(feature_edges.iter().all(|[a, b]| a < b && (*b as usize) < mesh.vertex_count()), "feature edges are edges");
    notes.iter().for_each(|note| check_line(&note.to_string()));
}

fn check_mesh(mesh: &TriangleMesh) {
    assert!(mesh.positions().iter().all(|position| position.is_finite()), "positions are finite");
    let vertices = mesh.vertex_count();
    assert!(mesh.triangles().iter().flatten().all(|&vertex| (vertex as usize) < vertices), "vertices exist");
}

fn process(mesh: &TriangleMesh, option: u8) {
    let reach = mesh.bounds().map_or(0.0, |bounds| bounds.radius as f32);
    let topology = Topology::new(mesh);
    let changed = match option % 8 {
        0 => None,
        1 => Some(weld_exact(mesh).mesh),
        2 => weld_within(mesh, reach * 1e-3).map(|welded| welded.mesh).ok(),
        3 => weld_within(mesh, reach).map(|welded| welded.mesh).ok(),
        4 => heal_t_junctions(mesh, reach * 1e-3).map(|healed| healed.mesh).ok(),
        5 => heal_t_junctions(mesh, reach * 0.1).map(|healed| healed.mesh).ok(),
        6 => Some(turned(mesh, &inside_out_faces(mesh, &topology))),
        _ => loop_subdivision(mesh, &topology, 1).ok(),
    };
    let mesh = changed.as_ref().unwrap_or(mesh);
    check_mesh(mesh);
    let topology = Topology::new(mesh);
    let found = inspect(mesh, &topology);
    assert_eq!((found.vertices, found.faces), (mesh.vertex_count(), mesh.face_count()));
    let middle = mesh.bounds().map_or(mesh.positions()[0], |bounds| bounds.center.as_vec3());
    for viewpoint in [
        Viewpoint::Perspective { eye: middle },
        Viewpoint::Orthographic { toward_viewer: silhouette_core::glam::Vec3::new(0.3, 0.5, 0.7) },
    ] {
        let facings = FaceFacings::new(mesh, &viewpoint);
        let edges = SilhouetteEdges::of(&topology, &facings);
        assert!(edges.len() <= topology.edge_count());
    }
}

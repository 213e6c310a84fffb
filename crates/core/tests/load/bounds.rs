//! What a file may cost: bytes that the caller allows, and scenes that repeat themselves.

use crate::expectations::{SQUARE, accepted, assert_refused};
use crate::gltf::{Document, square};
use silhouette_core::NoProgress;
use silhouette_core::load::{Format::Gltf, Problem, load_labelled_within};

#[test]
fn a_file_longer_than_is_allowed_is_not_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.obj");
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::fs::write(&path, text).unwrap();
    let length = text.len() as u64;
    assert_eq!(load_labelled_within(&path, length, &NoProgress).unwrap().mesh.face_count(), 1);
    let error = load_labelled_within(&path, length - 1, &NoProgress).unwrap_err();
    assert!(matches!(error.problem, Problem::TooLong { found, limit } if found == length && limit == length - 1));
    assert!(error.to_string().ends_with("allow more, or simplify it"), "{error}");
}

#[test]
fn buffers_beside_a_document_count_as_well() {
    let folder = tempfile::tempdir().unwrap();
    let document = square(5125);
    let json = document.json(r#","uri":"square.bin""#);
    let path = folder.path().join("square.gltf");
    std::fs::write(&path, &json).unwrap();
    std::fs::write(folder.path().join("square.bin"), &document.bin).unwrap();
    let all = (json.len() + document.bin.len()) as u64;
    assert_eq!(load_labelled_within(&path, all, &NoProgress).unwrap().mesh.face_count(), 2);
    let error = load_labelled_within(&path, all - 1, &NoProgress).unwrap_err();
    assert!(matches!(error.problem, Problem::TooLong { .. }), "{error}");
}

/// A mesh of many primitives of points and a triangle, placed by many nodes.
fn points(primitives: usize, nodes: usize) -> Vec<u8> {
    let mut document = Document::default();
    let corners = document.positions(&SQUARE[..3]);
    let triangle = format!(r#"{{"attributes":{{"POSITION":{corners}}}}}"#);
    let point = r#",{"attributes":{},"mode":0}"#.repeat(primitives);
    document.meshes.push(format!(r#"{{"primitives":[{triangle}{point}]}}"#));
    document.nodes = vec![r#"{"mesh":0}"#.to_owned(); nodes];
    document.glb()
}

/// Each node passes over all primitives: what is refused before that takes no time.
#[test]
fn points_that_are_placed_very_often_are_refused_at_once() {
    assert_eq!(accepted(Gltf, points(100, 100)).face_count(), 100);
    assert_refused(Gltf, points(10_000, 10_000), "", &["unfolds into", "bytes of mesh"]);
}

/// Skins that share the matrices of a few joints, each of which would hold them all.
#[test]
fn matrices_of_joints_are_bounded() {
    let skinned = |skins: usize, joints: usize| {
        let mut document = square(5125);
        let bytes = vec![0; 64 * joints];
        let view = document.view(&bytes);
        let matrices =
            document.accessor(&format!(r#""bufferView":{view},"componentType":5126,"count":{joints},"type":"MAT4""#));
        let skin = format!(r#"{{"joints":[0],"inverseBindMatrices":{matrices}}}"#);
        document.extra = format!(r#","skins":[{}]"#, vec![skin; skins].join(","));
        document.nodes = (0..skins).map(|skin| format!(r#"{{"mesh":0,"skin":{skin}}}"#)).collect();
        document.glb()
    };
    accepted(Gltf, skinned(20, 20));
    assert_refused(Gltf, skinned(2500, 2500), "", &["unfolds into", "matrices of joints"]);
}

//! Names of parts.

use crate::expectations::labelled;
use base64::Engine as _;
use silhouette_core::FaceId;
use silhouette_core::load::Format::{self, Gltf, Obj};
use silhouette_core::load::Parts;

fn parts(format: Format, text: &str) -> Option<Parts> {
    labelled(format, text).parts
}

/// The names of the part of each face and of all that it belongs to, innermost first.
fn names_of_faces(format: Format, text: &str) -> Vec<String> {
    let loaded = labelled(format, text);
    let parts = loaded.parts.expect("the file names parts");
    let path = |face: usize| {
        let mut part = parts.of(FaceId::from_usize(face));
        let mut names = Vec::new();
        while let Some(index) = part {
            names.push(parts.as_slice()[index as usize].names.join("+"));
            part = parts.as_slice()[index as usize].parent;
        }
        names.join("<")
    };
    (0..loaded.mesh.face_count()).map(path).collect()
}

const VERTICES: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[test]
fn objects_and_groups_name_the_faces_that_follow() {
    let file = |rows: &str| format!("{VERTICES}{}", rows.replace("; ", "\n").replace('F', "f 1 2 3"));
    let names = |rows: &str| names_of_faces(Obj, &file(rows));
    assert_eq!(
        names("F; o car # red; F; F; g wheel; F; o; F; g; F; o car; F"),
        ["", "car", "car", "wheel<car", "wheel", "", "car"]
    );
    assert_eq!(names("g left front; F; g default; F; o My Car; F"), ["left+front", "", "My Car"]);
    assert_eq!(names("g a; g b; F"), ["b"], "what no face has is no part");
    assert_eq!(parts(Obj, &file("F; usemtl red; F")), None);
    let counted = parts(Obj, &file("o a; F; o b; F; o a; F")).unwrap();
    assert_eq!(counted.as_slice().len(), 2, "a name that comes again is the same part");
    assert_eq!(counted.named(|part| part.names.iter().any(|name| name == "b")), [false, true]);
}

#[test]
fn parts_below_a_named_one_are_named_by_it() {
    let found = parts(Obj, &format!("{VERTICES}o car\ng wheel\nf 1 2 3\no tree\nf 1 2 3\n")).unwrap();
    let named = found.named(|part| part.names.iter().any(|name| name == "car"));
    let is_named = |face: u32| named[found.of(FaceId::new(face)).unwrap() as usize];
    assert!(is_named(0) && !is_named(1));
    let turned = found.of_faces([1, 0, 0].map(FaceId::new));
    assert_eq!([0, 1, 2].map(|face| turned.of(FaceId::new(face))), [1, 0, 0].map(|face| found.of(FaceId::new(face))));
}

#[test]
fn nodes_go_by_their_names_or_their_meshes() {
    let floats: Vec<u8> =
        [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].iter().flat_map(|x| x.to_le_bytes()).collect();
    let uri = format!("data:;base64,{}", base64::engine::general_purpose::STANDARD.encode(floats));
    let document = |meshes: &str, nodes: &str| {
        let accessor = r#"{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}"#;
        let views = r#"{"buffer":0,"byteLength":36}"#;
        format!(
            r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":36,"uri":"{uri}"}}],"bufferViews":[{views}],"accessors":[{accessor}],"meshes":[{meshes}]{nodes}}}"#
        )
    };
    let mesh = |name: &str| format!(r#"{{{name}"primitives":[{{"attributes":{{"POSITION":0}}}}]}}"#);
    let named = mesh(r#""name":"round","#);
    let nodes = r#","nodes":[{"name":"car","children":[1,2]},{"name":"wheel","mesh":0},{"mesh":0},{"mesh":1}]"#;
    let text = document(&format!("{named},{}", mesh("")), nodes);
    assert_eq!(names_of_faces(Gltf, &text), ["wheel<car", "round<car", ""]);
    assert_eq!(names_of_faces(Gltf, &document(&named, "")), ["round"], "without nodes");
    assert_eq!(parts(Gltf, &document(&mesh(""), r#","nodes":[{"mesh":0}]"#)), None);
}

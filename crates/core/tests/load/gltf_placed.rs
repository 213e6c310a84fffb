//! Where a glTF document places its vertices: instances, morph targets, skins, and which extensions it may require.

#![expect(clippy::float_cmp, reason = "sums of few small numbers are exact")]

use crate::expectations::{SQUARE, accepted, assert_refused, positions};
use crate::gltf::{Document, square};
use silhouette_core::load::{Format::Gltf, load};

fn floats(document: &mut Document, shape: &str, numbers: &[f32], count: usize) -> usize {
    let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
    let view = document.view(&bytes);
    document.accessor(&format!(r#""bufferView":{view},"componentType":5126,"count":{count},"type":"{shape}""#))
}

/// The square with a node that places it by these attributes of instances.
fn instanced(document: &mut Document, attributes: &str, node: &str) {
    let extension = format!(r#""EXT_mesh_gpu_instancing":{{"attributes":{{{attributes}}}}}"#);
    document.nodes = vec![format!(r#"{{"mesh":0,"extensions":{{{extension}}}{node}}}"#)];
    document.extra =
        r#","extensionsUsed":["EXT_mesh_gpu_instancing"],"extensionsRequired":["EXT_mesh_gpu_instancing"]"#.into();
}

#[test]
fn instances_are_placed_in_the_space_of_their_node() {
    let mut document = square(5125);
    let places = floats(&mut document, "VEC3", &[-4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0], 3);
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let turns = [[0.0, 0.0, 0.0, 1.0], [0.0, 0.0, half, half], [0.0, 0.0, 0.0, 1.0]].concat();
    let turns = floats(&mut document, "VEC4", &turns, 3);
    let sizes = floats(&mut document, "VEC3", &[1.0, 1.0, 1.0, 1.0, 1.0, 1.0, -2.0, 3.0, 1.0], 3);
    let attributes = format!(r#""TRANSLATION":{places},"ROTATION":{turns},"SCALE":{sizes}"#);
    instanced(&mut document, &attributes, r#","translation":[0,0,9]"#);
    let mesh = accepted(Gltf, document.glb());
    assert_eq!((mesh.vertex_count(), mesh.face_count()), (12, 6));
    let corner = |index: usize| positions(&mesh)[index].map(|x| (x * 1e4).round() / 1e4);
    assert_eq!(corner(1), [-3.0, 0.0, 9.0]);
    assert_eq!(corner(5), [0.0, 1.0, 9.0], "turned by 90 degrees");
    assert_eq!(corner(10), [2.0, 3.0, 9.0], "scaled");
    assert_eq!(mesh.triangles()[4], [8, 10, 9], "mirrored");

    let two = floats(&mut document, "VEC3", &[0.0; 6], 2);
    instanced(&mut document, &format!(r#""TRANSLATION":{places},"SCALE":{two}"#), "");
    assert_refused(Gltf, document.glb(), ", nodes[0]", &["as many", "[3, 2]"]);
}

#[test]
fn morph_targets_count_with_the_weights_of_the_node_or_the_mesh() {
    let height = |of_mesh: &str, of_node: &str| {
        let mut document = Document::default();
        let base = document.positions(&SQUARE[..3]);
        let [one, other] = [[0.0, 0.0, 5.0], [0.0, 0.0, 100.0]].map(|offset| document.positions(&[offset; 3]));
        let targets = format!(r#","targets":[{{"POSITION":{one}}},{{"POSITION":{other}}},{{}}]"#);
        document.meshes.push(format!(r#"{{"primitives":[{{"attributes":{{"POSITION":{base}}}{targets}}}]{of_mesh}}}"#));
        document.nodes.push(format!(r#"{{"mesh":0{of_node}}}"#));
        positions(&accepted(Gltf, document.glb()))[1][2]
    };
    assert_eq!(height("", ""), 0.0);
    assert_eq!(height(r#","weights":[1,0,0]"#, ""), 5.0);
    assert_eq!(height(r#","weights":[1,0,0]"#, r#","weights":[0.5,0.25,1]"#), 27.5);

    let mut document = square(5125);
    let few = document.positions(&SQUARE[..3]);
    document.meshes[0] =
        document.meshes[0].replace(r#""attributes""#, &format!(r#""targets":[{{"POSITION":{few}}}],"attributes""#));
    document.nodes[0] = r#"{"mesh":0,"weights":[1]}"#.into();
    assert_refused(Gltf, document.glb(), ", meshes[0].primitives[0]", &["3 positions of a morph target for 4"]);
}

#[test]
fn skins_are_in_the_pose_of_the_nodes() {
    let mut document = Document::default();
    let base = document.positions(&SQUARE[..3]);
    let view = document.view(&[0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0]);
    let joints = document.accessor(&format!(r#""bufferView":{view},"componentType":5121,"count":3,"type":"VEC4""#));
    let weights = [[1.0, 0.0, 0.0, 0.0], [0.25, 0.75, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]].concat();
    let weights = floats(&mut document, "VEC4", &weights, 3);
    let mut bind = [0.0_f32; 32];
    for diagonal in 0..4 {
        (bind[5 * diagonal], bind[16 + 5 * diagonal]) = (1.0, 1.0);
    }
    // The second joint was bound one up.
    bind[16 + 14] = -1.0;
    let bind = floats(&mut document, "MAT4", &bind, 2);
    document.meshes.push(format!(
        r#"{{"primitives":[{{"attributes":{{"POSITION":{base},"JOINTS_0":{joints},"WEIGHTS_0":{weights}}}}}]}}"#
    ));
    document.nodes = [
        r#"{"mesh":0,"skin":0,"translation":[7,7,7]}"#,
        r#"{"translation":[0,0,5],"children":[2]}"#,
        r#"{"translation":[0,0,4]}"#,
    ]
    .map(str::to_owned)
    .to_vec();
    document.extra =
        format!(r#","skins":[{{"joints":[1,2],"inverseBindMatrices":{bind}}}],"scenes":[{{"nodes":[0]}}]"#);
    let mesh = accepted(Gltf, document.glb());
    let heights: Vec<f32> = positions(&mesh).iter().map(|p| p[2]).collect();
    assert_eq!(heights, [5.0, 0.25 * 5.0 + 0.75 * 8.0, 8.0]);

    let json = document.embedded().replace(r#""joints":[1,2]"#, r#""joints":[1]"#);
    assert_refused(Gltf, json, ", meshes[0].primitives[0]", &["joint 1 of 1"]);
}

#[test]
fn required_extensions_are_known_or_named_in_a_refusal() {
    let requiring = |name: &str| {
        let mut document = square(5125);
        document.extra = format!(r#","extensionsUsed":["{name}"],"extensionsRequired":["{name}"]"#);
        document.glb()
    };
    for known in ["KHR_materials_unlit", "KHR_texture_transform", "KHR_mesh_quantization", "EXT_texture_webp"] {
        assert_eq!(accepted(Gltf, requiring(known)).face_count(), 2, "{known}");
    }
    for unknown in ["FOO_geometry_from_elsewhere", "CESIUM_RTC", "KHR_node_visibility"] {
        assert_refused(Gltf, requiring(unknown), "", &[unknown, "export without it"]);
    }
    assert_refused(Gltf, requiring("EXT_meshopt_compression"), "", &["without mesh compression"]);
    let mut used = square(5125);
    used.extra = r#","extensionsUsed":["FOO_geometry_from_elsewhere"]"#.into();
    assert_eq!(accepted(Gltf, used.glb()).face_count(), 2, "what is not required may be passed over");
}

#[test]
fn buffers_may_lie_above_the_document() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("inner")).unwrap();
    let document = square(5125);
    std::fs::write(folder.path().join("square.bin"), &document.bin).unwrap();
    let path = folder.path().join("inner/square.gltf");
    std::fs::write(&path, document.json(r#","uri":"../square.bin""#)).unwrap();
    assert_eq!(load(&path).unwrap().face_count(), 2);
}

use crate::expectations::{SQUARE, assert_refused, refused};
use crate::gltf::{Document, square};
use silhouette_core::load::{Format::Gltf, Place, Problem, load};

const PRIMITIVE: &str = ", meshes[0].primitives[0]";

/// The square as text with one passage replaced.
fn changed(from: &str, to: &str) -> String {
    let json = square(5125).embedded();
    assert!(json.contains(from), "{from} is not in {json}");
    json.replace(from, to)
}

#[test]
fn documents_that_are_no_gltf_are_refused_at_their_line() {
    assert_refused(Gltf, "{\n\"asset\": 7\n}", ", line 2", &["a glTF 2.0 document"]);
    assert_refused(Gltf, "{}", ", line 1", &["missing field `asset`"]);
    assert_refused(Gltf, b"{\"asset\": \"\xff\"}", ", line 1", &["a glTF 2.0 document"]);
    assert_refused(Gltf, r#"{"asset":{"version":"2.0"}}"#, "", &["no faces"]);
}

#[test]
fn containers_are_refused_wherever_they_are_cut() {
    let bytes = square(5125).glb();
    for length in 4..bytes.len() {
        let error = refused(Gltf, &bytes[..length]);
        assert!(matches!(error.problem, Problem::Truncated { .. }), "{length}: {error}");
        assert_eq!(error.place, Some(Place::Byte(0)));
    }
    let with = |range: std::ops::Range<usize>, value: u32| {
        let mut bytes = bytes.clone();
        bytes[range].copy_from_slice(&value.to_le_bytes());
        bytes
    };
    assert_refused(Gltf, with(8..12, 3), ", byte 0", &["cut short"]);
    assert_refused(Gltf, with(4..8, 1), ", byte 4", &["version 1"]);
    assert_refused(Gltf, with(12..16, u32::MAX), ", byte 12", &["4294967303 bytes are needed"]);
    assert_refused(Gltf, with(16..20, 0), ", byte 12", &["a JSON chunk"]);
}

#[test]
fn indices_that_lead_out_of_their_arrays_are_refused() {
    assert_refused(Gltf, changed(r#""POSITION":0"#, r#""POSITION":9"#), PRIMITIVE, &["beyond the 2 accessors"]);
    assert_refused(Gltf, changed(r#""indices":1"#, r#""indices":9"#), PRIMITIVE, &["beyond the 2 accessors"]);
    assert_refused(Gltf, changed(r#""bufferView":1"#, r#""bufferView":9"#), PRIMITIVE, &["beyond the 2 bufferViews"]);
    assert_refused(Gltf, changed(r#""buffer":0"#, r#""buffer":9"#), PRIMITIVE, &["beyond the 1 buffers"]);
    assert_refused(Gltf, changed(r#"{"mesh":0}"#, r#"{"mesh":9}"#), ", meshes[9]", &["beyond the 1 meshes"]);
    assert_refused(Gltf, changed(r#"{"mesh":0}"#, r#"{"children":[9]}"#), ", nodes[9]", &["beyond the 1 nodes"]);
    let scene = changed(r#","nodes""#, r#","scene":9,"nodes""#);
    assert_refused(Gltf, scene, ", scene", &["beyond the 0 scenes"]);
}

#[test]
fn nodes_must_form_a_tree() {
    let cycle =
        changed(r#""nodes":[{"mesh":0}]"#, r#""nodes":[{"children":[1]},{"children":[0]}],"scenes":[{"nodes":[0]}]"#);
    assert_refused(Gltf, cycle, ", nodes[0]", &["a tree of nodes"]);
    let shared = changed(r#""nodes":[{"mesh":0}]"#, r#""nodes":[{"children":[1,1]},{"mesh":0}]"#);
    assert_refused(Gltf, shared, ", nodes[1]", &["reached twice"]);
}

#[test]
fn promises_are_checked_against_the_buffer() {
    let count = changed(r#""count":4"#, r#""count":4294967295"#);
    assert_refused(Gltf, count, PRIMITIVE, &["an accessor", "48 are left"]);
    let largest = changed(r#""count":4"#, r#""count":18446744073709551615"#);
    assert_refused(Gltf, largest, PRIMITIVE, &["an accessor"]);
    let offset = changed(r#""byteOffset":48"#, r#""byteOffset":18446744073709551615"#);
    assert_refused(Gltf, offset, PRIMITIVE, &["a bufferView"]);
    assert_refused(
        Gltf,
        changed(r#""byteLength":72,"#, r#""byteLength":73,"#),
        PRIMITIVE,
        &["a buffer", "72 are left"],
    );
    let nothing =
        changed(r#""bufferView":0,"componentType":5126,"count":4"#, r#""componentType":5126,"count":4294967295"#);
    assert_refused(Gltf, nothing, "", &["bytes of mesh"]);
    let zeros = changed(r#""bufferView":0,"componentType":5126,"count":4"#, r#""componentType":5126,"count":2000000"#);
    assert_refused(Gltf, zeros, PRIMITIVE, &["2000000 elements without a bufferView"]);
    let stride = changed(r#""byteLength":48"#, r#""byteLength":48,"byteStride":0"#);
    assert_refused(Gltf, stride, PRIMITIVE, &["byteStride of 0"]);
}

#[test]
fn sparse_places_must_be_within() {
    let mut document = Document::default();
    document.view(&[3, 0, 0, 0]);
    document.view(&[0; 12]);
    let accessor = document.accessor(
        r#""componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,
        "indices":{"bufferView":0,"componentType":5125},"values":{"bufferView":1}}"#,
    );
    document.mesh(accessor, "");
    assert_refused(Gltf, document.glb(), PRIMITIVE, &["index 3 of 3"]);
}

#[test]
fn numbers_of_the_wrong_kind_are_refused() {
    assert_refused(Gltf, changed(r#""type":"VEC3""#, r#""type":"VEC2""#), PRIMITIVE, &["type VEC3"]);
    assert_refused(Gltf, changed(r#""componentType":5125"#, r#""componentType":5126"#), PRIMITIVE, &["unsigned"]);
    assert_refused(Gltf, changed(r#""componentType":5125"#, r#""componentType":7"#), PRIMITIVE, &["type SCALAR"]);
    assert_refused(Gltf, changed(r#""indices":1"#, r#""indices":1,"mode":7"#), PRIMITIVE, &["mode from 0 to 6"]);
    let seven = {
        let mut document = Document::default();
        let (positions, indices) = (document.positions(&SQUARE), document.indices(5121, &[0, 1, 2, 3]));
        document.mesh(positions, &format!(r#","indices":{indices}"#));
        document.glb()
    };
    assert_refused(Gltf, seven, PRIMITIVE, &["three corners", "4 corners"]);
}

#[test]
fn vertices_out_of_range_or_not_finite_are_refused() {
    let with = |positions: &[[f32; 3]], indices: &[u32], node: &str| {
        let mut document = Document::default();
        let (positions, indices) = (document.positions(positions), document.indices(5125, indices));
        document.mesh(positions, &format!(r#","indices":{indices}"#));
        document.nodes.push(format!(r#"{{"mesh":0{node}}}"#));
        document.glb()
    };
    assert_refused(Gltf, with(&SQUARE, &[0, 1, 2, 0, 2, 4], ""), PRIMITIVE, &["face 1", "vertex 4", "0 to 3"]);
    assert_refused(Gltf, with(&[[0.0, f32::NAN, 0.0]], &[0, 0, 0], ""), PRIMITIVE, &["vertex 0", "NaN"]);
    let huge = r#","scale":[1e30,1e30,1e30]"#;
    assert_refused(Gltf, with(&[[0.0, 1e30, 0.0]], &[0, 0, 0], huge), PRIMITIVE, &["vertex 0"]);
}

#[test]
fn what_cannot_be_read_is_named() {
    let draco = changed(r#","nodes""#, r#","extensionsRequired":["KHR_draco_mesh_compression"],"nodes""#);
    assert_refused(Gltf, draco, "", &["KHR_draco_mesh_compression", "without mesh compression"]);
    let document = square(5125);
    assert_refused(Gltf, document.json(r#","uri":"data:text/plain,abc""#), PRIMITIVE, &["base64"]);
    assert_refused(Gltf, document.json(r#","uri":"data:;base64,?""#), PRIMITIVE, &["base64"]);
    assert_refused(Gltf, document.json(r#","uri":"beside.bin""#), PRIMITIVE, &["beside.bin", "embed"]);
    assert_refused(Gltf, document.json(""), PRIMITIVE, &["a uri or a GLB binary chunk"]);
}

#[test]
fn buffers_elsewhere_are_not_opened() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("square.gltf");
    std::fs::create_dir(folder.path().join("folder")).unwrap();
    for uri in ["missing.bin", "/etc/hostname", "%2Fetc%2Fhostname", "http://x/y.bin", "folder"] {
        std::fs::write(&path, square(5125).json(&format!(r#","uri":"{uri}""#))).unwrap();
        let line = load(&path).unwrap_err().to_string();
        assert!(line.contains("put the buffer beside the document") && line.contains(uri), "{line}");
    }
}

/// To open a pipe is to wait for its writer, and a device may have no end.
#[cfg(unix)]
#[test]
fn buffers_that_are_no_files_are_not_opened() {
    let folder = tempfile::tempdir().unwrap();
    let inner = folder.path().join("inner");
    std::fs::create_dir(&inner).unwrap();
    assert!(std::process::Command::new("mkfifo").arg(folder.path().join("pipe.bin")).status().unwrap().success());
    std::os::unix::fs::symlink("/dev/zero", inner.join("endless.bin")).unwrap();
    std::os::unix::fs::symlink(folder.path().join("pipe.bin"), inner.join("pipe.bin")).unwrap();
    for uri in ["pipe.bin", "../pipe.bin", "endless.bin"] {
        let path = inner.join("square.gltf");
        std::fs::write(&path, square(5125).json(&format!(r#","uri":"{uri}""#))).unwrap();
        let line = load(&path).unwrap_err().to_string();
        assert!(line.contains("as a plain file") && line.contains(uri), "{line}");
    }
}

/// Zeros that no byte stands for, placed by each of thousands of nodes.
#[test]
fn elements_without_bytes_unfold_within_bounds() {
    let mut document = square(5125);
    let zeros = document.accessor(r#""componentType":5126,"count":72,"type":"VEC3""#);
    document.mesh(zeros, "");
    document.nodes = vec![r#"{"mesh":1}"#.to_owned(); 400_000];
    let error = refused(Gltf, document.glb());
    assert!(matches!(error.problem, Problem::TooLarge { what: "bytes of mesh", .. }), "{error}");
}

/// Places of instances that no byte stands for.
#[test]
fn instances_are_bounded_by_their_bytes() {
    let mut document = square(5125);
    let places = document.accessor(r#""componentType":5126,"count":4000000000,"type":"VEC3""#);
    let instancing = format!(r#""EXT_mesh_gpu_instancing":{{"attributes":{{"TRANSLATION":{places}}}}}"#);
    document.nodes = vec![format!(r#"{{"mesh":0,"extensions":{{{instancing}}}}}"#)];
    assert_refused(Gltf, document.glb(), ", nodes[0]", &["4000000000 placed meshes"]);
}

#[test]
fn a_small_document_cannot_unfold_without_bounds() {
    // 450000 corners of a byte each, named again by each of 3000 primitives: 16 GB of triangles from 600 kB.
    let mut document = Document::default();
    let positions = document.positions(&SQUARE);
    let indices = document.indices(5121, &[0; 450_000]);
    let primitive = format!(r#"{{"attributes":{{"POSITION":{positions}}},"indices":{indices}}}"#);
    document.meshes.push(format!(r#"{{"primitives":[{}]}}"#, vec![primitive; 3000].join(",")));
    let error = refused(Gltf, document.glb());
    assert!(matches!(error.problem, Problem::TooLarge { .. }), "{error}");
}

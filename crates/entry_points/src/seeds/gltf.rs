//! Scenes of a few triangles in glTF.

use base64::Engine as _;

/// A buffer with a triangle's positions at 0, its indices at 36 as three 16-bit numbers and two bytes of padding, joints at 44 and
/// weights at 56.
fn buffer() -> Vec<u8> {
    let mut bytes: Vec<u8> =
        [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].into_iter().flat_map(f32::to_le_bytes).collect();
    bytes.extend([0_u16, 1, 2, 0].into_iter().flat_map(u16::to_le_bytes));
    bytes.extend([0_u8; 12]);
    bytes.extend([1.0_f32, 0.0, 0.0, 0.0].repeat(3).into_iter().flat_map(f32::to_le_bytes));
    bytes
}

const ACCESSORS: &str = r#""accessors":[
{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"},
{"bufferView":2,"componentType":5121,"count":3,"type":"VEC4"},
{"bufferView":3,"componentType":5126,"count":3,"type":"VEC4"},
{"bufferView":2,"componentType":5121,"count":1,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6},
{"buffer":0,"byteOffset":44,"byteLength":12},{"buffer":0,"byteOffset":56,"byteLength":48}]"#;

fn document(rest: &str, uri: &str) -> String {
    format!(
        r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}{uri}}}],{ACCESSORS},{rest}}}"#,
        buffer().len()
    )
}

fn embedded(rest: &str) -> String {
    let base64 = base64::engine::general_purpose::STANDARD.encode(buffer());
    document(rest, &format!(r#","uri":"data:application/octet-stream;base64,{base64}""#))
}

/// A mesh that is placed three times, one of them mirrored, with a morph target.
pub fn text() -> String {
    embedded(
        r#""materials":[{"name":"red"}],
"meshes":[{"name":"leaf","weights":[0.5],"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":4,"material":0,
"targets":[{"POSITION":0}]}]}],
"nodes":[{"name":"tree","children":[1,2],"scale":[2,2,2]},{"mesh":0,"translation":[1,2,3]},
{"mesh":0,"matrix":[-1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]},{"mesh":0,"rotation":[0,0,0.7071068,0.7071068]}],
"scenes":[{"nodes":[0,3]}],"scene":0"#,
    )
}

/// A skin of one joint, and a strip beside it.
pub fn skinned() -> String {
    embedded(
        r#""meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3}}]},
{"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":5},{"attributes":{"POSITION":0},"mode":0}]}],
"skins":[{"joints":[1]}],
"nodes":[{"mesh":0,"skin":0},{"translation":[0,0,1]},{"mesh":1}],"scenes":[{"nodes":[0,1,2]}],"scene":0"#,
    )
}

/// A container with a triangle whose edges have visibilities.
pub fn binary() -> Vec<u8> {
    let mut json = document(
        r#""meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"extensions":
{"EXT_mesh_primitive_edge_visibility":{"visibility":4}}}]}],"extensionsUsed":["EXT_mesh_primitive_edge_visibility"],
"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0"#,
        "",
    )
    .into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let binary = buffer();
    let mut bytes = b"glTF".to_vec();
    bytes.extend(2_u32.to_le_bytes());
    bytes.extend((28 + json.len() as u32 + binary.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", &json), (b"BIN\0", &binary)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}

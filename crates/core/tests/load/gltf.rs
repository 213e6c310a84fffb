use crate::expectations::{SQUARE, accepted, assert_refused, assert_square, labels, positions};
use base64::Engine as _;
use silhouette_core::load::{Format::Gltf, load};

/// A document with one buffer, put together piece by piece.
#[derive(Default)]
pub struct Document {
    pub bin: Vec<u8>,
    views: Vec<String>,
    accessors: Vec<String>,
    pub meshes: Vec<String>,
    pub nodes: Vec<String>,
    /// Further members of the document, each behind a comma.
    pub extra: String,
}

impl Document {
    /// Appends bytes as a view; returns its index.
    pub fn view(&mut self, bytes: &[u8]) -> usize {
        let offset = self.bin.len();
        self.bin.extend(bytes);
        self.bin.resize(self.bin.len().next_multiple_of(4), 0);
        self.views.push(format!(r#"{{"buffer":0,"byteOffset":{offset},"byteLength":{}}}"#, bytes.len()));
        self.views.len() - 1
    }

    /// Appends bytes as a view of elements at equal distances; returns its index.
    pub fn strided_view(&mut self, bytes: &[u8], stride: usize) -> usize {
        let view = self.view(bytes);
        self.views[view] = self.views[view].replace('}', &format!(r#","byteStride":{stride}}}"#));
        view
    }

    /// Appends an accessor; returns its index.
    pub fn accessor(&mut self, json: &str) -> usize {
        self.accessors.push(format!("{{{json}}}"));
        self.accessors.len() - 1
    }

    /// Appends positions as 32-bit floats; returns the accessor.
    pub fn positions(&mut self, positions: &[[f32; 3]]) -> usize {
        let bytes: Vec<u8> = positions.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
        let view = self.view(&bytes);
        let count = positions.len();
        self.accessor(&format!(r#""bufferView":{view},"componentType":5126,"count":{count},"type":"VEC3""#))
    }

    /// Appends indices of a component type (5121, 5123 or 5125); returns the accessor.
    pub fn indices(&mut self, component: u32, indices: &[u32]) -> usize {
        let width = match component {
            5121 => 1,
            5123 => 2,
            _ => 4,
        };
        let bytes: Vec<u8> = indices.iter().flat_map(|index| index.to_le_bytes()[..width].to_vec()).collect();
        let view = self.view(&bytes);
        let count = indices.len();
        self.accessor(&format!(r#""bufferView":{view},"componentType":{component},"count":{count},"type":"SCALAR""#))
    }

    /// Appends a mesh of one primitive; returns its index.
    pub fn mesh(&mut self, positions: usize, rest: &str) -> usize {
        self.meshes.push(format!(r#"{{"primitives":[{{"attributes":{{"POSITION":{positions}}}{rest}}}]}}"#));
        self.meshes.len() - 1
    }

    /// The document, its buffer described by `buffer` (members behind `byteLength`).
    pub fn json(&self, buffer: &str) -> String {
        let buffer = format!(r#"{{"byteLength":{}{buffer}}}"#, self.bin.len());
        let list = |name: &str, items: &[String]| match items {
            [] => String::new(),
            items => format!(r#","{name}":[{}]"#, items.join(",")),
        };
        let (views, accessors) = (list("bufferViews", &self.views), list("accessors", &self.accessors));
        let (meshes, nodes) = (list("meshes", &self.meshes), list("nodes", &self.nodes));
        let extra = &self.extra;
        format!(r#"{{"asset":{{"version":"2.0"}},"buffers":[{buffer}]{views}{accessors}{meshes}{nodes}{extra}}}"#)
    }

    /// The document as text, its buffer embedded.
    pub fn embedded(&self) -> String {
        let base64 = base64::engine::general_purpose::STANDARD.encode(&self.bin);
        self.json(&format!(r#","uri":"data:application/octet-stream;base64,{base64}""#))
    }

    /// The document in a container.
    pub fn glb(&self) -> Vec<u8> {
        let mut json = self.json("").into_bytes();
        json.resize(json.len().next_multiple_of(4), b' ');
        let mut bytes = b"glTF".to_vec();
        bytes.extend(2_u32.to_le_bytes());
        bytes.extend((12 + 8 + json.len() as u32 + 8 + self.bin.len() as u32).to_le_bytes());
        for (kind, chunk) in [(b"JSON", &json), (b"BIN\0", &self.bin)] {
            bytes.extend((chunk.len() as u32).to_le_bytes());
            bytes.extend(kind);
            bytes.extend(chunk);
        }
        bytes
    }
}

/// The square, its triangles indexed with this component type.
pub fn square(component: u32) -> Document {
    let mut document = Document::default();
    let (positions, indices) = (document.positions(&SQUARE), document.indices(component, &[0, 1, 2, 0, 2, 3]));
    document.mesh(positions, &format!(r#","indices":{indices}"#));
    document.nodes.push(r#"{"mesh":0}"#.into());
    document
}

/// One triangle placed by these nodes; all of them are in the scene unless `extra` says otherwise.
fn placed(nodes: &[&str], extra: &str) -> Document {
    let mut document = Document::default();
    let positions = document.positions(&SQUARE[..3]);
    document.mesh(positions, "");
    document.nodes = nodes.iter().map(|&node| node.to_owned()).collect();
    document.extra = extra.to_owned();
    document
}

#[test]
fn embedded_contained_and_external_buffers_are_read() {
    let document = square(5125);
    assert_square(&accepted(Gltf, document.embedded()));
    assert_square(&accepted(Gltf, document.glb()));
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("the square.bin"), &document.bin).unwrap();
    let path = folder.path().join("square.GLTF");
    std::fs::write(&path, document.json(r#","uri":"the%20square.bin""#)).unwrap();
    assert_square(&load(&path).unwrap());
}

#[test]
fn indices_of_all_widths_are_read() {
    for component in [5121, 5123, 5125] {
        assert_square(&accepted(Gltf, square(component).glb()));
    }
}

#[test]
fn materials_label_faces() {
    let mut document = Document::default();
    let positions = document.positions(&SQUARE);
    let faces = document.indices(5125, &[0, 1, 2]);
    for material in ["", r#","material":1"#, r#","material":0"#] {
        document.mesh(positions, &format!(r#","indices":{faces}{material}"#));
    }
    let json = |materials: &str| document.embedded().replacen('{', &format!("{{{materials}"), 1);
    assert_eq!(labels(Gltf, json(r#""materials":[{},{}],"#)), Some(vec![0, 2, 1]));
    assert_refused(Gltf, json(r#""materials":[{}],"#), ", meshes[1].primitives[0]", &["materials"]);
}

#[test]
fn strips_fans_and_loose_triangles_are_read() {
    let mut document = Document::default();
    let positions = document.positions(&SQUARE);
    let strip = document.indices(5121, &[0, 1, 3, 2, 2]);
    document.mesh(positions, &format!(r#","indices":{strip},"mode":5"#));
    document.mesh(positions, r#","mode":6"#);
    let loose = document.positions(&SQUARE[1..]);
    document.mesh(loose, "");
    for mode in 0..4 {
        document.mesh(positions, &format!(r#","mode":{mode}"#));
    }
    let mesh = accepted(Gltf, document.glb());
    assert_eq!(mesh.triangles(), [[0, 1, 3], [3, 1, 2], [4, 5, 6], [4, 6, 7], [8, 9, 10]]);
    assert_eq!(positions_of(&mesh, 8..11), SQUARE[1..]);
}

fn positions_of(mesh: &silhouette_core::TriangleMesh, range: std::ops::Range<usize>) -> Vec<[f32; 3]> {
    positions(mesh)[range].to_vec()
}

#[test]
fn nested_transforms_are_applied_parents_first() {
    // Scaled by 2, turned a quarter about z, moved by 10 along x: (x, y) becomes (10 - 2y, 2x); then moved by 5 up.
    let quarter = std::f32::consts::FRAC_1_SQRT_2;
    let inner = format!(r#"{{"mesh":0,"translation":[10,0,0],"rotation":[0,0,{quarter},{quarter}],"scale":[2,2,2]}}"#);
    let outer = r#"{"children":[0],"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,5,1]}"#;
    let mesh = accepted(Gltf, placed(&[&inner, outer], "").glb());
    assert_eq!(positions(&mesh), [[10.0, 0.0, 5.0], [10.0, 2.0, 5.0], [8.0, 2.0, 5.0]]);
    assert_eq!(mesh.triangles(), [[0, 1, 2]]);
}

#[test]
fn mirroring_turns_triangles_round() {
    let mesh = accepted(Gltf, placed(&[r#"{"mesh":0,"scale":[-1,1,1]}"#], "").glb());
    assert_eq!(positions(&mesh), [[0.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [-1.0, 1.0, 0.0]]);
    assert_eq!(mesh.triangles(), [[0, 2, 1]]);
    let twice = [r#"{"mesh":0,"scale":[-1,1,1]}"#, r#"{"children":[0],"scale":[1,-1,1]}"#];
    assert_eq!(accepted(Gltf, placed(&twice, "").glb()).triangles(), [[0, 1, 2]]);
}

#[test]
fn the_default_scene_is_read_depth_first() {
    let moved = |x: u32, rest: &str| format!(r#"{{"mesh":0,"translation":[{x},0,0]{rest}}}"#);
    let nodes = [moved(1, ""), moved(2, r#","children":[3,0]"#), moved(4, ""), moved(8, "")];
    let nodes: Vec<&str> = nodes.iter().map(String::as_str).collect();
    let origins = |extra: &str| {
        let mesh = accepted(Gltf, placed(&nodes, extra).glb());
        positions(&mesh).iter().step_by(3).map(|p| p[0]).collect::<Vec<_>>()
    };
    let scenes = r#","scenes":[{"nodes":[2,1]},{"nodes":[0]}]"#;
    assert_eq!(origins(&format!(r#"{scenes},"scene":1"#)), [1.0]);
    assert_eq!(origins(scenes), [4.0, 2.0, 10.0, 3.0]);
    assert_eq!(origins(""), [2.0, 10.0, 3.0, 4.0]);
}

#[test]
fn a_skinned_mesh_is_not_placed_by_its_node() {
    let nodes = [r#"{"mesh":0,"skin":0,"translation":[7,7,7]}"#, r#"{"translation":[0,0,5]}"#];
    let mesh = accepted(Gltf, placed(&nodes, r#","skins":[{"joints":[1]}]"#).glb());
    assert_eq!(positions(&mesh), SQUARE[..3], "a vertex without joints stays where it is");
}

#[test]
fn sparse_accessors_replace_elements() {
    let mut document = Document::default();
    let bytes = |positions: &[[f32; 3]]| positions.iter().flatten().flat_map(|x| x.to_le_bytes()).collect::<Vec<_>>();
    let base = document.view(&bytes(&[SQUARE[0], [9.0; 3], SQUARE[2]]));
    let (places, items) = (document.view(&[1]), document.view(&bytes(&[SQUARE[1]])));
    let sparse = |count: usize, places: usize, items: usize| {
        format!(
            r#""componentType":5126,"count":3,"type":"VEC3","sparse":{{"count":{count},
            "indices":{{"bufferView":{places},"componentType":5121}},"values":{{"bufferView":{items}}}}}"#
        )
    };
    let dense = document.accessor(&format!(r#""bufferView":{base},{}"#, sparse(1, places, items)));
    let (places, items) = (document.view(&[1, 2]), document.view(&bytes(&SQUARE[1..3])));
    let from_zero = document.accessor(&sparse(2, places, items));
    document.mesh(dense, "");
    document.mesh(from_zero, "");
    let mesh = accepted(Gltf, document.glb());
    assert_eq!(positions_of(&mesh, 0..3), SQUARE[..3]);
    assert_eq!(positions_of(&mesh, 3..6), SQUARE[..3]);
}

#[test]
fn interleaved_and_quantized_positions_are_read() {
    let mut document = Document::default();
    document.view(&[0, 0, 0, 77, 127, 0, 0, 77, 127, 0x81, 0, 77]);
    let whole = document.accessor(r#""bufferView":0,"componentType":5120,"count":3,"type":"VEC3""#);
    let fraction = r#""bufferView":0,"componentType":5120,"normalized":true,"count":3,"type":"VEC3""#;
    let fraction = document.accessor(fraction);
    document.mesh(whole, "");
    document.mesh(fraction, "");
    let json = document.embedded().replace(r#""byteOffset":0,"byteLength":12"#, r#""byteLength":12,"byteStride":4"#);
    let mesh = accepted(Gltf, json);
    assert_eq!(positions_of(&mesh, 0..3), [[0.0; 3], [127.0, 0.0, 0.0], [127.0, -127.0, 0.0]]);
    assert_eq!(positions_of(&mesh, 3..6), [[0.0; 3], [1.0, 0.0, 0.0], [1.0, -1.0, 0.0]]);
}

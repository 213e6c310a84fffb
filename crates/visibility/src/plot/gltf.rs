//! Lines as glTF 2.0: geometry in the space of the mesh, for any viewer that shows the mesh.

use super::layer::LayerName;
use super::options::{Hidden, PlotOptions};
use super::pen::Colour;
use crate::chains::Chain;
use crate::lines::Lines;
use base64::Engine;
use serde_json::{Value, json};
use silhouette_core::glam::Vec3;
use std::io::{self, Write};

/// How the file is packed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GltfContainer {
    /// Text, `.gltf`, with the geometry inside as base64.
    Text,
    /// Binary, `.glb`.
    Binary,
}

/// `componentType` of 32-bit floats.
const FLOAT: u32 = 5126;
/// `componentType` of 32-bit indices.
const UNSIGNED_INT: u32 = 5125;
/// `target` of vertices.
const ARRAY_BUFFER: u32 = 34962;
/// `target` of indices.
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
/// `mode` of pairs of points.
const LINES: u32 = 1;

/// Geometry of one layer.
#[derive(Default)]
struct Geometry {
    positions: Vec<Vec3>,
    indices: Vec<u32>,
}

impl Geometry {
    fn push(&mut self, chain: &Chain<'_>) {
        let first = u32::try_from(self.positions.len()).expect("a view's lines have fewer than 2^32 points");
        self.positions.extend(chain.points.iter().map(|point| point.as_vec3()));
        let count = chain.points.len() as u32;
        let segments = chain.sources.len() as u32;
        self.indices.extend((0..segments).flat_map(|at| [first + at, first + (at + 1) % count]));
    }
}

/// Writes the lines that the options draw: a node, a mesh and an unlit material a layer, with pairs of points (mode
/// `LINES`) in the space of the mesh, rounded to 32 bits. Curves are written as their chords; the outline, which has no
/// depth, is left out. What the viewport does not show is written, too. O(points).
///
/// # Errors
/// Those of `out`; [`io::ErrorKind::InvalidInput`] beyond the 4 GiB that the format can hold.
pub fn write_gltf(
    lines: &Lines,
    options: &PlotOptions,
    container: GltfContainer,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut root = Root::default();
    for name in LayerName::all() {
        if name.is_hidden() && options.hidden == Hidden::Drop {
            continue;
        }
        let mut geometry = Geometry::default();
        lines.chains.iter().filter(|chain| LayerName::of(chain.style) == name).for_each(|chain| geometry.push(&chain));
        if let (LayerName::Lines { kind, visible }, false) = (name, geometry.indices.is_empty()) {
            let extras = json!({ "kind": kind.name(), "visible": visible });
            root.push(name, options.pens.of(kind).colour, &extras, &geometry);
        }
    }
    let Root { bytes, .. } = &root;
    let too_large = || io::Error::new(io::ErrorKind::InvalidInput, "glTF holds at most 4 GiB of lines");
    match container {
        GltfContainer::Text => {
            let uri = format!(
                "data:application/octet-stream;base64,{}",
                base64::engine::general_purpose::STANDARD.encode(bytes)
            );
            serde_json::to_writer(&mut *out, &root.document(Some(&uri)))?;
            out.write_all(b"\n")
        }
        GltfContainer::Binary => {
            let mut text = serde_json::to_vec(&root.document(None))?;
            text.resize(text.len().next_multiple_of(4), b' ');
            let chunks = if bytes.is_empty() { 20 } else { 28 };
            let total = u32::try_from(chunks + text.len() + bytes.len()).map_err(|_| too_large())?;
            out.write_all(b"glTF")?;
            for number in [2, total, text.len() as u32] {
                out.write_all(&number.to_le_bytes())?;
            }
            out.write_all(b"JSON")?;
            out.write_all(&text)?;
            if !bytes.is_empty() {
                out.write_all(&(bytes.len() as u32).to_le_bytes())?;
                out.write_all(b"BIN\0")?;
                out.write_all(bytes)?;
            }
            Ok(())
        }
    }
}

/// The document's arrays, and the bytes they speak of.
#[derive(Default)]
struct Root {
    bytes: Vec<u8>,
    nodes: Vec<Value>,
    meshes: Vec<Value>,
    materials: Vec<Value>,
    accessors: Vec<Value>,
    views: Vec<Value>,
}

impl Root {
    fn push(&mut self, name: LayerName, colour: Colour, extras: &Value, geometry: &Geometry) {
        let bounds = geometry
            .positions
            .iter()
            .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(min, max), &p| (min.min(p), max.max(p)));
        let positions = geometry.positions.iter().flat_map(Vec3::to_array).flat_map(f32::to_le_bytes);
        let positions = self.push_view(positions, ARRAY_BUFFER);
        let indices =
            self.push_view(geometry.indices.iter().flat_map(|index| index.to_le_bytes()), ELEMENT_ARRAY_BUFFER);
        let accessor = self.accessors.len();
        self.accessors.push(json!({
            "bufferView": positions, "componentType": FLOAT, "type": "VEC3", "count": geometry.positions.len(),
            "min": bounds.0, "max": bounds.1,
        }));
        self.accessors.push(json!({
            "bufferView": indices, "componentType": UNSIGNED_INT, "type": "SCALAR", "count": geometry.indices.len(),
        }));
        let layer = self.meshes.len();
        let name = name.to_string();
        let [red, green, blue] = colour.0.map(linear);
        self.materials.push(json!({
            "name": name, "extensions": { "KHR_materials_unlit": {} },
            "pbrMetallicRoughness": { "baseColorFactor": [red, green, blue, 1.0] },
        }));
        self.meshes.push(json!({
            "name": name,
            "primitives": [{ "attributes": { "POSITION": accessor }, "indices": accessor + 1, "mode": LINES, "material": layer }],
        }));
        self.nodes.push(json!({ "name": name, "mesh": layer, "extras": extras }));
    }

    fn push_view(&mut self, bytes: impl Iterator<Item = u8>, target: u32) -> usize {
        let offset = self.bytes.len();
        self.bytes.extend(bytes);
        let length = self.bytes.len() - offset;
        self.views.push(json!({ "buffer": 0, "byteOffset": offset, "byteLength": length, "target": target }));
        self.views.len() - 1
    }

    /// The document. The format allows no empty array, so that without lines there is no scene.
    fn document(&self, uri: Option<&str>) -> Value {
        let mut document = json!({ "asset": { "version": "2.0", "generator": "silhouettes" } });
        if self.nodes.is_empty() {
            return document;
        }
        let mut buffer = json!({ "byteLength": self.bytes.len() });
        if let Some(uri) = uri {
            buffer["uri"] = uri.into();
        }
        document["scene"] = 0.into();
        document["scenes"] = json!([{ "nodes": (0..self.nodes.len()).collect::<Vec<_>>() }]);
        document["extensionsUsed"] = json!(["KHR_materials_unlit"]);
        document["buffers"] = json!([buffer]);
        for (key, values) in [
            ("nodes", &self.nodes),
            ("meshes", &self.meshes),
            ("materials", &self.materials),
            ("accessors", &self.accessors),
            ("bufferViews", &self.views),
        ] {
            document[key] = values.as_slice().into();
        }
        document
    }
}

/// A component of sRGB as linear light, as glTF wants its factors.
fn linear(component: u8) -> f32 {
    let share = f32::from(component) / 255.0;
    if share <= 0.040_45 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
}

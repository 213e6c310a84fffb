//! Lines as glTF 2.0: geometry in the space of the mesh, for any viewer that shows the mesh.

use super::layer::LayerName;
use super::options::PlotOptions;
use super::pen::Colour;
use crate::chains::Chain;
use crate::lines::Lines;
use base64::Engine;
use serde_json::{Value, json};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::save::{GltfArrays, write_container};
use std::io::{self, Write};

/// How the file is packed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GltfContainer {
    /// Text, `.gltf`, with the geometry inside as base64.
    Text,
    /// Binary, `.glb`.
    Binary,
}

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
/// `LINES`) in the space of the mesh, rounded to 32 bits; nodes are moved to the mesh's origin. Curves are written as their chords; the outline, which has no
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
    let mut root = Root { origin: lines.origin, ..Root::default() };
    for name in LayerName::all() {
        let Some(pen) = name.pen(options) else { continue };
        let mut geometry = Geometry::default();
        lines.chains.iter().filter(|chain| LayerName::of(chain.style) == name).for_each(|chain| geometry.push(&chain));
        if let (LayerName::Lines { kind, visible }, false) = (name, geometry.indices.is_empty()) {
            let extras = json!({ "kind": kind.name(), "visible": visible });
            root.push(name, pen.colour, &extras, &geometry);
        }
    }
    match container {
        GltfContainer::Text => {
            let uri = format!(
                "data:application/octet-stream;base64,{}",
                base64::engine::general_purpose::STANDARD.encode(root.arrays.buffer())
            );
            serde_json::to_writer(&mut *out, &root.document(Some(&uri)))?;
            out.write_all(b"\n")
        }
        GltfContainer::Binary => write_container(&root.document(None), root.arrays.buffer(), out),
    }
}

/// The parts of the document.
#[derive(Default)]
struct Root {
    /// From where positions count.
    origin: DVec3,
    arrays: GltfArrays,
    nodes: Vec<Value>,
    meshes: Vec<Value>,
    materials: Vec<Value>,
}

impl Root {
    fn push(&mut self, name: LayerName, colour: Colour, extras: &Value, geometry: &Geometry) {
        let positions = self.arrays.positions(&geometry.positions);
        let indices = self.arrays.indices(&geometry.indices);
        let layer = self.meshes.len();
        let name = name.to_string();
        let [red, green, blue] = colour.0.map(linear);
        self.materials.push(json!({
            "name": name, "extensions": { "KHR_materials_unlit": {} },
            "pbrMetallicRoughness": { "baseColorFactor": [red, green, blue, 1.0] },
        }));
        self.meshes.push(json!({
            "name": name,
            "primitives": [{ "attributes": { "POSITION": positions }, "indices": indices, "mode": LINES, "material": layer }],
        }));
        let mut node = json!({ "name": name, "mesh": layer, "extras": extras });
        if self.origin != DVec3::ZERO {
            node["translation"] = json!(self.origin);
        }
        self.nodes.push(node);
    }

    /// The document. The format allows no empty array, so that without lines there is no scene.
    fn document(&self, uri: Option<&str>) -> Value {
        let mut document = json!({ "asset": { "version": "2.0", "generator": "silhouettes" } });
        if self.nodes.is_empty() {
            return document;
        }
        document["scene"] = 0.into();
        document["scenes"] = json!([{ "nodes": (0..self.nodes.len()).collect::<Vec<_>>() }]);
        document["extensionsUsed"] = json!(["KHR_materials_unlit"]);
        self.arrays.describe(uri, &mut document);
        for (key, values) in [("nodes", &self.nodes), ("meshes", &self.meshes), ("materials", &self.materials)] {
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

//! The arrays of a glTF document: bytes, the views into them and the accessors that say what they mean.

use glam::Vec3;
use serde_json::{Value, json};

/// `componentType` of signed 16-bit integers.
const SHORT: u32 = 5122;
/// `componentType` of bytes.
const UNSIGNED_BYTE: u32 = 5121;
/// `componentType` of 32-bit indices.
const UNSIGNED_INT: u32 = 5125;
/// `componentType` of 32-bit floats.
const FLOAT: u32 = 5126;
/// `target` of vertices.
const ARRAY_BUFFER: u32 = 34962;
/// `target` of indices.
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// Arrays that a glTF document refers to, in one buffer. Each method appends one and yields the index of its accessor.
///
/// The format allows no accessor without elements: append none that is empty.
#[derive(Debug, Default)]
pub struct GltfArrays {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl GltfArrays {
    /// Appends positions, 12 bytes each, with their bounds. O(n).
    pub fn positions(&mut self, positions: &[Vec3]) -> usize {
        let bounds =
            positions.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(min, max), &p| (min.min(p), max.max(p)));
        let bytes = positions.iter().flat_map(Vec3::to_array).flat_map(f32::to_le_bytes);
        let view = self.view(bytes, json!({ "target": ARRAY_BUFFER }));
        self.accessor(view, "VEC3", FLOAT, positions.len(), json!({ "min": bounds.0, "max": bounds.1 }))
    }

    /// Appends indices, 4 bytes each. O(n).
    pub fn indices(&mut self, indices: &[u32]) -> usize {
        let bytes = indices.iter().flat_map(|index| index.to_le_bytes());
        let view = self.view(bytes, json!({ "target": ELEMENT_ARRAY_BUFFER }));
        self.accessor(view, "SCALAR", UNSIGNED_INT, indices.len(), json!({}))
    }

    /// Appends bytes. O(n).
    pub fn bytes(&mut self, bytes: &[u8]) -> usize {
        let view = self.view(bytes.iter().copied(), json!({}));
        self.accessor(view, "SCALAR", UNSIGNED_BYTE, bytes.len(), json!({}))
    }

    /// Appends vectors whose components from -32767 to 32767 stand for -1 to 1, 8 bytes each, of which two are unused: vertex
    /// data begins at multiples of four bytes. O(n).
    pub fn normals(&mut self, normals: &[[i16; 3]]) -> usize {
        let bytes = normals.iter().flat_map(|&[x, y, z]| [x, y, z, 0]).flat_map(i16::to_le_bytes);
        let view = self.view(bytes, json!({ "byteStride": 8, "target": ARRAY_BUFFER }));
        self.accessor(view, "VEC3", SHORT, normals.len(), json!({ "normalized": true }))
    }

    /// The bytes of the buffer.
    pub fn buffer(&self) -> &[u8] {
        &self.bytes
    }

    /// Puts `buffers`, `bufferViews` and `accessors` into a document; the buffer is at `uri`, or in the container of a GLB
    /// file.
    pub fn describe(&self, uri: Option<&str>, document: &mut Value) {
        let mut buffer = json!({ "byteLength": self.bytes.len() });
        if let Some(uri) = uri {
            buffer["uri"] = uri.into();
        }
        document["buffers"] = json!([buffer]);
        document["bufferViews"] = self.views.as_slice().into();
        document["accessors"] = self.accessors.as_slice().into();
    }

    /// Appends a view that begins at a multiple of four bytes; `members` beside those that say where it is.
    fn view(&mut self, bytes: impl Iterator<Item = u8>, mut members: Value) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let offset = self.bytes.len();
        self.bytes.extend(bytes);
        members["buffer"] = 0.into();
        members["byteOffset"] = offset.into();
        members["byteLength"] = (self.bytes.len() - offset).into();
        self.views.push(members);
        self.views.len() - 1
    }

    fn accessor(&mut self, view: usize, shape: &str, component: u32, count: usize, mut members: Value) -> usize {
        members["bufferView"] = view.into();
        members["type"] = shape.into();
        members["componentType"] = component.into();
        members["count"] = count.into();
        self.accessors.push(members);
        self.accessors.len() - 1
    }
}

//! What glTF 2.0 and the extension `EXT_mesh_primitive_edge_visibility` demand of a file, restated as checks that share no code
//! with the writer.
//!
//! Of the container: its header and chunks, their lengths, alignment and padding. Of the arrays: views within the buffer,
//! accessors within their views and aligned, strides that are multiples of four, bounds of positions, indices within the
//! vertices. Of the extension:
//!
//! - `extensionsUsed` lists it and `extensionsRequired` does not;
//! - its object has no members but `visibility`, `silhouetteNormals`, `material` and `lineStrings`, of which `visibility` or
//!   `lineStrings` must be there; the first two are indices of accessors;
//! - `visibility` is a `SCALAR` accessor of unsigned bytes, as many as 6 bits a triangle take, rounded up, spare bits 0;
//! - at least one code is not 0;
//! - an edge is coded once as 1 and elsewhere as 0, or once as 2 and elsewhere as 3, or as 0 everywhere;
//! - `silhouetteNormals` is there exactly where a code is 1: a `VEC3` accessor of signed integers or floats with two unit
//!   vectors for each code of 1, in the order of the codes, the normals of the edge's two triangles.

use serde_json::Value;
use std::collections::BTreeMap;

const NAME: &str = "EXT_mesh_primitive_edge_visibility";

/// A file taken apart.
pub struct File {
    pub document: Value,
    pub binary: Vec<u8>,
}

fn check(holds: bool, fact: &str) -> Result<(), String> {
    if holds { Ok(()) } else { Err(fact.to_owned()) }
}

fn word(bytes: &[u8], at: usize) -> Result<usize, String> {
    let word = bytes.get(at..at + 4).ok_or("the file ends within a word")?;
    Ok(u32::from_le_bytes(word.try_into().unwrap()) as usize)
}

impl File {
    /// Takes the container apart.
    pub fn of(bytes: &[u8]) -> Result<Self, String> {
        check(bytes.starts_with(b"glTF") && word(bytes, 4)? == 2, "it begins with its name and version 2")?;
        check(word(bytes, 8)? == bytes.len(), "its length is that of the file")?;
        let json = word(bytes, 12)?;
        check(bytes.get(16..20) == Some(b"JSON") && json.is_multiple_of(4), "an aligned JSON chunk comes first")?;
        let text = bytes.get(20..20 + json).ok_or("the JSON chunk is cut short")?;
        let document = serde_json::from_slice(text).map_err(|error| error.to_string())?;
        let rest = &bytes[20 + json..];
        if rest.is_empty() {
            return Ok(Self { document, binary: Vec::new() });
        }
        check(rest.get(4..8) == Some(b"BIN\0"), "a binary chunk follows")?;
        check(word(rest, 0)? == rest.len() - 8 && rest.len().is_multiple_of(4), "it is aligned and ends the file")?;
        Ok(Self { document, binary: rest[8..].to_vec() })
    }

    /// The elements of an accessor, each as its bytes, and the accessor.
    fn elements(&self, accessor: &Value) -> Result<(Vec<&[u8]>, &Value), String> {
        let number = |value: &Value| value.as_u64().map(|number| number as usize);
        let index = number(accessor).ok_or("an accessor's index is a number")?;
        let accessor = self.document["accessors"].get(index).ok_or("an accessor's index is within its array")?;
        let view = number(&accessor["bufferView"]).and_then(|view| self.document["bufferViews"].get(view));
        let view = view.ok_or("a view's index is within its array")?;
        let component = match accessor["componentType"].as_u64() {
            Some(5120 | 5121) => 1,
            Some(5122 | 5123) => 2,
            Some(5125 | 5126) => 4,
            _ => return Err("a component type is one of glTF's".into()),
        };
        let size = component * if accessor["type"] == "VEC3" { 3 } else { 1 };
        let of = |value: &Value, name: &str| number(&value[name]).unwrap_or(0);
        let (start, length) = (of(view, "byteOffset"), of(view, "byteLength"));
        let buffer = of(&self.document["buffers"][of(view, "buffer")], "byteLength");
        check((buffer..buffer + 4).contains(&self.binary.len()), "the buffer fills its chunk up to padding")?;
        check(length > 0 && start + length <= buffer, "a view lies within its buffer")?;
        let stride = number(&view["byteStride"]);
        check(
            stride.is_none_or(|stride| stride.is_multiple_of(4) && stride >= size),
            "a stride is a multiple of four bytes",
        )?;
        let (stride, offset, count) = (stride.unwrap_or(size), of(accessor, "byteOffset"), of(accessor, "count"));
        check((start + offset).is_multiple_of(component), "an accessor is aligned to its components")?;
        check(count > 0, "an accessor has elements")?;
        check(offset + stride * (count - 1) + size <= length, "an accessor lies within its view")?;
        let at = |i: usize| &self.binary[start + offset + stride * i..][..size];
        Ok(((0..count).map(at).collect(), accessor))
    }

    pub fn primitive(&self) -> &Value {
        &self.document["meshes"][0]["primitives"][0]
    }

    pub fn extension(&self) -> &Value {
        &self.primitive()["extensions"][NAME]
    }

    pub fn positions(&self) -> Result<Vec<[f32; 3]>, String> {
        let (elements, accessor) = self.elements(&self.primitive()["attributes"]["POSITION"])?;
        check(accessor["type"] == "VEC3" && accessor["componentType"] == 5126, "positions are vectors of floats")?;
        let float = |bytes: &[u8]| f32::from_le_bytes(bytes.try_into().unwrap());
        let positions: Vec<[f32; 3]> =
            elements.iter().map(|bytes| [0, 4, 8].map(|at| float(&bytes[at..at + 4]))).collect();
        for axis in 0..3 {
            let along = positions.iter().map(|position| position[axis]);
            let bounds = [along.clone().fold(f32::INFINITY, f32::min), along.fold(f32::NEG_INFINITY, f32::max)];
            // Bounds are of the positions' own type.
            let stated = ["min", "max"].map(|name| accessor[name][axis].as_f64().map(|bound| bound as f32));
            check(stated == bounds.map(Some), "positions have their bounds")?;
        }
        Ok(positions)
    }

    pub fn triangles(&self) -> Result<Vec<[u32; 3]>, String> {
        let (elements, accessor) = self.elements(&self.primitive()["indices"])?;
        check(accessor["type"] == "SCALAR" && accessor["componentType"] == 5125, "indices are unsigned")?;
        check(self.primitive()["mode"] == 4 && elements.len().is_multiple_of(3), "they are of triangles")?;
        let indices: Vec<u32> = elements.iter().map(|&bytes| u32::from_le_bytes(bytes.try_into().unwrap())).collect();
        Ok(indices.as_chunks::<3>().0.to_vec())
    }

    /// The code of each side of each triangle, with all that the extension demands of them; none without the extension.
    pub fn codes(&self) -> Result<Option<Vec<u8>>, String> {
        let lists = |list: &str| self.document[list].as_array().is_some_and(|names| names.iter().any(|n| n == NAME));
        check(!lists("extensionsRequired"), "a viewer may do without the extension")?;
        let extension = self.extension();
        check(extension.is_null() != lists("extensionsUsed"), "the extension is listed where it is used")?;
        let Some(members) = extension.as_object() else { return Ok(None) };
        let known = ["visibility", "silhouetteNormals", "material", "lineStrings"];
        check(members.keys().all(|name| known.contains(&name.as_str())), "it has no other members")?;
        check(members.contains_key("visibility"), "it has visibility, having no lineStrings")?;

        // The codes.
        let (elements, accessor) = self.elements(&extension["visibility"])?;
        check(accessor["type"] == "SCALAR" && accessor["componentType"] == 5121, "visibility is of unsigned bytes")?;
        let (triangles, positions) = (self.triangles()?, self.positions()?);
        let sides = 3 * triangles.len();
        check(elements.len() == (2 * sides).div_ceil(8), "visibility has six bits a triangle")?;
        let mut codes: Vec<u8> = elements.iter().flat_map(|byte| (0..4).map(|at| byte[0] >> (2 * at) & 3)).collect();
        check(codes[sides..].iter().all(|&code| code == 0), "spare bits are 0")?;
        codes.truncate(sides);
        check(codes.iter().any(|&code| code != 0), "some code is not 0")?;

        // Each edge.
        let mut edges: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
        for side in 0..sides {
            let triangle = triangles[side / 3];
            check(triangle.iter().all(|&vertex| (vertex as usize) < positions.len()), "indices are of vertices")?;
            let (a, b) = (triangle[side % 3], triangle[(side + 1) % 3]);
            edges.entry([a.min(b), a.max(b)]).or_default().push(side);
        }
        for sides in edges.values() {
            let mut found: Vec<u8> = sides.iter().map(|&side| codes[side]).collect();
            found.sort_unstable();
            let (last, rest) = found.split_last().unwrap();
            let once = rest.iter().all(|&code| code == 0) && *last < 2;
            let repeated = found[0] == 2 && found[1..].iter().all(|&code| code == 3);
            check(once || repeated, "an edge is coded once and repeated as its kind demands")?;
        }

        // The normals of silhouettes.
        let silhouettes: Vec<usize> = (0..sides).filter(|&side| codes[side] == 1).collect();
        check(extension["silhouetteNormals"].is_null() == silhouettes.is_empty(), "silhouettes have normals")?;
        if !silhouettes.is_empty() {
            let stored = self.silhouette_normals()?;
            check(stored.len() == 2 * silhouettes.len(), "a silhouette has two normals")?;
            for (rank, &side) in silhouettes.iter().enumerate() {
                let triangle = triangles[side / 3];
                let (a, b) = (triangle[side % 3], triangle[(side + 1) % 3]);
                let [one, other] = edges[&[a.min(b), a.max(b)]][..] else {
                    return Err("a silhouette has two triangles".into());
                };
                let across = if one == side { other } else { one };
                for (normal, of) in [(stored[2 * rank], side / 3), (stored[2 * rank + 1], across / 3)] {
                    let expected = normal_of(triangles[of].map(|vertex| positions[vertex as usize]));
                    let near = (0..3).all(|axis| (normal[axis] - expected[axis]).abs() < 1e-4);
                    check(near, "a silhouette's normals are those of its triangles")?;
                }
            }
        }
        Ok(Some(codes))
    }

    /// The normals of silhouettes, two for each.
    pub fn silhouette_normals(&self) -> Result<Vec<[f64; 3]>, String> {
        let accessor = &self.extension()["silhouetteNormals"];
        if accessor.is_null() {
            return Ok(Vec::new());
        }
        let (elements, accessor) = self.elements(accessor)?;
        let is_short = accessor["componentType"] == 5122 && accessor["normalized"] == true;
        check(accessor["type"] == "VEC3" && is_short, "normals are vectors of normalized integers")?;
        let component = |bytes: &[u8]| f64::from(i16::from_le_bytes(bytes.try_into().unwrap())) / 32767.0;
        Ok(elements.iter().map(|bytes| [0, 2, 4].map(|at| component(&bytes[at..at + 2]))).collect())
    }
}

/// The unit normal of a triangle.
fn normal_of(corners: [[f32; 3]; 3]) -> [f64; 3] {
    let [a, b, c] = corners.map(|corner| corner.map(f64::from));
    let minus = |p: [f64; 3], q: [f64; 3]| [0, 1, 2].map(|i| p[i] - q[i]);
    let (u, v) = (minus(b, a), minus(c, a));
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    // Tiny triangles have squares that are no numbers any more.
    let largest = cross.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let scaled = cross.map(|x| x / largest);
    let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    scaled.map(|x| x / length)
}

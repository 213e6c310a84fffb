//! The edges that the extension `EXT_mesh_primitive_edge_visibility` declares hard, with what it says checked against the
//! primitive that it belongs to.

use super::accessor::{bytes, check_normals, indices, most_elements, restart};
use super::buffers::Buffers;
use super::document::parsed;
use crate::edge_visibility::{EdgeCode, NAME, packed_len, unpack};
use crate::load::error::{Located, Problem};
use crate::progress::Progress;
use ::gltf::json::accessor::Accessor;
use ::gltf::json::mesh::Mode;
use ::gltf::json::{Index, Root};
use serde::Deserialize;

/// The extension's objects of a document, by mesh and primitive. The document's schema passes extensions over.
#[derive(Debug, Default, Deserialize)]
pub(super) struct EdgeExtensions {
    #[serde(default)]
    meshes: Vec<MeshExtensions>,
}

#[derive(Debug, Deserialize)]
struct MeshExtensions {
    primitives: Vec<PrimitiveExtensions>,
}

#[derive(Debug, Deserialize)]
struct PrimitiveExtensions {
    extensions: Option<Extensions>,
}

#[derive(Debug, Deserialize)]
struct Extensions {
    #[serde(rename = "EXT_mesh_primitive_edge_visibility")]
    edges: Option<Box<PrimitiveEdges>>,
}

/// What the extension says of one primitive. Of its members, `material` says how edges look, and is passed over.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct PrimitiveEdges {
    visibility: Option<Index<Accessor>>,
    silhouette_normals: Option<Index<Accessor>>,
    #[serde(default)]
    line_strings: Vec<LineStrings>,
}

#[derive(Debug, Deserialize)]
struct LineStrings {
    indices: Index<Accessor>,
}

impl EdgeExtensions {
    /// Reads the document anew for the extension, if it says that it uses it.
    pub(super) fn of(json: &[u8], root: &Root, progress: &dyn Progress) -> Result<Self, Located> {
        if !root.extensions_used.iter().any(|name| name == NAME) {
            return Ok(Self::default());
        }
        parsed(json, "the members of EXT_mesh_primitive_edge_visibility", progress)
    }

    /// The extension of a primitive, if it has one.
    pub(super) fn of_primitive(&self, mesh: usize, primitive: usize) -> Option<&PrimitiveEdges> {
        self.meshes.get(mesh)?.primitives.get(primitive)?.extensions.as_ref()?.edges.as_deref()
    }
}

/// The corners of a primitive, and what they mean.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corners<'a> {
    pub(super) mode: Mode,
    /// As vertices of the mesh.
    pub(super) vertices: &'a [u32],
    /// The primitive's first vertex, and how many it has.
    pub(super) first: u32,
    pub(super) count: u64,
}

impl PrimitiveEdges {
    /// How many elements its accessors have, or can have.
    pub(super) fn most_elements(&self, root: &Root, buffers: &mut Buffers<'_>) -> Result<u64, Problem> {
        let lines = self.line_strings.iter().map(|line_strings| line_strings.indices);
        let accessors = self.visibility.into_iter().chain(self.silhouette_normals).chain(lines);
        let mut counts = accessors.map(|accessor| most_elements(root, buffers, accessor));
        counts.try_fold(0_u64, |sum, count| Ok(sum.saturating_add(count?)))
    }

    /// Appends the edges that are hard, in the order of the file, some of them several times; where line strings leave the
    /// mesh's edges, other pairs of vertices, too.
    ///
    /// That silhouettes are silhouettes is not checked: which edges can be is a matter of the mesh.
    pub(super) fn hard_edges(
        &self,
        root: &Root,
        buffers: &mut Buffers<'_>,
        corners: Corners<'_>,
        edges: &mut Vec<[u32; 2]>,
    ) -> Result<(), Problem> {
        if self.visibility.is_none() && self.line_strings.is_empty() {
            return Err(Problem::expected("visibility or lineStrings in EXT_mesh_primitive_edge_visibility", b""));
        }
        let mut silhouettes = 0;
        if let Some(visibility) = self.visibility {
            silhouettes = by_visibility(&bytes(root, buffers, visibility)?, corners, edges)?;
        }
        if let Some(normals) = self.silhouette_normals {
            let count = check_normals(root, buffers, normals)?;
            if count != 2 * silhouettes {
                let found = format!("{count} for {silhouettes} silhouettes");
                return Err(Problem::Expected { expected: "two silhouetteNormals for each silhouette", found });
            }
        }
        for line_strings in &self.line_strings {
            let restart = restart(root, line_strings.indices)?;
            let indices = indices(root, buffers, line_strings.indices)?;
            for line in indices.split(|&index| index == restart) {
                if let Some(index) = line.iter().find(|&&index| u64::from(index) >= corners.count) {
                    let found = format!("index {index} of {} vertices", corners.count);
                    return Err(Problem::Expected { expected: "lineStrings along the primitive's vertices", found });
                }
                edges.extend(line.windows(2).map(|pair| [corners.first + pair[0], corners.first + pair[1]]));
            }
        }
        Ok(())
    }
}

/// Appends the sides whose code is hard; yields the number of silhouettes.
fn by_visibility(visibility: &[u8], corners: Corners<'_>, edges: &mut Vec<[u32; 2]>) -> Result<u64, Problem> {
    let triangles = triangle_count(corners) as u64;
    if visibility.len() as u64 != packed_len(triangles) {
        let found = format!("{} bytes for {triangles} triangles", visibility.len());
        return Err(Problem::Expected { expected: "visibility of two bits for each side of each triangle", found });
    }
    let mut silhouettes = 0;
    for (side, code) in unpack(visibility).take(3 * triangles as usize).enumerate() {
        match code {
            EdgeCode::Hidden => {}
            EdgeCode::Silhouette => silhouettes += 1,
            EdgeCode::Hard | EdgeCode::RepeatedHard => {
                let triangle = triangle(corners, side / 3);
                edges.push([triangle[side % 3], triangle[(side + 1) % 3]]);
            }
        }
    }
    Ok(silhouettes)
}

fn triangle_count(corners: Corners<'_>) -> usize {
    match corners.mode {
        Mode::Triangles => corners.vertices.len() / 3,
        _ => corners.vertices.len().saturating_sub(2),
    }
}

/// A triangle of the primitive, its corners in the order of section 3.7.2.1 of glTF 2.0, on which codes depend: strips turn
/// every second triangle round its first corner, fans begin at the rim.
fn triangle(corners: Corners<'_>, index: usize) -> [u32; 3] {
    let at = |offset: usize| corners.vertices[index + offset];
    match corners.mode {
        Mode::TriangleStrip if index % 2 == 1 => [at(0), at(2), at(1)],
        Mode::TriangleStrip => [at(0), at(1), at(2)],
        Mode::TriangleFan => [at(1), at(2), corners.vertices[0]],
        _ => [0, 1, 2].map(|slot| corners.vertices[3 * index + slot]),
    }
}

//! glTF 2.0, as text or in a GLB container: the triangles of the default scene, in world space.
//!
//! The scene's nodes are visited depth first, parents before children, in the order of the document; each visit of a
//! mesh appends its primitives one after another, and so does each instance of `EXT_mesh_gpu_instancing`. A node's matrices are
//! applied in 64-bit arithmetic and rounded once; a mirroring transform turns its triangles round, so that they still face
//! outward. Points and lines are passed over. Edges that the extension `EXT_mesh_primitive_edge_visibility` declares hard are
//! feature edges. Morph targets count with the weights of the node, or else of the mesh; skins are in the pose that the
//! document's nodes have, without animation. A document that requires an [unknown extension](extensions) is refused.
//!
//! The `gltf` crate reads the container and the document's schema. Offsets and counts are followed by our own code,
//! which checks each of them: see `docs/decisions/0002-own-readers.md`.

mod accessor;
mod buffers;
mod dangling;
mod deform;
mod document;
mod edges;
mod extensions;
mod nodes;

use self::accessor::{indices, most_elements};
use self::buffers::Buffers;
use self::dangling::dangling;
use self::deform::{Deformed, deform};
use self::document::parsed;
use self::edges::{Corners, EdgeExtensions, PrimitiveEdges};
use self::nodes::{Placed, Placements, Transform, at_element, missing};
use super::Beside;
use super::assembly::{Assembly, LabelledMesh, vertex_id};
use super::error::{Located, Problem, quote};
use super::placing::Placing;
use super::polygon::{fan, strip};
use crate::mesh::MAX_VERTICES;
use crate::progress::Progress;
use ::gltf::json::accessor::Accessor;
use ::gltf::json::mesh::{Mode, Primitive, Semantic};
use ::gltf::json::validation::Checked;
use ::gltf::json::{Index, Root};
use glam::Vec3;

/// Bytes of a mesh that a byte of input may unfold into, beyond [`ALWAYS`]: a corner of a strip is 2 bytes or more and becomes a
/// triangle of 12.
const UNFOLDING: u64 = 16;

/// Bytes that any document may unfold into: nodes may place the same mesh, and primitives read the same accessor, any number of
/// times, so that a small document can describe more than any memory holds. A forest of 1000 trees of 10,000 faces each passes; what
/// repeats more is better kept apart.
const ALWAYS: u64 = 256 << 20;

/// Bytes that placing a skinned vertex takes beside its own: the mean of the matrices of its joints, joints and weights.
const SKINNED: u64 = 168;

/// Bytes that placing a primitive counts for whatever it holds, points and lines too: no memory, but time.
const VISITED: u64 = 8;

/// The bytes of a mesh that this many bytes of input may unfold into.
fn limit(input: u64) -> u64 {
    input.saturating_mul(UNFOLDING).saturating_add(ALWAYS)
}

/// Reads a glTF or GLB file, with its external buffers. O(bytes + triangles).
pub(super) fn read(
    bytes: &[u8],
    beside: Beside<'_>,
    placing: Placing,
    progress: &dyn Progress,
) -> Result<LabelledMesh, Located> {
    let (json, blob) = buffers::split(bytes)?;
    let root: Root = parsed(json, "a glTF 2.0 document", progress)?;
    extensions::check(&root.extensions_required)?;
    let edges = EdgeExtensions::of(json, &root, progress)?;
    let (mut buffers, mut assembly) = (Buffers::new(blob, beside), Assembly::new(placing));
    let most = limit(bytes.len() as u64) / size_of::<Placed>() as u64;
    let placed = Placements::of(json, progress)?.of_scene(&root, &mut buffers, &mut assembly.parts, most)?;
    progress.stage("assembling meshes", placed.len() as u64);
    let mut scene = SceneReader { root: &root, edges: &edges, buffers, assembly, faces: 0 };
    scene.check_unfolding(&placed, bytes.len() as u64)?;
    for placed in &placed {
        progress.check()?;
        scene.assembly.begin_part(placed.part);
        scene.each_surface(placed, |scene, surface| scene.surface(&surface, placed))?;
        progress.advance(1);
    }
    scene.assembly.finish()
}

/// A primitive that consists of triangles.
struct Surface<'a> {
    mode: Mode,
    primitive: &'a Primitive,
    positions: Index<Accessor>,
    indices: Option<Index<Accessor>>,
    /// One more than its material's index, 0 without a material.
    label: u32,
    edges: Option<&'a PrimitiveEdges>,
    /// Of the morph targets.
    weights: &'a [f32],
}

impl<'a> Surface<'a> {
    /// `None` for points, lines, and primitives whose positions are left to an extension.
    fn of(
        root: &Root,
        primitive: &'a Primitive,
        edges: Option<&'a PrimitiveEdges>,
        weights: &'a [f32],
    ) -> Result<Option<Self>, Problem> {
        let Checked::Valid(mode) = primitive.mode else {
            return Err(Problem::expected("a mode from 0 to 6", b"another number"));
        };
        let positions = primitive.attributes.get(&Checked::Valid(Semantic::Positions)).copied();
        let positions = positions.filter(|_| matches!(mode, Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan));
        let label = match primitive.material {
            None => 0,
            Some(material) if material.value() < root.materials.len() => material.value() as u32 + 1,
            Some(_) => return Err(dangling("materials", root.materials.len())),
        };
        let indices = primitive.indices;
        Ok(positions.map(|positions| Self { mode, primitive, positions, indices, label, edges, weights }))
    }
}

/// The mesh under construction, and where its numbers come from.
struct SceneReader<'a> {
    root: &'a Root,
    edges: &'a EdgeExtensions,
    buffers: Buffers<'a>,
    assembly: Assembly,
    /// Faces read so far.
    faces: u64,
}

impl<'a> SceneReader<'a> {
    /// Refuses a scene that grows out of proportion to its bytes, before memory is taken for it. The number of its
    /// vertices then fits 32 bits.
    fn check_unfolding(&mut self, placed: &[Placed], input: u64) -> Result<(), Located> {
        let mut size_of = vec![None; self.root.meshes.len()];
        let mut sum = Unfolded::default();
        for placed in placed {
            let size = match size_of.get(placed.mesh.value()).copied().flatten() {
                Some(size) => size,
                None => {
                    let mut size = Unfolded::default();
                    self.each_surface(placed, |scene, surface| {
                        size.add(scene.unfolded(&surface)?);
                        Ok(())
                    })?;
                    let primitives = self.root.get(placed.mesh).map_or(0, |mesh| mesh.primitives.len());
                    size.bytes = size.bytes.saturating_add(VISITED * primitives as u64);
                    if let Some(known) = size_of.get_mut(placed.mesh.value()) {
                        *known = Some(size);
                    }
                    size
                }
            };
            sum.add(size);
            if let Transform::Skinned(_) = placed.transform {
                sum.bytes = sum.bytes.saturating_add(size.vertices.saturating_mul(SKINNED));
            }
        }
        let limit = limit(input + self.buffers.external_bytes());
        for (what, count, limit) in
            [("bytes of mesh", sum.bytes, limit), ("vertices", sum.vertices, MAX_VERTICES as u64)]
        {
            if count > limit {
                return Err(Problem::TooLarge { what, count, limit }.into());
            }
        }
        Ok(())
    }

    /// The most that one primitive becomes, whatever its weights are.
    fn unfolded(&mut self, surface: &Surface<'_>) -> Result<Unfolded, Problem> {
        const POSITION: u64 = 12;
        const TRIANGLE: u64 = 12;
        let (root, buffers) = (self.root, &mut self.buffers);
        let vertices = most_elements(root, buffers, surface.positions)?;
        let corners = surface.indices.map_or(Ok(vertices), |indices| most_elements(root, buffers, indices))?;
        let triangles = if surface.mode == Mode::Triangles { corners / 3 } else { corners };
        let mut bytes = vertices.saturating_mul(POSITION).saturating_add(triangles.saturating_mul(TRIANGLE));
        if let Some(edges) = surface.edges {
            bytes =
                bytes.saturating_add(edges.most_elements(root, buffers)?.saturating_mul(size_of::<[u32; 2]>() as u64));
        }
        // No memory of the mesh, but time.
        let targets = surface.primitive.targets.as_deref().unwrap_or_default();
        for target in targets.iter().filter_map(|target| target.positions) {
            bytes = bytes.saturating_add(most_elements(root, buffers, target)?);
        }
        Ok(Unfolded { bytes, vertices })
    }

    /// Visits the primitives of a mesh that have triangles; a problem is put at the primitive.
    fn each_surface(
        &mut self,
        placed: &Placed,
        mut visit: impl FnMut(&mut Self, Surface<'a>) -> Result<(), Problem>,
    ) -> Result<(), Located> {
        let (root, edges, index) = (self.root, self.edges, placed.mesh);
        let element = format!("meshes[{}]", index.value());
        let mesh = root.get(index).ok_or_else(|| missing(&element, "meshes", root.meshes.len()))?;
        let of_node = placed.node.and_then(|node| root.nodes[node].weights.as_deref());
        let weights = of_node.or(mesh.weights.as_deref()).unwrap_or_default();
        for (rank, primitive) in mesh.primitives.iter().enumerate() {
            let edges = edges.of_primitive(index.value(), rank);
            let surface = Surface::of(root, primitive, edges, weights);
            let visited = surface.and_then(|surface| surface.map_or(Ok(()), |surface| visit(self, surface)));
            visited.map_err(|problem| at_element(format!("{element}.primitives[{rank}]"), problem))?;
        }
        Ok(())
    }

    /// Appends one primitive.
    fn surface(&mut self, surface: &Surface<'_>, placed: &Placed) -> Result<(), Problem> {
        // Append the positions.
        let (root, first) = (self.root, self.assembly.positions.len());
        let Deformed { positions, is_mirrored } =
            deform(root, &mut self.buffers, surface.primitive, surface.weights, &placed.transform)?;
        let vertices = positions.len() as u64;
        for position in positions {
            let placed = Vec3::from([0, 1, 2].map(|axis| self.assembly.placing.place(axis, position[axis])));
            if !placed.is_finite() {
                let value = quote(format!("{} {} {}", position.x, position.y, position.z).as_bytes());
                return Err(Problem::NotFinite { vertex: self.assembly.positions.len() as u64, value });
            }
            self.assembly.positions.push(placed);
        }

        // Append the triangles.
        let corners = match surface.indices {
            Some(index) => indices(root, &mut self.buffers, index)?,
            None => (0..u32::try_from(vertices).unwrap_or(u32::MAX)).collect(),
        };
        let base = u32::try_from(first).unwrap_or(u32::MAX);
        let corners = self.rebase(&corners, base, vertices)?;
        if let Some(edges) = surface.edges {
            let corners = Corners { mode: surface.mode, vertices: &corners, first: base, count: vertices };
            edges.hard_edges(root, &mut self.buffers, corners, &mut self.assembly.feature_edges)?;
        }
        let from = self.assembly.triangles.len();
        self.assembly.begin_label(surface.label);
        match surface.mode {
            Mode::TriangleStrip => strip(&corners, &mut self.assembly.triangles),
            Mode::TriangleFan => fan(&corners, &mut self.assembly.triangles),
            _ => {
                let (triangles, rest) = corners.as_chunks::<3>();
                if !rest.is_empty() {
                    let found = format!("{} corners", corners.len());
                    return Err(Problem::Expected { expected: "three corners for each triangle", found });
                }
                self.assembly.triangles.extend_from_slice(triangles);
            }
        }
        if is_mirrored {
            self.assembly.triangles[from..].iter_mut().for_each(|triangle| triangle.swap(1, 2));
        }
        self.faces += (self.assembly.triangles.len() - from) as u64;
        Ok(())
    }

    /// Turns indices into the primitive's positions into vertex ids.
    fn rebase(&self, corners: &[u32], base: u32, vertices: u64) -> Result<Vec<u32>, Problem> {
        let ids = corners.iter().enumerate().map(|(rank, &corner)| {
            let id = vertex_id(i64::from(corner), self.faces + rank as u64 / 3, vertices)?;
            // `check_unfolding` keeps the number of vertices within 32 bits.
            Ok(base + id)
        });
        ids.collect()
    }
}

/// What a part of a scene becomes.
#[derive(Debug, Clone, Copy, Default)]
struct Unfolded {
    /// Of positions, triangles and hard edges.
    bytes: u64,
    vertices: u64,
}

impl Unfolded {
    fn add(&mut self, other: Self) {
        self.bytes = self.bytes.saturating_add(other.bytes);
        self.vertices = self.vertices.saturating_add(other.vertices);
    }
}

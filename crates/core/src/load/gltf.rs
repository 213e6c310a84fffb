//! glTF 2.0, as text or in a GLB container: the triangles of the default scene, in world space.
//!
//! The scene's nodes are visited depth first, parents before children, in the order of the document; each visit of a
//! mesh appends its primitives one after another. A node's matrices are applied in 64-bit arithmetic and rounded once;
//! a mirroring transform turns its triangles round, so that they still face outward. Points and lines are passed over.
//! Edges that the extension `EXT_mesh_primitive_edge_visibility` declares hard are feature edges.
//! Skins and morph targets are not applied: the rest positions count, and the node of a skinned mesh is not placed by
//! its own transform, as the standard has it.
//!
//! The `gltf` crate reads the container and the document's schema. Offsets and counts are followed by our own code,
//! which checks each of them: see `docs/decisions/0002-own-readers.md`.

mod accessor;
mod buffers;
mod dangling;
mod edges;

use self::accessor::{indices, most_elements, positions};
use self::buffers::Buffers;
use self::dangling::dangling;
use self::edges::{Corners, EdgeExtensions, PrimitiveEdges};
use super::assembly::{Assembly, LabelledMesh, vertex_id};
use super::error::{Located, Place, Problem, quote};
use super::placing::Placing;
use super::polygon::{fan, strip};
use crate::progress::Progress;
use ::gltf::json::accessor::Accessor;
use ::gltf::json::mesh::{Mode, Primitive, Semantic};
use ::gltf::json::scene::Node;
use ::gltf::json::validation::Checked;
use ::gltf::json::{Index, Mesh, Root};
use glam::{DMat4, DQuat, DVec3, Vec3};
use std::path::Path;

/// Extensions that store triangles in a way that is not read.
const COMPRESSIONS: [&str; 3] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"];

/// Vertices and face corners, taken together, that a byte of input may unfold into.
///
/// Nodes may place the same mesh, and primitives read the same accessor, any number of times, so that a small document
/// can describe more than any memory holds. A forest of 1000 trees passes; what repeats more is better kept apart.
const UNFOLDING: u64 = 1024;

/// Reads a glTF or GLB file. External buffers are looked up in `folder`; without one they are refused. O(bytes +
/// triangles).
pub(super) fn read(
    bytes: &[u8],
    folder: Option<&Path>,
    placing: Placing,
    progress: &dyn Progress,
) -> Result<LabelledMesh, Located> {
    let (json, blob) = buffers::split(bytes)?;
    let root: Root = ::gltf::json::deserialize::from_slice(json).map_err(|error| {
        let found = error.to_string();
        Problem::Expected { expected: "a glTF 2.0 document", found }.at_line(error.line() as u64)
    })?;
    if let Some(name) = root.extensions_required.iter().find(|name| COMPRESSIONS.contains(&name.as_str())) {
        let what = format!("the extension {name}");
        return Err(Problem::Unsupported { what, mend: "export without mesh compression" }.into());
    }
    let edges = EdgeExtensions::of(json, &root)?;
    let placed = place_meshes(&root)?;
    progress.stage("assembling meshes", placed.len() as u64);
    let (buffers, assembly) = (Buffers::new(blob, folder), Assembly::new(placing));
    let mut scene = SceneReader { root: &root, edges: &edges, buffers, assembly, faces: 0 };
    scene.check_unfolding(&placed, bytes.len() as u64)?;
    for (mesh, world) in placed {
        progress.check()?;
        scene.each_surface(mesh, |scene, surface| scene.surface(&surface, world))?;
        progress.advance(1);
    }
    scene.assembly.finish()
}

/// The meshes that the scene places, each with its matrix, in the order of traversal.
fn place_meshes(root: &Root) -> Result<Vec<(Index<Mesh>, DMat4)>, Located> {
    let scene = root.scene.map_or_else(|| root.scenes.first(), |index| root.scenes.get(index.value()));
    let roots: Vec<usize> = match scene {
        Some(scene) => scene.nodes.iter().map(Index::value).collect(),
        None if root.scene.is_some() => return Err(missing("scene", "scenes", root.scenes.len())),
        None if root.nodes.is_empty() => {
            return Ok((0..root.meshes.len()).map(|mesh| (Index::new(mesh as u32), DMat4::IDENTITY)).collect());
        }
        None => roots_of(root),
    };
    let mut placed = Vec::new();
    let mut visited = vec![false; root.nodes.len()];
    let mut pending: Vec<(usize, DMat4)> = roots.iter().rev().map(|&node| (node, DMat4::IDENTITY)).collect();
    while let Some((index, parent)) = pending.pop() {
        let element = || format!("nodes[{index}]");
        let node = root.nodes.get(index).ok_or_else(|| missing(&element(), "nodes", root.nodes.len()))?;
        if std::mem::replace(&mut visited[index], true) {
            let problem =
                Problem::Expected { expected: "a tree of nodes", found: "a node that is reached twice".into() };
            return Err(at_element(element(), problem));
        }
        let world = parent * local_matrix(node);
        if let Some(mesh) = node.mesh {
            placed.push((mesh, if node.skin.is_some() { DMat4::IDENTITY } else { world }));
        }
        let children = node.children.as_deref().unwrap_or_default();
        pending.extend(children.iter().rev().map(|child| (child.value(), world)));
    }
    Ok(placed)
}

/// The nodes that are nobody's children, for a document without scenes.
fn roots_of(root: &Root) -> Vec<usize> {
    let mut is_child = vec![false; root.nodes.len()];
    for child in root.nodes.iter().flat_map(|node| node.children.as_deref().unwrap_or_default()) {
        if let Some(flag) = is_child.get_mut(child.value()) {
            *flag = true;
        }
    }
    (0..root.nodes.len()).filter(|&node| !is_child[node]).collect()
}

fn local_matrix(node: &Node) -> DMat4 {
    if let Some(matrix) = node.matrix {
        return DMat4::from_cols_array(&matrix.map(f64::from));
    }
    let vector = |v: Option<[f32; 3]>, default| v.map_or(default, |v| DVec3::from_array(v.map(f64::from)));
    let rotation = DQuat::from_array(node.rotation.unwrap_or_default().0.map(f64::from));
    // A rotation is stored to 32 bits, so it is of unit length only up to its rounding.
    let rotation = if rotation.length_squared() > 0.0 { rotation.normalize() } else { DQuat::IDENTITY };
    let (scale, translation) = (vector(node.scale, DVec3::ONE), vector(node.translation, DVec3::ZERO));
    DMat4::from_scale_rotation_translation(scale, rotation, translation)
}

/// A primitive that consists of triangles.
struct Surface<'a> {
    mode: Mode,
    positions: Index<Accessor>,
    indices: Option<Index<Accessor>>,
    /// One more than its material's index, 0 without a material.
    label: u32,
    edges: Option<&'a PrimitiveEdges>,
}

impl<'a> Surface<'a> {
    /// `None` for points, lines, and primitives whose positions are left to an extension.
    fn of(root: &Root, primitive: &Primitive, edges: Option<&'a PrimitiveEdges>) -> Result<Option<Self>, Problem> {
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
        Ok(positions.map(|positions| Self { mode, positions, indices: primitive.indices, label, edges }))
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
    fn check_unfolding(&mut self, placed: &[(Index<Mesh>, DMat4)], input: u64) -> Result<(), Located> {
        let mut size_of = vec![None; self.root.meshes.len()];
        let mut count = 0_u64;
        for &(index, _) in placed {
            let size = match size_of.get(index.value()).copied().flatten() {
                Some(size) => size,
                None => {
                    let mut size = 0_u64;
                    self.each_surface(index, |scene, surface| {
                        size += most_elements(scene.root, &mut scene.buffers, surface.positions)?;
                        if let Some(indices) = surface.indices {
                            size += most_elements(scene.root, &mut scene.buffers, indices)?;
                        }
                        if let Some(edges) = surface.edges {
                            size += edges.most_elements(scene.root, &mut scene.buffers)?;
                        }
                        Ok(())
                    })?;
                    size_of[index.value()] = Some(size);
                    size
                }
            };
            count = count.saturating_add(size);
        }
        let limit = (input + self.buffers.external_bytes()).saturating_mul(UNFOLDING).min(u64::from(u32::MAX));
        if count > limit {
            return Err(Problem::TooLarge { what: "vertices and corners", count, limit }.into());
        }
        Ok(())
    }

    /// Visits the primitives of a mesh that have triangles; a problem is put at the primitive.
    fn each_surface(
        &mut self,
        index: Index<Mesh>,
        mut visit: impl FnMut(&mut Self, Surface<'a>) -> Result<(), Problem>,
    ) -> Result<(), Located> {
        let (root, edges) = (self.root, self.edges);
        let element = format!("meshes[{}]", index.value());
        let mesh = root.get(index).ok_or_else(|| missing(&element, "meshes", root.meshes.len()))?;
        for (rank, primitive) in mesh.primitives.iter().enumerate() {
            let edges = edges.of_primitive(index.value(), rank);
            let visited =
                Surface::of(root, primitive, edges).and_then(|surface| surface.map_or(Ok(()), |s| visit(self, s)));
            visited.map_err(|problem| at_element(format!("{element}.primitives[{rank}]"), problem))?;
        }
        Ok(())
    }

    /// Appends one primitive.
    fn surface(&mut self, surface: &Surface<'_>, world: DMat4) -> Result<(), Problem> {
        // Append the positions.
        let (root, first) = (self.root, self.assembly.positions.len());
        let local = positions(root, &mut self.buffers, surface.positions)?;
        let vertices = local.len() as u64;
        for position in local {
            let placed = place(world, position, &mut self.assembly.placing);
            if !placed.is_finite() {
                let value = quote(format!("{} {} {}", position[0], position[1], position[2]).as_bytes());
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
        if world.determinant() < 0.0 {
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

/// The position in world space, rounded once; bit for bit the same where nothing moves it.
fn place(world: DMat4, position: [f32; 3], placing: &mut Placing) -> Vec3 {
    let local = Vec3::from_array(position).as_dvec3();
    let coordinates = if world == DMat4::IDENTITY { local } else { world.transform_point3(local) };
    Vec3::from([0, 1, 2].map(|axis| placing.place(axis, coordinates[axis])))
}

fn at_element(element: String, problem: Problem) -> Located {
    Located { place: Some(Place::Element(element)), problem }
}

/// An index that leads out of its array.
fn missing(element: &str, array: &'static str, count: usize) -> Located {
    at_element(element.to_owned(), dangling(array, count))
}

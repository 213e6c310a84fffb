//! Where a scene places its meshes: the transforms of nodes in 64 bits, instances, and the joints of skins.
//!
//! The `gltf` crate's schema rounds transforms to 32 bits and passes extensions over, so nodes are read anew here.

use super::accessor::{count, floats};
use super::buffers::Buffers;
use super::dangling::dangling;
use super::document::parsed;
use crate::load::error::{Located, Place, Problem};
use crate::load::parts::{NO_PART, Part};
use crate::progress::Progress;
use ::gltf::json::accessor::Accessor;
use ::gltf::json::scene::Node;
use ::gltf::json::{Index, Mesh, Root, Skin};
use glam::{DMat4, DQuat, DVec3};
use serde::Deserialize;
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::Arc;

/// The members of nodes that are read in another way than the crate does.
#[derive(Debug, Default, Deserialize)]
pub(super) struct Placements {
    #[serde(default)]
    nodes: Vec<NodeTransform>,
}

#[derive(Debug, Default, Deserialize)]
struct NodeTransform {
    matrix: Option<[f64; 16]>,
    translation: Option<[f64; 3]>,
    rotation: Option<[f64; 4]>,
    scale: Option<[f64; 3]>,
    #[serde(default)]
    extensions: NodeExtensions,
}

#[derive(Debug, Default, Deserialize)]
struct NodeExtensions {
    #[serde(rename = "EXT_mesh_gpu_instancing")]
    instancing: Option<Instancing>,
}

/// `EXT_mesh_gpu_instancing`: the node's mesh is placed once for each element of its accessors.
#[derive(Debug, Deserialize)]
struct Instancing {
    attributes: InstanceAttributes,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
struct InstanceAttributes {
    translation: Option<Index<Accessor>>,
    rotation: Option<Index<Accessor>>,
    scale: Option<Index<Accessor>>,
}

/// A mesh in the scene.
#[derive(Debug, Clone)]
pub(super) struct Placed {
    pub(super) mesh: Index<Mesh>,
    pub(super) transform: Transform,
    /// The node that places it, for its weights of morph targets.
    pub(super) node: Option<usize>,
    /// Which part it is.
    pub(super) part: u32,
}

/// How a mesh comes to its place.
#[derive(Debug, Clone)]
pub(super) enum Transform {
    /// All of it by one matrix.
    Rigid(DMat4),
    /// Each vertex by the matrices of its joints, those of the skin in the pose of the document.
    Skinned(Rc<[DMat4]>),
}

impl Placements {
    pub(super) fn of(json: &[u8], progress: &dyn Progress) -> Result<Self, Located> {
        parsed(json, "transforms and instances of nodes", progress)
    }

    /// The meshes that the scene places, in the order of traversal, at most `limit` of them. Each node that is visited becomes one of
    /// the `parts`.
    pub(super) fn of_scene(
        &self,
        root: &Root,
        buffers: &mut Buffers<'_>,
        parts: &mut Vec<Part>,
        limit: u64,
    ) -> Result<Vec<Placed>, Located> {
        let scene = root.scene.map_or_else(|| root.scenes.first(), |index| root.scenes.get(index.value()));
        let roots: Vec<usize> = match scene {
            Some(scene) => scene.nodes.iter().map(Index::value).collect(),
            None if root.scene.is_some() => return Err(missing("scene", "scenes", root.scenes.len())),
            None if root.nodes.is_empty() => {
                parts.extend(root.meshes.iter().map(|mesh| Part { names: name(mesh.name.as_ref()), parent: None }));
                let transform = || Transform::Rigid(DMat4::IDENTITY);
                let placed = |mesh| Placed { mesh: Index::new(mesh), transform: transform(), node: None, part: mesh };
                return Ok((0..root.meshes.len() as u32).map(placed).collect());
            }
            None => roots_of(root),
        };
        let mut worlds = vec![None; root.nodes.len()];
        let visited = self.visit(root, &roots, &mut worlds)?;
        let part_of = parts_of(root, &visited, parts);
        // Joints need not be in the scene.
        if root.nodes.iter().any(|node| node.skin.is_some()) {
            let others: Vec<usize> = roots_of(root).into_iter().filter(|&node| worlds[node].is_none()).collect();
            self.visit(root, &others, &mut worlds)?;
        }
        let mut skins = HashMap::new();
        let mut matrices = 0;
        let mut placed = Vec::new();
        for index in visited {
            let (node, world) = (&root.nodes[index], worlds[index].unwrap_or_default());
            let Some(mesh) = node.mesh else { continue };
            let mut put = |transform| {
                placed.push(Placed { mesh, transform, node: Some(index), part: part_of[index].unwrap_or(NO_PART) });
            };
            let element = |problem| at_element(format!("nodes[{index}]"), problem);
            match node.skin {
                Some(skin) => {
                    let joints = match skins.get(&skin.value()) {
                        Some(joints) => Rc::clone(joints),
                        None => {
                            matrices += matrices_of(root, skin).map_err(element)?;
                            if matrices > limit {
                                let what = "matrices of joints";
                                return Err(Problem::TooLarge { what, count: matrices, limit }.into());
                            }
                            joints(root, buffers, skin, &worlds).map_err(element)?.into()
                        }
                    };
                    skins.insert(skin.value(), Rc::clone(&joints));
                    put(Transform::Skinned(joints));
                }
                None => {
                    let instances = self.instances(root, buffers, index, limit).map_err(element)?;
                    instances.into_iter().for_each(|instance| put(Transform::Rigid(world * instance)));
                }
            }
            if placed.len() as u64 > limit {
                return Err(Problem::TooLarge { what: "placed meshes", count: placed.len() as u64, limit }.into());
            }
        }
        Ok(placed)
    }

    /// The nodes below `roots`, parents before children, with their matrices put among those of all nodes.
    fn visit(&self, root: &Root, roots: &[usize], worlds: &mut [Option<DMat4>]) -> Result<Vec<usize>, Located> {
        let mut visited = Vec::new();
        let mut pending: Vec<(usize, DMat4)> = roots.iter().rev().map(|&node| (node, DMat4::IDENTITY)).collect();
        while let Some((index, parent)) = pending.pop() {
            let element = || format!("nodes[{index}]");
            let node = root.nodes.get(index).ok_or_else(|| missing(&element(), "nodes", root.nodes.len()))?;
            let world = parent * self.local_matrix(index);
            if worlds[index].replace(world).is_some() {
                let problem =
                    Problem::Expected { expected: "a tree of nodes", found: "a node that is reached twice".into() };
                return Err(at_element(element(), problem));
            }
            visited.push(index);
            let children = node.children.as_deref().unwrap_or_default();
            pending.extend(children.iter().rev().map(|child| (child.value(), world)));
        }
        Ok(visited)
    }

    /// Where the instances of a node's mesh are in the node's space: one that stays where it is without the extension.
    fn instances(
        &self,
        root: &Root,
        buffers: &mut Buffers<'_>,
        index: usize,
        limit: u64,
    ) -> Result<Vec<DMat4>, Problem> {
        let instancing = self.nodes.get(index).and_then(|node| node.extensions.instancing.as_ref());
        let Some(InstanceAttributes { translation, rotation, scale }) = instancing.map(|found| &found.attributes)
        else {
            return Ok(vec![DMat4::IDENTITY]);
        };
        let given = [translation, rotation, scale].into_iter().flatten();
        let counts: Vec<u64> = given.map(|&accessor| count(root, accessor)).collect::<Result<_, _>>()?;
        let Some(&instances) = counts.first() else { return Ok(vec![DMat4::IDENTITY]) };
        if counts.iter().any(|&other| other != instances) {
            return Err(Problem::Expected {
                expected: "as many translations, rotations and scales of instances",
                found: format!("{counts:?}"),
            });
        }
        if instances > limit {
            return Err(Problem::TooLarge { what: "placed meshes", count: instances, limit });
        }
        let same = |value: [f32; 3]| vec![value; instances as usize];
        let mut vectors = |accessor: &Option<Index<Accessor>>, default| {
            let expected = "translations and scales of type VEC3";
            accessor.map_or_else(|| Ok(same(default)), |accessor| floats(root, buffers, accessor, expected))
        };
        let (translations, scales) = (vectors(translation, [0.0; 3])?, vectors(scale, [1.0; 3])?);
        let rotations = match *rotation {
            Some(accessor) => floats(root, buffers, accessor, "rotations of type VEC4")?,
            None => vec![[0.0, 0.0, 0.0, 1.0]; instances as usize],
        };
        let vector = |vector: [f32; 3]| DVec3::from_array(vector.map(f64::from));
        let instance = |((scale, rotation), translation): (([f32; 3], [f32; 4]), _)| {
            let rotation = unit(DQuat::from_array(rotation.map(f64::from)));
            DMat4::from_scale_rotation_translation(vector(scale), rotation, vector(translation))
        };
        Ok(scales.into_iter().zip(rotations).zip(translations).map(instance).collect())
    }

    fn local_matrix(&self, index: usize) -> DMat4 {
        let Some(node) = self.nodes.get(index) else { return DMat4::IDENTITY };
        if let Some(matrix) = &node.matrix {
            return DMat4::from_cols_array(matrix);
        }
        let vector = |v: Option<[f64; 3]>, default| v.map_or(default, DVec3::from_array);
        let rotation = unit(node.rotation.map_or(DQuat::IDENTITY, DQuat::from_array));
        let (scale, translation) = (vector(node.scale, DVec3::ONE), vector(node.translation, DVec3::ZERO));
        DMat4::from_scale_rotation_translation(scale, rotation, translation)
    }
}

/// A rotation is stored to 32 bits at best, so it is of unit length only up to its rounding.
fn unit(rotation: DQuat) -> DQuat {
    if rotation.length_squared() > 0.0 { rotation.normalize() } else { DQuat::IDENTITY }
}

/// How many matrices [`joints`] makes and reads for a skin.
fn matrices_of(root: &Root, skin: Index<Skin>) -> Result<u64, Problem> {
    let skin = root.get(skin).ok_or_else(|| dangling("skins", root.skins.len()))?;
    let inverse = skin.inverse_bind_matrices.map_or(Ok(0), |accessor| count(root, accessor))?;
    Ok(inverse.saturating_add(skin.joints.len() as u64))
}

/// For each joint of a skin the matrix that takes the mesh's own space to the world.
fn joints(
    root: &Root,
    buffers: &mut Buffers<'_>,
    skin: Index<Skin>,
    worlds: &[Option<DMat4>],
) -> Result<Vec<DMat4>, Problem> {
    let skin = root.get(skin).ok_or_else(|| dangling("skins", root.skins.len()))?;
    let inverse = match skin.inverse_bind_matrices {
        Some(accessor) => floats::<16>(root, buffers, accessor, "inverseBindMatrices of type MAT4")?,
        None => Vec::new(),
    };
    if skin.inverse_bind_matrices.is_some() && inverse.len() < skin.joints.len() {
        let found = format!("{} for {} joints", inverse.len(), skin.joints.len());
        return Err(Problem::Expected { expected: "an inverseBindMatrix for each joint", found });
    }
    let inverse = inverse.into_iter().map(|matrix| DMat4::from_cols_array(&matrix.map(f64::from)));
    let inverse = inverse.chain(std::iter::repeat(DMat4::IDENTITY));
    let world = |joint: &Index<Node>| match worlds.get(joint.value()) {
        Some(Some(world)) => Ok(*world),
        Some(None) => Err(Problem::expected("joints that are nodes of the scene", b"one that is not")),
        None => Err(dangling("nodes", root.nodes.len())),
    };
    skin.joints.iter().zip(inverse).map(|(joint, inverse)| Ok(world(joint)? * inverse)).collect()
}

/// Makes a part of each node visited, parents before children; yields the part of each node of the document.
fn parts_of(root: &Root, visited: &[usize], parts: &mut Vec<Part>) -> Vec<Option<u32>> {
    let mut part_of: Vec<Option<u32>> = vec![None; root.nodes.len()];
    let mut above: Vec<Option<u32>> = vec![None; root.nodes.len()];
    for &index in visited {
        let node = &root.nodes[index];
        let of_mesh = || node.mesh.and_then(|mesh| root.meshes.get(mesh.value())?.name.as_ref());
        let part = parts.len() as u32;
        parts.push(Part { names: name(node.name.as_ref().or_else(of_mesh)), parent: above[index] });
        part_of[index] = Some(part);
        for child in node.children.as_deref().unwrap_or_default() {
            if let Some(above) = above.get_mut(child.value()) {
                *above = Some(part);
            }
        }
    }
    part_of
}

fn name(name: Option<&String>) -> Arc<[String]> {
    name.filter(|name| !name.is_empty()).cloned().into_iter().collect()
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

pub(super) fn at_element(element: String, problem: Problem) -> Located {
    Located { place: Some(Place::Element(element)), problem }
}

/// An index that leads out of its array.
pub(super) fn missing(element: &str, array: &'static str, count: usize) -> Located {
    at_element(element.to_owned(), dangling(array, count))
}

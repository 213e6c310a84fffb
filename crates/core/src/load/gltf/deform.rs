//! Where the vertices of a primitive are in the world: moved by morph targets, then by the joints of a skin or by one matrix.

use super::accessor::{floats, positions};
use super::buffers::Buffers;
use super::nodes::Transform;
use crate::load::error::Problem;
use ::gltf::json::Root;
use ::gltf::json::mesh::{Primitive, Semantic};
use ::gltf::json::validation::Checked;
use glam::{DMat4, DVec3, Vec3};

/// Vertices in the world.
pub(super) struct Deformed {
    pub(super) positions: Vec<DVec3>,
    /// Whether the surface is mirrored, so that its triangles must be turned round to face outward.
    pub(super) is_mirrored: bool,
}

/// The morph targets of a primitive whose weights are not 0.
fn active_targets<'a>(
    primitive: &'a Primitive,
    weights: &'a [f32],
) -> impl Iterator<Item = (f64, ::gltf::json::Index<::gltf::json::Accessor>)> + 'a {
    let targets = primitive.targets.as_deref().unwrap_or_default().iter().zip(weights);
    targets.filter_map(|(target, &weight)| Some((f64::from(weight), target.positions?)).filter(|_| weight != 0.0))
}

/// Places the vertices of a primitive.
pub(super) fn deform(
    root: &Root,
    buffers: &mut Buffers<'_>,
    primitive: &Primitive,
    weights: &[f32],
    transform: &Transform,
) -> Result<Deformed, Problem> {
    let Some(&base) = primitive.attributes.get(&Checked::Valid(Semantic::Positions)) else {
        return Ok(Deformed { positions: Vec::new(), is_mirrored: false });
    };
    let base = positions(root, buffers, base)?.into_iter();
    let mut local: Vec<DVec3> = base.map(|position| Vec3::from_array(position).as_dvec3()).collect();
    for (weight, target) in active_targets(primitive, weights) {
        let offsets = positions(root, buffers, target)?;
        check_count("positions of a morph target", offsets.len(), local.len())?;
        for (position, offset) in local.iter_mut().zip(offsets) {
            *position += weight * Vec3::from_array(offset).as_dvec3();
        }
    }
    match transform {
        Transform::Rigid(world) if *world == DMat4::IDENTITY => Ok(Deformed { positions: local, is_mirrored: false }),
        Transform::Rigid(world) => {
            local.iter_mut().for_each(|position| *position = world.transform_point3(*position));
            Ok(Deformed { positions: local, is_mirrored: world.determinant() < 0.0 })
        }
        Transform::Skinned(joints) => skin(root, buffers, primitive, joints, local),
    }
}

/// Moves each vertex by the weighted mean of the matrices of its joints.
fn skin(
    root: &Root,
    buffers: &mut Buffers<'_>,
    primitive: &Primitive,
    joints: &[DMat4],
    mut positions: Vec<DVec3>,
) -> Result<Deformed, Problem> {
    let mut means: Vec<(f64, DMat4)> = vec![(0.0, DMat4::ZERO); positions.len()];
    for set in 0.. {
        let attribute = |semantic| primitive.attributes.get(&Checked::Valid(semantic)).copied();
        let (Some(of_joints), Some(of_weights)) = (attribute(Semantic::Joints(set)), attribute(Semantic::Weights(set)))
        else {
            break;
        };
        let numbers = floats::<4>(root, buffers, of_joints, "joints of type VEC4")?;
        let weights = floats::<4>(root, buffers, of_weights, "weights of joints of type VEC4")?;
        check_count("joints of vertices", numbers.len(), positions.len())?;
        check_count("weights of joints", weights.len(), positions.len())?;
        for ((mean, numbers), weights) in means.iter_mut().zip(numbers).zip(weights) {
            for (number, weight) in numbers.into_iter().zip(weights) {
                if weight != 0.0 {
                    let joint = joints.get(number as usize).ok_or_else(|| {
                        let found = format!("joint {number} of {}", joints.len());
                        Problem::Expected { expected: "joints of the node's skin", found }
                    })?;
                    let weight = f64::from(weight);
                    *mean = (mean.0 + weight, mean.1 + *joint * weight);
                }
            }
        }
    }
    let mut mirrored = 0;
    for (position, (sum, mean)) in positions.iter_mut().zip(means) {
        // A vertex without joints stays where it is.
        if sum != 0.0 {
            let world = mean * (1.0 / sum);
            *position = world.transform_point3(*position);
            mirrored += usize::from(world.determinant() < 0.0);
        }
    }
    let is_mirrored = 2 * mirrored > positions.len();
    Ok(Deformed { positions, is_mirrored })
}

fn check_count(what: &str, count: usize, vertices: usize) -> Result<(), Problem> {
    if count == vertices {
        return Ok(());
    }
    let found = format!("{count} {what} for {vertices}");
    Err(Problem::Expected { expected: "as many elements as vertices", found })
}

//! [`FlatNode`]: the hierarchy of a [`RayCaster`] as arrays, to be walked on a device.

use super::RayCaster;
use silhouette_core::glam::DVec3;

/// A node of the hierarchy, in the order in which a shader reads it.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct FlatNode {
    /// Least corner of the box, in local coordinates.
    pub low: [f32; 3],
    /// Faces of a leaf, at least 1; 0 for an inner node.
    pub faces: u32,
    /// Greatest corner of the box, in local coordinates.
    pub high: [f32; 3],
    /// The first face of a leaf, in [`RayCaster::flat_corners`]; the first of two adjacent children of an inner node.
    pub first: u32,
}

impl RayCaster {
    /// All nodes, the root first. Empty for a mesh without faces. O(F).
    pub fn flat_nodes(&self) -> Vec<FlatNode> {
        let node = |node: &obvhs::bvh2::node::Bvh2Node| FlatNode {
            low: node.aabb.min.to_array(),
            faces: node.prim_count,
            high: node.aabb.max.to_array(),
            first: node.first_index,
        };
        self.bvh.nodes.iter().map(node).collect()
    }

    /// The corners of faces in local coordinates, in the order of leaves.
    pub fn flat_corners(&self) -> &[[[f32; 3]; 3]] {
        &self.corners
    }

    /// A point in local coordinates, in which the mesh spans at most -1 to 1.
    pub fn to_local(&self, point: DVec3) -> DVec3 {
        (point - self.center) * self.scale
    }

    /// Local units per unit of the mesh's space.
    pub fn local_scale(&self) -> f64 {
        self.scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_testing::{edits, zoo};

    /// Every face lies in one leaf, and in the boxes of all nodes above it.
    #[test]
    fn a_walk_from_the_root_meets_every_face_once_within_its_boxes() {
        let mesh = edits::shaken(&zoo::builtin("icosphere:3"), 0.05, 3);
        let caster = RayCaster::new(&mesh);
        let (nodes, corners) = (caster.flat_nodes(), caster.flat_corners());
        let mut met = vec![0; mesh.face_count()];
        let mut open = vec![(0, [-2.0; 3], [2.0; 3])];
        while let Some((at, low, high)) = open.pop() {
            let node = nodes[at as usize];
            assert!((0..3).all(|axis| node.low[axis] >= low[axis] && node.high[axis] <= high[axis]));
            if node.faces == 0 {
                open.extend([0, 1].map(|child| (node.first + child, node.low, node.high)));
            }
            for face in node.first..node.first + node.faces {
                met[face as usize] += 1;
                for corner in corners[face as usize] {
                    assert!((0..3).all(|axis| node.low[axis] <= corner[axis] && corner[axis] <= node.high[axis]));
                }
            }
        }
        assert!(met.iter().all(|&count| count == 1));
        let first = caster.faces[0];
        let corner = caster.to_local(mesh.corners(first)[0].as_dvec3());
        assert_eq!(corner.as_vec3().to_array().map(f32::to_bits), corners[0][0].map(f32::to_bits));
        assert!(caster.to_local(DVec3::X).distance(caster.to_local(DVec3::ZERO)) - caster.local_scale() < 1e-12);
    }
}

//! Bounding volume hierarchies of boxes, many of which may be equal.
//!
//! `obvhs` merges each box with its nearest neighbour, round by round. Where n boxes are equal, as those of a face that is
//! listed n times, each round merges a single pair: O(n²) work, and a hierarchy of depth n. The hierarchy is therefore built
//! over distinct boxes, and equal boxes share a leaf.

use obvhs::aabb::Aabb;
use obvhs::bvh2::{Bvh2, builder::build_bvh2};
use obvhs::{Boundable, BvhBuildParams};
use std::collections::HashMap;
use std::time::Duration;

/// A box as `obvhs` takes it.
#[derive(Debug, Clone, Copy)]
pub struct Boxed(
    /// The box.
    pub Aabb,
);

impl Boundable for Boxed {
    fn aabb(&self) -> Aabb {
        self.0
    }
}

/// Size of the sample that is searched for equal boxes first. Only if it has some are all boxes searched.
const SAMPLE: usize = 1024;

/// A hierarchy over boxes; `primitive_indices` are ordered by leaf. Expected O(boxes log boxes).
pub fn build(boxes: &[Boxed]) -> Bvh2 {
    if boxes.is_empty() {
        return Bvh2::default();
    }
    let sample: Vec<u32> =
        (0..SAMPLE.min(boxes.len())).map(|at| (at * boxes.len() / SAMPLE.min(boxes.len())) as u32).collect();
    if alike(boxes, &sample).len() == sample.len() { build_of(boxes) } else { build_of_groups(boxes) }
}

fn build_of(boxes: &[Boxed]) -> Bvh2 {
    let mut time = Duration::ZERO;
    build_bvh2(boxes, BvhBuildParams::fast_build(), &mut time)
}

/// Indices of boxes, grouped by equal boxes, in order of first occurrence.
fn alike(boxes: &[Boxed], indices: &[u32]) -> Vec<Vec<u32>> {
    let mut group_of: HashMap<[u32; 6], usize> = HashMap::with_capacity(indices.len());
    let mut groups: Vec<Vec<u32>> = Vec::new();
    for &index in indices {
        let Aabb { min, max } = boxes[index as usize].0;
        let group =
            *group_of.entry([min.x, min.y, min.z, max.x, max.y, max.z].map(f32::to_bits)).or_insert(groups.len());
        if group == groups.len() {
            groups.push(Vec::new());
        }
        groups[group].push(index);
    }
    groups
}

fn build_of_groups(boxes: &[Boxed]) -> Bvh2 {
    let groups = alike(boxes, &(0..boxes.len() as u32).collect::<Vec<u32>>());
    let firsts: Vec<Boxed> = groups.iter().map(|group| boxes[group[0] as usize]).collect();
    let mut bvh = build_of(&firsts);
    let of_groups = std::mem::take(&mut bvh.primitive_indices);
    for node in bvh.nodes.iter_mut().filter(|node| node.prim_count > 0) {
        let first = bvh.primitive_indices.len();
        for &group in &of_groups[node.first_index as usize..(node.first_index + node.prim_count) as usize] {
            bvh.primitive_indices.extend(&groups[group as usize]);
        }
        (node.first_index, node.prim_count) = (first as u32, (bvh.primitive_indices.len() - first) as u32);
    }
    bvh
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::Vec3A;

    #[test]
    fn equal_boxes_share_a_leaf_and_none_is_lost() {
        let boxed = |index: u32| {
            let corner = Vec3A::new((index % 7) as f32, 0.0, if index < 3000 { 0.0 } else { 1.0 + index as f32 });
            Boxed(Aabb::new(corner, corner + 1.0))
        };
        let boxes: Vec<Boxed> = (0..3100).map(boxed).collect();
        let bvh = build(&boxes);
        let mut indices = bvh.primitive_indices.clone();
        indices.sort_unstable();
        assert!(indices.into_iter().eq(0..3100));
        let mut found = Vec::new();
        bvh.aabb_traverse(Aabb::new(Vec3A::splat(0.5), Vec3A::splat(0.6)), |bvh, node| {
            let node = &bvh.nodes[node as usize];
            let places = node.first_index as usize..(node.first_index + node.prim_count) as usize;
            found.extend(places.map(|place| bvh.primitive_indices[place]));
            true
        });
        assert_eq!(found.iter().filter(|&&index| index < 3000 && index % 7 == 0).count(), 429);
        assert!(bvh.max_depth < 200, "{}", bvh.max_depth);
    }
}

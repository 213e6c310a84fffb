//! Bounding volume hierarchies of boxes, many of which may be equal.
//!
//! `obvhs` merges each box with its nearest neighbour, round by round. Where n boxes are equal, as those of a face that is
//! listed n times, each round merges a single pair: O(n²) work, and a hierarchy of depth n. The hierarchy is therefore built
//! over distinct boxes, and equal boxes share a leaf. Many boxes are divided into parts first, so that it can be stopped.

use obvhs::aabb::Aabb;
use obvhs::bvh2::{Bvh2, leaf_collapser::collapse, reinsertion::ReinsertionOptimizer};
use obvhs::ploc::PlocBuilder;
use obvhs::{Boundable, BvhBuildParams};
use silhouette_core::{Cancelled, NoProgress, Progress};
use std::collections::HashMap;

mod parts;

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
#[expect(clippy::missing_panics_doc, reason = "nobody cancels")]
pub fn build(boxes: &[Boxed]) -> Bvh2 {
    build_with_progress(boxes, &NoProgress).expect("nobody cancels")
}

/// Like [`build`], but stops between its steps when `progress` asks to.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn build_with_progress(boxes: &[Boxed], progress: &dyn Progress) -> Result<Bvh2, Cancelled> {
    progress.check()?;
    if boxes.is_empty() {
        return Ok(Bvh2::default());
    }
    let sample: Vec<u32> =
        (0..SAMPLE.min(boxes.len())).map(|at| (at * boxes.len() / SAMPLE.min(boxes.len())) as u32).collect();
    if alike(boxes, &sample).len() == sample.len() {
        build_of(boxes, progress)
    } else {
        build_of_groups(boxes, progress)
    }
}

/// `obvhs` compares areas in 32 bits. Of boxes so small or so large that those are all 0 or infinite each is as near as any other, and
/// again a round merges a single pair. Such boxes are scaled by a power of two, and those of the nodes back, which changes no bit.
fn build_of(boxes: &[Boxed], progress: &dyn Progress) -> Result<Bvh2, Cancelled> {
    let largest = boxes.iter().map(|Boxed(Aabb { min, max })| min.abs().max(max.abs()).max_element());
    let largest = largest.fold(0.0, f32::max);
    if largest == 0.0 || (SMALLEST..=1.0 / SMALLEST).contains(&largest) {
        return parts::build(boxes, parts::MOST, progress);
    }
    let exponent = f64::from(largest).log2().floor();
    let scaled = |by: f64, Aabb { min, max }: Aabb| {
        let [min, max] = [min, max].map(|corner| (corner.as_dvec3() * by).as_vec3a());
        Aabb { min, max }
    };
    let unit: Vec<Boxed> = boxes.iter().map(|&Boxed(aabb)| Boxed(scaled((-exponent).exp2(), aabb))).collect();
    let mut bvh = parts::build(&unit, parts::MOST, progress)?;
    for node in &mut bvh.nodes {
        node.set_aabb(scaled(exponent.exp2(), *node.aabb()));
    }
    Ok(bvh)
}

/// `obvhs`'s fast build, in the steps of its `build_bvh2`, between which it can be stopped.
fn build_fast(boxes: &[Boxed], progress: &dyn Progress) -> Result<Bvh2, Cancelled> {
    let fast = BvhBuildParams::fast_build();
    let mut bvh = PlocBuilder::with_capacity(boxes.len()).build(
        fast.ploc_search_distance,
        boxes,
        (0..boxes.len() as u32).collect(),
        fast.sort_precision,
        fast.search_depth_threshold,
    );
    progress.check()?;
    ReinsertionOptimizer::default().run(&mut bvh, fast.reinsertion_batch_ratio, None);
    progress.check()?;
    collapse(&mut bvh, fast.max_prims_per_leaf, fast.collapse_traversal_cost);
    progress.check()?;
    Ok(bvh)
}

/// Largest coordinate below which boxes are scaled, and above whose inverse.
const SMALLEST: f32 = 1.0 / (1 << 30) as f32;

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

fn build_of_groups(boxes: &[Boxed], progress: &dyn Progress) -> Result<Bvh2, Cancelled> {
    let groups = alike(boxes, &(0..boxes.len() as u32).collect::<Vec<u32>>());
    let firsts: Vec<Boxed> = groups.iter().map(|group| boxes[group[0] as usize]).collect();
    progress.check()?;
    let mut bvh = build_of(&firsts, progress)?;
    let of_groups = std::mem::take(&mut bvh.primitive_indices);
    for node in bvh.nodes.iter_mut().filter(|node| node.prim_count > 0) {
        let first = bvh.primitive_indices.len();
        for &group in &of_groups[node.first_index as usize..(node.first_index + node.prim_count) as usize] {
            bvh.primitive_indices.extend(&groups[group as usize]);
        }
        (node.first_index, node.prim_count) = (first as u32, (bvh.primitive_indices.len() - first) as u32);
    }
    Ok(bvh)
}

#[cfg(test)]
mod tests {
    use super::*;
    use obvhs::bvh2::builder::build_bvh2;
    use silhouette_core::glam::Vec3A;
    use std::time::Duration;

    /// Boxes from the smallest numbers that there are to almost the largest: the same tree, to the last bit, as of boxes of usual size.
    #[test]
    fn tiny_and_huge_boxes_make_the_tree_of_usual_ones() {
        let boxes = |scale: f64| -> Vec<Boxed> {
            let corner = |index: u32| Vec3A::new((index % 50) as f32, (index / 50) as f32, (index % 7) as f32);
            let boxed = |index| {
                let [min, max] = [0.0, 1.0].map(|more| ((corner(index) + more).as_dvec3() * scale).as_vec3a());
                Boxed(Aabb { min, max })
            };
            (0..2500).map(boxed).collect()
        };
        let usual = build(&boxes(1.0));
        for exponent in [-149.0_f64, -100.0, 60.0, 120.0] {
            let scaled = build(&boxes(exponent.exp2()));
            assert_eq!(scaled.primitive_indices, usual.primitive_indices, "2^{exponent}");
            for (node, other) in scaled.nodes.iter().zip(&usual.nodes) {
                let expected = [other.aabb().min, other.aabb().max].map(|c| c.as_dvec3() * exponent.exp2());
                assert_eq!([node.aabb().min.as_dvec3(), node.aabb().max.as_dvec3()], expected);
            }
        }
    }

    /// The steps are those of `obvhs` itself, to the last bit; if a new version has more, this says so.
    #[test]
    fn the_steps_are_those_of_obvhs() {
        let corner = |index: u32| Vec3A::new((index % 50) as f32, (index / 50) as f32, (index % 7) as f32);
        let boxes: Vec<Boxed> = (0..2500).map(|index| Boxed(Aabb::new(corner(index), corner(index) + 1.0))).collect();
        let mut time = Duration::ZERO;
        let whole = build_bvh2(&boxes, BvhBuildParams::fast_build(), &mut time);
        let built = build(&boxes);
        assert_eq!(built.primitive_indices, whole.primitive_indices);
        let of = |bvh: &Bvh2| -> Vec<_> {
            bvh.nodes.iter().map(|node| (node.aabb().min, node.aabb().max, node.prim_count, node.first_index)).collect()
        };
        assert_eq!(of(&built), of(&whole));
    }

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

//! An order of the patches in which every aligned run of 8, 64, 512 ... is compact in space and in normal.
//!
//! Top down: the widest of six axes (centroid and mean normal) is split at the multiple of the next lower run length that
//! is nearest to the middle. That is a balanced 8-ary tree without pointers: node i of level k covers the patches
//! `i 8^k .. (i + 1) 8^k`. O(P log P) for P patches, parallel; ties go by patch number, so the order is unique.

use super::grow::Partition;
use super::planes::Frame;
use glam::DVec3;
use rayon::prelude::*;
use silhouette_core::{FaceId, TriangleMesh, glam};

/// Children of a node.
pub(crate) const FAN_OUT: usize = 8;

/// Patches below which a split is not worth a task.
const PATCHES_PER_TASK: usize = 1024;

#[derive(Debug, Clone, Copy)]
struct Key {
    coordinates: [f32; 6],
    patch: u32,
}

/// The patches in tree order.
pub(crate) fn tree_order(mesh: &TriangleMesh, partition: &Partition, frame: &Frame) -> Vec<u32> {
    let mut keys: Vec<Key> = (0..partition.len())
        .into_par_iter()
        .map(|patch| Key { coordinates: place(mesh, partition.own_faces(patch), frame), patch: patch as u32 })
        .collect();
    let mut run = 1;
    while run < keys.len() {
        run *= FAN_OUT;
    }
    split(&mut keys, run);
    keys.into_iter().map(|key| key.patch).collect()
}

/// Where a patch is: mean of its corners, and its mean normal by area, of length up to 1.
fn place(mesh: &TriangleMesh, faces: &[u32], frame: &Frame) -> [f32; 6] {
    let (mut center, mut normal, mut area) = (DVec3::ZERO, DVec3::ZERO, 0.0);
    for &face in faces {
        let [a, b, c] = mesh.corners(FaceId::new(face)).map(|corner| frame.local(corner));
        center += (a + b + c) / (3.0 * faces.len() as f64);
        let cross = (b - a).cross(c - a);
        normal += cross;
        area += cross.length();
    }
    let normal = if area > 0.0 { normal / area } else { DVec3::ZERO };
    [center.x, center.y, center.z, normal.x, normal.y, normal.z].map(|value| value as f32)
}

/// Orders the keys of one node that covers up to `run` patches.
fn split(keys: &mut [Key], run: usize) {
    if keys.len() <= 1 {
        return;
    }
    let child = run / FAN_OUT;
    if keys.len() <= child {
        return split(keys, child);
    }
    let middle = keys.len().div_ceil(child) / 2 * child;
    let axis = widest_axis(keys);
    keys.select_nth_unstable_by(middle, |a, b| {
        a.coordinates[axis].total_cmp(&b.coordinates[axis]).then(a.patch.cmp(&b.patch))
    });
    let (low, high) = keys.split_at_mut(middle);
    if low.len() + high.len() < PATCHES_PER_TASK {
        split(low, run);
        split(high, run);
    } else {
        rayon::join(|| split(low, run), || split(high, run));
    }
}

fn widest_axis(keys: &[Key]) -> usize {
    let (mut low, mut high) = ([f32::INFINITY; 6], [f32::NEG_INFINITY; 6]);
    for key in keys {
        for axis in 0..6 {
            low[axis] = low[axis].min(key.coordinates[axis]);
            high[axis] = high[axis].max(key.coordinates[axis]);
        }
    }
    (0..6).max_by(|&a, &b| (high[a] - low[a]).total_cmp(&(high[b] - low[b]))).unwrap_or(0)
}

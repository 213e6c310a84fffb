//! [`GpuBake`]: a [`Bake`] whose angles are found on a device.
//!
//! 1. Atlas, centres, tangents and the hierarchies of object and hull are made on the CPU, as for any bake, and so are the texels'
//!    own centres, if they have any, colours and normals.
//! 2. Tiles are gathered in batches (`batch.rs`). Texels are ordered by level; one invocation searches one meridian of one
//!    texel (`shaders/texture/border_search.wgsl`), and all meridians of a level are searched before those of the next, which follow
//!    their borders (`device_search.rs`). Each dispatch is as large as fits a quarter of a second (`pace.rs`).
//! 3. The angles of a batch are read back once, when all its levels are done, and put in place as those of the CPU are.
//!
//! Departures from the CPU's bake:
//!
//! 1. Rays are cast in `f32` throughout, from points that were placed in `f64`: single rays at the very border of the object may
//!    go the other way. On one device, the result is the same to the last bit for every run.
//! 2. Where an invocation visits too many nodes and faces, or the device ends its loops early (Mesa's llvmpipe ends all loops after
//!    65 535 turns, in silence), the CPU bakes the tile: [`GpuBakeReport::cpu_tiles`].

mod batch;
mod device_search;
mod device_texel;
mod hierarchies;
mod pace;
mod settings;
#[cfg(test)]
mod tests;

use crate::SilhouetteTexture;
use crate::bake::{Bake, BakeError, BakeReport};
use crate::gpu::bake::batch::{Batch, Start};
use crate::gpu::bake::device_search::{DeviceSearch, Found};
use crate::tile::{Baked, Grazed, Source};
use rayon::prelude::*;
use silhouette_core::Progress;
use silhouette_gpu::MeshTooLarge;

/// Nodes and faces that an invocation may visit. Below the turns after which llvmpipe ends loops.
const MOST_STEPS: u32 = 40_000;

/// A bake and the device that finds its angles.
#[derive(Clone, Copy)]
pub struct GpuBake<'a> {
    device: &'a wgpu::Device,
    queue: &'a wgpu::Queue,
    bake: &'a Bake<'a>,
    most_steps: u32,
}

/// What a bake on a device came to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GpuBakeReport {
    /// As for a bake on the CPU. No tile is restored.
    pub bake: BakeReport,
    /// Tiles that the device gave up and the CPU baked. What the device did for them is counted as well.
    pub cpu_tiles: u64,
    /// Dispatches of compute stages.
    pub dispatches: u64,
}

/// Why nothing was baked on a device.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GpuBakeError {
    /// The CPU would not have baked it either.
    #[error(transparent)]
    Bake(#[from] BakeError),
    /// The device's buffers cannot hold a hierarchy.
    #[error(transparent)]
    MeshTooLarge(#[from] MeshTooLarge),
    /// The device was lost, or did not answer.
    #[error("the device failed: {0}; bake on the CPU instead")]
    Device(String),
}

impl<'a> GpuBake<'a> {
    /// Bakes what `bake` says on a device, which needs 7 storage buffers and 1 uniform buffer per stage and no optional feature.
    pub fn new(device: &'a wgpu::Device, queue: &'a wgpu::Queue, bake: &'a Bake<'a>) -> Self {
        Self { device, queue, bake, most_steps: MOST_STEPS }
    }

    /// Bakes on the device, and on the current pool of threads. Blocks until the result has been read back. The device holds both
    /// meshes (36 bytes per face and up to 64 for its nodes), 80 bytes per texel of a batch and at most 36 per sample; a batch has
    /// two million samples at most, or one tile.
    ///
    /// # Errors
    /// [`GpuBakeError`].
    pub fn run(&self, progress: &dyn Progress) -> Result<(SilhouetteTexture, GpuBakeReport), GpuBakeError> {
        self.bake.prepare(progress, |source, tiles, mut target| {
            let mut search = DeviceSearch::new(self.device, self.queue, source, self.most_steps)?;
            progress.stage("silhouette texture", target.report.samples);
            let (mut left, mut cpu_tiles) = (tiles, 0);
            while !left.is_empty() {
                progress.check().map_err(BakeError::from)?;
                let (tiles, rest) = left.split_at(Batch::tiles_of(left, source.atlas.size().azimuths));
                left = rest;
                let mut batch = Batch::new(tiles, source);
                let found = search.search(&batch, progress)?;
                target.report.rays += found.rays;
                target.report.scans += found.scans;
                let slots = batch.texels.len();
                let baked: Vec<(Start, Option<Baked>)> = std::mem::take(&mut batch.starts)
                    .into_par_iter()
                    .map(|mut start| {
                        let is_found = put_angles(&mut start, &found, slots, source);
                        let by_cpu = (!is_found).then(|| start.tile.bake(source));
                        (start, by_cpu)
                    })
                    .collect();
                for (start, by_cpu) in baked {
                    cpu_tiles += u64::from(by_cpu.is_some());
                    target.put(source.atlas, &start.tile, by_cpu.as_ref().unwrap_or(&start.baked));
                }
            }
            let (texture, bake) = target.finish()?;
            Ok((texture, GpuBakeReport { bake, cpu_tiles, dispatches: search.dispatches }))
        })
    }
}

/// Completes a tile with what was found for it. Whether all of its angles were.
fn put_angles(start: &mut Start, found: &Found, slots: usize, source: &Source<'_>) -> bool {
    let azimuths = source.atlas.size().azimuths as usize;
    let unit = source.visibility.object().local_scale().recip();
    let mut angles = Vec::with_capacity(azimuths * start.slots.len());
    let mut grazed = vec![Grazed::default(); start.slots.len()];
    for azimuth in 0..azimuths {
        for (&slot, grazed) in start.slots.iter().zip(&mut grazed) {
            let [share, distance] = found.samples[azimuth * slots + slot as usize];
            if share.is_nan() || share < 0.0 {
                return false;
            }
            angles.push(share);
            grazed.add((distance >= 0.0).then(|| (f64::from(distance) * unit) as f32));
        }
    }
    start.baked.hidden_centers = start.slots.iter().filter(|&&slot| found.middles[slot as usize] < 0.0).count() as u64;
    start.baked.angles = angles;
    start.tile.complete(source, &start.texels, &grazed, &mut start.baked);
    true
}

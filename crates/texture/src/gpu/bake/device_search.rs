//! [`DeviceSearch`]: finds the borders of batches of texels on a device. Stages: `shaders/texture/border_search.wgsl`.

use crate::bake::BakeError;
use crate::gpu::bake::GpuBakeError;
use crate::gpu::bake::batch::Batch;
use crate::gpu::bake::hierarchies::Hierarchies;
use crate::gpu::bake::pace::Pace;
use crate::gpu::bake::settings::BakeUniform;
use crate::tile::Source;
use silhouette_core::Progress;
use silhouette_gpu::kit::{
    UniformBlock, bind_group, bind_layout, compute_pipeline, storage_buffer, storage_entry, uniform_entry, workgroups,
};
use silhouette_shaders::texture::BORDER_SEARCH;
use std::sync::mpsc;
use std::time::{Duration, Instant};
use wgpu::BufferUsages;

/// Words per meridian that other texels follow.
const MERIDIAN_WORDS: u64 = 7;

/// Bytes of two counts.
const COUNT_BYTES: u64 = 8;

/// How long a dispatch may take before the device counts as hung.
const TIMEOUT: Duration = Duration::from_secs(120);

/// Pipelines, hierarchies and settings, for all batches of a bake.
pub(super) struct DeviceSearch<'a> {
    device: &'a wgpu::Device,
    queue: &'a wgpu::Queue,
    layout: wgpu::BindGroupLayout,
    find_middles: wgpu::ComputePipeline,
    find_borders: wgpu::ComputePipeline,
    hierarchies: Hierarchies,
    uniform: UniformBlock<BakeUniform>,
    settings: BakeUniform,
    pace: Pace,
    pub dispatches: u64,
}

/// What was found for a batch.
pub(super) struct Found {
    /// Azimuth by azimuth, for each slot: the angle as a share of pi, negative where it was not found; how far away the object is
    /// grazed in its local units, negative where it is not.
    pub samples: Vec<[f32; 2]>,
    /// For each slot, how far away the object is shown along the middle of the lobe; negative where it is not.
    pub middles: Vec<f32>,
    pub rays: u64,
    pub scans: u64,
}

impl<'a> DeviceSearch<'a> {
    /// Compiles the stages and uploads the hierarchies.
    pub fn new(
        device: &'a wgpu::Device,
        queue: &'a wgpu::Queue,
        source: &Source<'_>,
        most_steps: u32,
    ) -> Result<Self, GpuBakeError> {
        let (read, written) = (|binding| storage_entry(binding, true), |binding| storage_entry(binding, false));
        let entries = [uniform_entry(0), read(1), read(2), read(3), written(4), written(5), written(6), written(7)];
        let layout = bind_layout(device, "silhouette texture: bake", &entries);
        let stage = |entry| compute_pipeline(device, BORDER_SEARCH, entry, &[Some(&layout)]);
        let hierarchies = Hierarchies::new(device, queue, source.visibility)?;
        Ok(Self {
            find_middles: stage("find_middles"),
            find_borders: stage("find_borders"),
            settings: BakeUniform::new(source, &hierarchies, most_steps),
            uniform: UniformBlock::new(device, "silhouette texture: bake"),
            pace: Pace::default(),
            dispatches: 0,
            device,
            queue,
            layout,
            hierarchies,
        })
    }

    /// Searches all texels of a batch, and reads the angles back. Progress advances by samples.
    pub fn search(&mut self, batch: &Batch, progress: &dyn Progress) -> Result<Found, GpuBakeError> {
        let texels = batch.texels.len() as u32;
        let samples = u64::from(texels) * u64::from(self.settings.azimuths);
        (self.settings.batch_texels, self.settings.known_texels) = (texels, batch.known_texels());
        let known = u64::from(batch.known_texels()) * u64::from(self.settings.azimuths);
        let buffer = |label, bytes, usage| storage_buffer(self.device, label, bytes, usage);
        let none = BufferUsages::empty();
        let texel_buffer = buffer("texels", size_of_val(&batch.texels[..]) as u64, none)?;
        let middles = buffer("middles of lobes", 4 * u64::from(texels), BufferUsages::COPY_SRC)?;
        let known = buffer("borders of lobes", 4 * MERIDIAN_WORDS * known, none)?;
        let found = buffer("angles", 8 * samples, BufferUsages::COPY_SRC)?;
        let counts = buffer("counts of rays", COUNT_BYTES, BufferUsages::COPY_SRC)?;
        self.queue.write_buffer(&texel_buffer, 0, bytemuck::cast_slice(&batch.texels));
        let Hierarchies { nodes, corners, .. } = &self.hierarchies;
        let buffers = [nodes, corners, &texel_buffer, &middles, &known, &found, &counts];
        let mut resources = vec![self.uniform.binding()];
        resources.extend(buffers.map(wgpu::Buffer::as_entire_binding));
        let group = bind_group(self.device, "silhouette texture: bake", &self.layout, &resources);
        self.dispatch(&self.find_middles.clone(), &group, texels, &|_| Ok(()))?;
        for level in &batch.levels {
            let elements = level.len() as u32 * self.settings.azimuths;
            (self.settings.first_slot, self.settings.level_texels) = (level.start, level.len() as u32);
            self.dispatch(&self.find_borders.clone(), &group, elements, &|done| {
                progress.advance(done);
                Ok(progress.check().map_err(BakeError::from)?)
            })?;
        }
        let [rays, scans] = self.read::<[u32; 2]>(&counts, COUNT_BYTES)?.first().map_or([0; 2], |c| c.map(u64::from));
        let middles = self.read(&middles, 4 * u64::from(texels))?;
        Ok(Found { samples: self.read(&found, 8 * samples)?, middles, rays, scans })
    }

    /// Runs a stage for so many elements, in parts of which each is awaited and reported to `done`.
    fn dispatch(
        &mut self,
        stage: &wgpu::ComputePipeline,
        group: &wgpu::BindGroup,
        elements: u32,
        done: &dyn Fn(u64) -> Result<(), GpuBakeError>,
    ) -> Result<(), GpuBakeError> {
        let mut first = 0;
        while first < elements {
            let count = self.pace.elements().min(elements - first);
            (self.settings.first_element, self.settings.end_element) = (first, first + count);
            self.uniform.write(self.queue, &self.settings);
            let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            {
                let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
                pass.set_pipeline(stage);
                pass.set_bind_group(0, group, &[]);
                let [x, y] = workgroups(count);
                pass.dispatch_workgroups(x, y, 1);
            }
            let start = Instant::now();
            let submission = self.queue.submit([encoder.finish()]);
            self.wait(submission)?;
            self.pace.note(count, start.elapsed());
            self.dispatches += 1;
            first += count;
            done(u64::from(count))?;
        }
        Ok(())
    }

    fn wait(&self, submission: wgpu::SubmissionIndex) -> Result<(), GpuBakeError> {
        let until = wgpu::PollType::Wait { submission_index: Some(submission), timeout: Some(TIMEOUT) };
        self.device.poll(until).map(|_| ()).map_err(|error| GpuBakeError::Device(error.to_string()))
    }

    /// The first `bytes` bytes of a buffer, as elements.
    fn read<T: bytemuck::Pod>(&self, buffer: &wgpu::Buffer, bytes: u64) -> Result<Vec<T>, GpuBakeError> {
        let copy = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("silhouette texture: read back"),
            size: bytes,
            usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_buffer_to_buffer(buffer, 0, &copy, 0, bytes);
        let (sender, receiver) = mpsc::channel();
        let submission = self.queue.submit([encoder.finish()]);
        copy.map_async(wgpu::MapMode::Read, .., move |outcome| {
            // The receiver is gone only if nothing waits for the outcome any longer.
            let _ = sender.send(outcome);
        });
        self.wait(submission)?;
        let failed = |error: String| GpuBakeError::Device(error);
        let outcome = receiver.try_recv().map_err(|_| failed("a buffer was not mapped in time".to_owned()))?;
        outcome.map_err(|error| failed(error.to_string()))?;
        let view = copy.get_mapped_range(..).map_err(|error| failed(error.to_string()))?;
        Ok(view.chunks_exact(size_of::<T>()).map(bytemuck::pod_read_unaligned).collect())
    }
}

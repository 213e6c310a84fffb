//! Running sums on the GPU.

use super::scene::{pipelines, read};
use crate::gpu::prefix_sum::Levels;
use crate::gpu::settings::SmoothingUniform;
use bytemuck::Zeroable as _;
use silhouette_core::glam::DMat4;
use silhouette_gpu::kit::{buffers_group, storage_buffer};
use silhouette_gpu::{CameraBinding, CameraUniform};
use silhouette_testing::{Random, gpu_or_skip};

#[test]
fn running_sums_are_exact() {
    let Some(gpu) = gpu_or_skip("running_sums_are_exact") else { return };
    let (device, queue) = (gpu.device(), gpu.queue());
    let pipelines = pipelines(gpu);
    let mut random = Random::new(7);
    for count in [1_u32, 3, 255, 256, 257, 5000, 65_536, 65_537, 150_000] {
        let levels = Levels::new(count);
        let elements: Vec<[u32; 4]> = (0..count).map(|_| [0; 4].map(|_: u32| random.below(200) as u32)).collect();
        let usage = wgpu::BufferUsages::COPY_SRC;
        let sums = storage_buffer(device, "sums", levels.bytes(), usage).unwrap();
        queue.write_buffer(&sums, 0, bytemuck::cast_slice(&elements));
        let camera = CameraBinding::new(device, &CameraBinding::layout(device), size_of::<SmoothingUniform>());
        let settings = SmoothingUniform {
            level_1_at: levels.level_1_at,
            level_2_at: levels.level_2_at,
            total_at: levels.total_at,
            levels: levels.count,
            ..SmoothingUniform::zeroed()
        };
        camera.write(queue, &CameraUniform::new(DMat4::IDENTITY), &settings);
        let output =
            buffers_group(device, "sums", &pipelines.output_layout, &[&sums, &unused(device), &unused(device)]);
        let frame_buffers: Vec<_> = (0..5).map(|_| unused(device)).collect();
        let frame = buffers_group(device, "frame", &pipelines.frame_layout, &frame_buffers.iter().collect::<Vec<_>>());
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, camera.bind_group(), &[]);
        pass.set_bind_group(1, &pipelines.no_mesh, &[]);
        pass.set_bind_group(2, &frame, &[]);
        pass.set_bind_group(3, &output, &[]);
        pipelines.sums.dispatch(&mut pass, &levels);
        drop(pass);
        queue.submit([encoder.finish()]);
        let found: Vec<[u32; 4]> = read(gpu, &sums);
        let mut before = [0; 4];
        for (index, element) in elements.iter().enumerate() {
            let mut sum = found[index];
            let above = [(levels.level_1_at, 256), (levels.level_2_at, 65_536)];
            for (at, block) in above.into_iter().take(levels.count as usize - 1) {
                let part = found[at as usize + index / block];
                (0..4).for_each(|i| sum[i] += part[i]);
            }
            assert_eq!(sum, before, "element {index} of {count}");
            (0..4).for_each(|i| before[i] += element[i]);
        }
        assert_eq!(found[levels.total_at as usize], before, "total of {count}");
    }
}

fn unused(device: &wgpu::Device) -> wgpu::Buffer {
    storage_buffer(device, "unused", 64, wgpu::BufferUsages::COPY_SRC).unwrap()
}

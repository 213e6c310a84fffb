//! Farthest depth of front faces over squares of the image, so that stages can leave out what is hidden behind them. Stages:
//! `shaders/image_precision/front_tiles.wgsl`, `shaders/shared/image_precision/hidden.wgsl`.
//!
//! Front faces are drawn once more, depth alone, before the application's pass. What is left out lies behind that depth in
//! every pixel that it could cover, so that the picture stays the same.

use crate::front_faces;
use crate::stage::compute;
use silhouette_gpu::{CameraBinding, MeshBuffers, TargetFormats};
use silhouette_shaders::image_precision::{FRONT_TILES, FRONT_TILES_MULTISAMPLED};

/// Side of a square in pixels. The stages' `TILE_PX`.
const TILE_PX: u32 = 8;

/// Side of a workgroup in squares.
const WORKGROUP_SIDE: u32 = 8;

/// Format of the depth, whatever the application's is.
const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Depths of a view, found anew for each.
#[derive(Debug)]
pub(crate) struct FrontDepth {
    formats: TargetFormats,
    front: wgpu::RenderPipeline,
    tiling: wgpu::BindGroupLayout,
    reading: wgpu::BindGroupLayout,
    find: wgpu::ComputePipeline,
    target: Option<DepthTarget>,
}

/// Textures of one size.
#[derive(Debug)]
struct DepthTarget {
    size: [u32; 2],
    depth: wgpu::TextureView,
    tiling: wgpu::BindGroup,
    reading: wgpu::BindGroup,
}

fn texture_entry(binding: u32, ty: wgpu::BindingType) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::COMPUTE, ty, count: None }
}

/// Layout of the group that stages read the squares from.
pub(crate) fn reading_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let squares = wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable: false },
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("squares of front faces"),
        entries: &[texture_entry(0, squares)],
    })
}

impl FrontDepth {
    pub fn new(device: &wgpu::Device, formats: TargetFormats) -> Self {
        let formats = TargetFormats { depth: DEPTH, ..formats };
        let depth = wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Depth,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: formats.samples > 1,
        };
        let squares = wgpu::BindingType::StorageTexture {
            access: wgpu::StorageTextureAccess::WriteOnly,
            format: wgpu::TextureFormat::R32Float,
            view_dimension: wgpu::TextureViewDimension::D2,
        };
        let tiling = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("depth of front faces"),
            entries: &[texture_entry(0, depth), texture_entry(1, squares)],
        });
        let camera = CameraBinding::layout(device);
        let stage = if formats.samples > 1 { FRONT_TILES_MULTISAMPLED } else { FRONT_TILES };
        Self {
            front: front_faces::depth_pipeline(device, &[Some(&camera)], formats),
            find: compute(device, stage, "find_farthest", &[Some(&camera), Some(&tiling)]),
            reading: reading_layout(device),
            formats,
            tiling,
            target: None,
        }
    }

    /// Makes textures for a viewport of this size, where they are not there.
    pub fn resize(&mut self, device: &wgpu::Device, size: [u32; 2]) {
        if self.target.as_ref().is_some_and(|target| target.size == size) {
            return;
        }
        let view = |label, [width, height]: [u32; 2], sample_count, format, usage| {
            let texture = device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: usage | wgpu::TextureUsages::TEXTURE_BINDING,
                view_formats: &[],
            });
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        let (drawn, stored) = (wgpu::TextureUsages::RENDER_ATTACHMENT, wgpu::TextureUsages::STORAGE_BINDING);
        let depth = view("depth of front faces", size, self.formats.samples, DEPTH, drawn);
        let tiles = size.map(|side| side.div_ceil(TILE_PX));
        let squares = view("squares of front faces", tiles, 1, wgpu::TextureFormat::R32Float, stored);
        let group = |label, layout, views: &[&wgpu::TextureView]| {
            let entries: Vec<_> = (0..)
                .zip(views)
                .map(|(binding, view)| wgpu::BindGroupEntry {
                    binding,
                    resource: wgpu::BindingResource::TextureView(view),
                })
                .collect();
            device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some(label), layout, entries: &entries })
        };
        let tiling = group("depth of front faces", &self.tiling, &[&depth, &squares]);
        let reading = group("squares of front faces", &self.reading, &[&squares]);
        self.target = Some(DepthTarget { size, depth, tiling, reading });
    }

    /// Finds the depths of the view whose uniforms are bound, and yields the group that stages read them from; `None` before
    /// the first [`resize`](Self::resize).
    pub fn encode(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        camera: &CameraBinding,
        buffers: &MeshBuffers,
    ) -> Option<&wgpu::BindGroup> {
        let target = self.target.as_ref()?;
        let far = wgpu::LoadOp::Clear(self.formats.clear_depth());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("depth of front faces"),
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &target.depth,
                depth_ops: Some(wgpu::Operations { load: far, store: wgpu::StoreOp::Store }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        pass.set_bind_group(0, camera.bind_group(), &[]);
        pass.set_pipeline(&self.front);
        buffers.draw(&mut pass);
        drop(pass);

        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, camera.bind_group(), &[]);
        pass.set_bind_group(1, &target.tiling, &[]);
        pass.set_pipeline(&self.find);
        let [x, y] = target.size.map(|side| side.div_ceil(TILE_PX * WORKGROUP_SIDE));
        pass.dispatch_workgroups(x, y, 1);
        Some(&target.reading)
    }
}

//! [`Field`]: the textures of a field. Twin of their use: `shaders/baselines/field.wgsl`.

use super::flood::FloodStage;
use super::reach::Extent;
use silhouette_gpu::RendererError;
use silhouette_gpu::kit::{bind_group, bind_layout, storage_texture_entry, texture_entry};
use wgpu::TextureFormat;

/// Depth, object and seed of a pixel; and a pixel of the field. Formats that every device of WebGPU writes from compute stages.
const RECORDS: TextureFormat = TextureFormat::Rg32Uint;
const NEAREST: TextureFormat = TextureFormat::R32Uint;

/// Side of the squares of pixels that a workgroup of the field's stages works on, as `@workgroup_size` says.
const WORKGROUP_SIDE: u32 = 8;

/// Layouts of the bind groups of a field.
#[derive(Debug)]
pub(crate) struct FieldLayouts {
    /// Group 2 of stages that plant seeds: records at binding 0, the pixels' own seeds at binding 1.
    pub planting: wgpu::BindGroupLayout,
    /// Group 1 of stages that read the field: records at binding 0, nearest seeds at binding 1.
    pub reading: wgpu::BindGroupLayout,
    /// Group 1 of the flood.
    pub flooding: wgpu::BindGroupLayout,
}

impl FieldLayouts {
    pub fn new(device: &wgpu::Device) -> Self {
        let read = |binding| texture_entry(binding, wgpu::TextureSampleType::Uint, false);
        let written = [storage_texture_entry(0, RECORDS), storage_texture_entry(1, NEAREST)];
        let flooding = [read(0), read(1), storage_texture_entry(2, NEAREST)];
        Self {
            planting: bind_layout(device, "planting of seeds", &written),
            reading: bind_layout(device, "field of seeds", &[read(0), read(1)]),
            flooding: bind_layout(device, "flooding of seeds", &flooding),
        }
    }
}

/// The textures of a field, 16 bytes per pixel.
#[derive(Debug)]
pub(crate) struct Field {
    extent: Extent,
    planted: wgpu::BindGroup,
    /// From the first texture of nearest seeds to the second, and back.
    floods: [wgpu::BindGroup; 2],
    /// The field as it is after an even and after an odd number of floods.
    read: [wgpu::BindGroup; 2],
}

impl Field {
    /// Makes textures for a field of this extent, whose sides [`check_size`] found to be possible.
    pub fn new(device: &wgpu::Device, layouts: &FieldLayouts, extent: Extent) -> Self {
        let usage = wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::TEXTURE_BINDING;
        let texture = |label, format| texture(device, label, format, 1, extent.size_px(), usage);
        let records = texture("records of pixels", RECORDS);
        let nearest = ["nearest seeds", "nearest seeds in turn"].map(|label| texture(label, NEAREST));
        let [records, first, second] = [&records, &nearest[0], &nearest[1]].map(wgpu::BindingResource::TextureView);
        let group = |label, layout, resources: &[_]| bind_group(device, label, layout, resources);
        Self {
            extent,
            planted: group("planting of seeds", &layouts.planting, &[records.clone(), first.clone()]),
            floods: [[&first, &second], [&second, &first]].map(|[from, to]| {
                group("flooding of seeds", &layouts.flooding, &[records.clone(), from.clone(), to.clone()])
            }),
            read: [&first, &second]
                .map(|known| group("field of seeds", &layouts.reading, &[records.clone(), known.clone()])),
        }
    }

    /// The size of the field.
    pub fn size_px(&self) -> [u32; 2] {
        self.extent.size_px()
    }

    /// The same textures for a field of the same size.
    pub fn set_extent(&mut self, extent: Extent) {
        self.extent = extent;
    }

    /// What a stage that plants seeds writes, for group 2.
    pub fn planted(&self) -> &wgpu::BindGroup {
        &self.planted
    }

    /// The flooded field, for group 1.
    pub fn known(&self) -> &wgpu::BindGroup {
        &self.read[FloodStage::passes(&self.extent) as usize % 2]
    }

    /// Runs a stage over all pixels.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass<'_>) {
        let [x, y] = self.size_px().map(|side| side.div_ceil(WORKGROUP_SIDE));
        pass.dispatch_workgroups(x, y, 1);
    }

    /// Floods the seeds that were planted, with the uniforms of group 0 bound.
    pub fn flood(&self, pass: &mut wgpu::ComputePass<'_>, stage: &FloodStage) {
        stage.encode(pass, &self.extent, &self.floods, |pass| self.dispatch(pass));
    }
}

/// Whether a device has textures as large as a field of this extent.
///
/// # Errors
/// [`RendererError::TextureTooLarge`].
pub(crate) fn check_size(device: &wgpu::Device, extent: &Extent) -> Result<(), RendererError> {
    let limit = device.limits().max_texture_dimension_2d;
    let texels = extent.size_px().into_iter().fold(0, u32::max);
    if texels > limit {
        let (what, instead) = ("pixels of the view and its margin", "draw a smaller viewport, or thinner lines");
        return Err(RendererError::TextureTooLarge { what, texels, limit, instead });
    }
    Ok(())
}

/// A texture that stages share, as a view.
pub(super) fn texture(
    device: &wgpu::Device,
    label: &str,
    format: TextureFormat,
    samples: u32,
    [width, height]: [u32; 2],
    usage: wgpu::TextureUsages,
) -> wgpu::TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: samples,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

//! Lists and draws polygons that are fattened. Stages: `shaders/image_precision/polygons.wgsl`, `fatten.wgsl`.

use crate::back_edges::draw_arguments;
use crate::polygons::Polygons;
use crate::stage::{Stage, buffers_group, compute, groups, storage_buffer, storage_entry};
use silhouette_gpu::{CameraBinding, MeshBinding, MeshTooLarge, TargetFormats};
use silhouette_shaders::image_precision::{FATTEN, POLYGONS};

/// Bytes of a corner of a listed polygon. Twin of `FatCorner` in `fatten.wgsl`.
const CORNER_BYTES: u64 = 48;

/// Fattened polygons, listed anew for each view.
#[derive(Debug)]
pub(crate) struct FatPolygons {
    count: u32,
    corners: Option<wgpu::Buffer>,
    arguments: wgpu::Buffer,
    filling: wgpu::BindGroup,
    drawing: wgpu::BindGroup,
    list: wgpu::ComputePipeline,
    fat: wgpu::RenderPipeline,
}

impl FatPolygons {
    /// Triangles, or `polygons` where there are any.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        faces: u32,
        polygons: Option<&Polygons>,
        is_charcoal: bool,
        formats: TargetFormats,
    ) -> Result<Self, MeshTooLarge> {
        let upload = |label, words: &[u32]| {
            let bytes = size_of_val(words) as u64;
            let buffer = storage_buffer(device, label, bytes, wgpu::BufferUsages::empty())?;
            queue.write_buffer(&buffer, 0, bytemuck::cast_slice(words));
            Ok::<_, MeshTooLarge>(buffer)
        };
        let corners = polygons.map(|polygons| upload("corners of polygons", &polygons.corners)).transpose()?;
        let starts = upload("starts of polygons", polygons.map_or(&[0], |polygons| &polygons.starts))?;
        let count = polygons.map_or(faces, |polygons| polygons.count() as u32);
        let corner_count = polygons.map_or(3 * u64::from(faces), |polygons| polygons.corners.len() as u64);
        let bytes = CORNER_BYTES * corner_count;
        let listed = storage_buffer(device, "fattened polygons", bytes, wgpu::BufferUsages::empty())?;
        let arguments = draw_arguments(device, queue)?;

        let layout = |entries: &[_]| {
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("polygons"), entries })
        };
        let filling = layout(&[storage_entry(0, false), storage_entry(1, false), storage_entry(2, true)]);
        let drawing = layout(&[storage_entry(0, true)]);
        let (camera, mesh) = (CameraBinding::layout(device), MeshBinding::layout(device));
        let fat = Stage {
            label: "image precision: fattened polygons",
            wgsl: FATTEN,
            vertex: "fat_vertex",
            fragment: if is_charcoal { "charcoal_fragment" } else { "fat_fragment" },
            is_indexed: false,
            culled: None,
            polygon_mode: wgpu::PolygonMode::Fill,
            depth: formats.depth_state(formats.nearer_or_equal()),
        };
        Ok(Self {
            count,
            corners,
            filling: buffers_group(device, "polygons", &filling, &[&listed, &arguments, &starts]),
            drawing: buffers_group(device, "polygons", &drawing, &[&listed]),
            list: compute(device, POLYGONS, "list_polygons", &[Some(&camera), Some(&mesh), Some(&filling)]),
            fat: fat.build(device, &[Some(&camera), Some(&drawing)], formats.color, formats.samples),
            arguments,
        })
    }

    /// Corners of the polygons, where they are not the triangles.
    pub fn corners(&self) -> Option<&wgpu::Buffer> {
        self.corners.as_ref()
    }

    /// Number of polygons.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// What the stages expect as `polygon_corners`.
    pub fn polygon_corners(&self) -> u32 {
        if self.corners.is_some() { 0 } else { 3 }
    }

    /// Makes the list for the view whose uniforms are bound.
    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder, camera: &CameraBinding, mesh: &MeshBinding) {
        encoder.clear_buffer(&self.arguments, 0, Some(4));
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, camera.bind_group(), &[]);
        pass.set_bind_group(1, mesh.bind_group(), &[]);
        pass.set_bind_group(2, &self.filling, &[]);
        pass.set_pipeline(&self.list);
        let [x, y] = groups(self.count);
        pass.dispatch_workgroups(x, y, 1);
    }

    /// Draws the list.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.fat);
        pass.set_bind_group(1, &self.drawing, &[]);
        pass.draw_indirect(&self.arguments, 0);
    }
}

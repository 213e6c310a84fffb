//! [`FatPolygons`]: the polygons of a view that are fattened, listed on the device and drawn. Lists:
//! `shaders/image_precision/fattened.wgsl`.

use crate::cut_triangles::CutTriangles;
use crate::fans::{Fans, Noted};
use crate::polygons::Polygons;
use crate::settings::Settings;
use silhouette_gpu::kit::{bind_layout, buffers_group, storage_buffer, storage_entry};
use silhouette_gpu::{CameraBinding, MeshBinding, MeshTooLarge, TargetFormats};

/// Initial arguments of the two draws, the first indexed, and two counts: one instance of no vertices each, no places taken, no
/// polygons left for fans.
const NOTHING_DRAWN: [u32; 11] = [0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0];

/// Where the arguments of the draw of cut triangles begin, in bytes.
const CUT_ARGUMENTS: u64 = 20;

/// The stages, shared by all renderers.
#[derive(Debug, Clone)]
pub(crate) struct FatStages {
    layout: wgpu::BindGroupLayout,
    noted: Noted,
    cut: CutTriangles,
    fans: Fans,
}

impl FatStages {
    pub fn new(device: &wgpu::Device, settings: &Settings, formats: TargetFormats) -> Self {
        let entries = [0, 1, 2, 3, 4, 5].map(|binding| storage_entry(binding, binding == 1));
        let layout = bind_layout(device, "lists of polygons", &entries);
        let (camera, mesh) = (CameraBinding::layout(device), MeshBinding::layout(device));
        let bindings = [Some(&camera), Some(&mesh), Some(&layout)];
        Self {
            noted: Noted::of(settings),
            cut: CutTriangles::new(device, &bindings, settings, formats),
            fans: Fans::new(device, &bindings, settings, formats),
            layout,
        }
    }
}

/// Fattened polygons, listed anew for each view.
#[derive(Debug)]
pub(crate) struct FatPolygons {
    stages: FatStages,
    count: u32,
    corners: Option<wgpu::Buffer>,
    nothing_drawn: wgpu::Buffer,
    arguments: wgpu::Buffer,
    places: wgpu::Buffer,
    notes: wgpu::Buffer,
    indices: wgpu::Buffer,
    lists: wgpu::BindGroup,
}

impl FatPolygons {
    /// Triangles, or `polygons` where there are any.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        stages: &FatStages,
        faces: u32,
        polygons: Option<&Polygons>,
    ) -> Result<Self, MeshTooLarge> {
        let upload = |label, words: &[u32], usage| {
            let buffer = storage_buffer(device, label, size_of_val(words) as u64, usage)?;
            queue.write_buffer(&buffer, 0, bytemuck::cast_slice(words));
            Ok::<_, MeshTooLarge>(buffer)
        };
        let none = wgpu::BufferUsages::empty();
        let corners = polygons.map(|polygons| upload("corners of polygons", &polygons.corners, none)).transpose()?;
        let starts = upload("starts of polygons", polygons.map_or(&[0], |polygons| &polygons.starts), none)?;
        let count = polygons.map_or(faces, |polygons| polygons.count() as u32);
        let corner_count = polygons.map_or(3 * u64::from(faces), |polygons| polygons.corners.len() as u64);
        let vertices = 2 * corner_count + u64::from(count);
        let note_bytes = if stages.noted == Noted::Nothing { 0 } else { 4 * vertices };
        let vertex_usage = wgpu::BufferUsages::VERTEX;
        let places = storage_buffer(device, "fattened polygons", 16 * vertices, vertex_usage)?;
        let notes = storage_buffer(device, "notes of fattened polygons", note_bytes, vertex_usage)?;
        let index_bytes = 24 * corner_count;
        let indices = storage_buffer(device, "triangles of fattened polygons", index_bytes, wgpu::BufferUsages::INDEX)?;
        let rest = storage_buffer(device, "polygons that become fans", 4 * u64::from(count), none)?;
        let nothing_drawn = upload("initial draw arguments", &NOTHING_DRAWN, wgpu::BufferUsages::COPY_SRC)?;
        let arguments = upload("arguments of the draws", &NOTHING_DRAWN, wgpu::BufferUsages::INDIRECT)?;

        let listed = [&arguments, &starts, &places, &notes, &indices, &rest];
        let lists = buffers_group(device, "lists of polygons", &stages.layout, &listed);
        let stages = stages.clone();
        Ok(Self { stages, count, corners, nothing_drawn, arguments, places, notes, indices, lists })
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

    /// What the stages expect as `noted`.
    pub fn noted(&self) -> u32 {
        self.stages.noted as u32
    }

    /// What the stages expect as `most_around`.
    pub fn most_around(&self) -> f32 {
        self.stages.cut.most_around()
    }

    /// Makes the lists for the view whose uniforms are bound.
    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder, camera: &CameraBinding, mesh: &MeshBinding) {
        encoder.copy_buffer_to_buffer(&self.nothing_drawn, 0, &self.arguments, 0, size_of_val(&NOTHING_DRAWN) as u64);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, camera.bind_group(), &[]);
        pass.set_bind_group(1, mesh.bind_group(), &[]);
        pass.set_bind_group(2, &self.lists, &[]);
        self.stages.cut.dispatch(&mut pass, self.count);
        self.stages.fans.dispatch(&mut pass, self.count);
    }

    /// Draws the lists.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_vertex_buffer(0, self.places.slice(..));
        if self.stages.noted != Noted::Nothing {
            pass.set_vertex_buffer(1, self.notes.slice(..));
        }
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        self.stages.fans.draw(pass, &self.arguments);
        self.stages.cut.draw(pass, &self.arguments, CUT_ARGUMENTS);
    }
}

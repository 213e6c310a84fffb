//! Lists and draws polygons that are fattened. Stages: `shaders/image_precision/polygon_list.wgsl`, `polygons.wgsl`,
//! `fatten.wgsl`.

use crate::back_edges::draw_arguments;
use crate::face_list::FaceList;
use crate::front_depth::{self, FrontDepth};
use crate::polygons::Polygons;
use crate::settings::{Settings, Texture, Variant};
use crate::stage::{Stage, buffers_group, compute, ink_fragment, storage_buffer, storage_entry};
use silhouette_gpu::{CameraBinding, MeshBinding, MeshBuffers, MeshTooLarge, TargetFormats};
use silhouette_shaders::image_precision::{FATTEN, POLYGON_LIST, POLYGONS};

/// A vertex in clip space, and what it tells of its edge or polygon.
const VERTEX_LAYOUTS: &[Option<wgpu::VertexBufferLayout<'static>>] = &[
    Some(wgpu::VertexBufferLayout {
        array_stride: 16,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &[wgpu::VertexAttribute { format: wgpu::VertexFormat::Float32x4, offset: 0, shader_location: 0 }],
    }),
    Some(wgpu::VertexBufferLayout {
        array_stride: 4,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &[wgpu::VertexAttribute { format: wgpu::VertexFormat::Uint32, offset: 0, shader_location: 1 }],
    }),
];

/// What vertices tell. The values are those of `polygons.wgsl`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Noted {
    Nothing = 0,
    Level = 1,
    Facing = 2,
}

impl Noted {
    fn of(settings: &Settings) -> Self {
        if matches!(settings.variant, Variant::Charcoal { .. }) {
            Self::Facing
        } else if settings.texture != Texture::Solid {
            Self::Level
        } else {
            Self::Nothing
        }
    }
}

/// Fattened polygons, listed anew for each view.
#[derive(Debug)]
pub(crate) struct FatPolygons {
    front: FrontDepth,
    listed: FaceList,
    corners: Option<wgpu::Buffer>,
    noted: Noted,
    places: wgpu::Buffer,
    notes: wgpu::Buffer,
    indices: wgpu::Buffer,
    arguments: wgpu::Buffer,
    filling: wgpu::BindGroup,
    fatten: wgpu::ComputePipeline,
    fat: wgpu::RenderPipeline,
}

impl FatPolygons {
    /// Triangles, or `polygons` where there are any.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        faces: u32,
        polygons: Option<&Polygons>,
        settings: &Settings,
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
        let noted = Noted::of(settings);
        let vertices = 2 * corner_count + u64::from(count);
        let note_bytes = if noted == Noted::Nothing { 0 } else { 4 * vertices };
        let vertex_usage = wgpu::BufferUsages::VERTEX;
        let places = storage_buffer(device, "fattened polygons", 16 * vertices, vertex_usage)?;
        let notes = storage_buffer(device, "notes of fattened polygons", note_bytes, vertex_usage)?;
        let index_bytes = 24 * corner_count;
        let indices = storage_buffer(device, "triangles of fattened polygons", index_bytes, wgpu::BufferUsages::INDEX)?;
        let arguments = draw_arguments(device, queue)?;

        let layout = |entries: &[_]| {
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("polygons"), entries })
        };
        let filling = layout(&[0, 1, 2, 3, 4, 5].map(|binding| storage_entry(binding, binding == 0 || binding == 2)));
        let listed = FaceList::new(device, count, (POLYGON_LIST, "list_polygons"), &starts)?;
        let filled = [listed.entries(), &arguments, &starts, &places, &notes, &indices];
        let filling_group = buffers_group(device, "polygons", &filling, &filled);
        let (camera, mesh) = (CameraBinding::layout(device), MeshBinding::layout(device));
        let squares = front_depth::reading_layout(device);
        let layouts = [Some(&camera), Some(&mesh), Some(&filling), Some(&squares)];
        let fat = Stage {
            label: "image precision: fattened polygons",
            wgsl: FATTEN,
            vertex: if noted == Noted::Nothing { "fat_vertex" } else { "noted_vertex" },
            fragment: Some(match noted {
                Noted::Nothing => ink_fragment(settings),
                Noted::Level => "textured_fragment",
                Noted::Facing => "charcoal_fragment",
            }),
            buffers: if noted == Noted::Nothing { &VERTEX_LAYOUTS[..1] } else { VERTEX_LAYOUTS },
            culled: None,
            polygon_mode: wgpu::PolygonMode::Fill,
            depth: formats.depth_state(formats.nearer_or_equal()),
        };
        Ok(Self {
            corners,
            filling: filling_group,
            fatten: compute(device, POLYGONS, "fatten_polygons", &layouts),
            fat: fat.build(device, &[Some(&camera)], formats.color, formats.samples),
            front: FrontDepth::new(device, formats),
            listed,
            noted,
            places,
            notes,
            indices,
            arguments,
        })
    }

    /// Corners of the polygons, where they are not the triangles.
    pub fn corners(&self) -> Option<&wgpu::Buffer> {
        self.corners.as_ref()
    }

    /// Number of polygons.
    pub fn count(&self) -> u32 {
        self.listed.count()
    }

    /// What the stages expect as `polygon_corners`.
    pub fn polygon_corners(&self) -> u32 {
        if self.corners.is_some() { 0 } else { 3 }
    }

    /// What the stages expect as `noted`.
    pub fn noted(&self) -> u32 {
        self.noted as u32
    }

    /// Makes room for a viewport of this size.
    pub fn resize(&mut self, device: &wgpu::Device, size: [u32; 2]) {
        self.front.resize(device, size);
    }

    /// Makes the list for the view whose uniforms are bound.
    pub fn encode(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        camera: &CameraBinding,
        buffers: &MeshBuffers,
        mesh: &MeshBinding,
    ) {
        let Some(squares) = self.front.encode(encoder, camera, buffers) else { return };
        encoder.clear_buffer(&self.arguments, 0, Some(4));
        self.listed.clear(encoder);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, camera.bind_group(), &[]);
        pass.set_bind_group(1, mesh.bind_group(), &[]);
        self.listed.encode(&mut pass);
        pass.set_bind_group(2, &self.filling, &[]);
        pass.set_bind_group(3, squares, &[]);
        pass.set_pipeline(&self.fatten);
        self.listed.dispatch(&mut pass, 1);
    }

    /// Draws the list.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.fat);
        pass.set_vertex_buffer(0, self.places.slice(..));
        if self.noted != Noted::Nothing {
            pass.set_vertex_buffer(1, self.notes.slice(..));
        }
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed_indirect(&self.arguments, 0);
    }
}

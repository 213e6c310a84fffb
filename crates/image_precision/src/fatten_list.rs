//! Fattens polygons and draws them. Stages: `shaders/image_precision/cut_triangles.wgsl`, `fans.wgsl`, `fatten.wgsl`.

use crate::fatten::FattenLaw;
use crate::options::Texture;
use crate::polygons::Polygons;
use crate::settings::{Settings, Variant};
use crate::stage::{Stage, buffers_group, compute, groups, ink_fragment, storage_buffer, storage_entry};
use silhouette_gpu::{CameraBinding, MeshBinding, MeshTooLarge, TargetFormats};
use silhouette_shaders::image_precision::{CUT_TRIANGLES, FANS, FATTEN};

/// Vertices of fans: in clip space, and what each tells of its edge or polygon.
const FAN_LAYOUTS: &[Option<wgpu::VertexBufferLayout<'static>>] = &[
    Some(wgpu::VertexBufferLayout {
        array_stride: 16,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &wgpu::vertex_attr_array![0 => Float32x4],
    }),
    Some(wgpu::VertexBufferLayout {
        array_stride: 4,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &wgpu::vertex_attr_array![1 => Uint32],
    }),
];

/// Vertices of cut triangles: in clip space, then how far inside each cut and what the polygon tells.
const CUT_LAYOUT: &[Option<wgpu::VertexBufferLayout<'static>>] = &[Some(wgpu::VertexBufferLayout {
    array_stride: 32,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![0 => Float32x4, 1 => Float32x4],
})];

/// Two draws of nothing, one indexed and one not, no places taken and nothing left: what the stages begin with.
const NOTHING_DRAWN: [u32; 11] = [0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0];

/// Where the arguments of the draw of cut triangles begin.
const CUT_ARGUMENTS: u64 = 20;

/// Cut triangles are at most this many times as large as what they show, as 98 % of the machine room's are. In software bounds from
/// 1.8 to 3 cost the same.
const MOST_AROUND: f32 = 3.0;

/// As many times the stage for fans goes round if it has to for all polygons.
const REST_ROUNDS: u32 = 8;

/// What vertices tell. The values are those of `style.wgsl`.
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
    count: u32,
    corners: Option<wgpu::Buffer>,
    noted: Noted,
    nothing_drawn: wgpu::Buffer,
    arguments: wgpu::Buffer,
    places: wgpu::Buffer,
    notes: wgpu::Buffer,
    indices: wgpu::Buffer,
    filling: wgpu::BindGroup,
    cut_triangles: wgpu::ComputePipeline,
    fan_rest: wgpu::ComputePipeline,
    fans: wgpu::RenderPipeline,
    /// None where every edge keeps its own triangles.
    cut: Option<wgpu::RenderPipeline>,
}

/// The stage that cuts a triangle's corners off; none where textures or the printed law ask for fans, or where samples lie at
/// places that are not told.
fn cut_fragment(settings: &Settings, noted: Noted, samples: u32) -> Option<&'static str> {
    let law = match settings.variant {
        Variant::Fatten { law } | Variant::Charcoal { law, .. } => law,
        _ => return None,
    };
    match samples {
        _ if noted == Noted::Level || law == FattenLaw::AsPrinted => None,
        1 => Some("cut_fragment"),
        4 => Some("cut_fragment_4"),
        _ => None,
    }
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
        let noted = Noted::of(settings);
        let vertices = 2 * corner_count + u64::from(count);
        let note_bytes = if noted == Noted::Nothing { 0 } else { 4 * vertices };
        let vertex_usage = wgpu::BufferUsages::VERTEX;
        let places = storage_buffer(device, "fattened polygons", 16 * vertices, vertex_usage)?;
        let notes = storage_buffer(device, "notes of fattened polygons", note_bytes, vertex_usage)?;
        let index_bytes = 24 * corner_count;
        let indices = storage_buffer(device, "triangles of fattened polygons", index_bytes, wgpu::BufferUsages::INDEX)?;
        let rest = storage_buffer(device, "polygons that become fans", 4 * u64::from(count), none)?;
        let nothing_drawn = upload("nothing drawn", &NOTHING_DRAWN, wgpu::BufferUsages::COPY_SRC)?;
        let arguments = upload("arguments of the draws", &NOTHING_DRAWN, wgpu::BufferUsages::INDIRECT)?;

        let filling_layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("polygons"),
            entries: &[0, 1, 2, 3, 4, 5].map(|binding| storage_entry(binding, binding == 1)),
        });
        let filled = [&arguments, &starts, &places, &notes, &indices, &rest];
        let filling = buffers_group(device, "polygons", &filling_layout, &filled);
        let (camera, mesh) = (CameraBinding::layout(device), MeshBinding::layout(device));
        let layouts = [Some(&camera), Some(&mesh), Some(&filling_layout)];
        let draws = |label, vertex, buffers, fragment| {
            let stage = Stage {
                label,
                wgsl: FATTEN,
                vertex,
                fragment,
                buffers,
                culled: None,
                polygon_mode: wgpu::PolygonMode::Fill,
                depth: formats.depth_state(formats.nearer_or_equal()),
            };
            stage.build(device, &[Some(&camera)], formats.color, formats.samples)
        };
        let fan_fragment = match noted {
            Noted::Nothing => ink_fragment(settings),
            Noted::Level => "textured_fragment",
            Noted::Facing => "charcoal_fragment",
        };
        let (fan_vertex, fan_layouts) =
            if noted == Noted::Nothing { ("fat_vertex", &FAN_LAYOUTS[..1]) } else { ("noted_vertex", FAN_LAYOUTS) };
        let cut = cut_fragment(settings, noted, formats.samples);
        Ok(Self {
            cut_triangles: compute(device, CUT_TRIANGLES, "cut_triangles", &layouts),
            fan_rest: compute(device, FANS, "fan_rest", &layouts),
            fans: draws("image precision: fattened polygons", fan_vertex, fan_layouts, fan_fragment),
            cut: cut.map(|fragment| draws("image precision: cut triangles", "cut_vertex", CUT_LAYOUT, fragment)),
            count,
            corners,
            noted,
            nothing_drawn,
            arguments,
            places,
            notes,
            indices,
            filling,
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

    /// What the stages expect as `noted`.
    pub fn noted(&self) -> u32 {
        self.noted as u32
    }

    /// What the stages expect as `most_around`.
    pub fn most_around(&self) -> f32 {
        if self.cut.is_some() { MOST_AROUND } else { 0.0 }
    }

    /// Makes the list for the view whose uniforms are bound.
    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder, camera: &CameraBinding, mesh: &MeshBinding) {
        encoder.copy_buffer_to_buffer(&self.nothing_drawn, 0, &self.arguments, 0, size_of_val(&NOTHING_DRAWN) as u64);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, camera.bind_group(), &[]);
        pass.set_bind_group(1, mesh.bind_group(), &[]);
        pass.set_bind_group(2, &self.filling, &[]);
        pass.set_pipeline(&self.cut_triangles);
        let [x, y] = groups(self.count);
        pass.dispatch_workgroups(x, y, 1);
        pass.set_pipeline(&self.fan_rest);
        let [x, _] = groups(self.count.div_ceil(REST_ROUNDS));
        pass.dispatch_workgroups(x, 1, 1);
    }

    /// Draws the list.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.fans);
        pass.set_vertex_buffer(0, self.places.slice(..));
        if self.noted != Noted::Nothing {
            pass.set_vertex_buffer(1, self.notes.slice(..));
        }
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed_indirect(&self.arguments, 0);
        if let Some(cut) = &self.cut {
            pass.set_pipeline(cut);
            pass.draw_indirect(&self.arguments, CUT_ARGUMENTS);
        }
    }
}

//! Finds the first layer of a view and draws what lies behind it. Stages: `shaders/image_precision/first_layer.wgsl`,
//! `unoriented.wgsl`, `later_faces.wgsl`, and for expanded edges those of [`screen`](crate::screen).

use crate::back_edges::{self, BackEdges, Listed, draw_arguments};
use crate::renderer::line_pipeline;
use crate::settings::Settings;
use crate::stage::{Stage, buffers_group, compute, groups, ink_fragment, storage_buffer, storage_entry};
use silhouette_gpu::{CameraBinding, MeshBinding, MeshTooLarge, TargetFormats};
use silhouette_shaders::image_precision::{FIRST_LAYER, LATER_FACES, UNORIENTED, UNORIENTED_MULTISAMPLED};

/// Numbers of faces in the layer's texture, a byte a channel: it needs as many samples a pixel as the target, so that no
/// face is seen there that the layer has not, and formats of whole numbers have one.
const NUMBERS: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// Side of the square that a workgroup of the marking stage covers, in pixels.
const MARKED_SQUARE: u32 = 8;

/// The first layer, found anew for each view.
#[derive(Debug)]
pub(crate) struct FirstLayer {
    faces: u32,
    formats: TargetFormats,
    marks: wgpu::Buffer,
    arguments: wgpu::Buffer,
    listed: wgpu::Buffer,
    number: wgpu::RenderPipeline,
    marking_layout: wgpu::BindGroupLayout,
    mark: wgpu::ComputePipeline,
    list: wgpu::ComputePipeline,
    drawing: wgpu::BindGroup,
    later: Later,
    target: Option<LayerTarget>,
}

/// How faces behind the first layer are drawn.
#[derive(Debug)]
enum Later {
    Faces(wgpu::RenderPipeline),
    Edges { list: BackEdges, pipeline: wgpu::RenderPipeline },
}

/// Textures of one size.
#[derive(Debug)]
struct LayerTarget {
    size: [u32; 2],
    numbers: wgpu::TextureView,
    depth: wgpu::TextureView,
    marking: wgpu::BindGroup,
}

impl FirstLayer {
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        faces: u32,
        scales: bool,
        settings: &Settings,
        formats: TargetFormats,
    ) -> Result<Self, MeshTooLarge> {
        let bytes = 4 * u64::from(faces);
        let none = wgpu::BufferUsages::empty();
        let marks = storage_buffer(device, "marks of the first layer", bytes, none)?;
        let listed = storage_buffer(device, "faces behind the first layer", bytes, none)?;
        let arguments = draw_arguments(device, queue)?;
        let texture = wgpu::BindGroupLayoutEntry {
            binding: 1,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: false },
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: formats.samples > 1,
            },
            count: None,
        };
        let marking_layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("first layer"),
            entries: &[storage_entry(0, false), texture, storage_entry(2, false), storage_entry(3, false)],
        });
        let (camera, mesh) = (CameraBinding::layout(device), MeshBinding::layout(device));
        let drawing_layout = back_edges::drawing_layout(device);
        let marking_stage = if formats.samples > 1 { UNORIENTED_MULTISAMPLED } else { UNORIENTED };
        let marking = [Some(&camera), None, Some(&marking_layout)];
        let drawing = [Some(&camera), Some(&mesh), Some(&drawing_layout)];
        let stage = |label, wgsl, [vertex, fragment]: [&'static str; 2], compare| Stage {
            label,
            wgsl,
            vertex,
            fragment,
            buffers: &[],
            culled: None,
            polygon_mode: wgpu::PolygonMode::Fill,
            depth: formats.depth_state(compare),
        };
        let number = stage("first layer", FIRST_LAYER, ["numbered_vertex", "number_fragment"], formats.nearer());
        let later = if scales {
            let words = ["later_vertex", ink_fragment(settings)];
            let stage = stage("faces behind the first layer", LATER_FACES, words, formats.nearer_or_equal());
            Later::Faces(stage.build(device, &drawing, formats.color, formats.samples))
        } else {
            let list = BackEdges::new(device, queue, faces, Listed::UnsharedLater, Some(&marks))?;
            Later::Edges { list, pipeline: line_pipeline(device, formats, settings, "line_of_edge") }
        };
        Ok(Self {
            faces,
            formats,
            number: number.build(device, &drawing[..2], NUMBERS, formats.samples),
            mark: compute(device, marking_stage, "mark_seen", &marking),
            list: compute(device, marking_stage, "list_later_faces", &marking),
            drawing: buffers_group(device, "faces behind the first layer", &drawing_layout, &[&listed]),
            marking_layout,
            marks,
            arguments,
            listed,
            later,
            target: None,
        })
    }

    /// Number of faces.
    pub fn faces(&self) -> u32 {
        self.faces
    }

    /// What the stages expect as `slot_mask`.
    pub fn slot_mask(&self) -> u32 {
        if let Later::Edges { list, .. } = &self.later { list.slot_mask() } else { 0 }
    }

    /// Makes textures for a viewport of this size, where they are not there.
    pub fn resize(&mut self, device: &wgpu::Device, size: [u32; 2]) {
        if self.target.as_ref().is_some_and(|target| target.size == size) {
            return;
        }
        let view = |label, format, usage| {
            let texture = device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: self.formats.samples,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: usage | wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            });
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        let numbers = view("numbers of faces", NUMBERS, wgpu::TextureUsages::TEXTURE_BINDING);
        let depth = view("depth of the first layer", self.formats.depth, wgpu::TextureUsages::empty());
        let entry = |binding, resource| wgpu::BindGroupEntry { binding, resource };
        let marking = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("first layer"),
            layout: &self.marking_layout,
            entries: &[
                entry(0, self.marks.as_entire_binding()),
                entry(1, wgpu::BindingResource::TextureView(&numbers)),
                entry(2, self.listed.as_entire_binding()),
                entry(3, self.arguments.as_entire_binding()),
            ],
        });
        self.target = Some(LayerTarget { size, numbers, depth, marking });
    }

    /// Finds the layer for the view whose uniforms are bound, and lists what lies behind it.
    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder, camera: &CameraBinding, mesh: &MeshBinding) {
        let Some(target) = &self.target else { return };
        encoder.clear_buffer(&self.marks, 0, None);
        encoder.clear_buffer(&self.arguments, 0, Some(4));
        let far = wgpu::LoadOp::Clear(self.formats.clear_depth());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("first layer"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &target.numbers,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &target.depth,
                depth_ops: Some(wgpu::Operations { load: far, store: wgpu::StoreOp::Discard }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        pass.set_bind_group(0, camera.bind_group(), &[]);
        pass.set_bind_group(1, mesh.bind_group(), &[]);
        pass.set_pipeline(&self.number);
        pass.draw(0..3 * self.faces, 0..1);
        drop(pass);

        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, camera.bind_group(), &[]);
        pass.set_bind_group(2, &target.marking, &[]);
        pass.set_pipeline(&self.mark);
        let [x, y] = target.size.map(|side| side.div_ceil(MARKED_SQUARE));
        pass.dispatch_workgroups(x, y, 1);
        if matches!(self.later, Later::Faces(_)) {
            pass.set_pipeline(&self.list);
            let [x, y] = groups(self.faces);
            pass.dispatch_workgroups(x, y, 1);
        }
        drop(pass);

        if let Later::Edges { list, .. } = &self.later {
            list.encode(encoder, camera, mesh);
        }
    }

    /// Draws what lies behind the layer.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        match &self.later {
            Later::Faces(pipeline) => {
                pass.set_pipeline(pipeline);
                pass.set_bind_group(2, &self.drawing, &[]);
                pass.draw_indirect(&self.arguments, 0);
            }
            Later::Edges { list, pipeline } => {
                pass.set_pipeline(pipeline);
                list.draw(pass);
            }
        }
    }
}

//! How the engine draws its objects.

use crate::device::Device;
use crate::scene::{Object, Scene, buffer};
use silhouette_gpu::color::linear;

/// Depth of the engine's targets.
pub const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// A pipeline with a uniform for each object.
pub struct Shading {
    pipeline: wgpu::RenderPipeline,
    uniforms: [(wgpu::Buffer, wgpu::BindGroup); 2],
}

impl Shading {
    /// Shades on a target with these samples; without a colour, draws depth alone.
    pub fn new(device: &Device, color: Option<wgpu::TextureFormat>, samples: u32) -> Self {
        let module = device.device.create_shader_module(wgpu::include_wgsl!("shading.wgsl"));
        let targets = [color.map(Into::into)];
        let fragment = color.map(|_| wgpu::FragmentState {
            module: &module,
            entry_point: Some("shaded"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &targets,
        });
        let layout = device.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("drawn"),
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
                ty: wgpu::BindingType::Buffer {
                    ty: wgpu::BufferBindingType::Uniform,
                    has_dynamic_offset: false,
                    min_binding_size: None,
                },
                count: None,
            }],
        });
        let pipeline_layout = device.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let pipeline = device.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("shading"),
            layout: Some(&pipeline_layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("vertex"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[Some(silhouette_gpu::POSITION_LAYOUT)],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Greater),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
            fragment,
            multiview_mask: None,
            cache: None,
        });
        let uniforms = [0, 1].map(|_| {
            let uniform = buffer(device, &[0; 80], wgpu::BufferUsages::UNIFORM);
            let group = device.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("drawn"),
                layout: &layout,
                entries: &[wgpu::BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() }],
            });
            (uniform, group)
        });
        Self { pipeline, uniforms }
    }

    /// Uploads matrices and colours.
    pub fn prepare(&self, device: &Device, scene: &Scene) {
        for (object, (uniform, _)) in scene.objects.iter().zip(&self.uniforms) {
            let [red, green, blue] = object.color.map(|part| linear(f64::from(part)) as f32);
            let drawn: Vec<f32> =
                scene.to_clip(object).to_cols_array().into_iter().chain([red, green, blue, 1.0]).collect();
            device.queue.write_buffer(uniform, 0, bytemuck::cast_slice(&drawn));
        }
    }

    /// Draws all objects.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, scene: &Scene) {
        pass.set_pipeline(&self.pipeline);
        for (object, (_, group)) in scene.objects.iter().zip(&self.uniforms) {
            let Object { positions, indices, mesh, .. } = object;
            pass.set_bind_group(0, group, &[]);
            pass.set_vertex_buffer(0, positions.slice(..));
            pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..3 * mesh.face_count() as u32, 0, 0..1);
        }
    }
}

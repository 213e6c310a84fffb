//! Draws every face as its id, so that the faces of the first layer are seen. Stage: `shaders/image_precision/first_layer.wgsl`.

use silhouette_gpu::kit::RenderStage;
use silhouette_gpu::{CameraBinding, MeshBinding, TargetFormats};
use silhouette_shaders::image_precision::FIRST_LAYER;

/// Face ids, one byte per channel: the texture needs as many samples per pixel as the target, so that each face that is seen there
/// is seen in the layer as well, and integer formats cannot be multisampled.
const IDS: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// The stage that draws ids, shared by all renderers.
#[derive(Debug, Clone)]
pub(crate) struct FirstLayerStage {
    formats: TargetFormats,
    pipeline: wgpu::RenderPipeline,
}

impl FirstLayerStage {
    pub fn new(device: &wgpu::Device, formats: TargetFormats) -> Self {
        let pipeline = RenderStage {
            label: "first layer",
            wgsl: FIRST_LAYER,
            vertex: "numbered_vertex",
            fragment: "number_fragment",
            bindings: &[Some(&CameraBinding::layout(device)), Some(&MeshBinding::layout(device))],
            depth: Some(formats.depth_state(formats.nearer())),
            color: IDS,
            samples: formats.samples,
            ..RenderStage::default()
        }
        .build(device);
        Self { formats, pipeline }
    }
}

/// The first layer of a view as a texture of face ids.
#[derive(Debug)]
pub(crate) struct FirstLayer {
    faces: u32,
    stage: FirstLayerStage,
    target: Option<LayerTarget>,
}

/// Textures of one size.
#[derive(Debug)]
struct LayerTarget {
    size: [u32; 2],
    ids: wgpu::TextureView,
    depth: wgpu::TextureView,
}

impl FirstLayer {
    pub fn new(stage: &FirstLayerStage, faces: u32) -> Self {
        Self { faces, stage: stage.clone(), target: None }
    }

    /// Makes textures for a viewport of this size. `Some` with the new texture of ids where the size has changed.
    pub fn resize(&mut self, device: &wgpu::Device, size: [u32; 2]) -> Option<&wgpu::TextureView> {
        if self.target.as_ref().is_some_and(|target| target.size == size) {
            return None;
        }
        let view = |label, format, usage| {
            let texture = device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: self.stage.formats.samples,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: usage | wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            });
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        let ids = view("ids of faces", IDS, wgpu::TextureUsages::TEXTURE_BINDING);
        let depth = view("depth of the first layer", self.stage.formats.depth, wgpu::TextureUsages::empty());
        Some(&self.target.insert(LayerTarget { size, ids, depth }).ids)
    }

    /// Draws the layer of the view whose uniforms are bound. Nothing before the first [`resize`](Self::resize).
    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder, camera: &CameraBinding, mesh: &MeshBinding) {
        let Some(target) = &self.target else { return };
        let far = wgpu::LoadOp::Clear(self.stage.formats.clear_depth());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("first layer"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &target.ids,
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
        pass.set_pipeline(&self.stage.pipeline);
        pass.draw(0..3 * self.faces, 0..1);
    }
}

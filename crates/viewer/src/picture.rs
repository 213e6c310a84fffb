//! [`Pictures`]: shows what methods drew, pixel for pixel. Stage: `shaders/viewer/picture.wgsl`.
//!
//! egui can show textures itself, at twice the work for each pixel: on a software adapter that is most of what a frame of the window costs.

use eframe::egui::{self, PaintCallbackInfo, Rect};
use eframe::egui_wgpu::{self, CallbackResources, CallbackTrait};
use eframe::wgpu;
use silhouette_gpu::kit::{RenderStage, bind_group, bind_layout, texture_entry};

/// Shows pictures in a window.
#[derive(Debug)]
pub struct Pictures {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
}

/// A picture that can be shown.
#[derive(Debug, Clone)]
pub struct Picture {
    pipeline: wgpu::RenderPipeline,
    texture: wgpu::BindGroup,
}

impl Pictures {
    /// For a window with pixels of this format.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat) -> Self {
        let sample_type = wgpu::TextureSampleType::Float { filterable: false };
        let layout = bind_layout(device, "picture", &[texture_entry(0, sample_type, false)]);
        let pipeline = RenderStage {
            label: "picture",
            wgsl: silhouette_shaders::viewer::PICTURE,
            vertex: "picture_corner",
            fragment: if format.is_srgb() { "picture_as_light" } else { "picture_as_stored" },
            bindings: &[Some(&layout)],
            color: format,
            ..RenderStage::default()
        }
        .build(device);
        Self { layout, pipeline }
    }

    /// The picture that a texture holds, one sample per pixel, premultiplied by alpha.
    pub fn of(&self, device: &wgpu::Device, texture: &wgpu::TextureView) -> Picture {
        let source = wgpu::BindingResource::TextureView(texture);
        let texture = bind_group(device, "picture", &self.layout, &[source]);
        Picture { pipeline: self.pipeline.clone(), texture }
    }
}

impl Picture {
    /// What shows it in a rectangle, on white paper.
    pub fn shape(self, rect: Rect) -> egui::Shape {
        egui::Shape::Callback(egui_wgpu::Callback::new_paint_callback(rect, self))
    }
}

impl CallbackTrait for Picture {
    fn paint(&self, _info: PaintCallbackInfo, pass: &mut wgpu::RenderPass<'static>, _resources: &CallbackResources) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.texture, &[]);
        pass.draw(0..3, 0..1);
    }
}

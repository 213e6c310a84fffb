//! [`FillPass`]: the triangles of a mesh.

use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::pass_view::PassView;
use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use silhouette_gpu::kit::RenderStage;
use silhouette_gpu::{CameraBinding, CameraUniform, MeshBuffers, POSITION_LAYOUT, TargetFormats};

/// How faces are coloured. Colours are what the format stores for `Unorm`, linear for `Srgb`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shade {
    /// One colour.
    Flat([f32; 4]),
    /// One colour, lit from the viewer's upper left by Lambert's law with each face's own normal, alike from both sides.
    Lit([f32; 4]),
    /// No colour is written, depth alone.
    DepthOnly,
}

/// Which faces are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Cull {
    /// All of them: what hidden lines need on any mesh.
    #[default]
    None,
    /// Front faces only, those whose vertices run counter-clockwise in the image: half the work on a closed mesh, and the
    /// same picture.
    Back,
}

/// How a mesh is filled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FillStyle {
    /// Colour.
    pub shade: Shade,
    /// Faces drawn.
    pub cull: Cull,
}

impl FillStyle {
    /// White on both sides, as paper for lines.
    pub const PAPER: Self = Self { shade: Shade::Flat([1.0; 4]), cull: Cull::None };
}

/// Share of the light that falls on faces turned away from it.
const AMBIENT: f32 = 0.25;

/// Towards the light, in view space: from over the viewer's left shoulder.
const LIGHT_VIEW: DVec3 = DVec3::new(-0.4, 0.6, 1.0);

/// Twin of the struct in `shaders/render/fill.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
struct FillUniform {
    color: [f32; 4],
    light: [f32; 4],
}

/// Draws the triangles of a mesh, nearest in front. One draw for each submit.
#[derive(Debug)]
pub struct FillPass {
    pipeline: wgpu::RenderPipeline,
    binding: CameraBinding,
    style: FillStyle,
}

impl FillPass {
    /// Builds the pipeline.
    ///
    /// # Errors
    /// What the device reports.
    pub fn new(gpu: &Gpu, formats: TargetFormats, style: FillStyle) -> Result<Self, GpuError> {
        let device = gpu.device();
        gpu.scoped(|| {
            let layout = CameraBinding::layout(device);
            let pipeline = RenderStage {
                label: "fill",
                wgsl: silhouette_shaders::render::FILL,
                vertex: "fill_vertex",
                fragment: if matches!(style.shade, Shade::Lit(_)) { "fill_lit" } else { "fill_flat" },
                bindings: &[Some(&layout)],
                vertex_buffers: &[Some(POSITION_LAYOUT)],
                cull_mode: (style.cull == Cull::Back).then_some(wgpu::Face::Back),
                depth: Some(formats.depth_state(formats.nearer())),
                color: formats.color,
                writes: match style.shade {
                    Shade::DepthOnly => wgpu::ColorWrites::empty(),
                    Shade::Flat(_) | Shade::Lit(_) => wgpu::ColorWrites::ALL,
                },
                samples: formats.samples,
                ..RenderStage::default()
            }
            .build(device);
            let binding = CameraBinding::new(device, &layout, size_of::<FillUniform>());
            Self { pipeline, binding, style }
        })
    }

    /// Uploads the view for the next submit.
    pub fn prepare(&self, gpu: &Gpu, mesh: &MeshBuffers, view: &PassView) {
        let camera = CameraUniform::new(view.local_to_clip(mesh.frame()));
        let light = view.camera.view_matrix().inverse().transform_vector3(LIGHT_VIEW).normalize().as_vec3();
        let color = match self.style.shade {
            Shade::Flat(color) | Shade::Lit(color) => color,
            Shade::DepthOnly => [0.0; 4],
        };
        self.binding.write(gpu.queue(), &camera, &FillUniform { color, light: light.extend(AMBIENT).to_array() });
    }

    /// Records the draw.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, mesh: &MeshBuffers) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        mesh.draw(pass);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_shaders::layout;
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        let members = [("color", offset_of!(FillUniform, color)), ("light", offset_of!(FillUniform, light))];
        assert!(layout::matches(silhouette_shaders::render::FILL, "FillUniform", size_of::<FillUniform>(), &members));
    }
}

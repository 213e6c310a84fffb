//! Fattened polygons as fans of triangles. Stage that lists them: `shaders/image_precision/fans.wgsl`.

use crate::fatten;
use crate::ink::{self, solid_fragment};
use crate::options::Texture;
use crate::settings::{Settings, Variant};
use silhouette_gpu::TargetFormats;
use silhouette_gpu::kit::{compute_pipeline, workgroups};
use silhouette_shaders::image_precision::FANS;

/// Vertices of fans: in clip space, and the note of each on its edge or polygon.
const LAYOUTS: &[Option<wgpu::VertexBufferLayout<'static>>] = &[
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

/// Polygons that an invocation takes if all of them become fans.
const MOST_PER_INVOCATION: u32 = 8;

/// What each vertex of a fattened polygon carries. The values are those of `style.wgsl`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Noted {
    /// Nothing.
    Nothing = 0,
    /// Whether its edge is level in the image.
    Level = 1,
    /// V.N of its polygon.
    Facing = 2,
}

impl Noted {
    /// What the look that is asked for needs.
    pub fn of(settings: &Settings) -> Self {
        if matches!(settings.variant, Variant::Charcoal { .. }) {
            Self::Facing
        } else if settings.texture != Texture::Solid {
            Self::Level
        } else {
            Self::Nothing
        }
    }
}

/// Makes and draws fans of the polygons that are not cut triangles.
#[derive(Debug, Clone)]
pub(crate) struct Fans {
    listing: wgpu::ComputePipeline,
    drawing: wgpu::RenderPipeline,
}

impl Fans {
    /// `bindings` are those of the listing stage: camera, mesh, lists.
    pub fn new(
        device: &wgpu::Device,
        bindings: &[Option<&wgpu::BindGroupLayout>],
        settings: &Settings,
        formats: TargetFormats,
    ) -> Self {
        let (stages, layouts) = match Noted::of(settings) {
            Noted::Nothing => (["fat_vertex", solid_fragment(settings)], &LAYOUTS[..1]),
            Noted::Level => (["noted_vertex", "textured_fragment"], LAYOUTS),
            Noted::Facing => (["noted_vertex", "charcoal_fragment"], LAYOUTS),
        };
        Self {
            listing: compute_pipeline(device, FANS, "fan_rest", bindings),
            drawing: fatten::pipeline(
                device,
                "image precision: fattened polygons",
                stages,
                layouts,
                ink::blend(settings),
                formats,
            ),
        }
    }

    /// Makes fans of what is left of this many polygons, with the groups that are bound.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass<'_>, polygons: u32) {
        pass.set_pipeline(&self.listing);
        let [x, _] = workgroups(polygons.div_ceil(MOST_PER_INVOCATION));
        pass.dispatch_workgroups(x, 1, 1);
    }

    /// Draws the fans from the vertex and index buffers that are set, with the arguments at the beginning of the buffer.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, arguments: &wgpu::Buffer) {
        pass.set_pipeline(&self.drawing);
        pass.draw_indexed_indirect(arguments, 0);
    }
}

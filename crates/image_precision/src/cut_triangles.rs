//! Fattened triangles as triangles whose corners are cut off. Stage that lists them: `shaders/image_precision/cut_triangles.wgsl`.

use crate::fans::Noted;
use crate::fatten::{self, FattenLaw};
use crate::ink;
use crate::settings::{Settings, Variant};
use silhouette_gpu::TargetFormats;
use silhouette_gpu::kit::{compute_pipeline, workgroups};
use silhouette_shaders::image_precision::CUT_TRIANGLES;

/// Vertices of cut triangles: in clip space, then how far inside each cut and the facing of the polygon.
const LAYOUT: &[Option<wgpu::VertexBufferLayout<'static>>] = &[Some(wgpu::VertexBufferLayout {
    array_stride: 32,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![0 => Float32x4, 1 => Float32x4],
})];

/// Most that a cut triangle's area may exceed what it shows, as a factor; 98 % of the machine room's triangles stay below. On a
/// software adapter bounds from 1.8 to 3 cost the same.
const MOST_AROUND: f32 = 3.0;

/// Lists polygons as cut triangles, or as the rest that becomes fans.
#[derive(Debug, Clone)]
pub(crate) struct CutTriangles {
    listing: wgpu::ComputePipeline,
    /// `None` where all polygons become fans.
    drawing: Option<wgpu::RenderPipeline>,
}

impl CutTriangles {
    /// `bindings` are those of the listing stage: camera, mesh, lists.
    pub fn new(
        device: &wgpu::Device,
        bindings: &[Option<&wgpu::BindGroupLayout>],
        settings: &Settings,
        formats: TargetFormats,
    ) -> Self {
        let drawing = fragment(settings, formats.samples).map(|fragment| {
            fatten::pipeline(
                device,
                "image precision: cut triangles",
                ["cut_vertex", fragment],
                LAYOUT,
                ink::blend(settings),
                formats,
            )
        });
        Self { listing: compute_pipeline(device, CUT_TRIANGLES, "cut_triangles", bindings), drawing }
    }

    /// What the stages expect as `most_around`.
    pub fn most_around(&self) -> f32 {
        if self.drawing.is_some() { MOST_AROUND } else { 0.0 }
    }

    /// Lists all of this many polygons, with the groups that are bound.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass<'_>, polygons: u32) {
        pass.set_pipeline(&self.listing);
        let [x, y] = workgroups(polygons);
        pass.dispatch_workgroups(x, y, 1);
    }

    /// Draws the list from vertex buffer 0, with the arguments at `offset` bytes.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, arguments: &wgpu::Buffer, offset: u64) {
        if let Some(drawing) = &self.drawing {
            pass.set_pipeline(drawing);
            pass.draw_indirect(arguments, offset);
        }
    }
}

/// The stage that cuts corners off. `None` where textures or the printed law ask for fans, and for sample counts whose sample
/// positions WebGPU does not fix.
fn fragment(settings: &Settings, samples: u32) -> Option<&'static str> {
    let law = match settings.variant {
        Variant::Fatten { law } | Variant::Charcoal { law, .. } => law,
        _ => return None,
    };
    match samples {
        _ if Noted::of(settings) == Noted::Level || law == FattenLaw::AsPrinted => None,
        1 => Some("cut_fragment"),
        4 => Some("cut_fragment_4"),
        _ => None,
    }
}

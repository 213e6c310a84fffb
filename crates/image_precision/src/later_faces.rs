//! Draws what lies behind the first layer. Stages: `shaders/image_precision/later_faces.wgsl`, or for expanded edges those of
//! [`screen`](crate::screen).

use crate::back_edges::{self, BackEdges, BackEdgesStages, Listed};
use crate::first_layer::{FirstLayer, FirstLayerStage};
use crate::ink::{blend, solid_fragment};
use crate::mark_seen::{SeenFaces, SeenStages};
use crate::screen;
use crate::settings::Settings;
use silhouette_gpu::kit::{RenderStage, buffers_group};
use silhouette_gpu::{CameraBinding, MeshBinding, MeshTooLarge, TargetFormats};
use silhouette_shaders::image_precision::LATER_FACES;

/// The stages, shared by all renderers.
#[derive(Debug)]
pub(crate) struct LaterStages {
    layer: FirstLayerStage,
    seen: SeenStages,
    drawn: DrawnStages,
}

/// How faces behind the first layer are drawn.
#[derive(Debug)]
enum DrawnStages {
    Faces { layout: wgpu::BindGroupLayout, pipeline: wgpu::RenderPipeline },
    Edges { list: BackEdgesStages, pipeline: wgpu::RenderPipeline },
}

impl LaterStages {
    /// `scales`: whether the faces are drawn, scaled about the eye, and not their edges.
    pub fn new(device: &wgpu::Device, scales: bool, settings: &Settings, formats: TargetFormats) -> Self {
        let drawn = if scales {
            let layout = back_edges::drawing_layout(device);
            DrawnStages::Faces { pipeline: pipeline(device, &layout, settings, formats), layout }
        } else {
            DrawnStages::Edges {
                list: BackEdgesStages::new(device, Listed::UnsharedLater),
                pipeline: screen::pipeline(device, formats, settings, "line_of_edge"),
            }
        };
        Self { layer: FirstLayerStage::new(device, formats), seen: SeenStages::new(device, formats.samples), drawn }
    }
}

/// Faces behind the first layer, found anew for each view.
#[derive(Debug)]
pub(crate) struct LaterFaces {
    faces: u32,
    layer: FirstLayer,
    seen: SeenFaces,
    drawn: Drawn,
}

/// What is drawn of them.
#[derive(Debug)]
enum Drawn {
    Faces { list: wgpu::BindGroup, pipeline: wgpu::RenderPipeline },
    Edges { list: BackEdges, pipeline: wgpu::RenderPipeline },
}

impl LaterFaces {
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        stages: &LaterStages,
        faces: u32,
    ) -> Result<Self, MeshTooLarge> {
        let seen = SeenFaces::new(device, queue, &stages.seen, faces)?;
        let drawn = match &stages.drawn {
            DrawnStages::Faces { layout, pipeline } => Drawn::Faces {
                list: buffers_group(device, "faces behind the first layer", layout, &[seen.listed()]),
                pipeline: pipeline.clone(),
            },
            DrawnStages::Edges { list, pipeline } => Drawn::Edges {
                list: BackEdges::new(device, queue, list, faces, Some(seen.marks()))?,
                pipeline: pipeline.clone(),
            },
        };
        Ok(Self { faces, layer: FirstLayer::new(&stages.layer, faces), seen, drawn })
    }

    /// Number of faces.
    pub fn faces(&self) -> u32 {
        self.faces
    }

    /// What the stages expect as `slot_mask`.
    pub fn slot_mask(&self) -> u32 {
        if let Drawn::Edges { list, .. } = &self.drawn { list.slot_mask() } else { 0 }
    }

    /// Makes textures for a viewport of this size, where they have another.
    pub fn resize(&mut self, device: &wgpu::Device, size: [u32; 2]) {
        if let Some(ids) = self.layer.resize(device, size) {
            self.seen.bind(device, ids, size);
        }
    }

    /// Finds the first layer of the view whose uniforms are bound, and lists what lies behind it.
    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder, camera: &CameraBinding, mesh: &MeshBinding) {
        self.layer.encode(encoder, camera, mesh);
        self.seen.encode(encoder, camera, matches!(self.drawn, Drawn::Faces { .. }));
        if let Drawn::Edges { list, .. } = &self.drawn {
            list.encode(encoder, camera, mesh);
        }
    }

    /// Draws what lies behind the layer.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        match &self.drawn {
            Drawn::Faces { list, pipeline } => {
                pass.set_pipeline(pipeline);
                pass.set_bind_group(2, list, &[]);
                pass.draw_indirect(self.seen.arguments(), 0);
            }
            Drawn::Edges { list, pipeline } => {
                pass.set_pipeline(pipeline);
                list.draw(pass);
            }
        }
    }
}

fn pipeline(
    device: &wgpu::Device,
    list: &wgpu::BindGroupLayout,
    settings: &Settings,
    formats: TargetFormats,
) -> wgpu::RenderPipeline {
    RenderStage {
        label: "faces behind the first layer",
        wgsl: LATER_FACES,
        vertex: "later_vertex",
        fragment: solid_fragment(settings),
        bindings: &[Some(&CameraBinding::layout(device)), Some(&MeshBinding::layout(device)), Some(list)],
        depth: Some(formats.depth_state(formats.nearer_or_equal())),
        color: formats.color,
        blend: blend(settings),
        samples: formats.samples,
        ..RenderStage::default()
    }
    .build(device)
}

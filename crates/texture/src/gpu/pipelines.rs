//! [`TexturePipelines`]: the pipelines of a style, for all volumes of a form. Stages: `shaders/texture/surface_stages.wgsl` and
//! `outline_stages.wgsl`, which `lookup.wgsl` and `lookup.terms.wgsl` import.

use super::style::{Drawing, Edge, OutlineStyle, OutlineWidth, Shading, TextureStyle};
use super::texture_vertices::TextureVertex;
use super::volume::VolumeForm;
use silhouette_gpu::kit::{RenderStage, WoundPipeline, bind_layout, uniform_entry};
use silhouette_gpu::{CameraBinding, FillPipelines, Interior, TargetFormats};
use silhouette_shaders::texture::{LOOKUP, LOOKUP_TERMS};
use std::borrow::Cow;
use std::sync::Arc;

/// What all renderers in one style, of volumes of one form, share.
#[derive(Debug)]
pub struct TexturePipelines {
    /// Drawn one after the other.
    pub(super) stages: Vec<WoundPipeline>,
    /// Group 1.
    pub(super) hull_layout: wgpu::BindGroupLayout,
    /// Draws the fine mesh; `None` where its interior is not drawn.
    pub(super) near: Option<Arc<FillPipelines>>,
    pub(super) form: VolumeForm,
    pub(super) formats: TargetFormats,
    pub(super) style: TextureStyle,
}

/// What a pipeline does with what its fragment stage yields.
#[derive(Debug, Clone, Copy)]
struct Stage {
    fragment: &'static str,
    /// Whether only fragments that are as near as what was drawn before are drawn too.
    is_over_itself: bool,
    writes: wgpu::ColorWrites,
    blends: bool,
}

impl TexturePipelines {
    /// Builds the pipelines. Some milliseconds each: one, or two for outlines without an opaque interior.
    pub fn new(device: &wgpu::Device, formats: TargetFormats, style: TextureStyle, form: VolumeForm) -> Self {
        let stages = stages(&style.drawing).into_iter();
        let draws_near = !matches!(style.drawing, Drawing::Outlines(OutlineStyle { interior: Interior::None, .. }));
        Self {
            stages: stages.map(|stage| wound(device, formats, &style, form, stage)).collect(),
            hull_layout: hull_layout(device),
            near: draws_near.then(|| Arc::new(FillPipelines::new(device, formats, style.near))),
            form,
            formats,
            style,
        }
    }

    /// Whether edges were asked to be soft and cannot be.
    pub(super) fn lacks_samples(&self) -> bool {
        self.style.edge == Edge::Coverage && !is_soft(&self.style, self.formats)
    }
}

fn hull_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    bind_layout(device, "silhouette texture: hull", &[uniform_entry(0)])
}

/// Soft edges need the four samples whose places the stages know.
fn is_soft(style: &TextureStyle, formats: TargetFormats) -> bool {
    style.edge == Edge::Coverage && formats.samples == 4
}

fn stages(drawing: &Drawing) -> Vec<Stage> {
    let plain = |fragment| Stage { fragment, is_over_itself: false, writes: wgpu::ColorWrites::ALL, blends: false };
    match drawing {
        Drawing::Surface(Shading::Custom(_)) | Drawing::Hull(Shading::Custom(_)) => vec![plain("custom")],
        Drawing::Surface(_) => vec![plain("carved")],
        Drawing::Hull(_) => vec![plain("uncarved")],
        Drawing::Outlines(OutlineStyle { ink, interior, .. }) => {
            let ink_blends = ink.alpha < 1.0;
            // A layer that is drawn first leaves its ink behind whatever is translucent and nearer. So depth comes first there.
            let depth = Stage { writes: wgpu::ColorWrites::empty(), ..plain("inked_paper") };
            match interior {
                Interior::Paper(paper) if paper.alpha >= 1.0 && !ink_blends => vec![plain("inked_paper")],
                Interior::Paper(_) => {
                    vec![depth, Stage { is_over_itself: true, blends: true, ..plain("inked_paper") }]
                }
                Interior::DepthOnly => {
                    vec![depth, Stage { is_over_itself: true, blends: ink_blends, ..plain("ink_alone") }]
                }
                Interior::None => vec![Stage { is_over_itself: true, blends: ink_blends, ..plain("ink_alone") }],
            }
        }
    }
}

/// One of the pipelines, for either winding.
fn wound(
    device: &wgpu::Device,
    formats: TargetFormats,
    style: &TextureStyle,
    form: VolumeForm,
    stage: Stage,
) -> WoundPipeline {
    let text = if form.has_terms { LOOKUP_TERMS } else { LOOKUP };
    let (shading, width_law, wgsl) = match &style.drawing {
        Drawing::Surface(shading) | Drawing::Hull(shading) => {
            let (number, wgsl) = match shading {
                Shading::Lit => (0, Cow::Borrowed(text)),
                Shading::Flat(_) => (1, Cow::Borrowed(text)),
                Shading::Normals => (2, Cow::Borrowed(text)),
                Shading::Custom(own) => (0, Cow::Owned(format!("{text}\n{own}"))),
            };
            (number, 0, wgsl)
        }
        Drawing::Outlines(outlines) => {
            let law = match outlines.width {
                OutlineWidth::Gradient { .. } => 0,
                OutlineWidth::Gap { .. } => 1,
                OutlineWidth::AsPrinted { .. } => 2,
            };
            (0, law, Cow::Borrowed(text))
        }
    };
    let is_soft = is_soft(style, formats);
    WoundPipeline::new(device, move |device, front_face| {
        let flag = |is_set: bool| f64::from(u8::from(is_set));
        RenderStage {
            label: "silhouette texture",
            wgsl: &wgsl,
            vertex: "hull_vertex",
            fragment: stage.fragment,
            constants: &[
                ("HAS_TEXEL_CENTERS", flag(form.has_texel_centers)),
                ("IS_FILTERED", flag(form.is_filtered)),
                ("IS_SOFT", flag(is_soft)),
                ("SHADING", f64::from(shading)),
                ("WIDTH_LAW", f64::from(width_law)),
            ],
            bindings: &[Some(&CameraBinding::layout(device)), Some(&hull_layout(device)), Some(&form.layout(device))],
            vertex_buffers: &[Some(TextureVertex::LAYOUT)],
            front_face,
            cull_mode: Some(wgpu::Face::Back),
            depth: Some(formats.depth_state(if stage.is_over_itself {
                formats.nearer_or_equal()
            } else {
                formats.nearer()
            })),
            color: formats.color,
            blend: stage.blends.then_some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            writes: stage.writes,
            samples: formats.samples,
            ..RenderStage::default()
        }
        .build(device)
    })
}

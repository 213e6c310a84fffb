//! [`Pipelines`]: what all renderers with the same options, on the same device and formats, share.

use crate::back_edges::{BackEdgesStages, Listed};
use crate::fat_polygons::FatStages;
use crate::later_faces::LaterStages;
use crate::settings::{ExtraEdges, Settings, Variant};
use crate::{back_faces, front_faces, screen};
use silhouette_gpu::kit::WoundPipeline;
use silhouette_gpu::{RendererError, TargetFormats};

/// The pipelines of a variant.
#[derive(Debug)]
pub struct Pipelines {
    pub(crate) settings: Settings,
    pub(crate) formats: TargetFormats,
    pub(crate) front: Option<WoundPipeline>,
    pub(crate) back: BackStages,
    /// Draws boundary edges and creases, where they are asked for.
    pub(crate) extra: Option<wgpu::RenderPipeline>,
}

/// What draws back faces.
#[derive(Debug)]
pub(crate) enum BackStages {
    /// The faces themselves, pulled by the matrix or by polygon offset, or as the adapter's own lines.
    Faces(WoundPipeline),
    /// Their edges as lines.
    Edges { list: BackEdgesStages, pipeline: wgpu::RenderPipeline },
    /// Their fattened polygons.
    Fat(FatStages),
    /// What lies behind the first layer.
    Later(LaterStages),
}

impl Pipelines {
    /// Builds them.
    pub(crate) fn new(
        device: &wgpu::Device,
        settings: &Settings,
        formats: TargetFormats,
    ) -> Result<Self, RendererError> {
        let is_oriented = !matches!(settings.variant, Variant::Unoriented { .. });
        let culled = is_oriented.then_some(wgpu::Face::Back);
        let draws_extra = settings.extra_edges != ExtraEdges::None;
        Ok(Self {
            settings: *settings,
            formats,
            front: front_faces::pipeline(device, formats, settings.interior, culled),
            back: BackStages::new(device, settings, formats)?,
            extra: draws_extra.then(|| screen::pipeline(device, formats, settings, "line_of_pair")),
        })
    }
}

impl BackStages {
    fn new(device: &wgpu::Device, settings: &Settings, formats: TargetFormats) -> Result<Self, RendererError> {
        let edges = |listed| Self::Edges {
            list: BackEdgesStages::new(device, listed),
            pipeline: screen::pipeline(device, formats, settings, "line_of_edge"),
        };
        match settings.variant {
            Variant::Screen => Ok(edges(Listed::Unshared)),
            Variant::Wireframe { polygon_mode: false } => Ok(edges(Listed::EveryEdge)),
            Variant::Wireframe { polygon_mode: true }
                if !device.features().contains(wgpu::Features::POLYGON_MODE_LINE) =>
            {
                Err(RendererError::MissingFeature {
                    what: "wireframe-lines=polygon-mode",
                    feature: "POLYGON_MODE_LINE",
                    instead: "use wireframe-lines=quads, which needs none",
                })
            }
            Variant::Fatten { .. } | Variant::Charcoal { .. } => {
                Ok(Self::Fat(FatStages::new(device, settings, formats)))
            }
            Variant::Unoriented { k } => Ok(Self::Later(LaterStages::new(device, k.is_some(), settings, formats))),
            Variant::Wireframe { polygon_mode: true }
            | Variant::Equal
            | Variant::FixedPull { .. }
            | Variant::Scale { .. }
            | Variant::DepthRange { .. }
            | Variant::Offset { .. } => Ok(Self::Faces(back_faces::pipeline(device, formats, settings))),
        }
    }
}

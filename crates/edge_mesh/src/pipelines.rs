//! [`Pipelines`]: what all renderers with the same options, on the same device and formats, share.

use crate::lines::LineStages;
use crate::options::EdgeMeshOptions;
use silhouette_core::line_style::InteriorChoice;
use silhouette_gpu::{FillPipelines, FillStyle, TargetFormats};
use std::sync::Arc;

/// The pipelines of a set of options.
#[derive(Debug)]
pub struct Pipelines {
    pub(crate) options: EdgeMeshOptions,
    pub(crate) formats: TargetFormats,
    pub(crate) interior: Option<Arc<FillPipelines>>,
    pub(crate) lines: Arc<LineStages>,
}

impl Pipelines {
    /// Builds them.
    pub(crate) fn new(device: &wgpu::Device, options: &EdgeMeshOptions, formats: TargetFormats) -> Self {
        let fill = |style| Some(Arc::new(FillPipelines::new(device, formats, style)));
        Self {
            options: *options,
            formats,
            interior: match options.interior {
                InteriorChoice::Paper => fill(FillStyle::PAPER),
                InteriorChoice::DepthOnly => fill(FillStyle::DEPTH),
                InteriorChoice::None => None,
            },
            lines: Arc::new(LineStages::new(device, options, formats)),
        }
    }
}

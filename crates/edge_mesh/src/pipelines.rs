//! [`Pipelines`]: what all renderers with the same options, on the same device and formats, share.

use crate::as_printed::AsPrintedStage;
use crate::lines::LineStages;
use crate::options::{ArithmeticChoice, CullChoice, EdgeMeshOptions};
use silhouette_core::line_style::InteriorChoice;
use silhouette_gpu::{Cull, FillPipelines, FillStyle, TargetFormats};
use std::sync::Arc;

/// The pipelines of a set of options.
#[derive(Debug)]
pub struct Pipelines {
    pub(crate) options: EdgeMeshOptions,
    pub(crate) formats: TargetFormats,
    /// With back faces, and without them, as far as a view may need either.
    pub(crate) interior: [Option<Arc<FillPipelines>>; 2],
    pub(crate) lines: Stages,
}

/// What draws lines.
#[derive(Debug)]
pub(crate) enum Stages {
    Corrected(Arc<LineStages>),
    AsPrinted(AsPrintedStage),
}

impl Pipelines {
    /// Builds them.
    pub(crate) fn new(device: &wgpu::Device, options: &EdgeMeshOptions, formats: TargetFormats) -> Self {
        let style = match options.interior {
            InteriorChoice::Paper => Some(FillStyle::PAPER),
            InteriorChoice::DepthOnly => Some(FillStyle::DEPTH),
            InteriorChoice::None => None,
        };
        let fill = |never: CullChoice, cull| {
            let style = style.filter(|_| options.cull != never)?;
            Some(Arc::new(FillPipelines::new(device, formats, FillStyle { cull, ..style })))
        };
        Self {
            options: *options,
            formats,
            interior: [fill(CullChoice::Back, Cull::None), fill(CullChoice::None, Cull::Back)],
            lines: match options.arithmetic {
                ArithmeticChoice::Corrected => Stages::Corrected(Arc::new(LineStages::new(device, options, formats))),
                ArithmeticChoice::AsPrinted => {
                    let ink = options.pens()[0].ink;
                    Stages::AsPrinted(AsPrintedStage::new(device, ink, formats))
                }
            },
        }
    }
}

//! [`TextureLines`]: outlines from the margin of the visibility function (equation 5).

use super::options::{Inside, WidthLaw, texture_options};
use super::pipelines::MethodPipelines;
use super::texture::SOURCE;
use super::textures::Textures;
use crate::gpu::{Drawing, OutlineStyle, OutlineWidth, TextureRenderer, TextureStyle};
use crate::silhouette_texture::SilhouetteTexture;
use silhouette_core::method::{Method, MethodGuide, MethodInfo, MethodOptions, PrepareError};
use silhouette_core::prepared::Artefact;
use silhouette_core::{PreparedMesh, Progress};
use silhouette_gpu::{Color, DrawsLines, Interior, MeshBuffers, PenPlacement, RendererError, TargetFormats};
use std::sync::Arc;

texture_options! {
    /// Options of [`TextureLines`].
    pub struct TextureLinesOptions {
        /// Width of lines, half of it outside of the outline.
        pub width_px: f64 = number("width", 0.0..=500.0 "px", default 1.5),
        /// How the width is kept.
        pub law: WidthLaw = choice("law"),
        /// Width as printed, in radians times the depth in radii of the hull.
        pub sigma: f64 = number("sigma", 0.0..=1.0, default 0.01),
        /// What is drawn inside of outlines.
        pub interior: Inside = choice("interior"),
    }
}

/// Inner and outer outlines, drawn from the hull and texture of [`Texture`](super::Texture): ink where the angle of view is close
/// to the border of the lobe.
#[derive(Debug, Clone)]
pub struct TextureLines {
    options: TextureLinesOptions,
    texture: Arc<SilhouetteTexture>,
}

impl Method for TextureLines {
    type Options = TextureLinesOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "texture-lines",
        summary: "Draws outlines from the 3-D texture of the method texture: ink where pixels hardly show the mesh.",
        source: SOURCE,
        exact: false,
        needs: &[Textures::NAME],
        options: TextureLinesOptions::SPECS,
        guide: MethodGuide {
            origin: "Wu et al. 2006, Eq. 5, of even width",
            yields: "ink",
            accuracy: "no: as `texture`",
            cost: "as `texture`",
            memory: "as `texture`",
            choose_when: "you draw `texture` and want its outlines as lines",
            limits: "as `texture`; loses many of the loops inside of the outline",
        },
        published: &[],
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &TextureLinesOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let textures = mesh.artefact::<Textures>(Self::INFO.name, progress)?;
        let texture = textures.get(mesh.mesh(), &options.bake(), progress)?;
        Ok(Self { options: *options, texture })
    }

    fn bytes(&self) -> usize {
        self.texture.bytes()
    }
}

impl DrawsLines for TextureLines {
    type Pipelines = MethodPipelines;
    type Renderer = TextureRenderer;

    fn pen_placement(&self) -> PenPlacement {
        PenPlacement::Centred
    }

    fn pipelines(&self, device: &wgpu::Device, formats: TargetFormats) -> Result<MethodPipelines, RendererError> {
        let TextureLinesOptions { width_px: px, law, sigma, interior, lookup, filter, .. } = self.options;
        let width = match law {
            WidthLaw::Gradient => OutlineWidth::Gradient { px },
            WidthLaw::Gap => OutlineWidth::Gap { px },
            WidthLaw::AsPrinted => OutlineWidth::AsPrinted { sigma },
        };
        let interior = match interior {
            Inside::Paper => Interior::Paper(Color::WHITE),
            Inside::DepthOnly => Interior::DepthOnly,
            Inside::None => Interior::None,
        };
        let outlines = OutlineStyle { width, ink: Color::BLACK, interior };
        let style = TextureStyle { azimuths: lookup, ..TextureStyle::new(Drawing::Outlines(outlines)) };
        Ok(MethodPipelines::new(device, formats, style, &self.texture, filter))
    }

    fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        pipelines: &Arc<MethodPipelines>,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<TextureRenderer, RendererError> {
        pipelines.renderer(device, queue, mesh)
    }
}

//! [`Texture`]: the object, cut out of its hull.

use super::options::texture_options;
use super::pipelines::MethodPipelines;
use super::published::PUBLISHED;
use super::textures::Textures;
use crate::gpu::{Drawing, Edge, Shading, TextureRenderer, TextureStyle};
use crate::silhouette_texture::SilhouetteTexture;
use silhouette_core::method::{Method, MethodGuide, MethodInfo, MethodOptions, PrepareError, Source};
use silhouette_core::prepared::Artefact;
use silhouette_core::{PreparedMesh, Progress};
use silhouette_gpu::{FillsImage, MeshBuffers, RendererError, TargetFormats};
use std::sync::Arc;

/// Where the methods of this crate were published.
pub(super) const SOURCE: Source = Source {
    authors: "Hongzhi Wu, Li-Yi Wei, Xi Wang, Baining Guo",
    title: "Silhouette Texture",
    venue: "Eurographics Symposium on Rendering",
    year: 2006,
};

texture_options! {
    /// Options of [`Texture`].
    pub struct TextureOptions {
        /// How edges are cut: at whole pixels, or at each of four samples.
        pub edge: Edge = choice("edge"),
    }
}

/// The object's surface with its outlines, drawn from a hull of few vertices and a 3-D texture: one lookup per fragment.
///
/// Preparation finds the hull and bakes the texture, for seconds to minutes, unless the mesh [has been given](Textures) one. A
/// frame is O(hull faces + pixels of the hull), whatever the object's faces.
#[derive(Debug, Clone)]
pub struct Texture {
    options: TextureOptions,
    texture: Arc<SilhouetteTexture>,
}

impl Texture {
    /// What is drawn.
    pub fn texture(&self) -> &Arc<SilhouetteTexture> {
        &self.texture
    }
}

impl Method for Texture {
    type Options = TextureOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "texture",
        summary: "Cuts the mesh out of a coarse hull: a 3-D texture on the hull says which pixels show the mesh.",
        source: SOURCE,
        exact: false,
        needs: &[Textures::NAME],
        options: TextureOptions::SPECS,
        guide: MethodGuide {
            origin: "Wu et al. 2006, corrected",
            yields: "a filled image with inner and outer outlines, from a coarse hull and a 3-D texture",
            accuracy: "no: as far as its lobes and samples go",
            cost: "a bake of seconds to minutes once; then O(hull faces + pixels of the hull) on the adapter, none \
                   on the processor",
            memory: "16 MiB of angles at 512 x 512 x 64, and 12.5 MiB of colours, normals and gaps; a quarter at 256 \
                     x 256",
            choose_when: "frame time near by counts more than memory and the last half percent of the outline, and \
                          the mesh does not move; at equal bytes `lod-mesh` has the better outline",
            limits: "holes open between thin parts that stand before each other; outlines swim by about a thousandth \
                     of the picture's height while the view changes; does not follow a mesh that moves",
        },
        published: PUBLISHED,
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &TextureOptions,
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

impl FillsImage for Texture {
    type Pipelines = MethodPipelines;
    type Renderer = TextureRenderer;

    fn pipelines(&self, device: &wgpu::Device, formats: TargetFormats) -> Result<MethodPipelines, RendererError> {
        let TextureOptions { edge, lookup, filter, .. } = self.options;
        let style = TextureStyle { edge, azimuths: lookup, ..TextureStyle::new(Drawing::Surface(Shading::Lit)) };
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

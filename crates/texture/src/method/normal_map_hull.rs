//! [`NormalMapHull`]: the whole hull, with the object's colours and normals.

use super::options::BakeChoice;
use super::pipelines::MethodPipelines;
use super::texture::SOURCE;
use super::textures::Textures;
use crate::bake::BakeOptions;
use crate::gpu::{Drawing, Filtering, Shading, TextureRenderer, TextureStyle};
use crate::silhouette_texture::SilhouetteTexture;
use crate::volume_size::VolumeSize;
use silhouette_core::method::{Method, MethodGuide, MethodInfo, MethodOptions, PrepareError};
use silhouette_core::prepared::Artefact;
use silhouette_core::{PreparedMesh, Progress};
use silhouette_gpu::{FillsImage, MeshBuffers, RendererError, TargetFormats};
use std::sync::Arc;

/// The fewest azimuths that a texture can have: of one that only serves for its colours and normals.
const FEWEST_AZIMUTHS: u32 = 3;

silhouette_core::method_options! {
    /// Options of [`NormalMapHull`].
    pub struct NormalMapHullOptions {
        /// Most vertices of the hull.
        pub hull_vertices: u32 = whole("hull-vertices", 4..=1000000, default 500, sweep log 100..=2000),
        /// Texels of colours and normals along either side of their map, in pairs.
        pub size: u32 = whole("size", 16..=16384 "texels", default 512, sweep log 128..=1024),
        /// Edges of the mesh whose faces differ by more are shaded as sharp.
        pub crease_deg: f64 = number("crease", 0.0..=180.0 "degrees", default 60.0),
    }
}

/// The hull of [`Texture`](super::Texture) with the object's colours and normals, and with its own outline: what the paper compares
/// with (figure 6).
#[derive(Debug, Clone)]
pub struct NormalMapHull {
    texture: Arc<SilhouetteTexture>,
}

impl Method for NormalMapHull {
    type Options = NormalMapHullOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "normal-map-hull",
        summary: "Draws the coarse hull of the method texture with the colours and normals of the mesh, and nothing cut away.",
        source: SOURCE,
        exact: false,
        needs: &[Textures::NAME],
        options: NormalMapHullOptions::SPECS,
        guide: MethodGuide {
            origin: "the hull of `texture` with the mesh's colours and normals",
            yields: "a filled image",
            accuracy: "no: its outline is that of the hull",
            cost: "as `texture`",
            memory: "12 bytes per texel of colour and normal",
            choose_when: "you compare `texture` with what it improves on",
            limits: "every outline is that of the coarse hull",
        },
        published: &[],
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &NormalMapHullOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let side = options.size / BakeOptions::default().detail;
        let size = VolumeSize { width: side, height: side, azimuths: FEWEST_AZIMUTHS, pages: 1 };
        let bake = BakeOptions { size, crease_deg: options.crease_deg, ..BakeOptions::default() };
        let choice = BakeChoice { hull_vertices: options.hull_vertices, options: bake, terms: 0 };
        let textures = mesh.artefact::<Textures>(Self::INFO.name, progress)?;
        Ok(Self { texture: textures.get(mesh.mesh(), &choice, progress)? })
    }

    fn bytes(&self) -> usize {
        self.texture.bytes()
    }
}

impl FillsImage for NormalMapHull {
    type Pipelines = MethodPipelines;
    type Renderer = TextureRenderer;

    fn pipelines(&self, device: &wgpu::Device, formats: TargetFormats) -> Result<MethodPipelines, RendererError> {
        let style = TextureStyle::new(Drawing::Hull(Shading::Lit));
        Ok(MethodPipelines::new(device, formats, style, &self.texture, Filtering::default()))
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

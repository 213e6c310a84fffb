//! What this workspace adds to the engine: one renderer per object.

use crate::device::Device;
use crate::scene::Scene;
use crate::shading::DEPTH;
use silhouette_core::view::DepthDirection;
use silhouette_core::{Method, PreparedMesh, Topology};
use silhouette_core::{NoProgress, method::NoOptions};
use silhouette_extraction::BruteForceSimd;
use silhouette_gpu::{
    DrawsLines, EdgeRenderer, FrameRenderer, Interior, MeshBuffers, Pen, PenPlacement, StrokePipelines, StrokeRenderer,
    StrokeStyle, TargetFormats,
};
use silhouette_image_precision::options::InteriorChoice;
use silhouette_image_precision::{ImagePrecision, ImagePrecisionOptions};
use std::error::Error;
use std::sync::Arc;

/// Width of all lines in pixels.
const WIDTH_PX: f64 = 3.0;

/// Renderers of the torus and of the knot.
pub struct Lines {
    torus: EdgeRenderer<BruteForceSimd>,
    knot: <ImagePrecision as DrawsLines>::Renderer,
}

impl Lines {
    /// Lines over what the engine shades, or `alone`: then objects hide lines, but show no colour.
    pub fn new(
        device: &Device,
        scene: &Scene,
        color: wgpu::TextureFormat,
        samples: u32,
        alone: bool,
    ) -> Result<Self, Box<dyn Error>> {
        let Device { device, queue } = device;
        let formats = TargetFormats { color, depth: DEPTH, depth_direction: DepthDirection::Reversed, samples };
        let [torus, knot] = &scene.objects;

        let prepared = Arc::new(PreparedMesh::new(Arc::clone(&torus.mesh)));
        let style = StrokeStyle {
            pen: Pen { width_px: WIDTH_PX, placement: PenPlacement::Centred },
            interior: if alone { Interior::DepthOnly } else { Interior::None },
            ..StrokeStyle::default()
        };
        let pipelines = Arc::new(StrokePipelines::new(device, formats, style));
        let buffers = Arc::new(MeshBuffers::new(device, queue, &torus.mesh)?);
        let strokes = StrokeRenderer::new(device, &pipelines, &buffers);
        let topology = prepared.artefact::<Topology>("engine", &NoProgress)?;
        let extractor = BruteForceSimd::new(&prepared, NoOptions)?;
        let torus = EdgeRenderer::new(extractor, Arc::clone(&torus.mesh), topology, strokes);

        let prepared = Arc::new(PreparedMesh::new(Arc::clone(&knot.mesh)));
        let options = ImagePrecisionOptions {
            width: WIDTH_PX,
            interior: if alone { InteriorChoice::DepthOnly } else { InteriorChoice::None },
            ..ImagePrecisionOptions::default()
        };
        let method = ImagePrecision::new(&prepared, options)?;
        let pipelines = Arc::new(method.pipelines(device, formats)?);
        let bounds = scene.moving_bounds().ok_or("the knot has faces")?;
        let triangles = knot.mesh.triangles();
        let buffers = MeshBuffers::from_position_buffer(device, queue, knot.positions.clone(), triangles, bounds)?;
        let knot = method.renderer(device, queue, &pipelines, &Arc::new(buffers))?;
        Ok(Self { torus, knot })
    }

    /// Hides the torus's lines behind whatever `depth` holds, the knot included.
    pub fn hide_behind(&mut self, depth: wgpu::TextureView) {
        self.torus.strokes_mut().set_scene_depth(Some(depth));
    }

    /// Uploads the view.
    pub fn prepare(&mut self, device: &Device, scene: &Scene) -> Result<(), Box<dyn Error>> {
        let [torus, knot] = &scene.objects;
        self.torus.prepare(&device.device, &device.queue, &scene.frame_view(torus)?)?;
        self.knot.prepare(&device.device, &device.queue, &scene.frame_view(knot)?)?;
        Ok(())
    }

    /// Records what comes before the engine's pass.
    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        self.torus.encode(encoder);
        self.knot.encode(encoder);
    }

    /// Records the lines in the engine's pass. Interiors of all objects come before lines of any: draw in two rounds where
    /// lines are alone. The torus's interior is drawn first, and its lines are hidden by the depth of the whole scene.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.torus.draw(pass);
        self.knot.draw(pass);
    }
}

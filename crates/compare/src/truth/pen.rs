//! The truth of one view: its visible lines, and pictures of them by any kind of pen.

use super::TrueLines;
use super::sampling::sample_lines;
use super::strokes::{polylines, strokes};
use glam::DVec2;
use silhouette_core::method::PrepareError;
use silhouette_core::view::Camera;
use silhouette_core::{EdgeId, ExtractsEdges, ExtractsLoops, Method, PreparedMesh, Progress};
use silhouette_core::{SilhouetteEdges, SilhouetteLoops, Topology};
use silhouette_extraction::BruteForce;
use silhouette_gpu::{MeshBuffers, MeshTooLarge, Pen};
use silhouette_render::{
    FillStyle, Gpu, GpuError, Image, LineStyle, Polylines, ReferenceRenderer, Scene, ScreenSegment,
};
use std::sync::Arc;

/// Why there is no truth.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TruthError {
    /// The brute-force extraction could not be prepared.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The device's buffers cannot hold the mesh.
    #[error(transparent)]
    MeshTooLarge(#[from] MeshTooLarge),
    /// The device failed.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

/// Finds the truth of any view of a mesh.
pub struct TruthFinder {
    mesh: Arc<PreparedMesh>,
    topology: Arc<Topology>,
    buffers: MeshBuffers,
    reference: ReferenceRenderer,
    oracle: BruteForce,
    supersampling: u32,
}

/// The truth of one view.
#[derive(Debug)]
pub struct Truth {
    /// The view.
    pub camera: Camera,
    /// All silhouette edges, visible or not.
    pub edges: SilhouetteEdges,
    /// The visible lines.
    pub lines: TrueLines,
    /// All lines, visible or not, a front face on their left.
    polylines: Polylines,
}

impl TruthFinder {
    /// Prepares for a mesh: topology, buffers, pipelines. `supersampling` is the number of samples a pixel along each axis.
    ///
    /// # Errors
    /// [`TruthError`].
    pub fn new(
        gpu: &Gpu,
        mesh: &Arc<PreparedMesh>,
        supersampling: u32,
        progress: &dyn Progress,
    ) -> Result<Self, TruthError> {
        let options = silhouette_core::method::OptionValues::defaults(BruteForce::INFO.options);
        Ok(Self {
            mesh: Arc::clone(mesh),
            topology: mesh.artefact("truth", progress).map_err(PrepareError::from)?,
            buffers: MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh())?,
            reference: ReferenceRenderer::new(gpu)?,
            oracle: BruteForce::prepare(mesh, &options, progress)?,
            supersampling,
        })
    }

    /// Number of edges of the mesh.
    pub fn edge_count(&self) -> usize {
        self.topology.edge_count()
    }

    /// The truth of a view. O(F + pixels x samples + length of lines).
    ///
    /// # Errors
    /// [`TruthError::Gpu`].
    pub fn find(&mut self, gpu: &Gpu, camera: &Camera) -> Result<Truth, TruthError> {
        let mut edges = SilhouetteEdges::default();
        let mut loops = SilhouetteLoops::default();
        self.oracle.extract_edges(&camera.viewpoint(), &mut edges);
        self.oracle.extract_loops(&camera.viewpoint(), &mut loops);
        let mesh = self.mesh.mesh();
        let strokes = strokes(mesh, &self.topology, &loops);

        let depth = self.reference.depth(gpu, &self.buffers, camera, self.supersampling)?;
        let position =
            |edge: EdgeId| self.topology.end_points(edge).map(|vertex| mesh.positions()[vertex.index()].as_dvec3());
        let mut current: Option<(EdgeId, Option<ScreenSegment>)> = None;
        let lines = sample_lines(mesh, &strokes, camera, |point| {
            if current.as_ref().is_none_or(|(edge, _)| *edge != point.edge) {
                let [a, b] = position(point.edge);
                current = Some((point.edge, depth.project(a, b)));
            }
            let segment = current.as_ref().and_then(|(_, segment)| segment.as_ref());
            let at = point.seen.pixel * f64::from(self.supersampling);
            segment.is_some_and(|segment| depth.visible_at(segment, share_along(segment, at)))
        });
        Ok(Truth { camera: *camera, edges, lines, polylines: polylines(mesh, &strokes) })
    }

    /// All silhouette edges of a view as if nothing hid them. O(F + length of lines).
    pub fn lines_seen_or_not(&mut self, camera: &Camera) -> TrueLines {
        let mut loops = SilhouetteLoops::default();
        self.oracle.extract_loops(&camera.viewpoint(), &mut loops);
        let strokes = strokes(self.mesh.mesh(), &self.topology, &loops);
        sample_lines(self.mesh.mesh(), &strokes, camera, |_| true)
    }

    /// The visible lines of a view drawn in black on white paper.
    ///
    /// # Errors
    /// [`TruthError::Gpu`].
    pub fn draw(&mut self, gpu: &Gpu, truth: &Truth, pen: Pen) -> Result<Image, TruthError> {
        let scene = Scene {
            mesh: &self.buffers,
            fill: FillStyle::PAPER,
            lines: &truth.polylines,
            style: LineStyle { pen, ..LineStyle::default() },
            camera: truth.camera,
            paper: crate::drawing::PAPER,
        };
        Ok(self.reference.image(gpu, &scene, self.supersampling)?)
    }
}

/// How far along a segment the point on it is that lies closest to `at`, 0 to 1.
fn share_along(segment: &ScreenSegment, at: DVec2) -> f64 {
    let (from, to) = (segment.at(0.0), segment.at(1.0));
    let along = to - from;
    let length_squared = along.length_squared();
    if length_squared > 0.0 { ((at - from).dot(along) / length_squared).clamp(0.0, 1.0) } else { 0.5 }
}

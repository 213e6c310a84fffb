//! [`Entry`]: a method with what it can do, its type erased.

use silhouette_core::glam::Vec3;
use silhouette_core::method::{
    ExtractionStats, ExtractsCurves, ExtractsMovingEdges, OptionValues, PositionsError, PrepareError,
};
use silhouette_core::{ExtractsEdges, ExtractsLoops, Method, MethodInfo, MethodOptions, PreparedMesh, Progress};
use silhouette_core::{SilhouetteEdges, Viewpoint};
use silhouette_gpu::{DrawsLines, FillsImage, FrameRenderer, MeshBuffers, PenPlacement, RendererError, TargetFormats};
use silhouette_render::Gpu;
use silhouette_smoothing::{MakesTriangles, Remesher};
use std::fmt;
use std::sync::Arc;

/// What a method can do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct Capabilities {
    /// Extracts silhouette edges.
    pub edges: bool,
    /// Extracts silhouette edges of a mesh whose vertices move.
    pub moving_edges: bool,
    /// Extracts loops of silhouette half-edges.
    pub loops: bool,
    /// Extracts smooth curves.
    pub curves: bool,
    /// Draws lines itself.
    pub lines: bool,
    /// Fills the image of the mesh.
    pub fill: bool,
    /// Makes triangles of its own for each view.
    pub triangles: bool,
}

/// A method of a registry.
#[derive(Clone)]
pub struct Entry {
    info: &'static MethodInfo,
    capabilities: Capabilities,
    prepare: Arc<PrepareFn>,
}

type PrepareFn =
    dyn Fn(&Arc<PreparedMesh>, &OptionValues, &dyn Progress) -> Result<Prepared, PrepareError> + Send + Sync;

impl Entry {
    /// Begins an entry of the method `M`, which can do nothing yet.
    pub fn of<M: Method>() -> EntryBuilder<M> {
        EntryBuilder(Views {
            edges: None,
            moving_edges: None,
            loops: None,
            curves: None,
            lines: None,
            fill: None,
            triangles: None,
        })
    }

    /// What the method says of itself.
    pub fn info(&self) -> &'static MethodInfo {
        self.info
    }

    /// What the method can do.
    pub fn capabilities(&self) -> Capabilities {
        self.capabilities
    }

    /// Prepares the method for a mesh.
    ///
    /// # Errors
    /// [`PrepareError`]: cancelled, an option that does not fit, or a mesh that the method is not defined for.
    pub fn prepare(
        &self,
        mesh: &Arc<PreparedMesh>,
        options: &OptionValues,
        progress: &dyn Progress,
    ) -> Result<Prepared, PrepareError> {
        (self.prepare)(mesh, options, progress)
    }
}

impl fmt::Debug for Entry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Entry").field("name", &self.info.name).field("capabilities", &self.capabilities).finish()
    }
}

type MakeRemesher<M> = fn(&M) -> Box<dyn Remesher>;

/// How a value of type `M` is seen as each of its capabilities.
struct Views<M> {
    edges: Option<fn(&mut M) -> &mut dyn ExtractsEdges>,
    moving_edges: Option<fn(&mut M) -> &mut dyn ExtractsMovingEdges>,
    loops: Option<fn(&mut M) -> &mut dyn ExtractsLoops>,
    curves: Option<fn(&mut M) -> &mut dyn ExtractsCurves>,
    lines: Option<fn(&M) -> &dyn LineMethod>,
    fill: Option<fn(&M) -> &dyn FillMethod>,
    triangles: Option<MakeRemesher<M>>,
}

impl<M> Clone for Views<M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for Views<M> {}

/// An entry to which capabilities are added; [`Registry::with`](super::Registry::with) takes it.
pub struct EntryBuilder<M>(Views<M>);

impl<M: Method> EntryBuilder<M> {
    /// Adds edges.
    #[must_use]
    pub fn edges(self) -> Self
    where
        M: ExtractsEdges,
    {
        Self(Views { edges: Some(|method| method), ..self.0 })
    }

    /// Adds edges of a mesh whose vertices move.
    #[must_use]
    pub fn moving(self) -> Self
    where
        M: ExtractsMovingEdges,
    {
        Self(Views { edges: Some(|method| method), moving_edges: Some(|method| method), ..self.0 })
    }

    /// Adds loops, and the edges that they consist of.
    #[must_use]
    pub fn loops(self) -> Self
    where
        M: ExtractsLoops,
    {
        Self(Views { edges: Some(|method| method), loops: Some(|method| method), ..self.0 })
    }

    /// Adds curves.
    #[must_use]
    pub fn curves(self) -> Self
    where
        M: ExtractsCurves,
    {
        Self(Views { curves: Some(|method| method), ..self.0 })
    }

    /// Adds lines that the method draws itself.
    #[must_use]
    pub fn lines(self) -> Self
    where
        M: DrawsLines,
    {
        Self(Views { lines: Some(|method| method), ..self.0 })
    }

    /// Adds filled images.
    #[must_use]
    pub fn fill(self) -> Self
    where
        M: FillsImage,
    {
        Self(Views { fill: Some(|method| method), ..self.0 })
    }

    /// Adds triangles that the method makes for each view.
    #[must_use]
    pub fn triangles(self) -> Self
    where
        M: MakesTriangles,
    {
        Self(Views { triangles: Some(|method| Box::new(method.remesher())), ..self.0 })
    }
}

impl<M: Method> From<EntryBuilder<M>> for Entry {
    fn from(EntryBuilder(views): EntryBuilder<M>) -> Self {
        let capabilities = Capabilities {
            edges: views.edges.is_some(),
            moving_edges: views.moving_edges.is_some(),
            loops: views.loops.is_some(),
            curves: views.curves.is_some(),
            lines: views.lines.is_some(),
            fill: views.fill.is_some(),
            triangles: views.triangles.is_some(),
        };
        let prepare: Arc<PrepareFn> = Arc::new(move |mesh, options, progress| {
            let method = M::prepare(mesh, &M::Options::read(options)?, progress)?;
            Ok(Prepared(Box::new(Seen { method, views })))
        });
        Self { info: const { &M::INFO }, capabilities, prepare }
    }
}

/// A method prepared for a mesh, asked for what it can do.
pub struct Prepared(Box<dyn Answers>);

impl Prepared {
    /// Bytes it holds beyond the artefacts of its mesh.
    pub fn bytes(&self) -> usize {
        self.0.bytes()
    }

    /// The method as one that extracts edges.
    pub fn edges(&mut self) -> Option<&mut dyn ExtractsEdges> {
        self.0.edges()
    }

    /// The method as an extractor of edges that outlives this value.
    pub fn into_edges(self) -> Option<Box<dyn ExtractsEdges>> {
        self.0.into_edges()
    }

    /// The method as an extractor of edges of a mesh that moves, which outlives this value.
    ///
    /// # Errors
    /// The value itself, where the method extracts no such edges.
    pub fn into_moving_edges(self) -> Result<Box<dyn ExtractsMovingEdges>, Self> {
        self.0.into_moving_edges().map_err(Self)
    }

    /// The method as one that extracts loops.
    pub fn loops(&mut self) -> Option<&mut dyn ExtractsLoops> {
        self.0.loops()
    }

    /// The method as one that extracts curves.
    pub fn curves(&mut self) -> Option<&mut dyn ExtractsCurves> {
        self.0.curves()
    }

    /// The method as one that draws lines.
    pub fn lines(&self) -> Option<&dyn LineMethod> {
        self.0.lines()
    }

    /// The method as one that fills images.
    pub fn fill(&self) -> Option<&dyn FillMethod> {
        self.0.fill()
    }

    /// The method as one that makes triangles of its own for each view.
    pub fn triangles(&self) -> Option<Box<dyn Remesher>> {
        self.0.triangles()
    }
}

/// [`DrawsLines`] with its types erased.
pub trait LineMethod: Send {
    /// See [`DrawsLines::pen_placement`].
    fn pen_placement(&self) -> PenPlacement;

    /// A renderer with pipelines of its own; see [`DrawsLines::renderer`].
    ///
    /// # Errors
    /// [`RendererError`]: the mesh is too large for the device, or the device lacks what the options ask for.
    fn renderer(
        &self,
        gpu: &Gpu,
        formats: TargetFormats,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<Box<dyn FrameRenderer>, RendererError>;
}

/// [`FillsImage`] with its types erased.
pub trait FillMethod: Send {
    /// A renderer with pipelines of its own; see [`FillsImage::renderer`].
    ///
    /// # Errors
    /// [`RendererError`]: the mesh is too large for the device, or the device lacks what the options ask for.
    fn renderer(
        &self,
        gpu: &Gpu,
        formats: TargetFormats,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<Box<dyn FrameRenderer>, RendererError>;
}

impl<M: DrawsLines> LineMethod for M {
    fn pen_placement(&self) -> PenPlacement {
        DrawsLines::pen_placement(self)
    }

    fn renderer(
        &self,
        gpu: &Gpu,
        formats: TargetFormats,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<Box<dyn FrameRenderer>, RendererError> {
        let pipelines = Arc::new(DrawsLines::pipelines(self, gpu.device(), formats)?);
        Ok(Box::new(DrawsLines::renderer(self, gpu.device(), gpu.queue(), &pipelines, mesh)?))
    }
}

impl<M: FillsImage> FillMethod for M {
    fn renderer(
        &self,
        gpu: &Gpu,
        formats: TargetFormats,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<Box<dyn FrameRenderer>, RendererError> {
        let pipelines = Arc::new(FillsImage::pipelines(self, gpu.device(), formats)?);
        Ok(Box::new(FillsImage::renderer(self, gpu.device(), gpu.queue(), &pipelines, mesh)?))
    }
}

/// What [`Prepared`] asks, for a method of any type.
trait Answers: Send {
    fn bytes(&self) -> usize;
    fn edges(&mut self) -> Option<&mut dyn ExtractsEdges>;
    fn into_edges(self: Box<Self>) -> Option<Box<dyn ExtractsEdges>>;
    fn into_moving_edges(self: Box<Self>) -> Result<Box<dyn ExtractsMovingEdges>, Box<dyn Answers>>;
    fn loops(&mut self) -> Option<&mut dyn ExtractsLoops>;
    fn curves(&mut self) -> Option<&mut dyn ExtractsCurves>;
    fn lines(&self) -> Option<&dyn LineMethod>;
    fn fill(&self) -> Option<&dyn FillMethod>;
    fn triangles(&self) -> Option<Box<dyn Remesher>>;
}

/// A prepared method with its views.
struct Seen<M> {
    method: M,
    views: Views<M>,
}

impl<M: Method> Answers for Seen<M> {
    fn bytes(&self) -> usize {
        self.method.bytes()
    }
    fn edges(&mut self) -> Option<&mut dyn ExtractsEdges> {
        Some(self.views.edges?(&mut self.method))
    }
    fn into_edges(self: Box<Self>) -> Option<Box<dyn ExtractsEdges>> {
        let view = self.views.edges?;
        Some(Box::new(Extractor { method: self.method, view }))
    }
    fn into_moving_edges(self: Box<Self>) -> Result<Box<dyn ExtractsMovingEdges>, Box<dyn Answers>> {
        match self.views.moving_edges {
            Some(view) => Ok(Box::new(MovingExtractor { method: self.method, view })),
            None => Err(self),
        }
    }
    fn loops(&mut self) -> Option<&mut dyn ExtractsLoops> {
        Some(self.views.loops?(&mut self.method))
    }
    fn curves(&mut self) -> Option<&mut dyn ExtractsCurves> {
        Some(self.views.curves?(&mut self.method))
    }
    fn lines(&self) -> Option<&dyn LineMethod> {
        Some(self.views.lines?(&self.method))
    }
    fn fill(&self) -> Option<&dyn FillMethod> {
        Some(self.views.fill?(&self.method))
    }
    fn triangles(&self) -> Option<Box<dyn Remesher>> {
        Some(self.views.triangles?(&self.method))
    }
}

/// A method seen as an extractor of edges for good.
struct Extractor<M> {
    method: M,
    view: fn(&mut M) -> &mut dyn ExtractsEdges,
}

impl<M: Send> ExtractsEdges for Extractor<M> {
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        (self.view)(&mut self.method).extract_edges(viewpoint, out)
    }
}

/// A method seen for good as an extractor of edges of a mesh that moves.
struct MovingExtractor<M> {
    method: M,
    view: fn(&mut M) -> &mut dyn ExtractsMovingEdges,
}

impl<M: Send> ExtractsEdges for MovingExtractor<M> {
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        (self.view)(&mut self.method).extract_edges(viewpoint, out)
    }
}

impl<M: Send> ExtractsMovingEdges for MovingExtractor<M> {
    fn update_positions(&mut self, positions: &[Vec3]) -> Result<(), PositionsError> {
        (self.view)(&mut self.method).update_positions(positions)
    }
}

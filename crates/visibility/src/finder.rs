//! [`LineFinder`]: the steps in order.

use crate::contours::{Contour, ContourFinder, UnpairedEdges};
use crate::face_tree::FaceTree;
use crate::frame::{ClippedEdge, PictureFrame};
use crate::gaps::Gap;
use crate::join::join;
use crate::lines::{LineStats, Lines};
use crate::options::LineOptions;
use crate::picture_grid::PictureGrid;
use crate::pieces::{ClearEdges, CutStats, CutterScratch, StrokeCutter, emit};
use crate::propagate::{CutStroke, Propagation};
use crate::scene::LineScene;
use crate::select::{FeatureEdges, mesh_strokes};
use crate::sight::Sight;
use crate::stroke::Stroke;
use crate::vertex_faces::VertexFaces;
use rayon::prelude::*;
use silhouette_core::method::{OptionValues, PrepareError};
use silhouette_core::{Camera, Cancelled, ExtractsEdges, FaceFacings, Method, Progress, SilhouetteEdges, Topology};
use silhouette_extraction::ClusterCones;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

/// Pairs of edge and contour that one view may test: about a minute of work on one core. A picture in which more pass
/// through the same cells is a tangle that no line drawing shows.
pub const MAX_PAIRS: u64 = 2_000_000_000;

/// Strokes that a task takes: some 0.1 ms of work.
const STROKES_PER_TASK: usize = 64;

/// Why there are no lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LineError {
    /// The work was stopped by its [`Progress`].
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// Too many edges lie over each other in this view.
    #[error(
        "more than {MAX_PAIRS} pairs of edges lie over each other in this view; choose another view or fewer kinds of edges"
    )]
    TooCrowded,
}

/// Finds the lines of any view of a scene.
pub struct LineFinder {
    scene: LineScene,
    topology: Arc<Topology>,
    tree: Arc<FaceTree>,
    unpaired: Arc<UnpairedEdges>,
    vertex_faces: Arc<VertexFaces>,
    /// Largest absolute coordinate.
    reach: f64,
    facings: FaceFacings,
    silhouette: SilhouetteEdges,
    features: Option<(LineOptions, FeatureEdges)>,
    clear_edges: ClearEdges,
    /// Finds the silhouette without looking at all faces, where many views are wanted.
    cones: Option<ClusterCones>,
}

/// An edge whose place in the picture is less certain than this comes so close to the eye that it may pass through it.
const NEAR_EYE_DOUBT_PX: f64 = 1e-6;

/// Who asks for artefacts.
const NAME: &str = "visible-lines";

impl LineFinder {
    /// Prepares a scene: topology and face tree. O(F log F).
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn new(scene: LineScene, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let mesh = scene.mesh();
        let (topology, tree) = rayon::join(|| mesh.artefact(NAME, progress), || mesh.artefact(NAME, progress));
        let (topology, tree) = (topology?, tree?);
        let (unpaired, vertex_faces) = (mesh.artefact(NAME, progress)?, mesh.artefact(NAME, progress)?);
        let edge_count = Topology::edge_count(&topology);
        let reach = mesh.mesh().bounds().map_or(0.0, |bounds| bounds.min.abs().max(bounds.max.abs()).max_element());
        Ok(Self {
            topology,
            tree,
            unpaired,
            vertex_faces,
            reach,
            facings: FaceFacings::default(),
            silhouette: SilhouetteEdges::default(),
            features: None,
            clear_edges: ClearEdges::new(edge_count),
            cones: None,
            scene,
        })
    }

    /// The same for many views: also prepares a search tree over planes, after which the silhouette of a view is found in
    /// time that grows with its length instead of with the mesh. About twice the preparation.
    ///
    /// # Errors
    /// [`PrepareError`] when `progress` cancels.
    pub fn for_many_views(scene: LineScene, progress: &dyn Progress) -> Result<Self, PrepareError> {
        let options = OptionValues::defaults(ClusterCones::INFO.options);
        let cones = ClusterCones::prepare(scene.mesh(), &options, progress)?;
        Ok(Self { cones: Some(cones), ..Self::new(scene, progress)? })
    }

    /// The scene.
    pub fn scene(&self) -> &LineScene {
        &self.scene
    }

    /// The lines of a view.
    ///
    /// # Errors
    /// [`LineError`].
    pub fn find(
        &mut self,
        camera: &Camera,
        options: &LineOptions,
        progress: &dyn Progress,
    ) -> Result<Lines, LineError> {
        let mut stats = LineStats::default();
        let started = Instant::now();
        progress.check()?;
        let viewpoint = camera.viewpoint();
        let mesh = self.scene.mesh().mesh();
        if let Some(cones) = &mut self.cones {
            cones.extract_edges(&viewpoint, &mut self.silhouette);
        } else {
            self.facings.classify(mesh, &viewpoint);
            self.silhouette = SilhouetteEdges::of(&self.topology, &self.facings);
        }
        if self.features.as_ref().is_none_or(|(of, _)| of != options) {
            self.features = Some((options.clone(), FeatureEdges::new(&self.scene, &self.topology, options)));
        }
        let finder = ContourFinder { mesh, topology: &self.topology, viewpoint };
        let contours = finder.find(&self.silhouette, &self.unpaired);
        let no_features = FeatureEdges::default();
        let features = self.features.as_ref().map_or(&no_features, |(_, features)| features);
        let strokes = mesh_strokes(&self.scene, &finder, &self.silhouette, features, options);
        stats.extract = started.elapsed();

        let started = Instant::now();
        progress.check()?;
        let frame = PictureFrame::new(camera, self.reach);
        let clip_contour = |contour: &Contour| frame.clip(contour.ends, 1.0);
        let clipped_contours: Vec<_> = contours.par_iter().map(clip_contour).collect();
        let grid = PictureGrid::new(&frame, &clipped_contours);
        // An edge through the eye has no place in the picture but a point.
        let clip_stroke = |stroke: &Stroke| {
            let clipped = frame.clip(stroke.ends, 0.0);
            clipped.filter(|edge| edge.doubt_px < NEAR_EYE_DOUBT_PX || !stroke.is_seen_end_on(&viewpoint))
        };
        let clipped: Vec<_> = strokes.strokes.par_iter().map(clip_stroke).collect();
        stats.project = started.elapsed();

        let started = Instant::now();
        let sight = Sight { mesh, tree: &self.tree, viewpoint };
        let cutter = StrokeCutter {
            strokes: &strokes,
            contours: &contours,
            clipped_contours: &clipped_contours,
            grid: &grid,
            finder,
            sight,
            clear_edges: &self.clear_edges,
        };
        let cuts = cut_all(&cutter, &clipped, progress)?;
        let propagation = Propagation { strokes: &strokes, sight, vertex_faces: &self.vertex_faces };
        let (layers, sight_lines) = propagation.decide(&cuts.strokes, &cuts.gaps);
        let mut pieces = Vec::with_capacity(cuts.gaps.len());
        for CutStroke { stroke, gaps, range, .. } in &cuts.strokes {
            emit(*stroke, *range, &cuts.gaps[gaps.clone()], |gap| layers[gaps.start + gap], &mut pieces);
        }
        stats.pieces = pieces.len() as u64;
        pieces.retain(|piece| piece.layers.invisibility() <= options.max_invisibility);
        stats.decide = started.elapsed();

        let started = Instant::now();
        let chains = join(&strokes, &pieces, &frame);
        stats.chain = started.elapsed();
        stats.edges = strokes.strokes.len() as u64;
        stats.contours = contours.len() as u64;
        (stats.pairs, stats.events, stats.sight_lines) = (cuts.stats.pairs, cuts.stats.events, sight_lines);
        Ok(Lines { camera: *camera, chains, outline: Vec::new(), stats })
    }
}

/// All strokes inside the picture with their gaps, in order.
#[derive(Default)]
struct Cuts {
    strokes: Vec<CutStroke>,
    gaps: Vec<Gap>,
    stats: CutStats,
}

fn cut_all(
    cutter: &StrokeCutter<'_>,
    clipped: &[Option<ClippedEdge>],
    progress: &dyn Progress,
) -> Result<Cuts, LineError> {
    progress.stage("visible lines", clipped.len() as u64);
    let pairs = AtomicU64::new(0);
    let cut_chunk = |scratch: &mut CutterScratch, (chunk, edges): (usize, &[Option<ClippedEdge>])| {
        if pairs.load(Ordering::Relaxed) > MAX_PAIRS {
            return Err(LineError::TooCrowded);
        }
        progress.check()?;
        let mut cuts = Cuts::default();
        for (place, edge) in edges.iter().enumerate() {
            if let Some(edge) = edge {
                let stroke = (chunk * STROKES_PER_TASK + place) as u32;
                let first = cuts.gaps.len();
                let touched = cutter.cut(stroke, edge, scratch, &mut cuts.gaps);
                cuts.strokes.push(CutStroke { stroke, gaps: first..cuts.gaps.len(), range: edge.range, touched });
            }
        }
        cuts.stats = std::mem::take(&mut scratch.stats);
        pairs.fetch_add(cuts.stats.pairs, Ordering::Relaxed);
        progress.advance(edges.len() as u64);
        Ok(cuts)
    };
    let chunks: Result<Vec<Cuts>, LineError> =
        clipped.par_chunks(STROKES_PER_TASK).enumerate().map_init(CutterScratch::default, cut_chunk).collect();
    let mut all = Cuts::default();
    for cuts in chunks? {
        let first = all.gaps.len();
        all.gaps.extend(cuts.gaps);
        all.strokes.extend(cuts.strokes.into_iter().map(|mut stroke| {
            stroke.gaps = stroke.gaps.start + first..stroke.gaps.end + first;
            stroke
        }));
        all.stats.pairs += cuts.stats.pairs;
        all.stats.events += cuts.stats.events;
    }
    if all.stats.pairs > MAX_PAIRS { Err(LineError::TooCrowded) } else { Ok(all) }
}

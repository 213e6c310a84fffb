//! [`LineFinder`]: the steps in order.

use crate::clear_edges::ClearEdges;
use crate::contours::{Contour, ContourFinder, EDGES_PER_TASK, UnpairedEdges, faces_at_eye};
use crate::curves::push_strokes;
use crate::cutter::StrokeCutter;
use crate::decide::{Decided, decide};
use crate::events::Depth;
use crate::face_tree::FaceTree;
use crate::frame::PictureFrame;
use crate::intersections::FaceIntersections;
use crate::join::join;
use crate::lines::{LineStats, Lines};
use crate::options::LineOptions;
use crate::outline::outermost_outline;
use crate::picture_grid::PictureGrid;
use crate::scene::LineScene;
use crate::select::{Selector, push_intersections};
use crate::sight::Sight;
use crate::stroke::Stroke;
use crate::vertex_faces::VertexFaces;
use rayon::prelude::*;
use silhouette_core::method::PrepareError;
use silhouette_core::{Camera, Cancelled, Progress, Topology};
use std::sync::Arc;
use std::time::Instant;

/// Most work that one view may take, in pairs of an edge and a contour that pass the same cell of the picture; what costs more
/// counts for more. Some ten seconds on one core; where all of it is exact tests, 6 s and 0.9 GB were measured. A picture that
/// takes more is a tangle that no line drawing shows.
pub const MAX_WORK: u64 = 2_000_000_000;

/// Why there are no lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LineError {
    /// The work was stopped by its [`Progress`].
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// Too many edges or faces lie over each other in this view.
    #[error("too many edges or faces lie over each other in this view; choose another view or fewer kinds of edges")]
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
    selector: Selector,
    clear_edges: ClearEdges,
}

/// An edge that is shorter in the picture may be seen end on.
const END_ON_PX: f64 = 1e-6;

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
        let reach = scene.reach();
        Ok(Self {
            topology,
            tree,
            unpaired,
            vertex_faces,
            reach,
            selector: Selector::default(),
            clear_edges: ClearEdges::new(edge_count),
            scene,
        })
    }

    /// The same for many views: also prepares a search tree over planes, after which the silhouette of a view is found in
    /// time that grows with its length instead of with the mesh, and asks of every edge whether it meets a face. Three to four
    /// times the preparation.
    ///
    /// # Errors
    /// [`PrepareError`] when `progress` cancels.
    pub fn for_many_views(scene: LineScene, progress: &dyn Progress) -> Result<Self, PrepareError> {
        let selector = Selector::for_many_views(&scene, progress)?;
        let finder = Self::new(scene, progress)?;
        let clear_edges = ClearEdges::of(finder.scene.mesh().mesh(), &finder.topology, &finder.tree, progress)?;
        Ok(Self { selector, clear_edges, ..finder })
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
        let at_eye = faces_at_eye(mesh, &self.tree, &viewpoint);
        let finder =
            ContourFinder { mesh, topology: &self.topology, unpaired: &self.unpaired, viewpoint, at_eye: &at_eye };
        self.selector.find_silhouette(mesh, &self.topology, &viewpoint);
        let contours = finder.find(self.selector.silhouette());
        let mut strokes = self.selector.strokes(&self.scene, &finder, &contours, options);
        let frame = PictureFrame::new(camera, self.reach);
        let mut first_id = mesh.vertex_count() as u32;
        if options.intersection {
            let found = self.scene.mesh().artefact::<FaceIntersections>(NAME, progress)?;
            first_id = push_intersections(&self.scene, &found, &mut strokes);
        }
        if options.curves {
            push_strokes(&self.scene, &frame, first_id, &mut strokes);
        }
        stats.extract = started.elapsed();

        let started = Instant::now();
        progress.check()?;
        let clip_contour = |contour: &Contour| frame.clip(contour.ends, 1.0);
        // An edge seen end on has no place in the picture but a point.
        let clip_stroke = |stroke: &Stroke| {
            let clipped = frame.clip_drawn(stroke.ends, 0.0);
            clipped.filter(|edge| edge.length_px() > END_ON_PX || !stroke.is_seen_end_on(&viewpoint))
        };
        let clipped_contours: Vec<_> = contours.par_iter().with_min_len(EDGES_PER_TASK).map(clip_contour).collect();
        let (grid, clipped): (_, Vec<_>) = rayon::join(
            || PictureGrid::new(&frame, &clipped_contours),
            || strokes.strokes.par_iter().with_min_len(EDGES_PER_TASK).map(clip_stroke).collect(),
        );
        stats.project = started.elapsed();

        let started = Instant::now();
        let sight = Sight { mesh, tree: &self.tree, viewpoint, depth: Depth::Nearer };
        let cutter = StrokeCutter {
            strokes: &strokes,
            contours: &contours,
            clipped_contours: &clipped_contours,
            grid: &grid,
            finder,
            sight,
            clear_edges: &self.clear_edges,
            depth: Depth::Nearer,
        };
        let Decided { mut pieces, stats: counted, sight_lines } =
            decide(&cutter, &self.vertex_faces, &clipped, progress)?;
        stats.pieces = pieces.len() as u64;
        pieces.retain(|piece| piece.layers.invisibility() <= options.max_invisibility);
        stats.decide = started.elapsed();

        let started = Instant::now();
        let chains = join(&self.scene, &strokes, &pieces, &frame);
        stats.chain = started.elapsed();
        stats.edges = strokes.strokes.len() as u64;
        stats.contours = contours.len() as u64;
        (stats.pairs, stats.events, stats.sight_lines) = (counted.pairs, counted.events, sight_lines);
        let started = Instant::now();
        let mut outline = Vec::new();
        if options.outline {
            let cutter = StrokeCutter { depth: Depth::Any, sight: Sight { depth: Depth::Any, ..sight }, ..cutter };
            outline = outermost_outline(&cutter, &frame, &self.vertex_faces, progress)?;
        }
        stats.outline = started.elapsed();
        Ok(Lines { camera: *camera, chains, outline, stats })
    }
}

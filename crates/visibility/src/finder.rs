//! [`LineFinder`]: the steps in order.

use crate::clear_edges::ClearEdges;
use crate::contours::EDGES_PER_TASK;
use crate::curves::push_strokes;
use crate::cut::{Cutter, PictureEdge, picture_edges};
use crate::decide::{Decided, decide};
use crate::face_tree::FaceTree;
use crate::frame::PictureFrame;
use crate::intersections::FaceIntersections;
use crate::join::join;
use crate::line_error::LineError;
use crate::lines::{LineStats, Lines};
use crate::options::LineOptions;
use crate::outline::{Outline, outline};
use crate::picture_grid::PictureGrid;
use crate::scene::{Extent, LineScene};
use crate::select::{Selector, push_intersections};
use crate::sight::Sight;
use crate::stroke::Stroke;
use crate::unpaired::UnpairedEdges;
use crate::vertex_faces::VertexFaces;
use crate::viewed_mesh::ViewedMesh;
use rayon::prelude::*;
use silhouette_core::method::PrepareError;
use silhouette_core::{Camera, Cancelled, DisplacedViewer, Progress, Topology, Viewpoint};
use std::sync::Arc;
use std::time::Instant;

/// Finds the lines of any view of a scene.
pub struct LineFinder {
    scene: LineScene,
    topology: Arc<Topology>,
    tree: Arc<FaceTree>,
    unpaired: Arc<UnpairedEdges>,
    vertex_faces: Arc<VertexFaces>,
    extent: Extent,
    selector: Selector,
    clear_edges: ClearEdges,
}

/// An edge that is shorter in the picture, beyond what rounding may add, may be seen end on.
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
        let extent = scene.extent();
        Ok(Self {
            topology,
            tree,
            unpaired,
            vertex_faces,
            extent,
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
        // Into the pool once, not for each of a dozen parallel loops, some of which take less than changing threads.
        rayon::scope(|_| self.find_in_pool(camera, options, progress))
    }

    fn find_in_pool(
        &mut self,
        camera: &Camera,
        options: &LineOptions,
        progress: &dyn Progress,
    ) -> Result<Lines, LineError> {
        let mut stats = LineStats::default();
        let started = Instant::now();
        progress.check()?;
        let viewpoint = camera.viewpoint();
        let (mesh, viewer) = (self.scene.mesh().mesh(), DisplacedViewer::new(viewpoint, self.extent.center()));
        let view = ViewedMesh { mesh, topology: &self.topology, unpaired: &self.unpaired, viewer };
        self.selector.find_silhouette(mesh, &self.topology, &viewer);
        let contours = view.contours(self.selector.silhouette());
        let mut strokes = self.selector.strokes(&self.scene, &view, &contours, options);
        let frame = PictureFrame::new(camera, self.extent.reach());
        let mut first_id = mesh.vertex_count() as u32;
        if options.intersection {
            let found = self.scene.mesh().artefact::<FaceIntersections>(NAME, progress)?;
            if found.is_too_crowded() {
                return Err(LineError::TooManyIntersections);
            }
            first_id = push_intersections(&self.scene, &found, &mut strokes);
        }
        if options.curves {
            push_strokes(&self.scene, &frame, first_id, &mut strokes);
        }
        let edges = picture_edges(&strokes, &contours);
        stats.extract = started.elapsed();

        let started = Instant::now();
        progress.check()?;
        let clip = |edge: &PictureEdge| frame.clip(edge.crossed.ends, 1.0);
        let clipped: Vec<_> = edges.par_iter().with_min_len(EDGES_PER_TASK).map(clip).collect();
        let drawn_range = |stroke: &Stroke| drawn_range(&frame, &viewpoint, stroke);
        let (grid, drawn): (_, Vec<_>) = rayon::join(
            || PictureGrid::new(&frame, &clipped, |index| edges[index].contour.is_some()),
            || strokes.strokes.par_iter().with_min_len(EDGES_PER_TASK).map(drawn_range).collect(),
        );
        stats.project = started.elapsed();

        let started = Instant::now();
        let sight = Sight { view, tree: &self.tree };
        let cutter = Cutter {
            strokes: &strokes,
            edges: &edges,
            clipped: &clipped,
            drawn: &drawn,
            grid: &grid,
            sight,
            clear_edges: &self.clear_edges,
        };
        let Decided { pieces, stats: counted, sight_lines } =
            decide(&cutter, &self.vertex_faces, options.max_invisibility, progress)?;
        stats.pieces = pieces.len() as u64;
        stats.decide = started.elapsed();

        let started = Instant::now();
        let chains = join(&self.scene, &strokes, &pieces, &frame);
        stats.chain = started.elapsed();
        stats.edges = strokes.strokes.len() as u64;
        stats.contours = contours.len() as u64;
        (stats.pairs, stats.events, stats.sight_lines) = (counted.pairs, counted.events, sight_lines);
        let started = Instant::now();
        let outline = if options.outline {
            outline(&view, &contours, &frame, &self.extent, progress)?
        } else {
            Outline::default()
        };
        stats.outline = started.elapsed();
        Ok(Lines { camera: *camera, chains, outline, origin: self.scene.mesh().mesh().origin(), stats })
    }

    /// The outline of a view: the boundary of the union of all projected faces. It is followed eight pictures beyond the
    /// picture on each side.
    ///
    /// For S silhouette edges and K crossings of those near the outline: O(F + S log S + K log K). A finder that was prepared
    /// for many views does without the O(F) where all of the scene lies within that window.
    ///
    /// # Errors
    /// [`LineError`].
    pub fn outline(&mut self, camera: &Camera, progress: &dyn Progress) -> Result<Outline, LineError> {
        progress.check()?;
        rayon::scope(|_| {
            let (mesh, viewer) =
                (self.scene.mesh().mesh(), DisplacedViewer::new(camera.viewpoint(), self.extent.center()));
            let view = ViewedMesh { mesh, topology: &self.topology, unpaired: &self.unpaired, viewer };
            self.selector.find_silhouette(mesh, &self.topology, &viewer);
            let contours = view.contours(self.selector.silhouette());
            outline(&view, &contours, &PictureFrame::new(camera, self.extent.reach()), &self.extent, progress)
        })
    }
}

/// What is drawn of a stroke: nothing of one that is seen end on, which has no place in the picture but a point.
fn drawn_range(frame: &PictureFrame, viewpoint: &Viewpoint, stroke: &Stroke) -> Option<[f64; 2]> {
    let clipped = frame.clip_drawn(stroke.ends, 0.0)?;
    let is_long = clipped.length_px() > END_ON_PX + 2.0 * clipped.doubt_px;
    (is_long || !stroke.is_seen_end_on(viewpoint)).then_some(clipped.range)
}

//! [`Scorer`]: what another program drew, measured as `compare` measures methods.

use super::Drawing;
use super::crowding;
use super::edge_list::{ClaimedCamera, ClaimedProjection, ClaimedViewpoint, Claims};
use super::error::ForeignFault;
use super::file::ForeignFile;
use super::trace::{Frame, Polyline};
use super::views::ScoredView;
use super::visible_edges::{found_edges, visible_parts};
use crate::cost::{FrameCost, PrepareCost, Spread};
use crate::metrics::{Ink, PictureKind};
use crate::options::OptionSettings;
use crate::record::{CameraRecord, Cell, PenRecord, View};
use crate::runner::frame_source::Output;
use crate::runner::truths::{Scored, Truths};
use crate::runner::{CompareError, Subject};
use crate::truth::pen;
use glam::DVec3;
use silhouette_core::view::{Projection, Viewpoint};
use silhouette_core::{Camera, Progress, SilhouetteEdges, Topology, TriangleMesh};
use silhouette_gpu::{Pen, PenPlacement};
use silhouette_render::Image;
use std::collections::BTreeMap;
use std::sync::Arc;

/// By how much a camera that a file states may differ from that of its view: as a share of the distance to what it looks at, and
/// of its field of view. A drawing is then off by half a pixel in a picture of 512.
const SAME_CAMERA: f64 = 1e-3;

/// Scores files of some views of a mesh.
pub struct Scorer<'a> {
    mesh: Arc<TriangleMesh>,
    name: &'a str,
    topology: Arc<Topology>,
    truths: Truths<'a>,
    views: Vec<ScoredView>,
    pen: Pen,
}

/// What a file scored.
#[derive(Debug, Clone)]
pub struct ForeignScore {
    /// The numbers. Nobody timed anything: times are NaN.
    pub view: View,
    /// What was drawn, the truth and their difference, for people.
    pub pictures: [Image; 3],
}

/// Why a file was not scored.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ScoreError {
    /// The file does not fit the view.
    #[error(transparent)]
    File(#[from] ForeignFault),
    /// The truth could not be found.
    #[error(transparent)]
    Truth(#[from] CompareError),
}

impl<'a> Scorer<'a> {
    /// Finds the truth of views of a mesh, to be drawn by a pen of this width. O(F log F) for the mesh, for each view as
    /// [`TruthFinder::find`](crate::truth::TruthFinder::find).
    ///
    /// # Errors
    /// [`CompareError::EmptyMesh`], [`CompareError::Truth`], [`CompareError::Cancelled`].
    pub fn new(
        subject: &'a Subject,
        views: Vec<ScoredView>,
        pen_width_px: f64,
        progress: &dyn Progress,
    ) -> Result<Self, CompareError> {
        let (name, prepared) = (&subject.mesh.name, &subject.mesh.mesh);
        if prepared.mesh().face_count() == 0 {
            return Err(CompareError::EmptyMesh { mesh: name.clone() });
        }
        let cameras: Vec<Camera> = views.iter().map(|view| view.camera).collect();
        let mut truths = Truths::find(subject, &cameras, pen_width_px, progress)?;
        let pen = Pen { width_px: pen_width_px, placement: PenPlacement::Centred };
        truths.prepare_pen(pen, progress)?;
        let topology = prepared.artefact("score", progress)?;
        Ok(Self { mesh: Arc::clone(prepared.mesh()), name, topology, truths, views, pen })
    }

    /// The views.
    pub fn views(&self) -> &[ScoredView] {
        &self.views
    }

    /// Scores what a file holds of a view. Lines are drawn with the pen of the truth, centred on them; of edges that are named by
    /// their vertices the visible parts are. O(pixels + length of lines); see [`visible_parts`] for edges.
    ///
    /// # Errors
    /// [`ScoreError`]: the file is of another mesh or camera, or holds nothing where something is to be seen.
    ///
    /// # Panics
    /// If there is no such view.
    pub fn score(
        &mut self,
        view: usize,
        file: ForeignFile,
        progress: &dyn Progress,
    ) -> Result<ForeignScore, ScoreError> {
        self.check(view, &file.claims)?;
        let (scored, edges) = match file.drawing {
            Drawing::Picture(picture) => {
                (self.truths.score_ink(view, self.pen, &Ink::from_picture(&picture), picture), None)
            }
            Drawing::Lines(lines) => {
                // A pen that is set down and lifted leaves no ink.
                let has_length = |line: &Polyline| line.points.windows(2).any(|ends| ends[0] != ends[1]);
                let lines: Vec<Polyline> = lines.into_iter().filter(has_length).collect();
                self.require(view, lines.is_empty(), |truth| truth.visible.is_empty())?;
                (self.score_lines(view, &lines)?, None)
            }
            Drawing::Edges(pairs) => {
                let found = found_edges(&pairs, &self.topology, self.mesh.vertex_count(), self.name)?;
                self.require(view, found.is_empty(), |truth| truth.edges.is_empty())?;
                let lines = self.visible(view, &found, progress)?;
                (self.score_lines(view, &lines)?, Some(self.truths.score_edges(view, &found)))
            }
        };
        let ScoredView { frame, camera } = self.views[view];
        let view = View {
            frame,
            camera: CameraRecord::from(&camera),
            frame_ms: f64::NAN,
            extract_ms: None,
            truth: self.truths.record(view, Output::Lines(self.pen)),
            edges,
            metrics: scored.metrics,
            errors: scored.errors,
        };
        Ok(ForeignScore { view, pictures: scored.pictures })
    }

    /// The views of one program as a row of results: one that no preparation and no frame was timed for, so that times are NaN.
    /// Results [leave them empty](super::results).
    ///
    /// # Panics
    /// Never: there is a spread of one time.
    pub fn cell(&self, method: &str, views: Vec<View>) -> Cell {
        let unmeasured = Spread::of(&[f64::NAN]).expect("one value has a spread");
        Cell {
            mesh: self.truths.mesh.clone(),
            method: method.to_owned(),
            options: OptionSettings::default(),
            picture: PictureKind::Lines,
            run: 0,
            pen: Some(PenRecord { width_px: self.pen.width_px, placement: "centred".to_owned() }),
            prepare: PrepareCost { prepare_ms: f64::NAN, renderer_ms: f64::NAN, bytes: 0 },
            frame: FrameCost {
                frames: 0,
                warm_up: 0,
                frame_ms: unmeasured,
                gpu_ms: None,
                extract_ms: None,
                counters: None,
            },
            artefacts: Vec::new(),
            views,
            intervals: BTreeMap::new(),
            coherence: Vec::new(),
        }
        .with_intervals()
    }

    fn score_lines(&self, view: usize, lines: &[Polyline]) -> Result<Scored, ForeignFault> {
        let size = self.views[view].camera.size();
        crowding::check(lines, Frame { size, pen_width_px: self.pen.width_px })?;
        let ink = pen::draw(lines, self.pen, size);
        let picture = ink.to_picture();
        Ok(self.truths.score_ink(view, self.pen, &ink, picture))
    }

    fn visible(
        &mut self,
        view: usize,
        found: &SilhouetteEdges,
        progress: &dyn Progress,
    ) -> Result<Vec<Polyline>, CompareError> {
        let (truth, finder) = self.truths.view_and_finder(view);
        visible_parts(found, truth, finder, progress).map_err(|cause| CompareError::truth(self.name, cause))
    }

    /// Refuses nothing where something is to be seen.
    fn require(
        &mut self,
        view: usize,
        is_empty: bool,
        is_right: impl FnOnce(&crate::truth::Truth) -> bool,
    ) -> Result<(), ForeignFault> {
        let is_wrong = is_empty && !is_right(self.truths.view_and_finder(view).0);
        if is_wrong { Err(ForeignFault::no_lines()) } else { Ok(()) }
    }

    /// Refuses a file that says that it shows another mesh, or by another camera.
    fn check(&self, view: usize, claims: &Claims) -> Result<(), ForeignFault> {
        if let Some(claimed) = claims.mesh {
            let counts = [
                ("vertices", claimed.vertices, self.mesh.vertex_count()),
                ("triangles", claimed.triangles, self.mesh.face_count()),
            ];
            for (what, claimed, count) in counts {
                if let Some(claimed) = claimed.filter(|claimed| *claimed != count) {
                    return Err(ForeignFault::OtherMesh {
                        place: format!("mesh.{what}"),
                        found: format!("was made of {claimed} {what}"),
                        mesh: self.name.to_owned(),
                        wanted: format!("{count}"),
                    });
                }
            }
        }
        let ScoredView { frame, camera } = self.views[view];
        let other = |place: &str, found: String, wanted: String| {
            Err(ForeignFault::OtherCamera { place: place.to_owned(), found, frame, wanted })
        };
        let placed = |point: glam::Vec3| self.mesh.in_file(point);
        let distance = camera.eye().as_dvec3().distance(camera.target().as_dvec3());
        let toward = (camera.eye().as_dvec3() - camera.target().as_dvec3()) / distance;
        match (claims.viewpoint, camera.viewpoint()) {
            (None, _) => {}
            (Some(ClaimedViewpoint::Perspective { eye }), Viewpoint::Perspective { .. }) => {
                if eye.distance(placed(camera.eye())) > SAME_CAMERA * distance {
                    return other("viewpoint", format!("is from {}", shown(eye)), shown(placed(camera.eye())));
                }
            }
            (Some(ClaimedViewpoint::Orthographic { toward_viewer }), Viewpoint::Orthographic { .. }) => {
                if toward_viewer.normalize_or_zero().distance(toward) > SAME_CAMERA {
                    return other("viewpoint", format!("is along {}", shown(toward_viewer)), shown(toward));
                }
            }
            (Some(_), _) => return other("viewpoint", "projects otherwise".to_owned(), projection(&camera)),
        }
        let Some(ClaimedCamera { eye, target, projection: claimed }) = claims.camera else { return Ok(()) };
        if (eye - target).normalize_or_zero().distance(toward) > SAME_CAMERA {
            return other("camera", format!("looks along {}", shown(target - eye)), shown(-toward * distance));
        }
        let is_near = |one: f64, other: f64| (one - other).abs() <= SAME_CAMERA * other;
        let is_same = match (claimed, camera.projection()) {
            (ClaimedProjection::Perspective { fov_y_rad: claimed }, Projection::Perspective { fov_y_rad }) => {
                if eye.distance(placed(camera.eye())) > SAME_CAMERA * distance {
                    return other("camera", format!("has its eye at {}", shown(eye)), shown(placed(camera.eye())));
                }
                is_near(claimed, fov_y_rad)
            }
            (ClaimedProjection::Orthographic { height: claimed }, Projection::Orthographic { height }) => {
                is_near(claimed, height)
            }
            _ => false,
        };
        if is_same { Ok(()) } else { other("camera", "projects otherwise".to_owned(), projection(&camera)) }
    }
}

fn shown(vector: DVec3) -> String {
    format!("{}, {}, {}", vector.x as f32, vector.y as f32, vector.z as f32)
}

fn projection(camera: &Camera) -> String {
    match camera.projection() {
        Projection::Perspective { fov_y_rad } => format!("a field of view of {} degrees", fov_y_rad.to_degrees()),
        Projection::Orthographic { height } => format!("a parallel projection {height} units high"),
    }
}

#[cfg(test)]
mod tests;

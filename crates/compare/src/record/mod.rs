//! [`Cell`]: everything about one method with its options on one mesh. Results are lists of these.
//!
//! [`flat`] turns them into rows of a table; [`label`] names them for people.

pub mod flat;
pub mod label;

use crate::coherence::{CoherenceMetrics, Motion};
use crate::cost::{FrameCost, PrepareCost};
use crate::interval;
use crate::metrics::LineErrors;
use crate::metrics::table::{MetricSpec, PictureKind, PictureMetrics};
use crate::options::OptionSettings;
use serde::{Deserialize, Serialize};
use silhouette_core::prepared::ArtefactReport;
use silhouette_core::view::{Camera, Projection};
use std::collections::BTreeMap;

/// One method with its options on one mesh: what it cost along the scene's path, and what its scored frames were worth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Cell {
    /// The mesh.
    pub mesh: MeshRecord,
    /// Name of the method.
    pub method: String,
    /// All of its options, defaults too.
    pub options: OptionSettings,
    /// What its pictures show.
    pub picture: PictureKind,
    /// Which of the [runs](crate::Comparison::runs) of the comparison measured it, from 0. Times of different runs are not compared.
    pub run: usize,
    /// The pen that it drew with and the truth was drawn with, for pictures of lines.
    pub pen: Option<PenRecord>,
    /// Cost of the preparation.
    pub prepare: PrepareCost,
    /// What the preparation built, in the order of completion; the method's own bytes come on top of these.
    #[serde(default)]
    pub artefacts: Vec<ArtefactRecord>,
    /// Cost of the timed frames.
    pub frame: FrameCost,
    /// Its scored frames in the order of the path: at least one.
    pub views: Vec<View>,
    /// Ends of the 95 % [interval] of the mean over the views, for each metric by its name.
    #[serde(default)]
    pub intervals: BTreeMap<String, [f64; 2]>,
    /// Coherence along the scene's motions; none where the scene asks for none.
    #[serde(default)]
    pub coherence: Vec<CoherenceRecord>,
}

/// Data derived from the mesh that a method asked for.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ArtefactRecord {
    /// Its name, as in [`MethodInfo::needs`](silhouette_core::method::MethodInfo::needs).
    pub name: String,
    /// Bytes in main memory.
    pub bytes: u64,
}

impl From<&ArtefactReport> for ArtefactRecord {
    fn from(built: &ArtefactReport) -> Self {
        Self { name: built.name.to_owned(), bytes: built.bytes as u64 }
    }
}

/// Coherence along a motion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CoherenceRecord {
    /// What moved.
    pub motion: Motion,
    /// Number of frames.
    pub frames: u32,
    /// The numbers; `None` where the mesh moved and the method cannot follow it.
    pub metrics: Option<CoherenceMetrics>,
}

/// A scored frame: one of those that were timed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct View {
    /// Which of the timed frames, from 0.
    pub frame: u32,
    /// Its camera.
    pub camera: CameraRecord,
    /// Wall time of this very frame in milliseconds; see [`FrameCost::frame_ms`].
    pub frame_ms: f64,
    /// Wall time of its extraction in milliseconds, for methods that extract edges.
    pub extract_ms: Option<f64>,
    /// The truth.
    pub truth: TruthRecord,
    /// Edges found against edges to be found, for methods that extract edges.
    pub edges: Option<EdgeScore>,
    /// Quality of the picture.
    pub metrics: PictureMetrics,
    /// Where it errs, for pictures of lines.
    #[serde(default)]
    pub errors: Option<LineErrors>,
}

/// A mesh, as far as results need it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct MeshRecord {
    /// Name that the user gave, usually a path.
    pub name: String,
    /// Number of vertices.
    pub vertices: usize,
    /// Number of faces.
    pub faces: usize,
    /// Number of edges.
    pub edges: usize,
    /// Number of faces that are wound inwards, for which methods that depend on winding draw what is hidden.
    #[serde(default)]
    pub inward_faces: usize,
}

/// A camera, as far as needed to set it up again.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CameraRecord {
    /// Viewport in pixels.
    pub size: [u32; 2],
    /// Eye in world space.
    pub eye: [f32; 3],
    /// Point looked at in world space.
    pub target: [f32; 3],
    /// Direction to the top of the viewport.
    pub up: [f32; 3],
    /// Vertical field of view in degrees, for a perspective.
    pub fov_y_deg: Option<f64>,
    /// World units from top to bottom, for an orthographic view.
    pub ortho_height: Option<f64>,
}

impl From<&Camera> for CameraRecord {
    fn from(camera: &Camera) -> Self {
        let (fov_y_deg, ortho_height) = match camera.projection() {
            Projection::Perspective { fov_y_rad } => (Some(fov_y_rad.to_degrees()), None),
            Projection::Orthographic { height } => (None, Some(height)),
        };
        Self {
            size: camera.size(),
            eye: camera.eye().to_array(),
            target: camera.target().to_array(),
            up: camera.up().to_array(),
            fov_y_deg,
            ortho_height,
        }
    }
}

/// A pen.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PenRecord {
    /// Width in pixels.
    pub width_px: f64,
    /// Where the pen sits: `centred`, `inside` or `outside`.
    pub placement: String,
}

/// The truth of a view.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TruthRecord {
    /// Number of silhouette edges, visible or not.
    pub silhouette_edges: usize,
    /// Length of the visible silhouette in pixels.
    pub visible_length_px: f64,
    /// Area that the mesh covers in pixels, for filled pictures.
    pub area_px: Option<f64>,
}

/// Silhouette edges found, against those that there are.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct EdgeScore {
    /// Number of edges found.
    pub found: usize,
    /// Share of the found edges that are silhouette edges; 1 where none was found.
    pub precision: f64,
    /// Share of the silhouette edges that were found; 1 where there is none.
    pub recall: f64,
}

impl Cell {
    /// The lowest precision, the lowest recall and the fewest edges found of all views, each by itself; `None` for a method
    /// that extracts no edges.
    pub fn worst_edges(&self) -> Option<EdgeScore> {
        self.views.iter().filter_map(|view| view.edges).reduce(|one, other| EdgeScore {
            found: one.found.min(other.found),
            precision: one.precision.min(other.precision),
            recall: one.recall.min(other.recall),
        })
    }

    /// Silhouette edges found over those that there are, all views together; `None` for a method that extracts no edges.
    pub fn recall(&self) -> Option<f64> {
        let scores = || self.views.iter().filter_map(|view| Some((view.edges?, view.truth.silhouette_edges)));
        let expected: usize = scores().map(|(_, expected)| expected).sum();
        let right: f64 = scores().map(|(edges, expected)| edges.recall * expected as f64).sum();
        let share = if expected > 0 { (right / expected as f64).clamp(0.0, 1.0) } else { 1.0 };
        scores().next().map(|_| share)
    }

    /// The scored view that is worst by the [leading metric](PictureKind::leading_metric), the last of several that are
    /// equally bad: by then a method that keeps state has had time to lose something. An index into `views`; `None` where
    /// there is no view.
    pub fn worst_view(&self) -> Option<usize> {
        let leading = self.picture.leading_metric();
        let error = |view: &View| (leading.value)(&view.metrics).unwrap_or(0.0);
        let views = self.views.iter().enumerate();
        views.max_by(|(_, one), (_, other)| error(one).total_cmp(&error(other))).map(|(index, _)| index)
    }

    /// Where its pictures of lines err, averaged over the views, each counting the same.
    pub fn mean_errors(&self) -> Option<LineErrors> {
        LineErrors::mean(&self.views.iter().filter_map(|view| view.errors).collect::<Vec<_>>())
    }

    /// The same with the [intervals](Self::intervals) that follow from its views.
    pub fn with_intervals(self) -> Self {
        let values = |metric: &MetricSpec| self.views.iter().map(|view| (metric.value)(&view.metrics)).collect();
        let interval = |metric: &MetricSpec| {
            let values: Option<Vec<f64>> = values(metric);
            Some((metric.name.to_owned(), interval::of_mean(&values?)?))
        };
        let intervals = self.picture.metrics().filter_map(interval).collect();
        Self { intervals, ..self }
    }

    /// The metrics averaged over the views, each counting the same; `None` where there is no view.
    pub fn mean_metrics(&self) -> Option<PictureMetrics> {
        PictureMetrics::mean(&self.views.iter().map(|view| view.metrics).collect::<Vec<_>>())
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::cost::Spread;
    use crate::machine::{AdapterRecord, RunDescription};
    use crate::metrics::{FillMetrics, LineMetrics};
    use crate::options::OptionSetting;

    /// A cell of one view.
    pub(crate) fn cell(mesh: &str, method: &str, frame_ms: f64, chamfer_px: f64) -> Cell {
        let spread = |median: f64| Spread {
            median,
            interval: [median * 0.5, median * 1.5],
            p95: median * 2.0,
            max: median * 3.0,
        };
        Cell {
            mesh: MeshRecord { name: mesh.to_owned(), vertices: 4, faces: 4, edges: 6, inward_faces: 0 },
            method: method.to_owned(),
            options: OptionSettings::default(),
            picture: PictureKind::Lines,
            run: 0,
            pen: Some(PenRecord { width_px: 2.0, placement: "centred".to_owned() }),
            prepare: PrepareCost { prepare_ms: 1.0, renderer_ms: 2.0, bytes: 300 },
            artefacts: vec![ArtefactRecord { name: "topology".to_owned(), bytes: 200 }],
            frame: FrameCost {
                frames: 20,
                warm_up: 3,
                frame_ms: spread(frame_ms),
                gpu_ms: None,
                extract_ms: Some(spread(frame_ms * 0.25)),
                counters: None,
            },
            views: vec![view(5, chamfer_px)],
            intervals: BTreeMap::new(),
            coherence: Vec::new(),
        }
        .with_intervals()
    }

    pub(crate) fn view(frame: u32, chamfer_px: f64) -> View {
        View {
            frame,
            camera: CameraRecord {
                size: [8, 8],
                eye: [0.0, 0.0, 3.0],
                target: [0.0; 3],
                up: [0.0, 1.0, 0.0],
                fov_y_deg: Some(45.0),
                ortho_height: None,
            },
            frame_ms: 1.5,
            extract_ms: Some(0.5),
            truth: TruthRecord { silhouette_edges: 4, visible_length_px: 20.0, area_px: None },
            edges: Some(EdgeScore { found: 4, precision: 1.0, recall: 1.0 }),
            metrics: PictureMetrics::Lines(LineMetrics { chamfer_px, width_mean_px: 2.0, ..LineMetrics::default() }),
            errors: Some(LineErrors { true_crease_px: 20.0, true_unexplained_px: 20.0, ..LineErrors::default() }),
        }
    }

    /// A cell whose pictures are filled.
    pub(crate) fn fill_cell(mesh: &str, method: &str, frame_ms: f64, xor_share: f64) -> Cell {
        let mut filled = cell(mesh, method, frame_ms, 0.0);
        filled.picture = PictureKind::Fill;
        filled.pen = None;
        for view in &mut filled.views {
            (view.edges, view.errors) = (None, None);
            view.metrics = PictureMetrics::Fill(FillMetrics { xor_share, ..FillMetrics::default() });
        }
        filled.with_intervals()
    }

    /// The same cell with coherence along an orbit, and a wave that it cannot follow.
    pub(crate) fn with_coherence(cell: Cell, flicker: f64) -> Cell {
        let metrics = CoherenceMetrics { flicker, loops_lost: Some(0.5), ..CoherenceMetrics::default() };
        let record = |motion, metrics| CoherenceRecord { motion, frames: 24, metrics };
        Cell { coherence: vec![record(Motion::Orbit, Some(metrics)), record(Motion::Wave, None)], ..cell }
    }

    pub(crate) fn with_option(cell: Cell, name: &str, value: OptionSetting) -> Cell {
        let mut options = cell.options.clone();
        options.0.insert(name.to_owned(), value);
        Cell { options, ..cell }
    }

    pub(crate) fn run() -> RunDescription {
        let text = |text: &str| text.to_owned();
        RunDescription {
            version: text("0.0.0"),
            commit: String::new(),
            rustc: text("rustc 1"),
            build: text("debug"),
            cpu: text("a <processor>"),
            threads: 2,
            system: text("some system"),
            adapter: AdapterRecord {
                name: text("an adapter"),
                driver: text("driver 1"),
                backend: text("Vulkan"),
                software: true,
                timestamps: false,
            },
        }
    }

    #[test]
    fn cells_survive_json() {
        let level = OptionSetting::Number(0.25);
        let lines = with_option(cell("a \"quoted\", mesh\n", "m", 2.0, 0.5), "level", level);
        let coherent = with_coherence(lines.clone(), 0.25);
        for cell in [lines, coherent, fill_cell("a", "m", 2.0, 0.5)] {
            let line = serde_json::to_string(&cell).unwrap();
            assert!(!line.contains('\n'));
            assert_eq!(serde_json::from_str::<Cell>(&line).unwrap(), cell);
        }
    }

    #[test]
    fn recall_counts_edges_and_the_worst_view_is_kept() {
        let mut cell = cell("a", "m", 2.0, 1.0);
        let mut worse = view(15, 3.0);
        worse.truth.silhouette_edges = 12;
        worse.edges = Some(EdgeScore { found: 3, precision: 0.5, recall: 0.25 });
        cell.views.push(worse);
        assert_eq!(cell.recall(), Some((4.0 + 3.0) / 16.0));
        assert_eq!(cell.worst_edges(), Some(EdgeScore { found: 3, precision: 0.5, recall: 0.25 }));
        let Some(PictureMetrics::Lines(mean)) = cell.mean_metrics() else { panic!("lines") };
        assert!((mean.chamfer_px - 2.0).abs() < 1e-12 && (mean.width_mean_px - 2.0).abs() < 1e-12);
        assert_eq!(cell.worst_view(), Some(1));
        let filled = fill_cell("a", "m", 2.0, 0.5);
        assert_eq!((filled.recall(), filled.worst_edges()), (None, None));
    }

    #[test]
    fn of_views_that_are_equally_bad_the_last_is_the_worst() {
        let mut cell = cell("a", "m", 2.0, 3.0);
        cell.views.extend([view(10, 3.0), view(15, 1.0)]);
        assert_eq!(cell.worst_view(), Some(1));
        cell.views.clear();
        assert_eq!(cell.worst_view(), None);
    }
}

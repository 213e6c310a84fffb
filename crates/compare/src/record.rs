//! [`Record`]: everything about one method on one mesh in one view. Results are lists of these.

use crate::cost::{FrameCost, PrepareCost};
use crate::machine::RunDescription;
use crate::metrics::{LineMetrics, METRICS};
use serde::{Deserialize, Serialize};
use silhouette_core::view::{Camera, Projection};

/// How much is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Profile {
    /// 512 x 512 pixels, 6 views, 20 timed frames: a few seconds a mesh on two cores without a graphics card.
    Quick,
    /// 1024 x 1024 pixels, 24 views, 120 timed frames.
    Full,
}

impl Profile {
    /// Every profile with the name the command line uses.
    pub const NAMED: [(&'static str, Self); 2] = [("quick", Self::Quick), ("full", Self::Full)];

    /// Viewport in pixels.
    pub fn size(self) -> [u32; 2] {
        match self {
            Self::Quick => [512; 2],
            Self::Full => [1024; 2],
        }
    }

    /// Views, spread over a turn, in which accuracy is measured.
    pub fn views(self) -> u32 {
        match self {
            Self::Quick => 6,
            Self::Full => 24,
        }
    }

    /// Frames that are timed.
    pub fn frames(self) -> u32 {
        match self {
            Self::Quick => 20,
            Self::Full => 120,
        }
    }

    /// Frames drawn before the timed ones.
    pub fn warm_up(self) -> u32 {
        match self {
            Self::Quick => 3,
            Self::Full => 10,
        }
    }

    /// Name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Quick => "quick",
            Self::Full => "full",
        }
    }
}

/// One method on one mesh in one view.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// The mesh.
    pub mesh: MeshRecord,
    /// Name of the method.
    pub method: String,
    /// Its options as `name=value` words.
    pub options: String,
    /// How much was measured.
    pub profile: Profile,
    /// The view.
    pub view: ViewRecord,
    /// The pen that the method drew with and the truth was drawn with.
    pub pen: PenRecord,
    /// The truth of the view.
    pub truth: TruthRecord,
    /// Edges found against edges to be found, for methods that extract edges.
    pub edges: Option<EdgeScore>,
    /// Quality of the picture in this view.
    pub metrics: LineMetrics,
    /// Cost of the preparation: the same in every view of a mesh and method.
    pub prepare: PrepareCost,
    /// Cost of frames along the animation path: the same in every view of a mesh and method.
    pub frame: FrameCost,
    /// Machine, adapter and program.
    pub run: RunDescription,
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
}

/// A view, as far as needed to set it up again.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ViewRecord {
    /// Number of the view on its path, from 0.
    pub index: u32,
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

impl ViewRecord {
    /// The view of a camera.
    pub fn of(index: u32, camera: &Camera) -> Self {
        let (fov_y_deg, ortho_height) = match camera.projection() {
            Projection::Perspective { fov_y_rad } => (Some(fov_y_rad.to_degrees()), None),
            Projection::Orthographic { height } => (None, Some(height)),
        };
        Self {
            index,
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

type Column = (&'static str, fn(&Record) -> String);

fn optional<T: ToString>(value: Option<T>) -> String {
    value.map(|value| value.to_string()).unwrap_or_default()
}

/// The columns of a flat table, metrics and run left out: they come from their own tables.
const COLUMNS: [Column; 33] = [
    ("mesh", |r| r.mesh.name.clone()),
    ("vertices", |r| r.mesh.vertices.to_string()),
    ("faces", |r| r.mesh.faces.to_string()),
    ("method", |r| r.method.clone()),
    ("options", |r| r.options.clone()),
    ("profile", |r| r.profile.name().to_owned()),
    ("view", |r| r.view.index.to_string()),
    ("width", |r| r.view.size[0].to_string()),
    ("height", |r| r.view.size[1].to_string()),
    ("fov_y_deg", |r| optional(r.view.fov_y_deg)),
    ("ortho_height", |r| optional(r.view.ortho_height)),
    ("pen_width_px", |r| r.pen.width_px.to_string()),
    ("pen_placement", |r| r.pen.placement.clone()),
    ("silhouette_edges", |r| r.truth.silhouette_edges.to_string()),
    ("visible_length_px", |r| r.truth.visible_length_px.to_string()),
    ("edges_found", |r| optional(r.edges.map(|edges| edges.found))),
    ("edge_precision", |r| optional(r.edges.map(|edges| edges.precision))),
    ("edge_recall", |r| optional(r.edges.map(|edges| edges.recall))),
    ("prepare_ms", |r| r.prepare.prepare_ms.to_string()),
    ("renderer_ms", |r| r.prepare.renderer_ms.to_string()),
    ("bytes_prepared", |r| r.prepare.bytes.to_string()),
    ("frames", |r| r.frame.frames.to_string()),
    ("frame_median_ms", |r| r.frame.frame_ms.median.to_string()),
    ("frame_p95_ms", |r| r.frame.frame_ms.p95.to_string()),
    ("frame_max_ms", |r| r.frame.frame_ms.max.to_string()),
    ("gpu_median_ms", |r| optional(r.frame.gpu_ms.map(|spread| spread.median))),
    ("extract_median_ms", |r| optional(r.frame.extract_ms.map(|spread| spread.median))),
    ("faces_tested", |r| optional(r.frame.counters.map(|counters| counters.faces_tested))),
    ("edges_tested", |r| optional(r.frame.counters.map(|counters| counters.edges_tested))),
    ("adapter", |r| r.run.adapter.name.clone()),
    ("cpu", |r| r.run.cpu.clone()),
    ("version", |r| r.run.version.clone()),
    ("commit", |r| r.run.commit.clone()),
];

impl Record {
    /// Names of the columns of a flat table.
    pub fn columns() -> impl Iterator<Item = &'static str> {
        COLUMNS.iter().map(|(name, _)| *name).chain(METRICS.iter().map(|metric| metric.name))
    }

    /// The record as a row of a flat table, in the order of [`columns`](Self::columns); empty where something does not
    /// apply.
    pub fn row(&self) -> impl Iterator<Item = String> + '_ {
        let metrics = METRICS.iter().map(|metric| (metric.value)(&self.metrics).to_string());
        COLUMNS.iter().map(|(_, value)| value(self)).chain(metrics)
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::cost::Spread;
    use crate::machine::AdapterRecord;
    use std::collections::BTreeSet;

    /// A record with a name that would break a page or a table that does not escape it.
    pub(crate) fn record(mesh: &str, method: &str, frame_ms: f64, chamfer_px: f64) -> Record {
        let spread = |median: f64| Spread { median, p95: median * 2.0, max: median * 3.0 };
        Record {
            mesh: MeshRecord { name: mesh.to_owned(), vertices: 4, faces: 4, edges: 6 },
            method: method.to_owned(),
            options: String::new(),
            profile: Profile::Quick,
            view: ViewRecord {
                index: 0,
                size: [8, 8],
                eye: [0.0, 0.0, 3.0],
                target: [0.0; 3],
                up: [0.0, 1.0, 0.0],
                fov_y_deg: Some(45.0),
                ortho_height: None,
            },
            pen: PenRecord { width_px: 2.0, placement: "centred".to_owned() },
            truth: TruthRecord { silhouette_edges: 4, visible_length_px: 20.0 },
            edges: Some(EdgeScore { found: 4, precision: 1.0, recall: 1.0 }),
            metrics: LineMetrics { chamfer_px, width_mean_px: 2.0, ..LineMetrics::default() },
            prepare: PrepareCost { prepare_ms: 1.0, renderer_ms: 2.0, bytes: 300 },
            frame: FrameCost {
                frames: 20,
                warm_up: 3,
                frame_ms: spread(frame_ms),
                gpu_ms: None,
                extract_ms: Some(spread(frame_ms * 0.25)),
                counters: None,
            },
            run: run(),
        }
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
    fn records_survive_json() {
        let record = record("a \"quoted\", mesh\n", "m", 2.0, 0.5);
        let line = serde_json::to_string(&record).unwrap();
        assert!(!line.contains('\n'));
        assert_eq!(serde_json::from_str::<Record>(&line).unwrap(), record);
    }

    #[test]
    fn a_row_has_a_value_for_every_column() {
        let record = record("mesh", "m", 2.0, 0.5);
        let names: Vec<_> = Record::columns().collect();
        assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len());
        assert_eq!(record.row().count(), names.len());
        let value = |name| record.row().nth(names.iter().position(|column| *column == name).unwrap()).unwrap();
        assert_eq!(
            (value("chamfer_px"), value("frame_median_ms"), value("gpu_median_ms")),
            ("0.5".into(), "2".into(), "".into())
        );
    }

    #[test]
    fn profiles_have_their_names() {
        assert!(Profile::NAMED.iter().all(|(name, profile)| profile.name() == *name));
    }
}

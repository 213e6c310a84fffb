//! What a scene holds. The fields are the keys of its file, in kebab case.

use super::error::SceneFault;
use crate::camera_path::{Orbit, scored_frames};
use crate::coherence::Motion;
use crate::options::OptionSetting;
use serde::{Deserialize, Serialize};
use silhouette_core::view::{Framing, UpAxis};
use std::collections::BTreeMap;
use std::path::Path;

/// What is compared, seen how, measured how thoroughly.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Scene {
    /// Name for results: that of the profile, or of the file without its ending.
    #[serde(default, skip_deserializing)]
    pub name: String,
    /// The meshes. Default: none; they are then named elsewhere.
    #[serde(default)]
    pub meshes: Vec<MeshSpec>,
    /// Where the camera goes.
    pub path: PathSpec,
    /// What frames are drawn to.
    pub picture: PictureSpec,
    /// What lines are drawn with. Default: 2 px wide.
    #[serde(default)]
    pub pen: PenSpec,
    /// Which motions coherence is measured along. Default: it is not measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coherence: Option<CoherenceSpec>,
    /// The methods, in the order in which they are reported. Default: all, with their default options.
    #[serde(default)]
    pub methods: Vec<MethodSpec>,
}

impl Scene {
    /// Has every mesh drawn with at most `faces` faces and measured against all of it, whatever number the scene gives.
    ///
    /// # Errors
    /// [`SceneFault::HasTruth`]: a mesh is measured against another.
    pub fn simplify_meshes(&mut self, faces: usize) -> Result<(), SceneFault> {
        for spec in &mut self.meshes {
            let mesh = spec.mesh().to_owned();
            if spec.truth().is_some() {
                return Err(SceneFault::HasTruth { mesh });
            }
            *spec = MeshSpec::Simplified { mesh, simplify: faces };
        }
        Ok(())
    }
}

/// What the names of built-in shapes begin with, where a mesh is named.
pub const BUILTIN: &str = "builtin:";

/// A mesh of a scene: a file, or `builtin:NAME`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(
    untagged,
    deny_unknown_fields,
    expecting = "a mesh, { mesh = \"coarse.obj\", truth = \"fine.obj\" }, \
                 or { mesh = \"fine.obj\", simplify = 500 }"
)]
pub enum MeshSpec {
    /// A mesh that is its own truth.
    Plain(String),
    /// A mesh whose filled pictures are measured against another.
    WithTruth {
        /// What is drawn.
        mesh: String,
        /// What it stands for, in the same coordinates.
        truth: String,
    },
    /// A mesh that is drawn simplified, and whose filled pictures are measured against all of it.
    Simplified {
        /// What it stands for.
        mesh: String,
        /// How many faces it has at most when drawn, 1 or more.
        simplify: usize,
    },
}

impl MeshSpec {
    /// What is drawn, or drawn simplified.
    pub fn mesh(&self) -> &str {
        match self {
            Self::Plain(mesh) | Self::WithTruth { mesh, .. } | Self::Simplified { mesh, .. } => mesh,
        }
    }

    /// With how many faces at most it is drawn, where that is limited.
    pub fn simplify(&self) -> Option<usize> {
        if let Self::Simplified { simplify, .. } = self { Some(*simplify) } else { None }
    }

    /// The same with paths taken as relative to a folder; names of built-in shapes and absolute paths stay as they are.
    pub fn relative_to(self, folder: &Path) -> Self {
        let placed = |name: String| {
            let is_file = !name.starts_with(BUILTIN);
            if is_file { folder.join(name).to_string_lossy().into_owned() } else { name }
        };
        match self {
            Self::Plain(mesh) => Self::Plain(placed(mesh)),
            Self::WithTruth { mesh, truth } => Self::WithTruth { mesh: placed(mesh), truth: placed(truth) },
            Self::Simplified { mesh, simplify } => Self::Simplified { mesh: placed(mesh), simplify },
        }
    }

    /// What filled pictures are measured against, where it is a mesh of another name.
    pub fn truth(&self) -> Option<&str> {
        match self {
            Self::Plain(_) | Self::Simplified { .. } => None,
            Self::WithTruth { truth, .. } => Some(truth),
        }
    }
}

/// The camera's path: one for each cell, followed frame by frame; some of its timed frames are scored.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct PathSpec {
    /// Its shape.
    pub kind: PathKind,
    /// How frames project.
    pub projection: ProjectionKind,
    /// Vertical field of view in degrees, for a perspective and for nothing else.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fov_deg: Option<f64>,
    /// The axis of the orbit, which points up: y where nothing is said.
    #[serde(default, skip_serializing_if = "is_y")]
    pub up_axis: UpAxis,
    /// Azimuth of the first frame, from the front towards the right: with y up from the z axis towards the x axis.
    pub first_azimuth_deg: f64,
    /// Middle of the elevations, above the horizon.
    pub elevation_deg: f64,
    /// How far the elevation swings to both sides in a turn.
    pub swing_deg: f64,
    /// Azimuth from frame to frame.
    pub step_deg: f64,
    /// Number of frames drawn first and not timed.
    pub warm_up: u32,
    /// Number of frames timed, in each pass.
    pub frames: u32,
    /// How often the path is followed, warm-up frames too, for times; all methods of a mesh in turn, which stay prepared meanwhile.
    /// Default: once.
    #[serde(default = "once", skip_serializing_if = "is_once")]
    pub passes: u32,
    /// Number of timed frames that are scored, spread evenly.
    pub scored: u32,
}

fn once() -> u32 {
    1
}

fn is_once(passes: &u32) -> bool {
    *passes == once()
}

fn is_y(axis: &UpAxis) -> bool {
    *axis == UpAxis::Y
}

/// The shape of a camera's path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PathKind {
    /// Around the mesh, whose bounding sphere fills the picture.
    Orbit,
}

/// How frames project.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ProjectionKind {
    /// From an eye.
    Perspective,
    /// In parallel.
    Orthographic,
}

impl PathSpec {
    /// All frames of the path, warm-up frames first, as an orbit.
    pub fn orbit(&self, size: [u32; 2]) -> Orbit {
        let framing = match (self.projection, self.fov_deg) {
            (ProjectionKind::Perspective, Some(fov_deg)) => Framing::Perspective { fov_y_rad: fov_deg.to_radians() },
            _ => Framing::Orthographic,
        };
        Orbit {
            up_axis: self.up_axis,
            framing,
            size,
            views: self.warm_up.saturating_add(self.frames),
            first_azimuth_rad: self.first_azimuth_deg.to_radians(),
            elevation_rad: self.elevation_deg.to_radians(),
            swing_rad: self.swing_deg.to_radians(),
            step_rad: self.step_deg.to_radians(),
        }
    }

    /// Which timed frames are scored, ascending.
    pub fn scored_frames(&self) -> Vec<u32> {
        scored_frames(self.frames, self.scored)
    }
}

/// Along what coherence is measured: after the timed path and outside of its clock.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct CoherenceSpec {
    /// The motions, each once.
    pub motions: Vec<Motion>,
    /// Number of consecutive frames of each.
    pub frames: u32,
}

/// What frames are drawn to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct PictureSpec {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Samples per pixel.
    pub samples: u32,
}

impl PictureSpec {
    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }
}

/// What lines are drawn with.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct PenSpec {
    /// Width in pixels, of drawn lines and of the true pen.
    pub width_px: f64,
}

/// Default pen: wide enough that coverage, not aliasing, decides what is ink.
pub const DEFAULT_PEN_WIDTH_PX: f64 = 2.0;

impl Default for PenSpec {
    fn default() -> Self {
        Self { width_px: DEFAULT_PEN_WIDTH_PX }
    }
}

/// A method with its options.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct MethodSpec {
    /// Name in the registry.
    pub name: String,
    /// Options that are not at their defaults.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub options: BTreeMap<String, OptionSpread>,
}

/// The value of an option, or several: one cell for each.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged, expecting = "a number, a word, or a list of them")]
pub enum OptionSpread {
    /// One value.
    One(OptionSetting),
    /// Several.
    Several(Vec<OptionSetting>),
}

impl OptionSpread {
    /// The values.
    pub fn values(&self) -> &[OptionSetting] {
        match self {
            Self::One(value) => std::slice::from_ref(value),
            Self::Several(values) => values,
        }
    }
}

//! [`Scene`]: what a method is given.

use crate::cell::Found;
use silhouette_core::glam::{DMat4, DQuat, Vec3};
use silhouette_core::method::{OptionError, OptionSpec, OptionValues};
use silhouette_core::view::{Camera, ClipRange};
use silhouette_core::{PreparedMesh, TriangleMesh, Viewpoint};
use silhouette_gpu::{FrameView, FrameViewError, TargetFormats};
use silhouette_render::DEFAULT_FORMATS;
use silhouette_testing::edits::{inside_out, mapped};
use silhouette_testing::prepare::prepared;
use silhouette_testing::views::{PERSPECTIVE, seen_from, three_quarter};
use std::sync::Arc;

/// Pixels along either side of a picture, where a row does not ask for others.
pub const SIZE: [u32; 2] = [96, 96];

/// Width of the pen in pixels, where a row does not ask for another.
pub const PEN_PX: f64 = 2.0;

/// Options with which silhouette textures are baked in a second or two.
const QUICK: [(&str, &str); 3] = [("hull-vertices", "100"), ("size", "96"), ("azimuths", "16")];

/// A mesh, how it is seen, and what it is drawn with.
#[derive(Clone)]
pub struct Scene {
    /// The mesh in its own space.
    pub mesh: Arc<PreparedMesh>,
    /// The camera, in the world.
    pub camera: Camera,
    /// Near and far plane; where none are given, those that hold the mesh.
    pub range: Option<ClipRange>,
    /// Formats of the target.
    pub formats: TargetFormats,
    /// Which way the view's depth runs, where it is not that of the formats.
    pub view_formats: TargetFormats,
    /// The mesh's own space to the world.
    pub model: DMat4,
    /// Width of the pen in pixels.
    pub pen_px: f64,
    /// Options, `name=value`, for the methods that have an option of that name.
    pub options: Vec<&'static str>,
}

impl Scene {
    /// A mesh seen from the right, above and in front.
    pub fn of(mesh: TriangleMesh) -> Self {
        let camera = three_quarter(&mesh, PERSPECTIVE, SIZE);
        Self::seen(mesh, camera)
    }

    /// A mesh seen by a camera.
    pub fn seen(mesh: TriangleMesh, camera: Camera) -> Self {
        Self {
            mesh: prepared(mesh),
            camera,
            range: None,
            formats: DEFAULT_FORMATS,
            view_formats: DEFAULT_FORMATS,
            model: DMat4::IDENTITY,
            pen_px: PEN_PX,
            options: Vec::new(),
        }
    }

    /// The same with other options.
    #[must_use]
    pub fn with_options(self, options: impl IntoIterator<Item = &'static str>) -> Self {
        Self { options: options.into_iter().collect(), ..self }
    }

    /// The same for a target and a view of these formats.
    #[must_use]
    pub fn with_formats(self, formats: TargetFormats) -> Self {
        Self { formats, view_formats: formats, ..self }
    }

    /// The mesh where the model matrix puts it, wound so that its outside is outside. The mesh itself without one.
    pub fn placed(&self) -> Arc<PreparedMesh> {
        if self.model == DMat4::IDENTITY {
            return Arc::clone(&self.mesh);
        }
        let placed = mapped(self.mesh.mesh(), |p| self.model.transform_point3(p.as_dvec3()).as_vec3());
        prepared(if self.model.determinant() < 0.0 { inside_out(&placed) } else { placed })
    }

    /// The view, with these depths where the scene has none of its own.
    ///
    /// # Errors
    /// [`FrameViewError`].
    pub fn view(&self, range: ClipRange) -> Result<FrameView, FrameViewError> {
        let range = self.range.unwrap_or(range);
        FrameView::from_camera(&self.camera, range, self.view_formats.depth_direction)?.with_model(self.model)
    }

    /// Where the mesh is seen from, in its own space.
    ///
    /// # Errors
    /// A refusal of the model matrix.
    pub fn viewpoint(&self) -> Result<Viewpoint, Found> {
        // Facing does not depend on depths.
        let any = ClipRange { near: 0.5, far: 2.0 };
        let view = FrameView::from_camera(&self.camera, any, self.view_formats.depth_direction)
            .and_then(|view| view.with_model(self.model));
        view.map(|view| view.viewpoint()).map_err(|error| Found::refused(&error))
    }

    /// Where a method that goes by the last view comes from: two steps of 2 degrees.
    pub fn before(&self) -> [Viewpoint; 2] {
        let (eye, target) = (self.camera.eye().as_dvec3(), self.camera.target().as_dvec3());
        [4.0_f64, 2.0].map(|degrees| {
            let turned = target + DQuat::from_rotation_y(degrees.to_radians()) * (eye - target);
            match self.camera.viewpoint() {
                Viewpoint::Perspective { .. } => seen_from(turned.as_vec3()),
                Viewpoint::Orthographic { .. } => {
                    Viewpoint::Orthographic { toward_viewer: (turned - target).as_vec3() }
                }
            }
        })
    }

    /// The options of a method: those that prepare quickly, then those of the scene that it has.
    ///
    /// # Errors
    /// [`OptionError`] where a value does not fit.
    pub fn options_of(&self, specs: &'static [OptionSpec]) -> Result<OptionValues, OptionError> {
        let mut words: Vec<String> = Vec::new();
        let own = self.options.iter().map(|word| word.split_once('=').unwrap_or((word, "")));
        for (name, value) in QUICK.into_iter().chain(own) {
            if specs.iter().any(|spec| spec.name == name) {
                words.retain(|word| word.split('=').next() != Some(name));
                words.push(format!("{name}={value}"));
            }
        }
        OptionValues::parse(specs, words.iter().map(String::as_str))
    }

    /// Whether a method has an option that the scene sets.
    pub fn concerns(&self, specs: &'static [OptionSpec]) -> bool {
        self.options.iter().any(|word| specs.iter().any(|spec| word.split('=').next() == Some(spec.name)))
    }
}

/// A camera at `eye` that looks at `target` with this field of view.
pub fn looking(eye: Vec3, target: Vec3, fov_deg: f64) -> Camera {
    silhouette_testing::views::look(eye, target, fov_deg, SIZE)
}

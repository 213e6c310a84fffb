//! [`View`]: the camera on screen, and how hands move it.

use glam::{DQuat, DVec3, Vec3};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, Projection, UpAxis, ViewError, ViewPreset};
use silhouettes::application::{CameraArguments, Failure};

/// Field of view of a perspective where none was chosen, in degrees: the command line's.
const DEFAULT_FOV_DEG: f64 = 40.0;

/// What fields of view the slider offers, in degrees.
pub const FOV_DEG: std::ops::RangeInclusive<f64> = 1.0..=150.0;

/// Turn for each point that the pointer is dragged.
const RAD_PER_POINT: f64 = 0.01;

/// How close to the target, or how far from it, the eye goes, in radii of the mesh.
const DISTANCE_RADII: std::ops::RangeInclusive<f64> = 1e-3..=1e3;

/// The camera on screen. What the command line calls a thing it is called here.
#[derive(Debug, Clone)]
pub struct View {
    camera: Camera,
    bounds: Bounds,
    origin: DVec3,
    /// Which axis of the mesh points up in named views, and which dragging turns about.
    pub up_axis: UpAxis,
    fov_deg: f64,
    /// What the camera was made of, unless it has been moved since.
    made_of: Option<CameraArguments>,
}

impl View {
    /// The view that the command line's options make of a mesh with these bounds, which count from `origin`.
    ///
    /// # Errors
    /// [`Failure::Input`]: the options do not make a camera.
    pub fn new(arguments: &CameraArguments, bounds: Bounds, origin: DVec3, size: [u32; 2]) -> Result<Self, Failure> {
        let camera = arguments.with_size(size).camera(&bounds, origin)?;
        let fov_deg = arguments.fov_deg().unwrap_or(DEFAULT_FOV_DEG);
        let mut view = Self { camera, bounds, origin, up_axis: arguments.up_axis(), fov_deg, made_of: None };
        view.set(Ok(camera));
        view.made_of = Some(arguments.clone());
        Ok(view)
    }

    /// The camera.
    pub fn camera(&self) -> Camera {
        self.camera
    }

    /// The camera for another viewport, in pixels.
    ///
    /// # Errors
    /// [`ViewError::Viewport`].
    pub fn camera_of_size(&self, size: [u32; 2]) -> Result<Camera, ViewError> {
        self.camera.with_size(size)
    }

    /// Takes the viewport to be this large, in pixels. What the mesh was to fit in, it fits in then.
    ///
    /// # Errors
    /// [`Failure::Input`]: there is no such viewport.
    pub fn resize(&mut self, size: [u32; 2]) -> Result<(), Failure> {
        if size == self.camera.size() {
            return Ok(());
        }
        let made_of = self.made_of.take();
        let camera = match &made_of {
            Some(arguments) => arguments.with_size(size).camera(&self.bounds, self.origin)?,
            None => self.camera.with_size(size)?,
        };
        self.set(Ok(camera));
        self.made_of = made_of;
        Ok(())
    }

    /// What the mesh spans.
    pub fn bounds(&self) -> &Bounds {
        &self.bounds
    }

    /// Whether the projection is orthographic.
    pub fn is_orthographic(&self) -> bool {
        matches!(self.camera.projection(), Projection::Orthographic { .. })
    }

    /// Vertical field of view of the perspective, in degrees.
    pub fn fov_deg(&self) -> f64 {
        self.fov_deg
    }

    /// Sees the mesh as a path does, with a field of view in degrees where that is a perspective.
    pub fn show(&mut self, camera: Camera, fov_deg: Option<f64>, up_axis: UpAxis) {
        self.fov_deg = fov_deg.unwrap_or(self.fov_deg);
        self.up_axis = up_axis;
        self.set(Ok(camera));
    }

    /// Azimuth and elevation of the eye about the target in degrees, as paths count them: from the front towards the right.
    pub fn azimuth_and_elevation_deg(&self) -> [f64; 2] {
        let offset = self.offset().normalize();
        let [right, up, front] = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| offset.dot(self.up_axis.from_y_up(axis)));
        [right.atan2(front).to_degrees(), up.clamp(-1.0, 1.0).asin().to_degrees()]
    }

    /// A named view that the mesh fits in, projected as now.
    ///
    /// # Errors
    /// [`Failure::Input`].
    pub fn name(&mut self, preset: ViewPreset) -> Result<(), Failure> {
        let name = ViewPreset::NAMED.iter().find(|(_, named)| *named == preset).map_or("", |(name, _)| name);
        let fov = self.fov_deg.to_string();
        let up_axis = if self.up_axis == UpAxis::Z { "z" } else { "y" };
        let projection = if self.is_orthographic() { ["--ortho", "fit"] } else { ["--fov", &fov] };
        let words = ["--view", name, "--up-axis", up_axis].into_iter().chain(projection);
        let arguments = CameraArguments::of_words(words)?.with_size(self.camera.size());
        let camera = arguments.camera(&self.bounds, self.origin)?;
        self.set(Ok(camera));
        self.made_of = Some(arguments);
        Ok(())
    }

    /// The options that have the command line draw this view in a picture of this size.
    pub fn words(&self, size: [u32; 2]) -> Vec<String> {
        let camera = &self.camera;
        let [eye, target] = [camera.eye(), camera.target()].map(|point| {
            let DVec3 { x, y, z } = point.as_dvec3() + self.origin;
            format!("{x},{y},{z}")
        });
        let up = camera.up();
        let projection = match camera.projection() {
            Projection::Perspective { .. } => ["--fov".to_owned(), self.fov_deg.to_string()],
            Projection::Orthographic { height } => ["--ortho".to_owned(), height.to_string()],
        };
        let words = [
            ["--eye".to_owned(), eye],
            ["--target".to_owned(), target],
            ["--up".to_owned(), format!("{},{},{}", up.x, up.y, up.z)],
            projection,
            ["--size".to_owned(), format!("{}x{}", size[0], size[1])],
        ];
        words.into_iter().flatten().collect()
    }

    /// Turns the eye about the target: about the up axis for a drag to the side, over and under it for one up or down, never past
    /// the pole. In points of the window.
    pub fn orbit(&mut self, [right, down]: [f64; 2]) {
        let up_axis = self.up_axis.from_y_up(DVec3::Y);
        let (offset, up) = (self.offset(), self.true_up());
        let side = up.cross(offset).normalize();
        let around = DQuat::from_axis_angle(up_axis, -right * RAD_PER_POINT);
        let over = DQuat::from_axis_angle(side, -down * RAD_PER_POINT);
        let is_upright = |turn: DQuat| (turn * up).dot(up_axis) >= 0.0 || up.dot(up_axis) < 0.0;
        let turn = if is_upright(around * over) { around * over } else { around };
        self.place(turn * offset, turn * up);
    }

    /// Turns the eye about the up axis.
    pub fn turn(&mut self, angle_rad: f64) {
        self.orbit([-angle_rad / RAD_PER_POINT, 0.0]);
    }

    /// Moves eye and target, so that what is at the target follows the pointer. In pixels of the picture.
    pub fn pan(&mut self, [right, down]: [f64; 2]) {
        let offset = self.offset();
        let up = self.true_up();
        let side = up.cross(offset).normalize();
        let units = 1.0 / self.camera.pixels_per_unit(offset.length());
        let moved = (up * down - side * right) * units;
        let [eye, target] = [self.camera.eye(), self.camera.target()].map(|point| (point.as_dvec3() + moved).as_vec3());
        self.set(Camera::new(eye, target, up.as_vec3(), self.camera.projection(), self.camera.size()));
    }

    /// Takes the eye closer to the target, or away from it by a factor above 1. An orthographic view shows less or more instead.
    pub fn dolly(&mut self, factor: f64) {
        if let Projection::Orthographic { height } = self.camera.projection() {
            let height = (height * factor).clamp(self.reach(DISTANCE_RADII.start()), self.reach(DISTANCE_RADII.end()));
            self.project(Projection::Orthographic { height });
        } else {
            let distance = self.offset().length();
            let reached =
                (distance * factor).clamp(self.reach(DISTANCE_RADII.start()), self.reach(DISTANCE_RADII.end()));
            self.place(self.offset() * (reached / distance), self.true_up());
        }
    }

    /// Makes the picture show more by a factor above 1, or less, from where the eye is.
    pub fn zoom(&mut self, factor: f64) {
        if self.is_orthographic() {
            self.dolly(factor);
        } else {
            let half = (self.fov_deg.to_radians() * 0.5).tan() * factor;
            self.set_fov(2.0 * half.atan().to_degrees());
        }
    }

    /// Sets the field of view of the perspective, in degrees.
    pub fn set_fov(&mut self, fov_deg: f64) {
        self.fov_deg = fov_deg.clamp(*FOV_DEG.start(), *FOV_DEG.end());
        if !self.is_orthographic() {
            self.project(Projection::Perspective { fov_y_rad: self.fov_deg.to_radians() });
        }
    }

    /// Changes between perspective and orthographic; what is at the target keeps its size.
    pub fn set_orthographic(&mut self, is_wanted: bool) {
        if is_wanted == self.is_orthographic() {
            return;
        }
        let half = (self.fov_deg.to_radians() * 0.5).tan();
        match self.camera.projection() {
            Projection::Perspective { .. } => {
                let height = 2.0 * half * self.offset().length();
                self.project(Projection::Orthographic { height });
            }
            Projection::Orthographic { height } => {
                let distance = height / (2.0 * half);
                self.place(self.offset().normalize() * distance, self.true_up());
                self.project(Projection::Perspective { fov_y_rad: self.fov_deg.to_radians() });
            }
        }
    }

    /// From the target to the eye.
    fn offset(&self) -> DVec3 {
        self.camera.eye().as_dvec3() - self.camera.target().as_dvec3()
    }

    /// What points up in the picture, at a right angle to the line of sight and of length 1.
    fn true_up(&self) -> DVec3 {
        let offset = self.offset();
        self.camera.up().as_dvec3().reject_from(offset).normalize()
    }

    fn reach(&self, radii: &f64) -> f64 {
        self.bounds.radius.max(f64::from(f32::MIN_POSITIVE)) * radii
    }

    fn place(&mut self, offset: DVec3, up: DVec3) {
        let eye = (self.camera.target().as_dvec3() + offset).as_vec3();
        let camera = &self.camera;
        self.set(Camera::new(eye, camera.target(), up.as_vec3(), camera.projection(), camera.size()));
    }

    fn project(&mut self, projection: Projection) {
        let camera = &self.camera;
        self.set(Camera::new(camera.eye(), camera.target(), camera.up(), projection, camera.size()));
    }

    /// A move beyond what a camera can be is not made. Eye and target are rounded to what is left of them in the file's
    /// coordinates, in which words state them.
    fn set(&mut self, camera: Result<Camera, ViewError>) {
        let rounded = |point: Vec3| (point.as_dvec3() + self.origin - self.origin).as_vec3();
        let stated = camera.and_then(|camera| {
            let (eye, target) = (rounded(camera.eye()), rounded(camera.target()));
            Camera::new(eye, target, camera.up(), camera.projection(), camera.size())
        });
        if let Ok(camera) = stated {
            self.camera = camera;
            self.made_of = None;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOUNDS: Bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE, center: DVec3::ZERO, radius: 1.8 };
    const SIZE: [u32; 2] = [640, 480];

    fn view(words: &[&str]) -> View {
        let arguments = CameraArguments::of_words(words.iter().copied()).unwrap();
        View::new(&arguments, BOUNDS, DVec3::new(1e5, -20.5, 3e-3), SIZE).unwrap()
    }

    /// Where a point appears.
    fn pixel(view: &View, point: DVec3) -> glam::DVec2 {
        view.camera().project(point).unwrap().pixel
    }

    #[test]
    fn its_words_make_the_same_camera() {
        for words in
            [&["--view", "iso"][..], &["--view", "top", "--ortho", "fit"], &["--fov", "23.7", "--up-axis", "z"]]
        {
            let mut view = view(words);
            for step in 0..20 {
                view.orbit([7.3, -2.9]);
                view.pan([3.0, f64::from(step)]);
                view.dolly(0.97);
                view.zoom(1.02);
                let words = view.words([800, 600]);
                let arguments = CameraArguments::of_words(words.iter().map(String::as_str)).unwrap();
                let again = arguments.camera(&BOUNDS, DVec3::new(1e5, -20.5, 3e-3)).unwrap();
                assert_eq!(again, view.camera_of_size([800, 600]).unwrap(), "{words:?}");
            }
        }
    }

    #[test]
    fn an_orbit_keeps_the_distance_the_target_and_the_pole_above() {
        for words in [&["--view", "front"][..], &["--view", "bottom", "--up-axis", "z"], &["--view", "top"]] {
            let mut view = view(words);
            let (target, distance) = (view.camera().target(), view.offset().length());
            for [right, down] in [[50.0, 3.0], [-10.0, 900.0], [0.0, -2000.0], [400.0, 10.0], [3.0, 4000.0]] {
                for _ in 0..40 {
                    view.orbit([right / 40.0, down / 40.0]);
                    let camera = view.camera();
                    assert!(camera.target() == target && (view.offset().length() / distance - 1.0).abs() < 1e-5);
                    let up_axis = view.up_axis.from_y_up(DVec3::Y);
                    assert!(camera.up().as_dvec3().dot(up_axis) > -1e-6, "{camera:?}");
                }
            }
        }
        let mut view = view(&["--view", "front"]);
        view.orbit([std::f64::consts::FRAC_PI_2 / RAD_PER_POINT, 0.0]);
        assert!(
            view.camera().eye().normalize().distance(Vec3::NEG_X) < 1e-5,
            "a drag to the right shows the left side"
        );
    }

    #[test]
    fn what_is_at_the_target_follows_the_pointer() {
        for words in [&["--view", "iso"][..], &["--view", "left", "--ortho", "fit"]] {
            let mut view = view(words);
            let target = view.camera().target().as_dvec3();
            let before = pixel(&view, target);
            view.pan([31.0, -17.0]);
            let moved = pixel(&view, target) - before;
            assert!(moved.distance(glam::DVec2::new(31.0, -17.0)) < 1e-2, "{moved}");
        }
    }

    #[test]
    fn what_is_at_the_target_keeps_its_size_when_the_projection_changes() {
        let mut view = view(&["--view", "front"]);
        let across = |view: &View| pixel(view, DVec3::X * 0.5).distance(pixel(view, DVec3::X * -0.5));
        let before = across(&view);
        view.set_orthographic(true);
        assert!(view.is_orthographic() && (across(&view) / before - 1.0).abs() < 1e-4);
        view.dolly(0.5);
        assert!((across(&view) / before - 2.0).abs() < 1e-4);
        view.set_orthographic(false);
        assert!(!view.is_orthographic() && (across(&view) / before - 2.0).abs() < 1e-4);
        view.zoom(2.0);
        assert!((across(&view) / before - 1.0).abs() < 1e-4, "a view twice as wide shows it half as large");
    }

    #[test]
    fn the_mesh_fits_a_viewport_of_another_size_until_it_is_moved() {
        let mut view = view(&["--view", "iso"]);
        view.resize([200, 900]).unwrap();
        let arguments = CameraArguments::of_words(["--view", "iso", "--size", "200x900"]).unwrap();
        let fitted = arguments.camera(&BOUNDS, DVec3::ZERO).unwrap();
        assert!(view.camera().eye().distance(fitted.eye()) < 1e-4, "{:?}", view.camera());
        view.orbit([3.0, 0.0]);
        let eye = view.camera().eye();
        view.resize(SIZE).unwrap();
        assert_eq!((view.camera().eye(), view.camera().size()), (eye, SIZE));
    }

    #[test]
    fn moves_end_where_cameras_do() {
        let mut view = view(&[]);
        (0..2000).for_each(|_| view.dolly(0.5));
        assert!(view.offset().length() >= 1.8e-3 * 0.99);
        (0..2000).for_each(|_| view.dolly(2.0));
        (0..100).for_each(|_| view.zoom(2.0));
        assert!(view.fov_deg() <= *FOV_DEG.end() && view.offset().length() <= 1.8e3 * 1.01);
    }

    #[test]
    fn named_views_are_the_command_line_s() {
        let mut moved = view(&["--up-axis", "z", "--fov", "30"]);
        moved.orbit([100.0, 20.0]);
        moved.name(ViewPreset::Right).unwrap();
        assert_eq!(moved.camera(), view(&["--up-axis", "z", "--fov", "30", "--view", "right"]).camera());
        moved.set_orthographic(true);
        moved.name(ViewPreset::Top).unwrap();
        assert_eq!(moved.camera(), view(&["--up-axis", "z", "--ortho", "fit", "--view", "top"]).camera());
    }
}

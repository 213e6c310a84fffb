//! [`FrameView`]: everything between a mesh's own space and the pixels of a target.

use crate::depth_law::DepthLaw;
use crate::frame_view_error::FrameViewError;
use glam::{DMat3, DMat4, DVec3, DVec4, Vec3, Vec4Swizzles};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, ClipRange, DepthDirection, Viewpoint};

/// A rectangle of a target, in pixels. Renderers draw into it and nowhere else.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Viewport {
    /// Top left corner.
    pub origin_px: [u32; 2],
    /// Width and height, above 0.
    pub size_px: [u32; 2],
}

impl Viewport {
    /// All of a target of this size.
    pub const fn whole(size_px: [u32; 2]) -> Self {
        Self { origin_px: [0, 0], size_px }
    }

    /// Makes it the viewport of a pass, for all depths.
    pub fn set(&self, pass: &mut wgpu::RenderPass<'_>) {
        let ([x, y], [width, height]) = (self.origin_px.map(|side| side as f32), self.size_px.map(|side| side as f32));
        pass.set_viewport(x, y, width, height, 0.0, 1.0);
    }
}

/// What a renderer draws for: view, projection and model matrix, and the viewport.
///
/// Matrices act on column vectors, as in glam and in WGSL. Clip space is WebGPU's: y up, depth 0 to 1. *Depth* is the
/// distance along the viewing axis in units of view space, above 0 in front of the viewer. View space may be right-handed
/// or left-handed.
///
/// Facing is decided in the mesh's own space by [`viewpoint`](Self::viewpoint), the viewer carried there by the inverse of the
/// model matrix. A model matrix that mirrors leaves the facing of faces as it is and turns their winding in the image around
/// ([`is_mirrored`](Self::is_mirrored)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameView {
    view: DMat4,
    projection: DMat4,
    model: DMat4,
    viewport: Viewport,
    direction: DepthDirection,
    law: DepthLaw,
    /// The eye with w = 1, or a direction towards the viewer with w = 0, in world space.
    world_eye: DVec4,
    /// The same in the mesh's own space.
    object_eye: DVec4,
    is_mirrored: bool,
}

impl FrameView {
    /// What `camera` shows between the depths of `range`, in the whole of a target as large as the camera's viewport. The far
    /// plane of a perspective may be infinite.
    ///
    /// # Errors
    /// [`FrameViewError::Depths`] where `range` is none: near not above 0 in a perspective, or far not beyond near.
    pub fn from_camera(camera: &Camera, range: ClipRange, direction: DepthDirection) -> Result<Self, FrameViewError> {
        let projection = camera.clip_matrix(range, direction);
        let law = finite(projection, "projection").and_then(|()| DepthLaw::new(projection, direction));
        let law = law.map_err(|_| FrameViewError::Depths(direction))?;
        let world_eye = match camera.viewpoint() {
            Viewpoint::Perspective { eye } => eye.as_dvec3().extend(1.0),
            Viewpoint::Orthographic { toward_viewer } => toward_viewer.as_dvec3().extend(0.0),
        };
        Self {
            view: camera.view_matrix(),
            projection,
            model: DMat4::IDENTITY,
            viewport: Viewport::whole(camera.size()),
            direction,
            law,
            world_eye,
            object_eye: world_eye,
            is_mirrored: false,
        }
        .completed()
    }

    /// The caller's own matrices: world to view space, and view to clip space. Off-axis projections, sub-pixel jitter, either
    /// depth direction and an infinite far plane are all served.
    ///
    /// # Errors
    /// [`FrameViewError`] says which matrix is at fault.
    pub fn from_matrices(
        view: DMat4,
        projection: DMat4,
        direction: DepthDirection,
        viewport: Viewport,
    ) -> Result<Self, FrameViewError> {
        check_affine(view, "view")?;
        check(projection, "projection")?;
        let law = DepthLaw::new(projection, direction)?;
        let world_eye = eye_of(projection * view, &law, |toward| view.transform_vector3(toward).z);
        Self {
            view,
            projection,
            model: DMat4::IDENTITY,
            viewport,
            direction,
            law,
            world_eye,
            object_eye: world_eye,
            is_mirrored: false,
        }
        .completed()
    }

    /// The same view of a mesh that `model` places in the world: any affine map that can be inverted, mirrors and non-uniform
    /// scale included.
    ///
    /// # Errors
    /// [`FrameViewError`] where the matrix has no inverse or is not affine.
    pub fn with_model(self, model: DMat4) -> Result<Self, FrameViewError> {
        check_affine(model, "model")?;
        Self { model, ..self }.completed()
    }

    /// The same view in another rectangle of the target.
    ///
    /// # Errors
    /// [`FrameViewError::Viewport`].
    pub fn with_viewport(self, viewport: Viewport) -> Result<Self, FrameViewError> {
        Self { viewport, ..self }.completed()
    }

    /// A rectangle of the viewport, drawn at `scale` x `scale` pixels per pixel, in the whole of a target that it fills. The
    /// rectangle may reach beyond the viewport; `origin_px` counts from the viewport's top left corner.
    ///
    /// # Errors
    /// [`FrameViewError::Viewport`] where the rectangle has no pixel.
    pub fn tile(self, origin_px: [i32; 2], size_px: [u32; 2], scale: u32) -> Result<Self, FrameViewError> {
        let [x, y] = [0, 1].map(|axis| {
            let (full, part) = (f64::from(self.viewport.size_px[axis]), f64::from(size_px[axis]));
            let from_middle = f64::from(origin_px[axis]) + 0.5 * part - 0.5 * full;
            (full / part, -2.0 * from_middle / part)
        });
        // Pixels count downwards, clip space upwards.
        let crop = DMat4::from_translation(DVec3::new(x.1, -y.1, 0.0)) * DMat4::from_scale(DVec3::new(x.0, y.0, 1.0));
        let viewport = Viewport::whole(size_px.map(|side| side.saturating_mul(scale)));
        Self { projection: crop * self.projection, viewport, ..self }.completed()
    }

    /// Checks the viewport and derives what depends on the model matrix.
    fn completed(mut self) -> Result<Self, FrameViewError> {
        if self.viewport.size_px.contains(&0) {
            return Err(FrameViewError::Viewport);
        }
        let to_object = self.model.inverse();
        if !to_object.is_finite() {
            return Err(FrameViewError::Singular { matrix: "model" });
        }
        self.object_eye = to_object * self.world_eye;
        let [x, y, w] = [0, 1, 3].map(|row| self.object_to_clip().row(row));
        self.is_mirrored = cross(x, y, w).dot(self.object_eye) < 0.0;
        Ok(self)
    }

    /// The mesh's own space to clip space.
    pub fn object_to_clip(&self) -> DMat4 {
        self.projection * self.object_to_view()
    }

    /// The mesh's own space to view space.
    pub fn object_to_view(&self) -> DMat4 {
        self.view * self.model
    }

    /// View to clip space.
    pub fn projection(&self) -> DMat4 {
        self.projection
    }

    /// The mesh's own space to world space.
    pub fn model(&self) -> DMat4 {
        self.model
    }

    /// How depths relate to values of the depth buffer.
    pub fn depth_law(&self) -> &DepthLaw {
        &self.law
    }

    /// Which end of the depth buffer is near.
    pub fn depth_direction(&self) -> DepthDirection {
        self.direction
    }

    /// The rectangle that is drawn into.
    pub fn viewport(&self) -> Viewport {
        self.viewport
    }

    /// Where the mesh is seen from, in its own space, rounded to 32 bits: what facing depends on.
    pub fn viewpoint(&self) -> Viewpoint {
        let vector: Vec3 = self.object_eye.truncate().as_vec3();
        if self.is_perspective() {
            Viewpoint::Perspective { eye: vector }
        } else {
            Viewpoint::Orthographic { toward_viewer: vector }
        }
    }

    /// The eye with w = 1, or a direction towards the viewer of any length with w = 0, in the mesh's own space.
    pub fn object_eye(&self) -> DVec4 {
        self.object_eye
    }

    /// Whether depth makes things smaller.
    pub fn is_perspective(&self) -> bool {
        self.law.is_perspective()
    }

    /// Whether front faces run clockwise in the image, which a model or view matrix that mirrors brings about.
    pub fn is_mirrored(&self) -> bool {
        self.is_mirrored
    }

    /// The depth of a point of the mesh's own space.
    pub fn depth(&self, object: DVec3) -> f64 {
        self.law.depth_of_view_z(self.object_to_view().transform_point3(object).z)
    }

    /// Pixels that a unit of view space covers at `depth`, across the view.
    pub fn pixels_per_unit(&self, depth: f64) -> f64 {
        let up = self.projection.row(1);
        0.5 * f64::from(self.viewport.size_px[1]) * up.x.hypot(up.y) / self.law.w_at(depth)
    }

    /// Radius in view space of what lies within these bounds in object space: of its bounding sphere or its box, whichever the model
    /// matrix makes the smaller one.
    pub fn radius(&self, bounds: &Bounds) -> f64 {
        let half = (bounds.max - bounds.min) * 0.5;
        let to_view = DMat3::from_mat4(self.object_to_view());
        let corner = |signs: [f64; 2]| (to_view * (half * DVec3::new(1.0, signs[0], signs[1]))).length();
        let farthest = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(corner).into_iter().fold(0.0, f64::max);
        farthest.min(bounds.radius * self.largest_scale())
    }

    /// The largest length in view space of a unit vector of the mesh's own space.
    pub fn largest_scale(&self) -> f64 {
        let linear = DMat3::from_mat4(self.object_to_view());
        let squares = linear.transpose() * linear;
        // Power iteration from each column reaches the largest eigenvalue to well below a percent, which bounds need.
        let grown = |start: DVec3| (0..24).fold(start, |v, _| (squares * v).normalize_or_zero());
        [squares.x_axis, squares.y_axis, squares.z_axis]
            .map(|column| (linear * grown(column)).length())
            .into_iter()
            .fold(0.0, f64::max)
    }
}

fn finite(matrix: DMat4, name: &'static str) -> Result<(), FrameViewError> {
    if matrix.is_finite() { Ok(()) } else { Err(FrameViewError::NotFinite { matrix: name }) }
}

fn check(matrix: DMat4, name: &'static str) -> Result<(), FrameViewError> {
    finite(matrix, name)?;
    let is_regular = matrix.determinant().is_normal() && matrix.inverse().is_finite();
    if is_regular { Ok(()) } else { Err(FrameViewError::Singular { matrix: name }) }
}

fn check_affine(matrix: DMat4, name: &'static str) -> Result<(), FrameViewError> {
    finite(matrix, name)?;
    if matrix.row(3) != DVec4::W {
        return Err(FrameViewError::NotAffine { matrix: name });
    }
    check(matrix, name)
}

/// The vector that is orthogonal to three others, as the expansion of their determinant along a fourth row has it.
fn cross(a: DVec4, b: DVec4, c: DVec4) -> DVec4 {
    let without = |v: DVec4, skip: usize| match skip {
        0 => v.yzw(),
        1 => v.xzw(),
        2 => v.xyw(),
        _ => v.xyz(),
    };
    let minor = |skip| DMat3::from_cols(without(a, skip), without(b, skip), without(c, skip)).determinant();
    DVec4::new(minor(0), -minor(1), minor(2), -minor(3))
}

/// The one point that projects to no pixel: the eye of a perspective, or the direction towards the viewer.
fn eye_of(to_clip: DMat4, law: &DepthLaw, view_z_of: impl Fn(DVec3) -> f64) -> DVec4 {
    let eye = cross(to_clip.row(0), to_clip.row(1), to_clip.row(3));
    if law.is_perspective() {
        return eye / eye.w;
    }
    let toward = eye.truncate().normalize();
    let is_away = law.depth_of_view_z(view_z_of(toward)) > 0.0;
    (if is_away { -toward } else { toward }).extend(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DQuat, DVec2, DVec3};
    use silhouette_core::view::Projection;

    const RANGE: ClipRange = ClipRange { near: 0.5, far: 50.0 };
    const SIZE: [u32; 2] = [300, 200];
    const DIRECTIONS: [DepthDirection; 2] = [DepthDirection::Standard, DepthDirection::Reversed];

    fn cameras() -> [Camera; 2] {
        [Projection::Perspective { fov_y_rad: 0.8 }, Projection::Orthographic { height: 6.0 }].map(|projection| {
            Camera::new(Vec3::new(1.0, 2.0, 5.0), Vec3::new(0.1, -0.2, 0.3), Vec3::Y, projection, SIZE).unwrap()
        })
    }

    /// Where a point of the mesh's own space appears, in pixels of the target.
    fn pixel(view: &FrameView, object: DVec3) -> DVec2 {
        let ndc = view.object_to_clip().project_point3(object);
        let [x, y] = view.viewport().origin_px.map(f64::from);
        let [width, height] = view.viewport().size_px.map(f64::from);
        DVec2::new(x + (ndc.x + 1.0) * 0.5 * width, y + (1.0 - ndc.y) * 0.5 * height)
    }

    fn direction_of(viewpoint: Viewpoint) -> Vec3 {
        match viewpoint {
            Viewpoint::Perspective { eye } => eye,
            Viewpoint::Orthographic { toward_viewer } => toward_viewer.normalize(),
        }
    }

    #[test]
    fn matrices_of_a_camera_make_the_camera_s_view() {
        for camera in cameras() {
            for direction in DIRECTIONS {
                let own = FrameView::from_camera(&camera, RANGE, direction).unwrap();
                assert_eq!(own.viewpoint(), camera.viewpoint(), "the same bits");
                let clip = camera.clip_matrix(RANGE, direction);
                let viewport = Viewport { origin_px: [20, 30], size_px: SIZE };
                let given = FrameView::from_matrices(camera.view_matrix(), clip, direction, viewport).unwrap();
                let [a, b] = [own, given].map(|view| direction_of(view.viewpoint()));
                let expected = direction_of(camera.viewpoint());
                assert!(a.distance(expected) < 1e-6 && b.distance(expected) < 1e-5, "{a} {b}");
                assert!(!own.is_mirrored() && !given.is_mirrored());
                let point = DVec3::new(0.4, -0.3, 0.9);
                let seen = camera.project(point).unwrap();
                assert!((pixel(&own, point) - seen.pixel).length() < 1e-9);
                assert!((pixel(&given, point) - seen.pixel - DVec2::new(20.0, 30.0)).length() < 1e-9);
                assert!((given.depth(point) - seen.depth).abs() < 1e-9);
                assert!((given.pixels_per_unit(2.0) - camera.pixels_per_unit(2.0)).abs() < 1e-9);
            }
        }
    }

    /// A left-handed view space, off-axis and jittered, with an infinite far plane.
    #[test]
    fn left_handed_off_axis_and_infinite_projections_find_the_same_eye() {
        let [camera, _] = cameras();
        let view = camera.view_matrix();
        let flip = DMat4::from_scale(DVec3::new(1.0, 1.0, -1.0));
        let mut off_axis = camera.clip_matrix(ClipRange { near: 0.1, far: f64::INFINITY }, DepthDirection::Reversed);
        off_axis.z_axis.x += 0.3;
        off_axis.z_axis.y -= 0.001;
        for (view, projection) in [(view, off_axis), (flip * view, off_axis * flip)] {
            let made =
                FrameView::from_matrices(view, projection, DepthDirection::Reversed, Viewport::whole(SIZE)).unwrap();
            assert!(direction_of(made.viewpoint()).distance(camera.eye()) < 1e-5);
            assert!(!made.is_mirrored() && made.depth_law().range().far.is_infinite());
            assert!((made.depth(DVec3::ZERO) - camera.project(DVec3::ZERO).unwrap().depth).abs() < 1e-9);
        }
    }

    /// A face's plane at the viewpoint and its winding in the image agree, mirrored or not.
    #[test]
    fn facing_in_object_space_is_the_winding_in_the_image() {
        let models = [
            DMat4::IDENTITY,
            DMat4::from_scale_rotation_translation(
                DVec3::new(2.0, 0.3, -1.0),
                DQuat::from_rotation_x(0.7),
                DVec3::new(0.2, 0.1, -0.4),
            ),
            DMat4::from_scale(DVec3::new(-1.0, 1e-3, 1.0)),
        ];
        let triangle = [DVec3::new(0.1, 0.0, 0.2), DVec3::new(0.9, 0.1, 0.0), DVec3::new(0.3, 0.8, 0.1)];
        let mut seen = [false; 2];
        for camera in cameras() {
            for model in models {
                let view = FrameView::from_camera(&camera, RANGE, DepthDirection::Reversed).unwrap();
                let view = view.with_model(model).unwrap();
                let eye = view.object_eye();
                let normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
                let is_front = normal.dot(eye.truncate() - triangle[0] * eye.w) > 0.0;
                let [a, b, c] = triangle.map(|corner| pixel(&view, corner));
                // Pixels count downwards, so that counter-clockwise has a negative area.
                let is_counter_clockwise = (b - a).perp_dot(c - a) < 0.0;
                assert_eq!(is_front, is_counter_clockwise != view.is_mirrored(), "{camera:?} {model}");
                assert_eq!(view.is_mirrored(), model.determinant() < 0.0);
                seen[usize::from(view.is_mirrored())] = true;
            }
        }
        assert_eq!(seen, [true; 2]);
    }

    #[test]
    fn a_tile_shows_its_part_of_the_viewport() {
        let [camera, _] = cameras();
        let whole = FrameView::from_camera(&camera, RANGE, DepthDirection::Reversed).unwrap();
        let part = whole.tile([-10, 120], [50, 40], 3).unwrap();
        assert_eq!(part.viewport(), Viewport::whole([150, 120]));
        for object in [DVec3::ZERO, DVec3::new(0.4, -0.3, 0.9)] {
            let expected = camera.project(object).unwrap().pixel;
            let seen = pixel(&part, object) / 3.0 + DVec2::new(-10.0, 120.0);
            assert!((seen - expected).length() < 1e-9, "{seen} {expected}");
        }
        assert!((part.pixels_per_unit(2.0) / whole.pixels_per_unit(2.0) - 3.0).abs() < 1e-9);
    }

    #[test]
    fn scales_are_bounded_by_the_largest() {
        let [camera, _] = cameras();
        let view = FrameView::from_camera(&camera, RANGE, DepthDirection::Reversed).unwrap();
        assert!((view.largest_scale() - 1.0).abs() < 1e-9);
        let model = DMat4::from_quat(DQuat::from_rotation_y(1.0)) * DMat4::from_scale(DVec3::new(3.0, 1e-3, 2.9));
        assert!((view.with_model(model).unwrap().largest_scale() / 3.0 - 1.0).abs() < 0.01);
    }

    #[test]
    fn matrices_that_make_no_view_are_refused_by_name() {
        let [camera, _] = cameras();
        let direction = DepthDirection::Reversed;
        let (view, clip) = (camera.view_matrix(), camera.clip_matrix(RANGE, direction));
        let whole = Viewport::whole(SIZE);
        let made = FrameView::from_matrices(view, clip, direction, whole).unwrap();
        let refused = |result: Result<FrameView, FrameViewError>| result.unwrap_err();
        let nan = DMat4::from_scale(DVec3::new(1.0, f64::NAN, 1.0));
        assert_eq!(refused(made.with_model(nan)), FrameViewError::NotFinite { matrix: "model" });
        let flat = DMat4::from_scale(DVec3::new(1.0, 0.0, 1.0));
        assert_eq!(refused(made.with_model(flat)), FrameViewError::Singular { matrix: "model" });
        assert_eq!(refused(made.with_model(clip)), FrameViewError::NotAffine { matrix: "model" });
        let no_pixel = Viewport { origin_px: [0, 0], size_px: [0, 4] };
        assert_eq!(refused(made.with_viewport(no_pixel)), FrameViewError::Viewport);
        assert_eq!(
            refused(FrameView::from_matrices(flat, clip, direction, whole)),
            FrameViewError::Singular { matrix: "view" }
        );
        let standard = camera.clip_matrix(RANGE, DepthDirection::Standard);
        assert_eq!(
            refused(FrameView::from_matrices(view, standard, direction, whole)),
            FrameViewError::Depths(direction)
        );
        let backwards = ClipRange { near: 3.0, far: 2.0 };
        assert_eq!(refused(FrameView::from_camera(&camera, backwards, direction)), FrameViewError::Depths(direction));
    }
}

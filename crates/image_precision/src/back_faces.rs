//! Step 3: back faces, black, scaled about the eye. Twin of `shaders/image_precision/back_faces.wgsl`.

use silhouette_core::glam::DVec3;
use silhouette_core::view::{Camera, ClipRange, DepthDirection, Projection};

/// Where scaling by `scale` puts a point of view space: towards the eye, or along the axis for an orthographic camera.
pub fn pull(camera: &Camera, view: DVec3, scale: f64) -> DVec3 {
    match camera.projection() {
        Projection::Perspective { .. } => view * scale,
        Projection::Orthographic { .. } => view + DVec3::Z * orthographic_pull(camera, scale),
    }
}

/// How far an orthographic camera's back faces are pulled, in world units.
fn orthographic_pull(camera: &Camera, scale: f64) -> f64 {
    (1.0 - scale) * camera.eye().as_dvec3().distance(camera.target().as_dvec3())
}

/// What [`pull`] adds to clip-space z while x, y and w stay: the same for every point.
///
/// In perspective the depth buffer holds A + B / d for a depth d, as z = A d + B over w = d. At k d that is A + B / (k d),
/// or z + B (1 / k - 1) over the same w. In orthographic views it holds A d + B over w = 1, and a pull p takes away A p.
pub fn clip_z_offset(camera: &Camera, range: ClipRange, direction: DepthDirection, scale: f64) -> f64 {
    let clip = camera.clip_matrix(range, direction);
    match camera.projection() {
        Projection::Perspective { .. } => clip.w_axis.z * (1.0 / scale - 1.0),
        // View-space z is -d, so this entry is -A.
        Projection::Orthographic { .. } => clip.z_axis.z * orthographic_pull(camera, scale),
    }
}

/// `range` with its near plane as far in as [`pull`] brings a point on it.
pub fn widened(camera: &Camera, range: ClipRange, scale: f64) -> ClipRange {
    let near = match camera.projection() {
        Projection::Perspective { .. } => range.near * scale,
        Projection::Orthographic { .. } => range.near - orthographic_pull(camera, scale),
    };
    ClipRange { near, ..range }
}

/// Width of the ink on a smooth rim, in world units across the view, for a pull in world units and the surface's radius
/// of curvature along the view: `pull² / (8 radius)`.
///
/// At a distance w inside the rim, front and back of the surface are `2 sqrt(2 radius w)` apart; ink shows where the pull
/// is more. So the width falls with the square of the pull: on a sphere of radius 1 at a distance of 3, k = 0.99 pulls
/// by 0.027 and leaves 9e-5, far below a pixel of most images; k = 0.95 pulls by 0.13 and leaves 2e-3. Holds for pulls
/// well below the radius. At a crease with inward depth slopes a and b > a of its front and back face the width is
/// `pull / (b - a)`, linear instead.
pub fn rim_width(pull: f64, radius: f64) -> f64 {
    pull * pull / (8.0 * radius)
}

#[cfg(feature = "gpu")]
pub(crate) use gpu::{BackFacesUniform, pipeline};

#[cfg(feature = "gpu")]
mod gpu {
    use bytemuck::{Pod, Zeroable};
    use silhouette_gpu::TargetFormats;

    /// Twin of the struct in `shaders/image_precision/back_faces.wgsl`.
    #[repr(C)]
    #[derive(Debug, Clone, Copy, Pod, Zeroable)]
    pub(crate) struct BackFacesUniform {
        pub clip_z_offset: f32,
    }

    /// Back faces alone, over everything as near or farther.
    pub(crate) fn pipeline(
        device: &wgpu::Device,
        layout: &wgpu::PipelineLayout,
        formats: TargetFormats,
    ) -> wgpu::RenderPipeline {
        crate::renderer::Stage {
            label: "image precision: back faces",
            wgsl: silhouette_shaders::image_precision::BACK_FACES,
            vertex: "back_vertex",
            fragment: "back_fragment",
            culled: wgpu::Face::Front,
            compare: formats.nearer_or_equal(),
        }
        .build(device, layout, formats)
    }

    #[cfg(test)]
    mod tests {
        use super::*;
        use std::mem::offset_of;

        #[test]
        fn the_uniform_is_laid_out_as_its_wgsl_twin() {
            let members = [("clip_z_offset", offset_of!(BackFacesUniform, clip_z_offset))];
            let stage = silhouette_shaders::image_precision::BACK_FACES;
            let size = size_of::<BackFacesUniform>();
            assert!(silhouette_shaders::layout::matches(stage, "BackFacesUniform", size, &members));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::Vec3;

    const RANGE: ClipRange = ClipRange { near: 1.5, far: 8.0 };

    fn cameras() -> [Camera; 2] {
        [Projection::Perspective { fov_y_rad: 0.9 }, Projection::Orthographic { height: 3.0 }]
            .map(|projection| Camera::new(Vec3::Z * 4.0, Vec3::ZERO, Vec3::Y, projection, [64, 48]).unwrap())
    }

    #[test]
    fn the_offset_does_to_the_depth_buffer_what_the_pull_does_to_the_point() {
        for camera in cameras() {
            for direction in [DepthDirection::Standard, DepthDirection::Reversed] {
                for scale in [1.0, 0.99, 0.6] {
                    let clip = camera.clip_matrix(RANGE, direction);
                    let offset = clip_z_offset(&camera, RANGE, direction, scale);
                    for view in [DVec3::new(0.3, -0.2, -2.0), DVec3::new(-1.0, 0.4, -7.5)] {
                        let pulled = clip.project_point3(pull(&camera, view, scale));
                        let unscaled = clip * view.extend(1.0);
                        let shifted = (unscaled.z + offset) / unscaled.w;
                        assert!((pulled.z - shifted).abs() < 1e-12, "{direction:?} {scale}: {pulled} {shifted}");
                        assert!((pulled.truncate() - unscaled.truncate().truncate() / unscaled.w).length() < 1e-12);
                    }
                }
            }
        }
    }

    #[test]
    fn nothing_is_pulled_across_the_widened_near_plane() {
        for camera in cameras() {
            let nearest = pull(&camera, DVec3::new(0.0, 0.0, -RANGE.near), 0.7);
            assert!((widened(&camera, RANGE, 0.7).near + nearest.z).abs() < 1e-12);
        }
    }

    #[test]
    fn the_rim_is_as_wide_as_where_the_pull_closes_the_gap() {
        // Exact for a sphere in an orthographic view: half the pull is the depth of the front at the strip's inner end.
        let (radius, pull) = (2.0_f64, 0.1_f64);
        let exact = radius - (radius * radius - 0.25 * pull * pull).sqrt();
        assert!((rim_width(pull, radius) / exact - 1.0).abs() < 1e-3);
    }
}

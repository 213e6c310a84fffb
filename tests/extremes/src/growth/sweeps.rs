//! The scenes of each sweep, from the plain one to the extreme.

use crate::meshes::{corners, slivers, torus};
use crate::scene::{SIZE, Scene, looking};
use silhouette_core::glam::{DQuat, DVec3, Vec3};
use silhouette_core::view::{Camera, ClipRange, DepthDirection, Projection, ViewPreset};
use silhouette_gpu::TargetFormats;
use silhouette_render::DEFAULT_FORMATS;
use silhouette_testing::edits::transformed;
use wgpu::TextureFormat::{Depth16Unorm, Depth24Plus, Depth32Float};

/// Scenes along an axis.
pub struct Sweep {
    /// What stands below the axis.
    pub label: &'static str,
    /// Value and scene.
    pub scenes: Vec<(f64, Scene)>,
}

fn sweep(label: &'static str, values: &[f64], scene: impl Fn(f64) -> Scene) -> Sweep {
    Sweep { label, scenes: values.iter().map(|&value| (value, scene(value))).collect() }
}

/// A scene from eyes all around, as far from the target and as high.
pub fn around(scene: &Scene, eyes: u32) -> Vec<Scene> {
    let (eye, target) = (scene.camera.eye().as_dvec3(), scene.camera.target().as_dvec3());
    let turned = |index: u32| {
        let turn = DQuat::from_rotation_y(std::f64::consts::TAU * f64::from(index) / f64::from(eyes));
        let eye = (target + turn * (eye - target)).as_vec3();
        let camera = Camera::new(eye, scene.camera.target(), Vec3::Y, scene.camera.projection(), scene.camera.size());
        Scene { camera: camera.expect("an eye beside its target"), ..scene.clone() }
    };
    (0..eyes).map(turned).collect()
}

/// The torus moved along each axis, and rounded to 32 bits there.
pub fn offset() -> Sweep {
    sweep("offset, in units of which the torus is 3 across", &[1.0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7], |by| {
        Scene::of(transformed(&torus(), 1.0, DVec3::new(by, -by, by)))
    })
}

/// The torus scaled.
pub fn scale() -> Sweep {
    sweep("scale", &[1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9, 1e12, 1e15], |scale| {
        Scene::of(transformed(&torus(), scale, DVec3::ZERO))
    })
}

/// An eye farther and farther away, with a field of view in which the torus is as large.
pub fn distance() -> Sweep {
    sweep("distance of the eye", &[4.0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9], |away| {
        let mesh = torus();
        let bounds = mesh.bounds().expect("a torus has faces");
        let (direction, up) = ViewPreset::ThreeQuarter.directions();
        let eye = (bounds.center + direction.normalize() * away).as_vec3();
        let fov_y_rad = 2.0 * (1.05 * bounds.radius / away).asin();
        let camera = Camera::new(eye, bounds.center.as_vec3(), up, Projection::Perspective { fov_y_rad }, SIZE);
        Scene::seen(mesh, camera.expect("an eye away from its target"))
    })
}

/// Slivers ever thinner.
pub fn aspect() -> Sweep {
    sweep("aspect of slivers", &[10.0, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8], |aspect| Scene::of(slivers(aspect)))
}

/// An eye closer and closer to the plane of a face.
pub fn height() -> Sweep {
    sweep("height of the eye above the plane of a face", &[1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7], |height| {
        let [a, b, c] = corners(&torus(), 40);
        let eye = a + (b - a) * 9.0 - (c - a) * 4.0 + (b - a).cross(c - a).normalize() * height;
        Scene::seen(torus(), looking(eye.as_vec3(), Vec3::new(0.05, 0.02, -0.03), 70.0))
    })
}

/// Depth buffers of more and more bits, near at 0 and a millionth of far.
pub fn depth_bits() -> Sweep {
    sweep("bits of depth, near over far 1e-6", &[16.0, 24.0, 32.0], |bits| {
        let depth = match bits as u32 {
            16 => Depth16Unorm,
            24 => Depth24Plus,
            _ => Depth32Float,
        };
        let formats = TargetFormats { depth, depth_direction: DepthDirection::Standard, ..DEFAULT_FORMATS };
        let range = Some(ClipRange { near: 1e-5, far: 10.0 });
        Scene { range, ..Scene::of(torus()).with_formats(formats) }
    })
}

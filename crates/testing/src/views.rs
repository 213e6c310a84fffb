//! Cameras that frame a mesh, orbits around it, and viewpoints that are hard to get right.

use crate::random::Random;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::view::{Framing, ViewPreset};
use silhouette_core::{Camera, FaceId, Projection, TriangleMesh, Viewpoint};

/// A perspective of 40 degrees.
pub const PERSPECTIVE: Framing = Framing::Perspective { fov_y_rad: 0.7 };

/// A camera that shows all of a mesh from a direction. Up is y; for directions close to y, x.
pub fn framed(mesh: &TriangleMesh, direction: DVec3, framing: Framing, size: [u32; 2]) -> Camera {
    let up = if direction.cross(DVec3::Y).length() > 0.1 * direction.length() { Vec3::Y } else { Vec3::X };
    Camera::framing(&mesh.bounds().unwrap(), direction, up, framing, size).unwrap()
}

/// A camera that shows all of a mesh from the command line's default direction: from the right, above and in front.
pub fn three_quarter(mesh: &TriangleMesh, framing: Framing, size: [u32; 2]) -> Camera {
    framed(mesh, ViewPreset::ThreeQuarter.directions().0, framing, size)
}

/// A perspective from `eye` towards `target`, some direction across being up.
pub fn look(eye: Vec3, target: Vec3, fov_deg: f64, size: [u32; 2]) -> Camera {
    let projection = Projection::Perspective { fov_y_rad: fov_deg.to_radians() };
    Camera::new(eye, target, (target - eye).any_orthogonal_vector(), projection, size).unwrap()
}

/// The viewpoint of an eye.
pub fn seen_from(eye: impl Into<Vec3>) -> Viewpoint {
    Viewpoint::Perspective { eye: eye.into() }
}

/// The viewpoint of an eye that many bounding-sphere radii from the middle of a mesh. Negative distances are on the other side.
pub fn seen_from_radii(mesh: &TriangleMesh, direction: DVec3, radii: f64) -> Viewpoint {
    let bounds = mesh.bounds().unwrap();
    seen_from((bounds.center + direction.normalize() * (radii * bounds.radius)).as_vec3())
}

/// `frames` viewpoints on a tilted circle around a mesh, 2.4 radii away and `step_deg` apart.
pub fn orbit(mesh: &TriangleMesh, step_deg: f64, frames: u32) -> impl Iterator<Item = Viewpoint> + '_ {
    (0..frames).map(move |frame| {
        // Begins between two axes, so that no face of a built-in shape is seen edge-on.
        let (sin, cos) = (f64::from(frame) * step_deg.to_radians() + 0.417).sin_cos();
        seen_from_radii(mesh, DVec3::new(cos, 0.34 + 0.2 * sin, sin), 2.4)
    })
}

/// Viewpoints in a face's plane, on an edge, on a vertex, inside, around and far away, and directions along an edge, anywhere
/// and along a normal: `count` of each. A mesh without faces has one viewpoint.
pub fn hard_viewpoints(mesh: &TriangleMesh, count: usize) -> Vec<Viewpoint> {
    let Some(bounds) = mesh.bounds() else { return vec![seen_from(Vec3::ONE)] };
    let mut views = Vec::new();
    for index in 0..count {
        let face = FaceId::from_usize(index * 7919 % mesh.face_count());
        let [a, b, c] = mesh.corners(face).map(Vec3::as_dvec3);
        let (s, t) = (f64::from(index as u32 % 7) * 0.9 - 2.0, f64::from(index as u32 % 11) * 0.7 - 3.0);
        let direction = DVec3::new((index as f64).sin(), (index as f64 * 1.7).cos(), (index as f64 * 0.3).sin());
        let around = |radii: f64| bounds.center + direction.normalize() * (radii * bounds.radius);
        let eyes = [a + (b - a) * s + (c - a) * t, (a + b) * 0.5, a, around(0.1), around(3.0), around(1e7)];
        views.extend(eyes.map(|eye| seen_from(eye.as_vec3())));
        let directions = [b - a, a - c, direction, (b - a).cross(c - a)];
        views.extend(directions.map(|d| Viewpoint::Orthographic { toward_viewer: d.as_vec3() }));
    }
    views
}

/// A random eye for which some face is a tie, or nearly: on a vertex, on an edge, on a face, in the plane of a face or at the
/// fourth corner of its parallelogram.
pub fn hard_eye(mesh: &TriangleMesh, random: &mut Random) -> Vec3 {
    let [a, b, c] = mesh.corners(FaceId::from_usize(random.below(mesh.face_count())));
    match random.below(5) {
        0 => a,
        1 => (a + b) * 0.5,
        2 => (a + b + c) / 3.0,
        3 => b + (c - a),
        _ => {
            let [s, t] = [0; 2].map(|_| (3.0 * random.signed()) as f32);
            a + (b - a) * s + (c - a) * t
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directions::{AXES, spread};
    use crate::zoo::builtin;

    #[test]
    fn framed_meshes_fill_their_pictures() {
        let mesh = builtin("gear");
        for direction in AXES.into_iter().chain(spread(20)) {
            for framing in [PERSPECTIVE, Framing::Orthographic] {
                let camera = framed(&mesh, direction, framing, [120, 80]);
                let pixels: Vec<_> =
                    mesh.positions().iter().map(|p| camera.project(p.as_dvec3()).unwrap().pixel).collect();
                assert!(
                    pixels.iter().all(|p| (0.0..120.0).contains(&p.x) && (0.0..80.0).contains(&p.y)),
                    "{direction}"
                );
                let [low, high] = [f64::min, f64::max].map(|of| pixels.iter().map(|p| p.y).reduce(of).unwrap());
                assert!(high - low > 8.0, "{direction}: {low} to {high}");
            }
        }
    }

    #[test]
    fn orbits_keep_their_distance_and_step() {
        let mesh = builtin("torus");
        let bounds = mesh.bounds().unwrap();
        let eyes: Vec<DVec3> = orbit(&mesh, 90.0, 5)
            .map(|view| match view {
                Viewpoint::Perspective { eye } => (eye.as_dvec3() - bounds.center) / bounds.radius,
                Viewpoint::Orthographic { .. } => panic!("an orbit of eyes"),
            })
            .collect();
        assert!(eyes.iter().all(|eye| (eye.length() - 2.4).abs() < 1e-5), "{eyes:?}");
        assert!(eyes[0].distance(eyes[4]) < 1e-5 && eyes[0].distance(eyes[1]) > 2.0, "{eyes:?}");
    }

    /// Some plane of the mesh that they were made for contains each of them, and hardly ever one of another mesh.
    #[test]
    fn hard_eyes_lie_in_the_plane_of_a_face() {
        let [mesh, other] = [builtin("blob:500"), builtin("blob:500,0.6")];
        let mut random = Random::new(1);
        let is_tied = |mesh: &TriangleMesh, eye: Vec3| {
            (0..mesh.face_count()).map(FaceId::from_usize).any(|face| {
                let [a, b, c] = mesh.corners(face).map(|corner| (corner - eye).as_dvec3());
                let height = (b - a).cross(c - a).normalize().dot(a).abs();
                height < 1e-6 * (a.length() + f64::from(eye.length()))
            })
        };
        let eyes: Vec<Vec3> = (0..200).map(|_| hard_eye(&mesh, &mut random)).collect();
        assert!(eyes.iter().all(|&eye| is_tied(&mesh, eye)));
        assert!(eyes.iter().filter(|&&eye| is_tied(&other, eye)).count() < 100);
    }
}

//! Meshes and cameras that several tests look at.

use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::view::{Framing, Projection};
use silhouette_core::{Camera, NoProgress, PreparedMesh, TriangleMesh, load, shapes};
use silhouette_visibility::{LineFinder, LineOptions, LineScene, Lines};
use std::path::PathBuf;
use std::sync::Arc;

/// A real model, where the machine has them.
pub fn model(name: &str) -> Option<TriangleMesh> {
    let Some(folder) = std::env::var_os("SILHOUETTES_MODELS") else {
        eprintln!("skipped {name}: SILHOUETTES_MODELS is not set");
        return None;
    };
    Some(load::load(&PathBuf::from(folder).join(name)).unwrap())
}

/// A built-in shape.
pub fn builtin(name: &str) -> TriangleMesh {
    shapes::by_name(name).unwrap()
}

/// A camera that frames a mesh from a direction.
pub fn framing(mesh: &TriangleMesh, direction: DVec3, perspective: bool) -> Camera {
    let fov = if perspective { Framing::Perspective { fov_y_rad: 0.7 } } else { Framing::Orthographic };
    let up = if direction.cross(DVec3::Y).length() > 0.1 * direction.length() { Vec3::Y } else { Vec3::X };
    Camera::framing(&mesh.bounds().unwrap(), direction, up, fov, [1024, 1024]).unwrap()
}

/// The lines of one view, all of them.
pub fn all_lines(mesh: &TriangleMesh, camera: &Camera, options: &LineOptions) -> Lines {
    let scene = LineScene::new(Arc::new(PreparedMesh::new(mesh.clone())));
    let options = LineOptions { max_invisibility: u32::MAX, ..options.clone() };
    LineFinder::new(scene, &NoProgress).unwrap().find(camera, &options, &NoProgress).unwrap()
}

/// Directions spread over the sphere (a spiral of Fibonacci's), none along an axis.
pub fn directions(count: usize) -> impl Iterator<Item = DVec3> {
    (0..count).map(move |index| {
        let height = 1.0 - 2.0 * (index as f64 + 0.37) / count as f64;
        let turn = index as f64 * 2.399_963_229_728_653 + 0.2;
        let radius = (1.0 - height * height).sqrt();
        DVec3::new(radius * turn.cos(), height, radius * turn.sin())
    })
}

/// A camera at `eye` that looks at `target`.
pub fn look(eye: Vec3, target: Vec3, fov_deg: f64, size: [u32; 2]) -> Camera {
    let projection = Projection::Perspective { fov_y_rad: fov_deg.to_radians() };
    Camera::new(eye, target, (target - eye).any_orthogonal_vector(), projection, size).unwrap()
}

/// Meshes in one space, as the scene joins them.
pub fn joined(meshes: &[&TriangleMesh]) -> TriangleMesh {
    LineScene::of_meshes(meshes).unwrap().mesh().mesh().as_ref().clone()
}

/// Runs `work` in a pool of `count` threads.
pub fn with_threads<T: Send>(count: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap().install(work)
}

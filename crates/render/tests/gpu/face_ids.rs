//! Pictures of face ids.

use glam::Vec3;
use silhouette_core::TriangleMesh;
use silhouette_core::view::{Camera, Projection};
use silhouette_gpu::MeshBuffers;
use silhouette_render::{DEFAULT_FORMATS, FaceIdPass, GpuError, Target};
use silhouette_testing::gpu_or_skip;

#[test]
fn each_pixel_holds_the_nearest_face_and_a_hole_nothing() {
    let Some(gpu) = gpu_or_skip("each_pixel_holds_the_nearest_face_and_a_hole_nothing") else { return };
    // A square of two faces seen from both sides, and a nearer face over its middle.
    let corners = [(-1.0, -1.0, 0.0), (1.0, -1.0, 0.0), (1.0, 1.0, 0.0), (-1.0, 1.0, 0.0)];
    let nearer = [(-0.4, -0.4, 1.0), (0.4, -0.4, 1.0), (0.0, 0.4, 1.0)];
    let positions = corners.into_iter().chain(nearer).map(|(x, y, z)| Vec3::new(x, y, z)).collect();
    let mesh = TriangleMesh::new(positions, vec![[0, 1, 2], [0, 3, 2], [4, 5, 6]]).unwrap();
    let buffers = MeshBuffers::new(gpu.device(), gpu.queue(), &mesh).unwrap();
    let projection = Projection::Orthographic { height: 4.0 };
    let camera = Camera::new(Vec3::Z * 5.0, Vec3::ZERO, Vec3::Y, projection, [40, 40]).unwrap();
    let mut pass = FaceIdPass::new(gpu).unwrap();
    for scale in [1, 2] {
        let ids = pass.draw(gpu, &buffers, &camera, scale).unwrap();
        assert_eq!([ids.width, ids.height], [40 * scale; 2]);
        let at = |x: f64, y: f64| {
            let pixel = |along: f64| ((along + 2.0) * 10.0 * f64::from(scale)) as usize;
            ids.values[pixel(-y) * ids.width as usize + pixel(x)]
        };
        assert_eq!([at(0.8, -0.8), at(-0.8, 0.8), at(0.01, -0.1), at(1.5, 0.0)], [1, 2, 3, 0]);
    }
    let empty = TriangleMesh::new(Vec::new(), Vec::new()).unwrap();
    let nothing = MeshBuffers::new(gpu.device(), gpu.queue(), &empty).unwrap();
    assert!(pass.draw(gpu, &nothing, &camera, 1).unwrap().values.iter().all(|&value| value == 0));
    let colour = Target::new(gpu, [4, 4], DEFAULT_FORMATS).unwrap();
    assert!(matches!(colour.read_ids(gpu), Err(GpuError::ColorFormat(_))));
}

//! The mesh: a square beam along the y axis, with its weights.

use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::mesh::Bounds;
use silhouette_core::{MeshError, TriangleMesh};

/// Rings of vertices along the beam.
const RINGS: u32 = 25;

/// Half of the beam's length and of its width.
const HALF_LENGTH: f32 = 1.0;
const HALF_WIDTH: f32 = 0.3;

/// A closed beam of four sides, counter-clockwise from outside.
pub fn beam() -> Result<TriangleMesh, MeshError> {
    let corners = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
    let height = |ring: u32| (2.0 * ring as f32 / (RINGS - 1) as f32 - 1.0) * HALF_LENGTH;
    let ring = |ring: u32| corners.map(|[x, z]| Vec3::new(x * HALF_WIDTH, height(ring), z * HALF_WIDTH));
    let positions = (0..RINGS).flat_map(ring).collect();
    let side = |ring: u32, corner: u32| {
        let [a, b] = [4 * ring + corner, 4 * ring + (corner + 1) % 4];
        [[a, a + 4, b], [b, a + 4, b + 4]]
    };
    let sides = (0..RINGS - 1).flat_map(|ring| (0..4).flat_map(move |corner| side(ring, corner)));
    let top = 4 * (RINGS - 1);
    let caps = [[0, 1, 2], [0, 2, 3], [top, top + 2, top + 1], [top, top + 3, top + 2]];
    TriangleMesh::new(positions, sides.chain(caps).collect())
}

/// How far a vertex follows the second joint, 0 to 1: smoothly from a quarter of the beam to three quarters.
pub fn weight(position: Vec3) -> f32 {
    let t = (0.5 + position.y / HALF_LENGTH).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Where the beam can be, whatever its pose.
pub fn bounds() -> Bounds {
    let reach = f64::from(HALF_LENGTH + 2.0 * HALF_WIDTH);
    Bounds { min: DVec3::splat(-reach), max: DVec3::splat(reach), center: DVec3::ZERO, radius: reach }
}

//! Closed surfaces of revolution about y: spheres by latitude, cylinders, cones.

use super::{around_y, finish, turn};
use crate::mesh::TriangleMesh;
use glam::{DVec2, DVec3};
use rayon::prelude::*;

/// Faces of [`revolve`] for a profile of `rings` points between the poles.
pub(super) fn face_count(segments: u32, rings: u32) -> u64 {
    2 * u64::from(segments) * u64::from(rings)
}

/// Turns `rings`, points (distance from the axis, height) from the lower to the upper pole, about the y axis. The poles,
/// given as heights, are single vertices: vertex 0 is the lower one, the last vertex the upper one, the rings of
/// `segments` vertices lie between them in order. Faces run from the lower pole's fan to the upper pole's.
pub(super) fn revolve(poles: [f64; 2], rings: &[DVec2], segments: u32) -> TriangleMesh {
    let on_ring = |ring: &DVec2, segment| around_y(turn(segment, segments)) * ring.x + DVec3::Y * ring.y;
    let on_ring = &on_ring;
    let between: Vec<_> = rings
        .par_iter()
        .flat_map_iter(|ring| (0..segments).map(move |segment| on_ring(ring, segment).as_vec3()))
        .collect();
    let [lower, upper] = poles.map(|height| (DVec3::Y * height).as_vec3());
    let positions: Vec<_> = std::iter::once(lower).chain(between).chain([upper]).collect();

    let top = positions.len() as u32 - 1;
    let vertex = |ring: u32, segment: u32| 1 + ring * segments + segment % segments;
    let mut triangles: Vec<_> = (0..segments).map(|s| [0, vertex(0, s + 1), vertex(0, s)]).collect();
    let bands = rings.len() as u32 - 1;
    triangles.par_extend((0..bands).into_par_iter().flat_map_iter(|ring| {
        (0..segments).flat_map(move |s| {
            let [a, b] = [vertex(ring, s), vertex(ring, s + 1)];
            let [d, c] = [vertex(ring + 1, s), vertex(ring + 1, s + 1)];
            [[a, b, c], [a, c, d]]
        })
    }));
    triangles.extend((0..segments).map(|s| [vertex(bands, s), vertex(bands, s + 1), top]));
    finish(positions, triangles)
}

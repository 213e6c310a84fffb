//! Pictures against the CPU twin, pixel by pixel.

use super::scene::{ECCENTRIC, PLAIN, Scene, Shot, Stored, ray};
use super::{flat, renderer, volume};
use crate::atlas::Place;
use crate::gpu::Filtering;
use crate::lookup::{AzimuthRule, Lookup};
use crate::silhouette_texture::SilhouetteTexture;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::{FaceId, TriangleMesh};
use silhouette_testing::gpu_or_skip;
use std::f32::consts::PI;

/// The largest margin of all front faces of the hull along a ray; below -pi where it meets none.
fn best_margin(texture: &SilhouetteTexture, (origin, direction): (DVec3, DVec3)) -> f32 {
    let lookup = Lookup::new(texture, AzimuthRule::Aligned);
    let hull: &TriangleMesh = texture.parts().hull.mesh();
    let faces = (0..hull.face_count()).map(FaceId::from_usize);
    let margins = faces.filter_map(|face| {
        let [a, b, c] = hull.corners(face).map(Vec3::as_dvec3);
        let normal = (b - a).cross(c - a);
        let facing = normal.dot(direction);
        let hit = origin + direction * (normal.dot(a - origin) / facing);
        let part = |from: DVec3, to: DVec3| (to - from).cross(hit - from).dot(normal) / normal.length_squared();
        let weights = [part(b, c), part(c, a), part(a, b)];
        let is_hit = facing < 0.0 && weights.iter().all(|&weight| weight >= 0.0);
        is_hit.then(|| {
            let place = Place { face, weights: DVec3::from(weights).as_vec3() };
            let (frame, direction) = (lookup.frame(&place), direction.as_vec3());
            lookup.angle(&place, &frame, direction) - frame.angle(direction)
        })
    });
    margins.fold(-4.0, f32::max)
}

/// Per form and filtering, the margin within which GPU and CPU may decide differently, in radians: a step of 8-bit filtering on
/// software adapters is 1.84 / 255 of pi, and weights of terms are off by as much of each term's range.
#[test]
fn the_gpu_draws_what_its_twin_shows() {
    let Some(gpu) = gpu_or_skip("the_gpu_draws_what_its_twin_shows") else { return };
    let eight_bits = 1.84 / 255.0 * PI;
    for (stored, filtering, band) in [
        (Stored::Float16, Filtering::Native, 2e-3),
        (Stored::Float16, Filtering::Manual, 1e-4),
        (Stored::Unorm8, Filtering::Native, eight_bits),
        (Stored::Unorm8, Filtering::Float16, 2e-3),
        (Stored::Unorm8, Filtering::Manual, 1e-4),
        (Stored::Terms(5), Filtering::Native, eight_bits),
        (Stored::Terms(5), Filtering::Float16, 2e-3),
        (Stored::Terms(5), Filtering::Manual, 1e-4),
    ] {
        for (pages, has_texel_centers, is_perspective) in [(1, false, true), (2, true, false)] {
            let scene = Scene { stored, pages, has_texel_centers, ..Scene::new(ECCENTRIC, 1) };
            let texture = scene.texture();
            let shot = Shot { is_perspective, ..PLAIN };
            let mut renderer = renderer(gpu, shot.formats(), flat(), &volume(gpu, &texture, filtering));
            let picture = shot.draw(gpu, &mut [&mut renderer]);
            let view = shot.view();
            let mut worst = 0.0_f32;
            for (x, y) in (0..picture.height).flat_map(|y| (0..picture.width).map(move |x| (x, y))) {
                let margin = best_margin(&texture, ray(&view, f64::from(x) + 0.5, f64::from(y) + 0.5));
                if (picture.pixel(x, y)[3] > 0) != (margin >= 0.0) {
                    worst = worst.max(margin.abs());
                }
            }
            assert!(worst <= band, "{stored:?} {filtering:?} {pages} pages: {worst} rad");
        }
    }
}

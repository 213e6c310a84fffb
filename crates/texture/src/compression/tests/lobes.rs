//! Textures whose angles are known: the unit sphere seen from points of an icosahedron around it.

use crate::{Angles, FacePlace, Frame, Hull, Parts, SilhouetteTexture, VisibilityRule, VolumeSize};
use glam::{Vec2, Vec3};
use half::f16;
use silhouette_core::shapes::Sphere;
use silhouette_core::{TriangleMesh, glam};
use silhouette_testing::Random;
use std::f32::consts::{PI, TAU};

/// Any texture of these angles.
pub fn texture(size: VolumeSize, angles: Angles) -> SilhouetteTexture {
    let texels = size.texels() as usize;
    SilhouetteTexture::new(Parts {
        hull: Hull::trusted(TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]).unwrap()),
        centers: vec![Vec3::NEG_Z; 3],
        tangents: vec![Vec3::X; 3],
        places: vec![FacePlace { page: 0, corners: [Vec2::ZERO; 3] }],
        size,
        rule: VisibilityRule::Interior,
        angles,
        texel_centers: None,
        gaps: vec![f16::ZERO; texels],
        detail: 0,
        colors: vec![],
        normals: vec![],
    })
    .unwrap()
}

/// A row of 16 texels and a page per face of an icosahedron: from each, the directions that meet the unit sphere fill a cone, whose
/// border is known at every azimuth of the frame that is interpolated between the corners. Shares of pi, sampled at `k / azimuths` turns.
pub fn sphere(size: VolumeSize) -> Vec<f32> {
    let hull = Sphere::default().icosphere(0).unwrap();
    // All faces lie outside: their inscribed sphere's radius is 0.795 of the corners'.
    let radius = 1.3;
    let random = &mut Random::new(7);
    let mut shares = vec![0.0; size.samples() as usize];
    for page in 0..size.pages {
        for (x, y) in (0..size.height).flat_map(|y| (0..size.width).map(move |x| (x, y))) {
            let face = hull.triangles()[random.below(hull.face_count())];
            let (a, b) = (random.unit() as f32, random.unit() as f32);
            let (a, b) = if a + b > 1.0 { (1.0 - a, 1.0 - b) } else { (a, b) };
            let of = |values: [Vec3; 3]| a * values[0] + b * values[1] + (1.0 - a - b) * values[2];
            let corners = face.map(|vertex| radius * hull.positions()[vertex as usize]);
            let point = of(corners);
            // Centres at corners are tilted, as a hull's around an uneven object are.
            let frame =
                Frame::new(-of(corners.map(|corner| corner + 0.4 * Vec3::new(corner.y, -corner.z, 0.3))), Vec3::Z);
            for azimuth in 0..size.azimuths {
                let angle = cone_border(&frame, point, azimuth as f32 / size.azimuths as f32);
                shares[size.sample(page, azimuth, x, y)] = angle / PI;
            }
        }
    }
    shares
}

/// The angle from the frame's centre, along an azimuth in turns, to the border of the cone in which the unit sphere lies from a point.
fn cone_border(frame: &Frame, point: Vec3, turns: f32) -> f32 {
    let axis = -point.normalize();
    let half_angle = (1.0 / point.length()).asin();
    let toward = frame.direction(turns, PI / 2.0).dot(axis);
    let along = frame.center.dot(axis);
    // cos(angle) * along + sin(angle) * toward = cos(half_angle)
    toward.atan2(along) + (half_angle.cos() / toward.hypot(along)).clamp(-1.0, 1.0).acos()
}

pub fn to_bytes(shares: &[f32]) -> Angles {
    Angles::Unorm8(shares.iter().map(|share| (share * 255.0).round() as u8).collect())
}

pub const SPHERE: VolumeSize = VolumeSize { width: 37, height: 30, azimuths: 64, pages: 2 };

#[test]
fn borders_of_cones_are_borders() {
    let size = VolumeSize { width: 8, height: 4, azimuths: 16, pages: 1 };
    assert!(sphere(size).iter().all(|share| (0.05..0.95).contains(share)));
    let (frame, point) = (Frame::new(Vec3::new(0.2, 0.1, -1.0), Vec3::X), Vec3::new(0.1, 0.0, 1.4));
    for turns in [0.0, 0.3, 0.9] {
        let angle = cone_border(&frame, point, turns);
        for (beyond, is_met) in [(-1e-3, true), (1e-3, false)] {
            let direction = frame.direction(turns, angle + beyond);
            assert_eq!(point.cross(direction).length() < 1.0, is_met, "at {turns} of {TAU}");
        }
    }
}

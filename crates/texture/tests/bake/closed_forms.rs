//! A sphere within a concentric hull: from distance d, the object of radius r is a cone of half-angle asin(r / d) about the centre.

use silhouette_core::glam::Vec3;
use silhouette_core::shapes::Sphere;
use silhouette_core::{FaceId, NoProgress};
use silhouette_texture::atlas::{Atlas, Place};
use silhouette_texture::lookup::{AzimuthRule, Lookup};
use silhouette_texture::{AngleFormat, Angles, Bake, BakeOptions, Hull, SilhouetteTexture, VisibilityRule, VolumeSize};
use std::f32::consts::PI;

const RADIUS: f32 = 1.0;

/// What the finest object's faces are inside the sphere by, and steps of storage, in radians.
const TOLERANCE: f32 = 0.01;

fn options() -> BakeOptions {
    BakeOptions {
        size: VolumeSize { width: 96, height: 96, azimuths: 16, pages: 1 },
        rule: VisibilityRule::Exterior,
        format: AngleFormat::Float16,
        ..BakeOptions::default()
    }
}

fn bake(hull: &Hull, options: BakeOptions) -> SilhouetteTexture {
    let object = Sphere { radius: f64::from(RADIUS) }.icosphere(5).unwrap();
    Bake::new(&object, hull, options).run(&NoProgress, None).unwrap().0
}

fn sphere_hull(radius: f64) -> Hull {
    Hull::trusted(Sphere { radius }.icosphere(1).unwrap())
}

#[test]
fn lobes_of_a_sphere_are_cones_about_its_middle() {
    let hull = sphere_hull(2.0);
    let texture = bake(&hull, options());
    let parts = texture.parts();
    for (center, position) in parts.centers.iter().zip(hull.mesh().positions()) {
        assert!(center.angle_between(-*position) < 0.03, "{center} at {position}");
    }
    let lookup = Lookup::new(&texture, AzimuthRule::Aligned);
    for face in (0..hull.mesh().face_count()).map(FaceId::from_usize) {
        for weights in [Vec3::splat(1.0 / 3.0), Vec3::new(0.6, 0.3, 0.1), Vec3::new(0.0, 0.5, 0.5)] {
            let place = Place { face, weights };
            let point: Vec3 = hull.mesh().corners(face).into_iter().zip(weights.to_array()).map(|(p, w)| p * w).sum();
            let frame = lookup.frame(&place);
            let half_angle = (RADIUS / point.length()).asin();
            for azimuth in 0..16 {
                // The interpolated middle is off by as much as the mean over directions is.
                let angle = lookup.angle(&place, &frame, frame.direction(azimuth as f32 / 16.0, 0.5));
                let off = frame.center.angle_between(-point);
                assert!((angle - half_angle).abs() < off + TOLERANCE, "{angle} instead of {half_angle}");
            }
        }
    }
}

/// Every sample itself, without interpolation: the border of a cone seen from a middle that is not quite its axis.
#[test]
fn each_sample_is_where_its_meridian_leaves_the_cone() {
    let hull = sphere_hull(2.0);
    let texture = bake(&hull, options());
    let parts = texture.parts();
    let Angles::Float16(angles) = &parts.angles else { panic!("asked for 16 bits") };
    let atlas = Atlas::new(&hull, parts.size, 1).unwrap();
    let lookup = Lookup::new(&texture, AzimuthRule::Aligned);
    for block in atlas.blocks() {
        for (x, y) in (0..atlas.side()).flat_map(|y| (0..atlas.side()).map(move |x| (x, y))) {
            let place = atlas.point(block, f64::from(x), f64::from(y));
            let corners = hull.mesh().corners(place.face);
            let point: Vec3 = corners.into_iter().zip(place.weights.to_array()).map(|(p, w)| p * w).sum();
            let frame = lookup.frame(&place);
            for azimuth in 0..parts.size.azimuths {
                let sample = angles[parts.size.sample(block.page, azimuth, block.x + x, block.y + y)].to_f32() * PI;
                let border = frame.direction(azimuth as f32 / parts.size.azimuths as f32, sample);
                let half_angle = (RADIUS / point.length()).asin();
                assert!((border.angle_between(-point) - half_angle).abs() < TOLERANCE);
            }
        }
    }
}

/// From a hull point at distance d, the outline lies at sqrt(d^2 - r^2).
#[test]
fn gaps_are_the_distances_to_the_tangent_points() {
    let hull = sphere_hull(2.0);
    let texture = bake(&hull, options());
    let parts = texture.parts();
    let atlas = Atlas::new(&hull, parts.size, 1).unwrap();
    for block in atlas.blocks() {
        for at in 0..atlas.side() {
            let place = atlas.point(block, f64::from(at), f64::from(at));
            let corners = hull.mesh().corners(place.face);
            let point: Vec3 = corners.into_iter().zip(place.weights.to_array()).map(|(p, w)| p * w).sum();
            let gap = f64::from(parts.gaps[parts.size.texel(block.page, block.x + at, block.y + at)].to_f32());
            let expected = f64::from((point.length_squared() - RADIUS * RADIUS).sqrt());
            assert!((gap * texture.unit() / expected - 1.0).abs() < 0.05, "{gap} {expected}");
        }
    }
}

//! The visibility function itself, before it is sampled: a ray from outside is shown by some front face of the hull exactly if it
//! meets the object.

use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::shapes::Torus;
use silhouette_core::{NoProgress, TriangleMesh};
use silhouette_testing::random::Random;
use silhouette_testing::{edits, real_meshes, zoo};
use silhouette_texture::hull::HullOptions;
use silhouette_texture::visibility_function::HullPoint;
use silhouette_texture::{Hull, VisibilityFunction, VisibilityRule};

/// Of some rays: those that meet the object, those that were shown wrongly, and the most front faces that any ray met.
#[derive(Debug, Default)]
struct Tally {
    hits: u32,
    lost: u32,
    invented: u32,
    layers: usize,
    /// Rays whose nearest point shown lies before another layer than the one that the object is first met in.
    astray: u32,
}

/// Rays from eyes around the hull at random points of its box.
fn tally(object: &TriangleMesh, hull: &Hull, rule: VisibilityRule, rays: u32) -> Tally {
    let visibility = VisibilityFunction::new(object, hull, rule);
    let bounds = hull.mesh().bounds().unwrap();
    let mut random = Random::new(16);
    let mut tally = Tally::default();
    for _ in 0..rays {
        let eye = bounds.center + random.vector().normalize() * bounds.radius * (1.2 + 4.0 * random.unit());
        let half = (bounds.max - bounds.min) * 0.5;
        let target = bounds.center + half * DVec3::new(random.signed(), random.signed(), random.signed());
        let direction = (target - eye).normalize().as_vec3();
        let entries: Vec<HullPoint> = visibility
            .hull()
            .all(eye, direction)
            .into_iter()
            .filter(|hit| !hit.is_exit)
            .map(|hit| HullPoint {
                position: eye + hit.distance * direction.as_dvec3(),
                ..visibility.point(hit.face, hit.weights)
            })
            .collect();
        let shown = entries.iter().find(|point| visibility.shows(point, direction));
        let first = visibility.object().first(eye, direction, f64::INFINITY);
        tally.hits += u32::from(first.is_some());
        tally.lost += u32::from(first.is_some() && shown.is_none());
        tally.invented += u32::from(first.is_none() && shown.is_some());
        if let (Some(point), Some(first)) = (shown, first) {
            let distance = first.distance - point.position.distance(eye);
            tally.astray +=
                u32::from(visibility.hull().exits(point.position, direction, 1e-6 * bounds.radius, distance));
        }
        tally.layers = tally.layers.max(entries.len());
    }
    tally
}

/// Objects with hulls that enclose them by construction: a thick torus around a thin one, spheres around anything.
fn enclosed() -> Vec<(&'static str, TriangleMesh, Hull)> {
    let torus = |minor_radius, around, across| Torus { major_radius: 1.0, minor_radius }.mesh(around, across).unwrap();
    let mut scenes = vec![("torus in a torus", torus(0.3, 96, 48), Hull::trusted(torus(0.42, 24, 8)))];
    for (name, object) in zoo::closed() {
        let bounds = object.bounds().unwrap();
        // An icosahedron divided twice reaches to 0.98 of its radius everywhere.
        let around = |point: Vec3| (bounds.center + point.as_dvec3() * bounds.radius * 1.1).as_vec3();
        scenes.push((name, object, Hull::trusted(edits::mapped(&zoo::builtin("icosphere:2"), around))));
    }
    scenes
}

#[test]
fn a_ray_is_shown_exactly_if_it_meets_the_object() {
    for (name, object, hull) in enclosed() {
        for rule in [VisibilityRule::Interior, VisibilityRule::Exterior] {
            let tally = tally(&object, &hull, rule, 4000);
            assert_eq!((tally.lost, tally.invented), (0, 0), "{name}: {tally:?}");
            assert!(tally.hits > 100, "{name}: {tally:?}");
        }
    }
}

#[test]
fn rays_at_real_meshes_are_shown_exactly_if_they_meet_them() {
    for name in ["stanford-bunny.obj", "armadillo.obj", "dragon.ply"] {
        let Some(mesh) = real_meshes::real_mesh("exact_rays", name) else { continue };
        let hull =
            Hull::enclosing(&mesh, &HullOptions { vertices: 1000, ..HullOptions::default() }, &NoProgress).unwrap();
        let tally = tally(&mesh, &hull, VisibilityRule::Interior, 20_000);
        assert_eq!((tally.lost, tally.invented), (0, 0), "{name}: {tally:?}");
        assert!(tally.layers > 1 && tally.hits > 2000, "{name}: {tally:?}");
    }
}

/// By equation 2 the nearest point that shows a ray is in front of what the ray meets first; by equation 1 it may be one that the
/// ray leaves the hull after, which is why that keeps outer outlines only.
#[test]
fn inner_outlines_need_equation_2() {
    let ball = edits::mapped(&zoo::builtin("icosphere:3"), |point| point * 0.8);
    let hull = edits::mapped(&zoo::builtin("icosphere:2"), |point| point * 0.95);
    let apart = Vec3::X * 2.2;
    let object = edits::joined(&[&ball, &edits::moved(&ball, apart)]);
    let hull = Hull::trusted(edits::joined(&[&hull, &edits::moved(&hull, apart)]));
    let [interior, exterior] =
        [VisibilityRule::Interior, VisibilityRule::Exterior].map(|rule| tally(&object, &hull, rule, 20_000));
    assert_eq!((interior.lost, interior.invented, interior.astray), (0, 0, 0));
    assert_eq!((exterior.lost, exterior.invented), (0, 0));
    assert!(exterior.astray > 100, "{exterior:?}");

    // A direction from the first part's hull past the first ball to the second one.
    let (inner, outer) = (
        VisibilityFunction::new(&object, &hull, VisibilityRule::Interior),
        VisibilityFunction::new(&object, &hull, VisibilityRule::Exterior),
    );
    let eye = DVec3::new(-5.0, 1.27, 0.0);
    let direction = (DVec3::new(2.2, 0.694, 0.0) - eye).normalize().as_vec3();
    let entry = inner.hull().first(eye, direction, f64::INFINITY).unwrap();
    let point =
        HullPoint { position: eye + entry.distance * direction.as_dvec3(), ..inner.point(entry.face, entry.weights) };
    assert!(point.position.x < 0.5 && outer.shows(&point, direction) && !inner.shows(&point, direction));
}

/// A hull that cuts into the object loses rays: the check above can fail.
#[test]
fn a_hull_that_does_not_enclose_loses_rays() {
    let object = zoo::builtin("icosphere:3");
    let hull = Hull::trusted(edits::mapped(&zoo::builtin("icosphere:2"), |point| point * 0.95));
    let tally = tally(&object, &hull, VisibilityRule::Interior, 2000);
    assert!(tally.lost > 100, "{tally:?}");
}

/// No direction enters a face from behind, and a point on an edge sees its neighbour's exit.
#[test]
fn points_on_edges_show_nothing_outwards() {
    let object = edits::mapped(&zoo::builtin("icosphere:2"), |point| point * 0.5);
    let far = edits::moved(&object, Vec3::X * 4.0);
    let object = edits::joined(&[&object, &far]);
    let hull =
        edits::joined(&[&zoo::builtin("icosphere:1"), &edits::moved(&zoo::builtin("icosphere:1"), Vec3::X * 4.0)]);
    let hull = Hull::trusted(hull);
    let visibility = VisibilityFunction::new(&object, &hull, VisibilityRule::Interior);
    let mesh = hull.mesh();
    let mut tried = 0;
    for face in (0..mesh.face_count()).map(silhouette_core::FaceId::from_usize) {
        for weights in [Vec3::X, Vec3::new(0.5, 0.5, 0.0), Vec3::new(0.0, 0.3, 0.7)] {
            let corners = mesh.corners(face);
            let position: Vec3 = (0..3).map(|at| weights[at] * corners[at]).sum();
            let point = visibility.point(face, weights);
            assert!(point.position.distance(position.as_dvec3()) < 3e-3);
            // From the hull of one ball towards the other ball, by directions that enter this face but leave the hull at once.
            let direction = (if position.x < 2.0 { Vec3::X * 4.0 } else { Vec3::ZERO } - position).normalize();
            let own = if position.x < 2.0 { Vec3::ZERO } else { Vec3::X * 4.0 };
            let (to_own, along) = (own - position, (own - position).dot(direction));
            let misses_own = along < 0.0 || (to_own - along * direction).length() > 0.5;
            if point.normal.dot(direction) >= 0.0 || misses_own {
                assert!(!visibility.shows(&point, direction), "{point:?}");
                tried += 1;
            }
        }
    }
    assert!(tried > 100);
}

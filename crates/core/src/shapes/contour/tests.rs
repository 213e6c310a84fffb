use super::super::{Cylinder, Ellipsoid, Sphere, Torus};
use super::*;
use glam::Vec3;
use proptest::prelude::*;

fn from_eye(x: f32, y: f32, z: f32) -> Viewpoint {
    Viewpoint::Perspective { eye: Vec3::new(x, y, z) }
}

fn from_direction(x: f32, y: f32, z: f32) -> Viewpoint {
    Viewpoint::Orthographic { toward_viewer: Vec3::new(x, y, z) }
}

fn shapes() -> [Box<dyn AnalyticContour>; 4] {
    [
        Box::new(Sphere { radius: 1.3 }),
        Box::new(Ellipsoid { semi_axes: [1.1, 0.5, 0.7] }),
        Box::new(Cylinder { radius: 0.8, height: 1.7 }),
        Box::new(Torus { major_radius: 1.0, minor_radius: 0.35 }),
    ]
}

fn check(shape: &dyn AnalyticContour, viewpoint: &Viewpoint) {
    for curve in shape.contour(viewpoint) {
        for point in curve.polyline(64) {
            assert!(shape.distance(point).abs() < 1e-9, "{point} is {} off", shape.distance(point));
            if curve.kind() == ContourKind::Smooth {
                let facing = shape.facing(point, viewpoint);
                assert!(facing.abs() < 1e-9, "{facing} at {point} from {viewpoint:?}");
            }
        }
        let gap = curve.point(0.0).distance(curve.point(1.0));
        assert_eq!(gap < 1e-7, curve.is_closed(), "{curve:?}");
        // No jump: a curve of bounded speed halves its largest step when the steps are halved.
        let largest_step = |segments: u32| {
            let points: Vec<DVec3> = (0..=segments).map(|i| curve.point(f64::from(i) / f64::from(segments))).collect();
            points.windows(2).map(|ends| ends[0].distance(ends[1])).fold(0.0, f64::max)
        };
        assert!(largest_step(8192) < 0.6 * largest_step(4096) + 1e-9, "{curve:?} jumps");
    }
}

#[test]
fn curves_lie_on_the_surface_at_right_angles_to_the_line_of_sight() {
    let viewpoints = [
        from_eye(3.0, 2.0, 5.0),
        from_eye(0.0, 4.0, 0.0),
        from_eye(-2.5, 0.1, 0.3),
        from_eye(2.0, 0.0, 0.0),
        from_eye(0.1, 0.05, 0.2),
        from_eye(0.0, 0.0, 0.0),
        from_eye(1.1, 0.1, 0.1),
        from_direction(0.3, -0.4, 2.0),
        from_direction(0.0, 1.0, 0.0),
        from_direction(1.0, 0.0, 0.5),
    ];
    for shape in shapes() {
        for viewpoint in &viewpoints {
            check(shape.as_ref(), viewpoint);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn any_viewpoint(v in prop::array::uniform3(-4.0_f32..4.0)) {
        for shape in shapes() {
            check(shape.as_ref(), &from_eye(v[0], v[1], v[2]));
            // Exactly from the side a torus' curves cross; close to that they turn too sharply for the steps of `check`.
            if v[1].abs() > 0.1 {
                check(shape.as_ref(), &from_direction(v[0], v[1], v[2]));
            }
        }
    }
}

#[test]
fn a_point_off_the_contour_fails_the_same_checks() {
    let (shape, viewpoint) = (Sphere::default(), from_eye(0.0, 0.0, 3.0));
    assert!(shape.facing(DVec3::Z, &viewpoint) > 1.0 && shape.facing(DVec3::NEG_Z, &viewpoint) < -1.0);
    assert!((shape.distance(DVec3::Z * 1.5) - 0.5).abs() < 1e-15);
}

#[test]
fn the_sphere_shows_the_circle_of_the_formula() {
    let (radius, distance) = (1.5_f64, 4.0_f64);
    let curves = Sphere { radius }.contour(&from_eye(0.0, 0.0, distance as f32));
    assert_eq!(curves.len(), 1);
    for point in curves[0].polyline(17) {
        assert!((point.z - radius * radius / distance).abs() < 1e-14);
        assert!((point.x.hypot(point.y) - radius * (1.0 - (radius / distance).powi(2)).sqrt()).abs() < 1e-14);
    }
}

#[test]
fn convex_shapes_show_no_contour_from_inside() {
    for shape in &shapes()[..3] {
        assert!(shape.contour(&from_eye(0.1, 0.2, -0.1)).is_empty());
        assert!(!shape.contour(&from_eye(0.1, 2.2, -0.1)).is_empty());
    }
    assert!(Sphere::default().contour(&from_eye(1.0, 0.0, 0.0)).is_empty(), "an eye on the sphere");
}

#[test]
fn a_torus_shows_two_curves_from_outside() {
    let torus = Torus::default();
    let outside =
        [(2.0, 1.0, 3.0), (0.0, 5.0, 0.0), (3.0, 0.1, 0.0), (0.2, 0.1, 0.0), (0.0, 0.0, 0.0), (1.0, 0.9, 0.0)];
    for (x, y, z) in outside {
        assert_eq!(torus.contour(&from_eye(x, y, z)).len(), 2, "{x} {y} {z}");
    }
    assert_eq!(torus.contour(&from_direction(1.0, 0.2, 0.4)).len(), 2);
    assert_eq!(torus.contour(&from_eye(1.1, 0.1, 0.0)).len(), 1, "within the tube");
    assert_eq!(torus.contour(&from_direction(1.0, 0.0, 0.0)).len(), 4, "from the side");
}

#[test]
fn a_torus_along_its_axis_shows_its_two_equators() {
    let torus = Torus { major_radius: 1.25, minor_radius: 0.5 };
    let radii: Vec<f64> = torus
        .contour(&from_direction(0.0, 2.0, 0.0))
        .iter()
        .map(|curve| {
            let points = curve.polyline(32);
            assert!(points.iter().all(|p| p.y.abs() < 1e-15));
            points.iter().map(|p| p.x.hypot(p.z)).sum::<f64>() / 32.0
        })
        .collect();
    let mut sorted = radii.clone();
    sorted.sort_by(f64::total_cmp);
    assert!((sorted[0] - 0.75).abs() < 1e-12 && (sorted[1] - 1.75).abs() < 1e-12, "{radii:?}");
}

#[test]
fn lines_and_rims_of_a_cylinder_form_one_closed_loop() {
    let cylinder = Cylinder::default();
    for viewpoint in [from_eye(3.0, 2.0, 1.0), from_eye(3.0, 0.0, 1.0), from_direction(1.0, -1.0, 0.0)] {
        let curves = cylinder.contour(&viewpoint);
        assert_eq!(curves.len(), 4);
        let ends: Vec<DVec3> = curves.iter().flat_map(|curve| [curve.point(0.0), curve.point(1.0)]).collect();
        for end in &ends {
            assert_eq!(ends.iter().filter(|other| other.distance(*end) < 1e-12).count(), 2, "{viewpoint:?}");
        }
    }
    let from_above = cylinder.contour(&from_eye(0.1, 5.0, 0.0));
    assert!(from_above.len() == 1 && from_above[0].is_closed() && from_above[0].kind() == ContourKind::Crease);
}

/// By definition: the side just inside of a rim's arc and the cap must differ in facing, off the arc they must agree.
#[test]
fn a_rim_is_contour_exactly_where_cap_and_side_differ() {
    let cylinder = Cylinder { radius: 0.7, height: 1.4 };
    for viewpoint in [from_eye(2.0, 3.0, 1.0), from_eye(1.5, 0.2, 0.4), from_direction(0.4, -0.6, 1.0)] {
        let rims: Vec<DVec3> = cylinder
            .contour(&viewpoint)
            .iter()
            .filter(|curve| curve.kind() == ContourKind::Crease)
            .flat_map(|curve| curve.polyline(4000))
            .collect();
        for y in [-0.7, 0.7] {
            for i in 0..100 {
                let rim = super::super::around_y(f64::from(i) * 0.0628 + 0.01) * 0.7 + DVec3::Y * y;
                let side = cylinder.facing(rim - DVec3::Y * y * 0.1, &viewpoint) > 0.0;
                let cap = cylinder.facing(rim * DVec3::new(0.9, 1.0, 0.9), &viewpoint) > 0.0;
                let on_contour = rims.iter().any(|p| p.distance(rim) < 2e-3);
                // The side's normal depends on the angle only, so moving down a little changes nothing there.
                assert_eq!(on_contour, side != cap, "{rim} from {viewpoint:?}");
            }
        }
    }
}

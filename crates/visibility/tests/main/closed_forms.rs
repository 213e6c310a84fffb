//! Lines of tessellated surfaces against their contours in closed form, in both directions.
//!
//! # Tolerance
//!
//! With h the longest edge, silhouette edges stay within about 0.52 h of the contour generator (`tests/analytic.rs` of the
//! workspace holds that against spheres). A point of the surface that far from the generator lies off the tangent plane
//! there, which appears as a line, by at most `(0.52 h)^2 / (2 rho)`, rho being the smallest radius of curvature; a chord
//! of length h adds `h^2 / (8 rho)`. So in the picture a line strays from the contour by the *second-order* tolerance
//! `0.26 h^2 / rho` and not by 0.52 h. It may go wrong by 0.52 h, the *first-order* tolerance, only where it goes along the
//! contour: where visibility ends. At a cusp the generator runs along the sight line, so that such an end is also nowhere
//! near as far off in the picture. Both are in pixels where the surface is nearest to the eye.

use crate::scenes::{all_lines, framing};
use silhouette_core::glam::{DVec2, DVec3};
use silhouette_core::shapes::{AnalyticContour, Ellipsoid, Sphere, Torus};
use silhouette_core::{Camera, TriangleMesh, Viewpoint};
use silhouette_testing::builtin;
use silhouette_testing::directions::spread;
use silhouette_testing::edges::longest_edge;
use silhouette_visibility::{LineOptions, Lines};

/// Steps along a curve in closed form: far shorter than a pixel.
const STEPS: u32 = 4096;

/// Why the visibility of a contour generator ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum SwitchKind {
    /// The sight line is tangent to the generator itself.
    Cusp,
    /// Another part of the surface begins to hide it.
    Junction,
}

/// What the viewer sees of a point of a contour generator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Seen {
    Visible,
    /// Hidden by the surface around it: the sight line enters the solid at once.
    Inside,
    /// Hidden by another part of the surface.
    Behind,
}

impl Seen {
    fn is_visible(self) -> bool {
        self == Self::Visible
    }
}

fn toward_viewer(viewpoint: &Viewpoint, from: DVec3) -> DVec3 {
    match *viewpoint {
        Viewpoint::Perspective { eye } => eye.as_dvec3() - from,
        Viewpoint::Orthographic { toward_viewer } => toward_viewer.as_dvec3(),
    }
}

/// A surface whose contour and its visibility are known.
struct Surface {
    contour: Box<dyn AnalyticContour>,
    /// Smallest radius of curvature.
    curvature_radius: f64,
    /// Of a convex surface nothing of the contour is hidden.
    torus: Option<Torus>,
}

/// `C^2 s^2 + linear s + constant`, what remains of a torus' equation along the sight line that touches it at `s = 0`.
struct Remainder {
    square: f64,
    linear: f64,
    constant: f64,
}

impl Surface {
    fn sphere() -> Self {
        let sphere = Sphere::default();
        Self { contour: Box::new(sphere), curvature_radius: sphere.radius, torus: None }
    }

    fn ellipsoid() -> Self {
        let ellipsoid = Ellipsoid::default();
        let [least, most] = [f64::min, f64::max].map(|of| ellipsoid.semi_axes.into_iter().reduce(of).unwrap());
        Self { contour: Box::new(ellipsoid), curvature_radius: least * least / most, torus: None }
    }

    /// With a hole at least as wide as its tube, so that the tube is where it bends most.
    fn torus() -> Self {
        let torus = Torus::default();
        Self { contour: Box::new(torus), curvature_radius: torus.minor_radius, torus: Some(torus) }
    }

    /// The torus is the set where `f(p) = (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2)` vanishes, and f is negative inside.
    /// Along a sight line `x + s d` that touches it at x, f has a double root at `s = 0`; what remains is a quadratic.
    fn remainder(torus: &Torus, viewpoint: &Viewpoint, x: DVec3) -> Remainder {
        let d = toward_viewer(viewpoint, x);
        let major = torus.major_radius * torus.major_radius;
        let offset = x.length_squared() + major - torus.minor_radius * torus.minor_radius;
        let (along, length) = (x.dot(d), d.length_squared());
        let across = d.x * d.x + d.z * d.z;
        Remainder {
            square: length * length,
            linear: 4.0 * along * length,
            constant: 4.0 * along * along + 2.0 * offset * length - 4.0 * major * across,
        }
    }

    /// What the viewer sees of a point of the contour generator.
    fn sight(&self, viewpoint: &Viewpoint, x: DVec3) -> Seen {
        let Some(torus) = &self.torus else { return Seen::Visible };
        let Remainder { square, linear, constant } = Self::remainder(torus, viewpoint, x);
        if constant <= 0.0 {
            return Seen::Inside;
        }
        let end = match viewpoint {
            Viewpoint::Perspective { .. } => 1.0,
            Viewpoint::Orthographic { .. } => f64::INFINITY,
        };
        let lowest = (-linear / (2.0 * square)).clamp(0.0, end);
        if (square * lowest + linear) * lowest + constant > 0.0 { Seen::Visible } else { Seen::Behind }
    }
}

/// The contour in closed form, in pixels.
#[derive(Default)]
struct Expected {
    /// Stretches of it that are visible, and those that are not.
    visible: Vec<Vec<DVec2>>,
    hidden: Vec<Vec<DVec2>>,
    /// Where one follows the other.
    switches: Vec<Switch>,
}

#[derive(Debug)]
struct Switch {
    kind: SwitchKind,
    pixel: DVec2,
    /// Sine of the angle between the generator and the sight line.
    sine: f64,
}

fn expected(surface: &Surface, camera: &Camera) -> Expected {
    let viewpoint = camera.viewpoint();
    let pixel = |point: DVec3| camera.project(point).unwrap().pixel;
    let mut found = Expected::default();
    for curve in surface.contour.contour(&viewpoint) {
        let point = |step: u32| curve.point(f64::from(step) / f64::from(STEPS));
        let mut stretch = vec![pixel(point(0))];
        let mut before = surface.sight(&viewpoint, point(0));
        for step in 1..=STEPS {
            let now = surface.sight(&viewpoint, point(step));
            stretch.push(pixel(point(step)));
            if before.is_visible() != now.is_visible() {
                let kind =
                    if before == Seen::Inside || now == Seen::Inside { SwitchKind::Cusp } else { SwitchKind::Junction };
                let (place, along) = (point(step), (point(step) - point(step - 1)).normalize());
                let sine = along.cross(toward_viewer(&viewpoint, place).normalize()).length();
                found.switches.push(Switch { kind, pixel: pixel(place), sine });
            }
            if before.is_visible() != now.is_visible() || step == STEPS {
                let stretches = if before.is_visible() { &mut found.visible } else { &mut found.hidden };
                stretches.push(std::mem::replace(&mut stretch, vec![pixel(point(step))]));
            }
            before = now;
        }
    }
    found
}

fn distance_to_segment(point: DVec2, [from, to]: [DVec2; 2]) -> f64 {
    let along = to - from;
    let share = ((point - from).dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    point.distance(from + along * share)
}

/// Distance of each point to the nearest of some polylines.
fn distances(points: impl Iterator<Item = DVec2>, lines: &[Vec<DVec2>]) -> Vec<f64> {
    let nearest = |point| {
        let segments = lines.iter().flat_map(|line| line.windows(2));
        segments.map(|ends| distance_to_segment(point, [ends[0], ends[1]])).fold(f64::INFINITY, f64::min)
    };
    points.map(nearest).collect()
}

/// Points of polylines, at most a pixel apart.
fn samples(lines: &[Vec<DVec2>]) -> Vec<DVec2> {
    let between = |ends: &[DVec2]| {
        let [from, to] = [ends[0], ends[1]];
        let count = from.distance(to).ceil().max(1.0) as u32;
        (0..=count).map(move |step| from.lerp(to, f64::from(step) / f64::from(count))).collect::<Vec<_>>()
    };
    lines.iter().flat_map(|line| line.windows(2).flat_map(between)).collect()
}

/// The visible lines, or the others.
fn drawn(lines: &Lines, visible: bool) -> Vec<Vec<DVec2>> {
    let wanted = lines.chains.iter().filter(|chain| (chain.style.invisibility == 0) == visible);
    wanted.map(|chain| chain.pixels.iter().chain(chain.closed.then(|| &chain.pixels[0])).copied().collect()).collect()
}

/// Allowed distances in pixels. See the [module](self).
#[derive(Debug, Clone, Copy)]
struct Tolerance {
    first_order: f64,
    second_order: f64,
}

impl Tolerance {
    fn new(mesh: &TriangleMesh, surface: &Surface, camera: &Camera) -> Self {
        let nearest = camera.eye().as_dvec3().length() - mesh.bounds().unwrap().radius;
        let (edge, scale) = (longest_edge(mesh), camera.pixels_per_unit(nearest));
        let second_order = 0.26 * edge * edge / surface.curvature_radius * scale;
        Self { first_order: 0.52 * edge * scale, second_order }
    }
}

/// How far lines and contour are apart, in pixels.
#[derive(Debug)]
struct Apart {
    /// From points of visible lines to the visible contour: the largest where no switch is within the first-order
    /// tolerance, and at most there.
    lines: [f64; 2],
    /// From points of the visible contour to visible lines.
    visible: f64,
    /// The same on the average.
    visible_mean: f64,
    /// From points of the hidden contour, those near a switch left out, to hidden lines.
    hidden: f64,
}

fn apart(lines: &Lines, expected: &Expected, tolerance: Tolerance) -> Apart {
    let largest = |distances: &mut dyn Iterator<Item = f64>| distances.fold(0.0, f64::max);
    let is_near_switch =
        |pixel: &DVec2| expected.switches.iter().any(|switch| switch.pixel.distance(*pixel) <= tolerance.first_order);
    let (near, far): (Vec<DVec2>, Vec<DVec2>) = samples(&drawn(lines, true)).into_iter().partition(is_near_switch);
    let visible = distances(samples(&expected.visible).into_iter().step_by(3), &drawn(lines, true));
    let hidden = samples(&expected.hidden).into_iter().filter(|pixel| !is_near_switch(pixel)).step_by(3);
    Apart {
        lines: [far, near].map(|points| largest(&mut distances(points.into_iter(), &expected.visible).into_iter())),
        visible: largest(&mut visible.iter().copied()),
        visible_mean: visible.iter().sum::<f64>() / visible.len() as f64,
        hidden: largest(&mut distances(hidden, &drawn(lines, false)).into_iter()),
    }
}

/// Checks a surface at finer and finer tessellations, each with half the edges of the one before.
fn check(surface: &Surface, tessellations: &[&str]) {
    for (index, direction) in spread(6).enumerate() {
        let mut means: Vec<f64> = Vec::new();
        for name in tessellations {
            let mesh = builtin(name);
            let camera = framing(&mesh, direction, index % 2 == 0);
            let tolerance = Tolerance::new(&mesh, surface, &camera);
            let lines = all_lines(&mesh, &camera, &LineOptions::default());
            let apart = apart(&lines, &expected(surface, &camera), tolerance);
            eprintln!("{name} from {direction:.2}: {apart:.3?}, {tolerance:.3?}");
            let worst = apart.lines[0].max(apart.visible).max(apart.hidden);
            assert!(worst <= tolerance.second_order, "{name} from {direction}: {apart:?}, {tolerance:?}");
            assert!(apart.lines[1] <= tolerance.first_order, "{name} from {direction}: {apart:?}, {tolerance:?}");
            means.push(apart.visible_mean);
        }
        // Half the edge, a quarter of the distance, but for how edges happen to lie.
        assert!(means.windows(2).all(|pair| pair[1] < 0.4 * pair[0]), "from {direction}: {means:?}");
    }
}

#[test]
fn a_sphere_shows_its_circle() {
    check(&Surface::sphere(), &["icosphere:3", "icosphere:4", "icosphere:5"]);
}

#[test]
fn an_ellipsoid_shows_its_ellipse() {
    check(&Surface::ellipsoid(), &["ellipsoid:32,16", "ellipsoid:64,32", "ellipsoid:128,64"]);
}

#[test]
fn a_torus_shows_its_two_curves_but_for_what_it_hides() {
    check(&Surface::torus(), &["torus:64,32", "torus:128,64", "torus:256,128"]);
}

fn torus_from(elevation_deg: f64, perspective: bool) -> (TriangleMesh, Camera) {
    let mesh = builtin("torus:128,64");
    let (sin, cos) = elevation_deg.to_radians().sin_cos();
    let camera = framing(&mesh, DVec3::new(0.31 * cos, sin, 0.95 * cos), perspective);
    (mesh, camera)
}

/// From high above nothing is hidden. From 30 degrees the near rim of the hole ends in two cusps, where the generator is
/// tangent to the sight line, and hides both ends of the far rim. From 10 degrees the far rim is hidden altogether.
#[test]
fn a_torus_has_its_cusps_and_junctions() {
    let surface = Surface::torus();
    for perspective in [true, false] {
        for (elevation_deg, cusps, junctions) in [(80.0, 0, 0), (30.0, 2, 2), (10.0, 2, 0)] {
            let (mesh, camera) = torus_from(elevation_deg, perspective);
            let expected = expected(&surface, &camera);
            let of_kind = |kind| expected.switches.iter().filter(move |switch| switch.kind == kind);
            let counts = [SwitchKind::Cusp, SwitchKind::Junction].map(|kind| of_kind(kind).count());
            eprintln!("{elevation_deg} degrees, perspective {perspective}: {:?}", expected.switches);
            assert_eq!(counts, [cusps, junctions], "{elevation_deg} degrees, perspective {perspective}");
            assert!(of_kind(SwitchKind::Cusp).all(|switch| switch.sine < 0.02), "{:?}", expected.switches);
            assert!(of_kind(SwitchKind::Junction).all(|switch| switch.sine > 0.2), "{:?}", expected.switches);

            let tolerance = Tolerance::new(&mesh, &surface, &camera);
            let lines = all_lines(&mesh, &camera, &LineOptions::default());
            let ends: Vec<DVec2> = {
                let open = lines.chains.iter().filter(|chain| chain.style.invisibility == 0 && !chain.closed);
                open.flat_map(|chain| [chain.pixels[0], chain.pixels[chain.pixels.len() - 1]]).collect()
            };
            for switch in &expected.switches {
                let nearest = ends.iter().map(|end| end.distance(switch.pixel)).fold(f64::INFINITY, f64::min);
                assert!(nearest <= tolerance.first_order, "no line ends at {switch:?}, the nearest {nearest} px off");
            }
        }
    }
}

/// The comparison can fail: lines of a view two degrees away, and lines of which the hidden ones count as visible.
#[test]
fn another_view_and_hidden_lines_are_seen_to_be_wrong() {
    let surface = Surface::torus();
    let (mesh, camera) = torus_from(30.0, true);
    let tolerance = Tolerance::new(&mesh, &surface, &camera);
    let truth = expected(&surface, &camera);
    let lines = all_lines(&mesh, &torus_from(32.0, true).1, &LineOptions::default());
    let moved = apart(&lines, &truth, tolerance);
    assert!(moved.lines[0].min(moved.visible) > 2.0 * tolerance.second_order, "{moved:?}, {tolerance:?}");

    let all = Expected { visible: [truth.visible, truth.hidden].concat(), ..Expected::default() };
    let lines = all_lines(&mesh, &camera, &LineOptions::default());
    let through = apart(&lines, &all, tolerance);
    assert!(through.visible > tolerance.first_order, "{through:?}, {tolerance:?}");
}

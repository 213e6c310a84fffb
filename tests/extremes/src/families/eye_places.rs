//! Eyes where predicates tie, where the near plane cuts the mesh, and very far away.

use crate::cell::Aspect::{Curves, Edges, Lines};
use crate::cell::Outcome::{Differs, Empty};
use crate::meshes::{corners, torus};
use crate::row::{Row, Who};
use crate::scene::{SIZE, Scene, looking};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::view::{Camera, Framing, Projection};
use silhouette_testing::builtin;
use silhouette_testing::views::three_quarter;

/// A face on the outer side of the torus.
const FACE: usize = 40;

/// Combines the corners of the face: `a + s (b - a) + t (c - a)`, without rounding for s and t that are multiples of a quarter.
fn on_plane(s: f64, t: f64) -> Vec3 {
    let [a, b, c] = corners(&torus(), FACE);
    (a + (b - a) * s + (c - a) * t).as_vec3()
}

/// The torus from `eye`, which looks at its middle.
fn from(eye: Vec3) -> Scene {
    Scene::seen(torus(), looking(eye, Vec3::new(0.05, 0.02, -0.03), 70.0))
}

/// The torus in parallel projection, as an eye 1e7 away sees it.
fn parallel() -> Scene {
    let mesh = torus();
    let camera = three_quarter(&mesh, Framing::Orthographic, SIZE);
    Scene::seen(mesh, camera)
}

fn at_1e7() -> Scene {
    let mesh = torus();
    let bounds = mesh.bounds().expect("a torus has faces");
    let (direction, up) = silhouette_core::view::ViewPreset::ThreeQuarter.directions();
    let eye = (bounds.center + direction.normalize() * 1e7).as_vec3();
    let distance = (eye.as_dvec3() - bounds.center).length();
    let fov_y_rad = 2.0 * (1.05 * bounds.radius / distance).asin();
    let projection = Projection::Perspective { fov_y_rad };
    let camera = Camera::new(eye, bounds.center.as_vec3(), up, projection, SIZE).expect("a camera");
    Scene::seen(mesh, camera)
}

/// The torus from outside, with the same field of view.
fn near_by() -> Scene {
    from(on_plane(9.0, -4.0) + Vec3::new(0.01, 0.02, 0.03))
}

const NO_OUTLINE: &str = "the mesh fills the picture, so that it has no outline in it";
const NO_RIM: &str = "with the eye on the surface, back faces touch the eye and are cut by the near plane: their edges are taken for \
                      silhouettes, or lie across the picture";
const CUT_OPEN: &str =
    "the near plane, 1e-5 of the far plane away, cuts off the face that hides all else: what is behind it is drawn";
const CLOSE_BY: &str = "where normals, which are interpolated, are perpendicular to the view is not where faces turn away, least of all \
                        close by";
const ALL_BACK: &str = "it draws what lies behind the surface, and with the eye inside that is the whole picture";
const NONE_SEEN: &str = "no line is seen from there, and none is drawn";

/// What is expected of an eye on the surface.
fn on_the_surface(row: Row) -> Row {
    row.beside("from the side", near_by)
        .expect_of(Lines, &["image-precision", "inverted-hull"], Differs, NO_RIM)
        .expect_of(Lines, &["jump-flood", "texture-lines"], Empty, NO_OUTLINE)
}

/// The rows.
pub fn rows() -> Vec<Row> {
    let normal = || {
        let [a, b, c] = corners(&torus(), FACE);
        (b - a).cross(c - a).normalize()
    };
    let grazing = "steps in depth below its threshold have no line, and surfaces that are grazed close by have steps";
    vec![
        Row::new("in a face's plane", "an eye exactly in the plane of a face, outside of it", || {
            from(on_plane(9.0, -4.0))
        })
        .beside("from the side", near_by),
        on_the_surface(Row::new("on an edge", "an eye exactly in the middle of an edge", || from(on_plane(0.5, 0.0))))
            .expect_of(Lines, &["gbuffer-filter"], Differs, grazing)
            .expect_all_of_randomized(),
        on_the_surface(Row::new("on a vertex", "an eye exactly on a vertex", || from(on_plane(0.0, 0.0))))
            .expect_of(Lines, &["gbuffer-filter"], Differs, grazing)
            .expect_of(Curves, &["smoothing", "interpolated-contours"], Differs, CLOSE_BY),
        on_the_surface(Row::new("in a face", "an eye exactly on a face, inside of it", || from(on_plane(0.25, 0.25))))
            .expect_of(Lines, &["image-precision"], Empty, "it takes the eye to be inside, and leaves back faces out")
            .expect_of(Curves, &["smoothing", "interpolated-contours"], Differs, CLOSE_BY)
            .expect_all_of_randomized(),
        on_the_surface(Row::new("1e-6 off", "an eye 1e-6 in front of a face", move || {
            from((on_plane(0.25, 0.25).as_dvec3() + normal() * 1e-6).as_vec3())
        }))
        .expect_of(
            Lines,
            &["brute-force", "edge-mesh", "image-precision", "inverted-hull", "gbuffer-filter"],
            Differs,
            CUT_OPEN,
        )
        .expect_of(Curves, &["smoothing", "interpolated-contours"], Differs, CLOSE_BY),
        Row::new("inside", "an eye inside of the closed torus", || {
            let [a, ..] = corners(&torus(), FACE);
            let ring = DVec3::new(a.x, 0.0, a.z).normalize();
            Scene::seen(torus(), looking(ring.as_vec3(), Vec3::new(0.1, 0.05, 0.2), 70.0))
        })
        .beside("from the side", near_by)
        .expect(Who::Every(Lines), Empty, NONE_SEEN)
        .expect_of(Lines, &["inverted-hull"], Differs, ALL_BACK)
        .expect_all_of_randomized(),
        Row::new("inside, convex", "an eye inside of a cube", || {
            Scene::seen(builtin("cube"), looking(Vec3::new(0.1, 0.05, -0.07), Vec3::new(0.4, 0.3, 0.2), 70.0))
        })
        .expect(Who::Every(Edges), Empty, "from inside of a convex mesh every face is back")
        .expect_of(Edges, &["randomized"], Empty, "from inside of a convex mesh every face is back")
        .expect(Who::Every(Curves), Empty, "from inside of a convex mesh there is no silhouette")
        .expect(Who::Every(Lines), Empty, NONE_SEEN)
        .expect_of(Lines, &["inverted-hull"], Differs, ALL_BACK),
        Row::new("1e7 away", "an eye 1e7 away, which sees the torus as large as in the plain case", at_1e7)
            .beside("parallel", parallel)
            .expect_all_of_randomized(),
    ]
}

//! Fields of view, and model matrices of the drawing convention.

use crate::cell::Aspect::{Curves, Fill, Lines};
use crate::cell::Found;
use crate::cell::Outcome::{Differs, Empty, Refused};
use crate::meshes::torus;
use crate::row::{Row, Who};
use crate::scene::{SIZE, Scene};
use silhouette_core::glam::{DMat4, DVec3, Vec3};
use silhouette_core::view::{Camera, Framing, Projection};
use silhouette_testing::edits::{inside_out, mapped};
use silhouette_testing::views::{PERSPECTIVE, three_quarter};

fn with_fov(degrees: f64) -> Scene {
    let mesh = torus();
    let camera = three_quarter(&mesh, Framing::Perspective { fov_y_rad: degrees.to_radians() }, SIZE);
    Scene::seen(mesh, camera)
}

fn parallel() -> Scene {
    let mesh = torus();
    let camera = three_quarter(&mesh, Framing::Orthographic, SIZE);
    Scene::seen(mesh, camera)
}

/// A mesh that a model matrix makes into the torus, up to rounding.
fn under(model: DMat4) -> Scene {
    let inverse = model.inverse();
    let mesh = mapped(&torus(), |p| inverse.transform_point3(p.as_dvec3()).as_vec3());
    let mesh = if model.determinant() < 0.0 { inside_out(&mesh) } else { mesh };
    let camera = three_quarter(&torus(), PERSPECTIVE, SIZE);
    Scene { model, ..Scene::seen(mesh, camera) }
}

fn stretch() -> DMat4 {
    DMat4::from_scale(DVec3::new(1e-3, 1.0, 1e3))
}

fn mirror() -> DMat4 {
    DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0))
}

fn mirrored_stretch() -> DMat4 {
    DMat4::from_rotation_y(0.5) * DMat4::from_scale(DVec3::new(0.5, -3.0, 1.0))
}

/// A view whose model matrix is refused.
fn flattened() -> Result<Scene, Found> {
    let scene = Scene { model: DMat4::from_scale(DVec3::new(1.0, 0.0, 1.0)), ..Scene::of(torus()) };
    let range = silhouette_core::view::ClipRange { near: 1.0, far: 10.0 };
    scene.view(range).map_err(|error| Found::refused(&error))?;
    Ok(scene)
}

/// A camera with this field of view.
fn camera(degrees: f64) -> Result<Scene, Found> {
    let projection = Projection::Perspective { fov_y_rad: degrees.to_radians() };
    let camera = Camera::new(Vec3::new(1.0, 2.0, 5.0), Vec3::ZERO, Vec3::Y, projection, SIZE);
    Ok(Scene::seen(torus(), camera.map_err(|error| Found::refused(&error))?))
}

const FEW_PIXELS: &str = "the torus covers a few pixels in the middle, and one sample per pixel says little of each";
const OWN_SPACE: &str = "hull and texture are made in the mesh's own space, whose proportions the matrix changes";

/// The rows.
pub fn rows() -> Vec<Row> {
    vec![
        Row::new("fov 0.01°", "a field of view of 0.01 degrees that holds the torus", || with_fov(0.01))
            .beside("parallel", parallel)
            .expect_all_of_randomized(),
        Row::new("fov 179°", "a field of view of 179 degrees that holds the torus", || with_fov(179.0))
            .expect(Who::Every(Fill), Differs, FEW_PIXELS)
            .expect_of(
                Fill,
                &["normal-map-hull"],
                Differs,
                "its hull surrounds the eye, or nearly, and fills many pixels",
            ),
        Row::fallible("fov 180°", "a field of view of 180 degrees", || camera(180.0)).expect(Who::All, Refused, ""),
        Row::new(
            "model 1e-3 to 1e3",
            "a model matrix that scales by 1e-3, 1 and 1e3 along the axes, of a mesh that it makes a torus",
            || under(stretch()),
        )
        .expect_of(
            Curves,
            &["interpolated-contours"],
            Differs,
            "normals are averaged in the mesh's own space, which is flat there",
        )
        .expect_of(Fill, &["texture"], Empty, OWN_SPACE)
        .expect_of(Lines, &["texture-lines"], Empty, OWN_SPACE)
        .expect_of(Fill, &["normal-map-hull"], Differs, OWN_SPACE)
        .expect_all_of_randomized(),
        Row::new("mirror", "a model matrix that mirrors", || under(mirror())),
        Row::new("mirror, stretch", "a model matrix that mirrors, stretches and turns", || under(mirrored_stretch()))
            .expect_of(Fill, &["texture", "normal-map-hull"], Differs, OWN_SPACE)
            .expect_of(Lines, &["texture-lines"], Differs, OWN_SPACE),
        Row::fallible("flat model", "a model matrix that flattens", flattened).expect(Who::All, Refused, ""),
    ]
}

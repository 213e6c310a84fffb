//! Tiny and huge meshes, and meshes far from the origin.

use crate::cell::Aspect::{Curves, Fill, Lines};
use crate::cell::Outcome::{Differs, Refused};
use crate::meshes::torus;
use crate::row::Row;
use crate::scene::Scene;
use silhouette_core::TriangleMesh;
use silhouette_core::glam::DVec3;
use silhouette_core::origin::origin_between;
use silhouette_testing::edits::transformed;

fn scaled(scale: f64) -> Scene {
    Scene::of(transformed(&torus(), scale, DVec3::ZERO))
}

/// The torus at an offset, its positions rounded to 32 bits where they are.
fn offset(by: f64) -> Scene {
    Scene::of(transformed(&torus(), 1.0, DVec3::new(by, -by, by)))
}

/// The same rounded torus, back near zero without another rounding.
fn brought_back(by: f64) -> Scene {
    let far = (**offset(by).mesh.mesh()).clone();
    let center = far.bounds().expect("a torus has faces").center;
    Scene::of(far.relative_to(center.round()).expect("it is near zero"))
}

/// The torus at an offset that its file states in 64 bits: loaders have positions count from an origin near by.
fn offset_in_file(by: f64) -> Scene {
    let by = DVec3::new(by, -by, by);
    let places: Vec<DVec3> = torus().positions().iter().map(|p| p.as_dvec3() + by).collect();
    let low = places.iter().copied().reduce(DVec3::min).expect("a torus has vertices");
    let high = places.iter().copied().reduce(DVec3::max).expect("a torus has vertices");
    let origin = origin_between(low, high);
    let positions = places.iter().map(|place| (place - origin).as_vec3()).collect();
    let mesh = TriangleMesh::new(positions, torus().triangles().to_vec()).expect("a torus is a mesh");
    Scene::of(mesh.with_origin(origin))
}

/// No hull can be written down among positions so far apart.
fn without_hulls(row: Row) -> Row {
    row.expect_of(Fill, &["texture", "normal-map-hull"], Refused, "").expect_of(Lines, &["texture-lines"], Refused, "")
}

const ROUNDED_EYE: &str =
    "the eye is rounded to steps of 1 as well, and sees so coarse a mesh from another side than in the plain case";

/// The rows.
pub fn rows() -> Vec<Row> {
    vec![
        Row::new("scale 1e-9", "the torus scaled by 1e-9", || scaled(1e-9)),
        Row::new("scale 1e9", "the torus scaled by 1e9", || scaled(1e9)),
        Row::new("file offset 1e7", "the torus moved by 1e7 along each axis in 64 bits, as a file states it", || {
            offset_in_file(1e7)
        }),
        Row::new("offset 1e3", "the torus moved by 1e3 and rounded to 32 bits there", || offset(1e3))
            .beside("brought back from 1e3", || brought_back(1e3)),
        without_hulls(Row::new("offset 1e6", "the torus moved by 1e6 and rounded to 32 bits there, steps of 1/16", || offset(1e6))
            .beside("brought back from 1e6", || brought_back(1e6))
            .expect_of(
                Fill,
                &["pn-triangles", "phong-tessellation", "adaptive-refinement"],
                Differs,
                "vertices between those of the mesh are rounded to 32 bits where the mesh lies, to steps of 1/16; a mesh whose \
                 positions count from an origin close by has none of this",
            )),
        without_hulls(Row::new("offset 1e7", "the torus moved by 1e7 and rounded to 32 bits there, steps of 1", || offset(1e7))
            .beside("brought back from 1e7", || brought_back(1e7)))
            .expect_of(Lines, &["inverted-hull"], Differs, ROUNDED_EYE)
            .expect_of(Curves, &["interpolated-contours"], Differs, ROUNDED_EYE),
    ]
}

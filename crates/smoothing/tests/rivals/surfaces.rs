//! The methods that make surfaces, and views of them.

use silhouette_core::glam::Vec3;
use silhouette_core::method::{Method, MethodOptions};
use silhouette_core::view::{Camera, Projection};
use silhouette_core::{PreparedMesh, TriangleMesh};
use silhouette_smoothing::AdaptiveRefinement;
use silhouette_smoothing::BoundaryCurve;
use silhouette_smoothing::PhongTessellation;
use silhouette_smoothing::PnTriangles;
use silhouette_smoothing::{MakesTriangles as _, Remesher, SmoothingView, ViewMesh};
use silhouette_testing::prepare::prepared;
use std::sync::Arc;

/// Those whose surfaces are closed where the mesh is.
pub const CLOSED: [&str; 3] = ["pn-triangles", "phong-tessellation", "adaptive-refinement"];

/// All of them.
pub const NAMES: [&str; 4] = ["pn-triangles", "phong-tessellation", "adaptive-refinement", "boundary-curve"];

pub fn method<M: Method>(mesh: &Arc<PreparedMesh>, words: &[&str]) -> M {
    M::new(mesh, M::Options::parse(words.iter().copied()).unwrap()).unwrap()
}

/// The remesher of a method by name, with options by words.
pub fn remesher(name: &str, mesh: &TriangleMesh, words: &[&str]) -> Box<dyn Remesher> {
    let mesh = prepared(mesh.clone());
    match name {
        "pn-triangles" => Box::new(method::<PnTriangles>(&mesh, words).remesher()),
        "phong-tessellation" => Box::new(method::<PhongTessellation>(&mesh, words).remesher()),
        "adaptive-refinement" => Box::new(method::<AdaptiveRefinement>(&mesh, words).remesher()),
        "boundary-curve" => Box::new(method::<BoundaryCurve>(&mesh, words).remesher()),
        _ => panic!("{name}"),
    }
}

pub fn surface(remesher: &mut dyn Remesher, view: &SmoothingView) -> ViewMesh {
    let mut surface = ViewMesh::default();
    assert!(remesher.remesh(view, &mut surface), "the first mesh differs from none");
    surface
}

/// A view of the unit sphere, or of something as large, from a direction: from this many radii away, or in parallel.
pub fn view(direction: Vec3, radii: Option<f32>) -> (Camera, SmoothingView) {
    let distance = radii.unwrap_or(3.0);
    let projection = match radii {
        Some(_) => Projection::Perspective { fov_y_rad: 2.0 * f64::from(1.0 / distance).asin() + 0.3 },
        None => Projection::Orthographic { height: 2.4 },
    };
    let direction = direction.normalize();
    let up = direction.any_orthogonal_vector();
    let camera = Camera::new(distance * direction, Vec3::ZERO, up, projection, [800, 800]).unwrap();
    (camera, SmoothingView::from_camera(&camera))
}

//! Tests of the whole method.

mod coherence;
#[cfg(feature = "gpu")]
mod cracks;
mod extremes;
mod outlines;
pub(crate) mod remeshed;

use crate::{Smoothing, SmoothingOptions};
use silhouette_core::{Method, PreparedMesh, TriangleMesh, shapes};
use std::sync::Arc;

pub(crate) fn smoothing(mesh: TriangleMesh, options: SmoothingOptions) -> Smoothing {
    Smoothing::new(&Arc::new(PreparedMesh::new(mesh)), options).unwrap()
}

pub(crate) fn shape(name: &str, options: SmoothingOptions) -> Smoothing {
    smoothing(shapes::by_name(name).unwrap(), options)
}

fn longest_edge(mesh: &TriangleMesh) -> f32 {
    let corners = mesh.triangles().iter().map(|corners| corners.map(|corner| mesh.positions()[corner as usize]));
    let sides = corners.flat_map(|[a, b, c]| [a.distance(b), b.distance(c), c.distance(a)]);
    sides.fold(0.0, f32::max)
}

//! Tests of the whole method.

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

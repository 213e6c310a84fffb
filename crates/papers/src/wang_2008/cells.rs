//! Section III-B, clusters: corners of the printed cells may agree on what the inside of the cell does not.

use crate::directions::spread;
use crate::error::Cause;
use silhouette_core::shapes::Sphere;
use silhouette_core::view::Viewpoint;
use silhouette_core::{PreparedMesh, Progress};
use silhouette_smoothing::vertex_visibility::{Cells, VertexVisibility};
use silhouette_smoothing::{Eye, ShadingMesh, SmoothingOptions};

/// Number of views.
pub const VIEWS: u32 = 2000;

/// Vertices that clusters decide wrongly on an icosphere of 20 480 faces in parallel projection, per million.
///
/// # Errors
/// [`Cause`]: cancelled.
pub fn wrong_per_million(cells: Cells, progress: &dyn Progress) -> Result<f64, Cause> {
    let mesh = PreparedMesh::new(Sphere::default().icosphere(5)?);
    let options = SmoothingOptions::default();
    let mesh = ShadingMesh::new(&mesh, options.crease_deg, options.normals, "cells", progress)?;
    let [mut clustered, mut plain] = [cells, Cells::None].map(|cells| VertexVisibility::new(&mesh, cells));
    let mut wrong = 0;
    for toward in spread(VIEWS) {
        progress.check()?;
        let eye = Eye::from(Viewpoint::Orthographic { toward_viewer: toward.as_vec3() });
        clustered.classify(&mesh, eye);
        plain.classify(&mesh, eye);
        let pairs = clustered.is_visible().iter().zip(plain.is_visible());
        wrong += pairs.filter(|(one, other)| one != other).count();
    }
    Ok(1e6 * wrong as f64 / (f64::from(VIEWS) * mesh.positions().len() as f64))
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::NoProgress;

    #[test]
    fn printed_cells_decide_some_vertices_wrongly_and_gnomonic_ones_none() {
        let of = |cells| wrong_per_million(cells, &NoProgress).unwrap();
        assert!(of(Cells::Gnomonic) <= 0.0 && (0.1..10_000.0).contains(&of(Cells::AsPrinted)));
    }
}

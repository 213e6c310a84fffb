//! How wide the article's lines come out, derived from the geometry and drawn, and ours.
//!
//! The article moves the vertices of an edge by `EXTEND` times their distance from the eye along the normals of its two faces, so that
//! across the edge, in the direction s of the image plane, its line is as wide as the sum of both normals' shares along s. In pixels
//! that is EXTEND * f * distance / depth * (|N_F . s| + |N_B . s|), where f is the focal length in pixels: a share of the picture's
//! height that falls with the field of view, at most 2 EXTEND f where the surface is smooth, less where the edge is sharp. The half on
//! the side of the front face lies behind that face, which bulges towards the viewer by more than the line is moved, so that where
//! the mesh is drawn about half of the width remains: the share of N_F, which points outwards.

use super::methods::{AS_PRINTED, COMPACTED, Drawn};
use super::printed::EXTEND;
use crate::drawings::{FOV_Y_RAD, camera};
use crate::error::{Cause, PaperError};
use crate::paper::Run;
use crate::table::{Cell, Column, Row, Table};
use silhouette_compare::metrics::Ink;
use silhouette_compare::metrics::width::drawn_width;
use silhouette_compare::truth::{Truth, TruthFinder};
use silhouette_core::glam::{DVec2, DVec3};
use silhouette_core::view::{Camera, ViewPreset};
use silhouette_core::{EdgeId, FaceId, PreparedMesh, Progress, Topology, TriangleMesh};
use silhouette_render::Gpu;
use std::sync::Arc;

/// Fields of view, in degrees, at the second of the heights.
const FOVS_DEG: [f64; 5] = [10.0, 30.0, 60.0, 90.0, 120.0];

/// The width that ours is asked for: percent of the picture's height.
const ASKED_PERCENT: f64 = 0.4;

/// The first mesh at several heights and fields of view.
///
/// # Errors
/// [`PaperError`]: cancelled, or a device that failed.
pub fn measure(gpu: &Gpu, run: &Run<'_>, heights: &[u32]) -> Result<Table, PaperError> {
    let Some(named) = run.meshes.first() else { return Err(Cause::NoMesh.into()) };
    let fixed_height = heights.get(1).copied().unwrap_or(512);
    let by_height = heights.iter().map(|&height| (height, FOV_Y_RAD.to_degrees()));
    let by_fov = FOVS_DEG.iter().map(|&fov_deg| (fixed_height, fov_deg));
    let cases: Vec<_> = by_height.chain(by_fov).collect();
    run.progress.stage("widths", cases.len() as u64);
    let row = |&(height, fov_deg): &(u32, f64)| {
        let row = row(gpu, &named.mesh, height, fov_deg, run.progress);
        run.progress.advance(1);
        row
    };
    let rows = cases.iter().map(row).collect::<Result<_, _>>().map_err(PaperError::of::<Cause>(&named.name))?;
    let px = |title, metric, meaning| Column { digits: 3, ..Column::new(title, metric, "px", meaning) };
    let percent = |title, metric, meaning| Column { digits: 3, ..Column::new(title, metric, "%", meaning) };
    Ok(Table {
        name: "width",
        subject: named.name.clone(),
        about: format!("the article's lines as they come out, and ours, asked for {ASKED_PERCENT} % of the height"),
        columns: vec![
            px("law", "width as printed, derived", "mean of the law over the visible lines"),
            px(
                "outside",
                "width outside as printed, derived",
                "mean of the part of the law that lies outside of the front face",
            ),
            px("drawn", "width as printed, drawn", "mean width in the picture"),
            percent("of height", "width as printed, of the height", "drawn width over the height of the picture"),
            px("ours", "width, drawn", "mean width in the picture"),
            percent("of height", "width, of the height", "drawn width over the height of the picture"),
        ],
        rows,
        ..Table::default()
    })
}

fn row(gpu: &Gpu, mesh: &Arc<PreparedMesh>, height: u32, fov_deg: f64, progress: &dyn Progress) -> Result<Row, Cause> {
    let (direction, _) = ViewPreset::default().directions();
    let camera = camera(mesh.mesh(), direction, fov_deg.to_radians(), [height; 2])?;
    let truth = TruthFinder::new(mesh, progress)?.find(&camera, progress)?;
    let topology = mesh.artefact::<Topology>("width law", progress)?;
    let [derived, outside] = law_px(mesh.mesh(), &topology, &camera, &truth);
    let drawn = |drawn: Drawn, words: &str| -> Result<f64, Cause> {
        let mut drawing = drawn.drawing(gpu, mesh, words, camera.size(), progress)?;
        drawing.draw(gpu, &camera)?;
        let ink = Ink::from_picture(&drawing.picture(gpu)?);
        // The window has to hold the widest lines: ours in the largest picture.
        let window_px = 0.01 * ASKED_PERCENT * f64::from(height);
        Ok(drawn_width(&ink, &truth.lines, window_px.max(derived)).mean_px)
    };
    let printed = drawn(AS_PRINTED, "")?;
    let ours = drawn(COMPACTED, &format!("width={ASKED_PERCENT} width-unit=height-percent"))?;
    let share = |px: f64| 100.0 * px / f64::from(height);
    let cells = [derived, outside, printed, share(printed), ours, share(ours)].map(Cell::one);
    Ok(Row::new(format!("{height} pixels high, field of view {fov_deg:.0}°"), cells.to_vec()))
}

/// The means over the visible lines of edges with two faces, by length, of the article's width and of its part outside.
fn law_px(mesh: &TriangleMesh, topology: &Topology, camera: &Camera, truth: &Truth) -> [f64; 2] {
    let (mut sum, mut length) = (DVec2::ZERO, 0.0);
    for sample in &truth.lines.samples {
        if let Some(widths) = law_of_edge_px(mesh, topology, camera, sample.edge, sample.tangent) {
            sum += widths * sample.length_px;
            length += sample.length_px;
        }
    }
    (sum / length).to_array()
}

/// The article's width, and its part outside of the front face, at the middle of an edge that runs along `tangent` in the image (y
/// down).
fn law_of_edge_px(
    mesh: &TriangleMesh,
    topology: &Topology,
    camera: &Camera,
    edge: EdgeId,
    tangent: DVec2,
) -> Option<DVec2> {
    let faces: [FaceId; 2] = topology.faces(edge).collect::<Vec<_>>().try_into().ok()?;
    let at = |vertex: usize| mesh.positions()[vertex].as_dvec3();
    let normal = |face: FaceId| {
        let [a, b, c] = mesh.triangles()[face.index()].map(|vertex| at(vertex as usize));
        (b - a).cross(c - a).normalize_or_zero()
    };
    let [begin, end] = topology.end_points(edge).map(|vertex| at(vertex.index()));
    let middle = 0.5 * (begin + end);
    let to_view = camera.view_matrix();
    // Across the line, in the image plane: a quarter turn of its direction, from pixels (y down) to view space (y up).
    let across = to_view.inverse().transform_vector3(DVec3::new(-tangent.y, -tangent.x, 0.0)).normalize();
    let depth = camera.project(middle)?.depth;
    let eye = camera.eye().as_dvec3();
    let is_front = |face: FaceId| normal(face).dot(eye - middle) > 0.0;
    let share = |face: FaceId| normal(face).dot(across).abs();
    let front: f64 = faces.into_iter().filter(|&face| is_front(face)).map(share).sum();
    let both: f64 = faces.into_iter().map(share).sum();
    Some(EXTEND * middle.distance(eye) * camera.pixels_per_unit(depth) * DVec2::new(both, front))
}

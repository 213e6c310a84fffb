//! An extraction as SVG: every loop as a closed path in the camera's pixels, hidden parts included.

use super::Extraction;
use silhouette_core::view::Camera;
use svg::node::element::path::Data;
use svg::node::element::{Group, Path, Title};

/// The file. Parts of loops behind the eye of a perspective are left out.
pub fn write(found: &Extraction, name: &str, camera: &Camera) -> Vec<u8> {
    let [width, height] = camera.size();
    let mut group = Group::new()
        .set("fill", "none")
        .set("stroke", "black")
        .set("stroke-width", 1)
        .set("stroke-linejoin", "round")
        .set("stroke-linecap", "round");
    for vertices in &found.loops {
        let points = vertices.iter().map(|vertex| {
            let world = found.mesh.positions()[vertex.index()].as_dvec3();
            camera.project(world).map(|seen| seen.pixel)
        });
        group = group.add(Path::new().set("d", path(&points.collect::<Vec<_>>())));
    }
    let document = svg::Document::new()
        .set("width", width)
        .set("height", height)
        .set("viewBox", (0, 0, width, height))
        .add(Title::new(format!("Silhouette of {name} by {}", found.method)))
        .add(group);
    format!("{document}\n").into_bytes()
}

/// A closed path through the points; broken where one is behind the eye.
fn path(points: &[Option<glam::DVec2>]) -> Data {
    let rounded = |pixel: glam::DVec2| ((pixel.x * 1000.0).round() / 1000.0, (pixel.y * 1000.0).round() / 1000.0);
    let whole = points.iter().all(Option::is_some);
    let mut data = Data::new();
    let mut drawing = false;
    let closing = if whole { None } else { points.first() };
    for point in points.iter().chain(closing) {
        data = match (point, drawing) {
            (Some(pixel), true) => data.line_to(rounded(*pixel)),
            (Some(pixel), false) => data.move_to(rounded(*pixel)),
            (None, _) => data,
        };
        drawing = point.is_some();
    }
    if whole && !points.is_empty() { data.close() } else { data }
}

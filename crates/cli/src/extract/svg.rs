//! An extraction as SVG in the camera's pixels, hidden parts included: every curve as a path of cubic Bezier curves, or every loop
//! as a closed path where the method finds no curves.

use super::Extraction;
use glam::DVec2;
use silhouette_core::SilhouetteCurves;
use silhouette_core::curves::CurveChain;
use silhouette_core::view::Camera;
use svg::node::element::path::Data;
use svg::node::element::{Group, Path, Title};

/// Largest distance, in pixels, of a path from the picture of its curve.
const TOLERANCE_PX: f64 = 0.05;

/// The file. Parts of loops and curves behind the eye of a perspective are left out.
pub fn write(found: &Extraction, name: &str, camera: &Camera) -> Vec<u8> {
    let [width, height] = camera.size();
    let mut group = Group::new()
        .set("fill", "none")
        .set("stroke", "black")
        .set("stroke-width", 1)
        .set("stroke-linejoin", "round")
        .set("stroke-linecap", "round");
    for chain in found.curves.iter().flat_map(SilhouetteCurves::iter) {
        group = group.add(Path::new().set("d", curve(&chain, camera)));
    }
    let loops = found.edges.iter().filter(|_| found.curves.is_none()).flat_map(|edges| &edges.loops);
    for vertices in loops {
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

fn rounded(pixel: DVec2) -> (f64, f64) {
    ((pixel.x * 1000.0).round() / 1000.0, (pixel.y * 1000.0).round() / 1000.0)
}

/// A path along a chain of smooth pieces; broken where they are behind the eye.
fn curve(chain: &CurveChain<'_>, camera: &Camera) -> Data {
    let mut cubics = Vec::new();
    chain.pieces.iter().for_each(|piece| piece.picture(camera, TOLERANCE_PX, &mut cubics));
    let mut data = Data::new();
    let (mut last, mut begun) = (None, 0);
    for &[from, a, b, to] in &cubics {
        if last != Some(from) {
            data = data.move_to(rounded(from));
            begun += 1;
        }
        data = data.cubic_curve_to((rounded(a), rounded(b), rounded(to)));
        last = Some(to);
    }
    let meets = cubics.first().is_some_and(|&[from, ..]| last == Some(from));
    if chain.closed && begun == 1 && meets { data.close() } else { data }
}

/// A closed path through the points; broken where one is behind the eye.
fn path(points: &[Option<DVec2>]) -> Data {
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

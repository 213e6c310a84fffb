//! An extraction as Wavefront OBJ: one `l` element a curve, or a loop where the method finds no curves.

use super::Extraction;
use silhouette_compare::registry::FoundEdges;
use silhouette_core::mesh::Bounds;
use silhouette_core::{SilhouetteCurves, TriangleMesh};
use std::collections::BTreeMap;
use std::fmt::Write;

/// How far a polyline may stray from its curve, as a share of the mesh's largest extent.
const TOLERANCE_SHARE: f64 = 1e-4;

/// The file.
pub fn write(found: &Extraction, bounds: &Bounds) -> Vec<u8> {
    let mut text = String::new();
    if let Some(curves) = &found.curves {
        let tolerance = TOLERANCE_SHARE * (bounds.max - bounds.min).max_element();
        let _ = writeln!(text, "# {} curves by {}, within {tolerance:.1e}", curves.len(), found.method);
        write_curves(&found.mesh, curves, tolerance, &mut text);
    } else if let Some(edges) = &found.edges {
        let _ = writeln!(text, "# {} silhouette loops by {}", edges.loops.len(), found.method);
        write_loops(found, edges, &mut text);
    }
    text.into_bytes()
}

/// Curves as polylines, each with vertices of its own.
fn write_curves(mesh: &TriangleMesh, curves: &SilhouetteCurves, tolerance: f64, text: &mut String) {
    let mut points = Vec::new();
    let mut first = 1;
    for chain in curves.iter() {
        points.clear();
        chain.flatten(tolerance, &mut points);
        for point in &points {
            let p = mesh.in_file(point.as_vec3());
            let _ = writeln!(text, "v {} {} {}", p.x, p.y, p.z);
        }
        text.push('l');
        for number in (first..first + points.len()).chain(chain.closed.then_some(first)) {
            let _ = write!(text, " {number}");
        }
        text.push('\n');
        first += points.len();
    }
}

/// Loops over the vertices of the silhouette, which keep the mesh's order but not its numbers; coordinates are the mesh's own,
/// to the last bit.
fn write_loops(found: &Extraction, edges: &FoundEdges, text: &mut String) {
    let mut numbers: BTreeMap<_, usize> = edges.loops.iter().flatten().map(|&vertex| (vertex, 0)).collect();
    numbers.values_mut().zip(1..).for_each(|(number, next)| *number = next);
    for vertex in numbers.keys() {
        let p = found.mesh.in_file(found.mesh.positions()[vertex.index()]);
        let _ = writeln!(text, "v {} {} {}", p.x, p.y, p.z);
    }
    for vertices in &edges.loops {
        text.push('l');
        for vertex in vertices.iter().chain(vertices.first()) {
            let _ = write!(text, " {}", numbers[vertex]);
        }
        text.push('\n');
    }
}

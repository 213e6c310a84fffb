//! A cube from every octant: nine edges are visible, and the three at the far corner are hidden.

use crate::scenes::{all_lines, framing};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::{EdgeId, Topology, TriangleMesh, VertexId};
use silhouette_testing::builtin;
use silhouette_testing::directions::octants;
use silhouette_testing::edits::{keeping, mapped};
use silhouette_visibility::{LineKind, LineOptions, Lines, SegmentSource};
use std::collections::BTreeMap;

/// Half the cube's side.
const SCALES: [f32; 5] = [1e-9, 1e-3, 1.0, 1e3, 1e9];

/// How far from the origin its centre is, in halves of its side. At the largest a coordinate's last bit is worth a
/// sixteenth: the box that is left of the cube is rounded alike at all corners and keeps its faces flat.
const OFFSETS: [f32; 3] = [0.0, 1e3, 1e6];

fn options() -> LineOptions {
    LineOptions { ridge_deg: Some(45.0), ..LineOptions::default() }
}

fn cube(half: f32, offset: f32) -> TriangleMesh {
    let center = Vec3::new(1.0, -0.7, 0.4) * (offset * half);
    mapped(&builtin("cube"), |corner| corner * half + center)
}

/// For each edge that is drawn: why, how many cover it, and its ends; an edge in several pieces fails.
fn edges_drawn(lines: &Lines) -> BTreeMap<EdgeId, (LineKind, u32, [DVec3; 2])> {
    let mut drawn = BTreeMap::new();
    for chain in lines.chains.iter() {
        for (segment, source) in chain.sources.iter().enumerate() {
            let SegmentSource::Edge(edge) = *source else { panic!("{source:?} was not asked for") };
            let ends = [segment, (segment + 1) % chain.points.len()].map(|point| chain.points[point]);
            let before = drawn.insert(edge, (chain.style.kind, chain.style.invisibility, ends));
            assert_eq!(before, None, "an edge of a cube is visible or hidden as a whole");
        }
    }
    drawn
}

fn check(mesh: &TriangleMesh, direction: DVec3, perspective: bool) {
    let camera = framing(mesh, direction, perspective);
    let lines = all_lines(mesh, &camera, &options());
    let topology = Topology::new(mesh);
    let place = |vertex: usize| mesh.positions()[vertex].as_dvec3();
    let drawn = edges_drawn(&lines);
    let count = |wanted: LineKind, covers: u32| {
        drawn.values().filter(|(kind, invisibility, _)| (*kind, *invisibility) == (wanted, covers)).count()
    };
    assert_eq!(drawn.len(), 12, "{camera:?}: {drawn:?}");
    assert_eq!((count(LineKind::Silhouette, 0), count(LineKind::Ridge, 0), count(LineKind::Ridge, 1)), (6, 3, 3));

    let far_corner = (0..8).min_by(|&one, &other| place(one).dot(direction).total_cmp(&place(other).dot(direction)));
    for (&edge, &(_, invisibility, ends)) in &drawn {
        let vertices = topology.end_points(edge).map(VertexId::index);
        let corners = vertices.map(place);
        assert!(ends == corners || ends == [corners[1], corners[0]], "corners are exact: {ends:?}, {corners:?}");
        assert_eq!(invisibility > 0, vertices.contains(&far_corner.unwrap()), "hidden edges meet at the far corner");
    }

    let outline: Vec<_> = lines.chains.iter().filter(|chain| chain.style.kind == LineKind::Silhouette).collect();
    assert!(outline.len() == 1 && outline[0].closed && outline[0].sources.len() == 6, "one hexagon: {outline:?}");
    for chain in lines.chains.iter() {
        for (&point, pixel) in chain.points.iter().zip(chain.pixels) {
            let seen = camera.project(point).unwrap().pixel;
            assert!(seen.distance(*pixel) < 1e-6, "{point} appears at {seen}, not at {pixel}");
        }
    }
}

#[test]
fn a_cube_shows_nine_edges_and_hides_three_from_every_octant() {
    for half in SCALES {
        for offset in OFFSETS {
            let mesh = cube(half, offset);
            for direction in octants() {
                for perspective in [true, false] {
                    check(&mesh, direction, perspective);
                }
            }
        }
    }
}

/// The count can fail: without the side that a viewer looks through, some of the three edges are seen.
#[test]
fn an_open_box_shows_more() {
    for direction in octants() {
        let cube = cube(1.0, 0.0);
        // The sides come in the order -x, +x, -y, +y, -z, +z, two faces each.
        let lid = if direction.y > 0.0 { 3 } else { 2 };
        let open = keeping(&cube, |face| face / 2 != lid);
        let camera = framing(&open, direction, true);
        let hidden_px = |mesh| {
            let lines = all_lines(mesh, &camera, &options());
            let hidden = lines.chains.iter().filter(|chain| chain.style.invisibility > 0);
            hidden.map(|chain| chain.length_px()).sum::<f64>()
        };
        let (closed, open) = (hidden_px(&cube), hidden_px(&open));
        assert!(open < 0.9 * closed, "{open} px of {closed} px stay hidden");
    }
}

//! Every decision about a point of a line against a sight line cast by brute force.

use crate::oracle::{Oracle, nearest_step};
use crate::scenes::{all_lines, framing};
use silhouette_core::glam::DVec3;
use silhouette_core::{Camera, Projection, Topology, TriangleMesh, VertexId};
use silhouette_testing::directions::{AXES, spread};
use silhouette_testing::{builtin, real_mesh};
use silhouette_visibility::{LineOptions, Lines, SegmentSource};

/// Share of the picture that a decision keeps from the nearest end of its piece.
const CLEARANCE: f64 = 1e-4;

/// What a comparison saw.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct Tally {
    /// Points compared.
    pub samples: usize,
    /// Those with another invisibility.
    pub wrong: usize,
    /// Points compared at which something was too close to a tie for floating point.
    pub ties: usize,
    /// Points compared that are hidden.
    pub hidden: usize,
}

/// Share of the way from one point to the other in space at which the given share of the way in the picture lies.
fn in_space(camera: &Camera, ends: [DVec3; 2], share: f64) -> f64 {
    match camera.projection() {
        Projection::Orthographic { .. } => share,
        Projection::Perspective { .. } => {
            let [from, to] = ends.map(|end| -camera.view_matrix().transform_point3(end).z);
            share * from / (to + share * (from - to))
        }
    }
}

/// Compares about `wanted` points, spread evenly along all lines.
pub fn compare(mesh: &TriangleMesh, lines: &Lines, wanted: usize) -> Tally {
    let topology = Topology::new(mesh);
    let oracle = Oracle::new(mesh, &lines.camera.viewpoint());
    let clearance_px = CLEARANCE * f64::from(lines.camera.size()[0].max(lines.camera.size()[1]));
    let total: f64 = lines.chains.iter().map(|chain| chain.length_px()).sum();
    let spacing = total / wanted as f64;
    let mut tally = Tally::default();
    let mut walked = spacing * 0.5;
    for chain in lines.chains.iter() {
        for (segment, source) in chain.sources.iter().enumerate() {
            let length = {
                let [from, to] = chain.segment_pixels(segment);
                from.distance(to)
            };
            let SegmentSource::Edge(edge) = *source else { panic!("only mesh edges were asked for") };
            while walked < length {
                let at = walked;
                walked += spacing;
                if at < clearance_px || at > length - clearance_px {
                    continue;
                }
                let points = [segment, (segment + 1) % chain.points.len()].map(|index| chain.points[index]);
                let vertices = topology.end_points(edge).map(VertexId::get);
                let ends = vertices.map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
                let point = points[0].lerp(points[1], in_space(&lines.camera, points, at / length));
                let t = point.distance(ends[0]) / ends[1].distance(ends[0]);
                let (expected, is_tie) = oracle.invisibility(vertices, nearest_step(t));
                tally.samples += 1;
                tally.ties += usize::from(is_tie);
                tally.hidden += usize::from(expected > 0);
                tally.wrong += usize::from(expected != chain.style.invisibility);
            }
            walked -= length;
        }
    }
    tally
}

fn check(name: &str, mesh: &TriangleMesh, views: usize, wanted: usize, options: &LineOptions) {
    let mut sum = Tally::default();
    for (index, direction) in spread(views).enumerate() {
        let camera = framing(mesh, direction, index % 3 != 2);
        let tally = compare(mesh, &all_lines(mesh, &camera, options), wanted);
        assert_eq!(tally.wrong, 0, "{name} from {direction}: {tally:?}");
        sum.samples += tally.samples;
        sum.ties += tally.ties;
        sum.hidden += tally.hidden;
    }
    eprintln!("{name}: {sum:?}");
    assert!(sum.samples > wanted * views / 2, "{name}: {sum:?}");
}

const SHAPES: [&str; 9] =
    ["cube", "icosphere:2", "torus:24,16", "knot", "gear", "blob:3000", "grid", "moebius", "cone"];

#[test]
fn shapes_agree_with_brute_force() {
    for name in SHAPES {
        check(name, &builtin(name), 6, 400, &LineOptions::default());
    }
}

#[test]
fn every_mesh_edge_agrees_with_brute_force() {
    let options = LineOptions { mesh: true, ..LineOptions::default() };
    for name in ["cube", "icosphere:2", "torus:24,16", "gear", "moebius"] {
        check(name, &builtin(name), 4, 1000, &options);
    }
}

/// Along axes and diagonals, edges cover edges and faces are edge-on.
#[test]
fn views_along_axes_agree_with_brute_force() {
    let options = LineOptions { mesh: true, ..LineOptions::default() };
    for name in ["cube", "gear", "grid", "cylinder", "uv-sphere"] {
        let mesh = builtin(name);
        for direction in [DVec3::X, DVec3::NEG_Y, DVec3::Z, DVec3::new(1.0, 1.0, 0.0), DVec3::ONE] {
            for perspective in [true, false] {
                let camera = framing(&mesh, direction, perspective);
                let tally = compare(&mesh, &all_lines(&mesh, &camera, &options), 500);
                assert_eq!(tally.wrong, 0, "{name} along {direction}, perspective {perspective}: {tally:?}");
            }
        }
    }
}

const MODELS: [&str; 8] = [
    "cow.obj",
    "spot.obj",
    "fandisk.obj",
    "suzanne.obj",
    "teapot.obj",
    "homer.obj",
    "stanford-bunny.obj",
    "armadillo.obj",
];

/// Whether a long run is wanted.
pub fn is_thorough() -> bool {
    std::env::var_os("SILHOUETTES_ORACLE").is_some()
}

#[test]
fn real_models_agree_with_brute_force() {
    let (views, wanted) = if is_thorough() { (10, 10_000) } else { (2, 150) };
    for name in MODELS {
        if let Some(mesh) = real_mesh("real_models_agree_with_brute_force", name) {
            check(name, &mesh, views, wanted, &LineOptions::default());
        }
    }
}

/// Along axes, faces of real models are exactly edge-on, and halves of symmetric ones coincide.
#[test]
fn real_models_along_axes_agree_with_brute_force() {
    let wanted = if is_thorough() { 4000 } else { 60 };
    for name in MODELS {
        let Some(mesh) = real_mesh("real_models_along_axes_agree_with_brute_force", name) else { continue };
        let mut sum = Tally::default();
        for direction in AXES {
            for perspective in if is_thorough() { &[false, true][..] } else { &[false][..] } {
                let camera = framing(&mesh, direction, *perspective);
                let tally = compare(&mesh, &all_lines(&mesh, &camera, &LineOptions::default()), wanted);
                assert_eq!(tally.wrong, 0, "{name} along {direction}, perspective {perspective}: {tally:?}");
                sum.samples += tally.samples;
                sum.ties += tally.ties;
                sum.hidden += tally.hidden;
            }
        }
        eprintln!("{name} along axes: {sum:?}");
        assert!(sum.samples > wanted, "{name}: {sum:?}");
    }
}

/// The comparison can fail: lines of a camera that stands elsewhere are wrong in many places.
#[test]
fn lines_of_another_view_are_seen_to_be_wrong() {
    let mesh = builtin("knot");
    let camera = framing(&mesh, DVec3::new(0.5, 0.4, 1.0), true);
    let mut lines = all_lines(&mesh, &camera, &LineOptions::default());
    lines.camera = framing(&mesh, DVec3::new(-1.0, 0.4, 0.2), true);
    let tally = compare(&mesh, &lines, 400);
    assert!(tally.wrong * 10 > tally.samples, "{tally:?}");
}

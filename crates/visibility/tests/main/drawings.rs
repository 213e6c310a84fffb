//! Whole drawings of random scenes against brute force, ties included: which edges are drawn and why, and how many layers
//! hide each stretch of each.

use crate::oracle::{Oracle, STEPS};
use crate::scenes::all_lines;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::{Camera, Projection, Topology, TriangleMesh, VertexId, Viewpoint};
use silhouette_testing::Random;
use silhouette_testing::lattice_scenes::{FAMILIES, Family, camera, scene, seeds};
use silhouette_visibility::{LineKind, LineOptions, Lines, SegmentSource};
use std::collections::BTreeMap;

/// Stretches between places where something may change that are shorter than this share of their edge are not looked at.
const LEAST_STRETCH: f64 = 1e-4;

/// How far from an end of a piece it is looked at, as a share of its edge.
const CLEARANCE: f64 = 1e-5;

/// Pixels from the border of the picture within which it does not matter whether a line is drawn.
const BORDER_PX: f64 = 0.5;

/// What a comparison saw.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct Tally {
    pub scenes: usize,
    pub edges: usize,
    pub samples: usize,
    /// Samples at which floating point could not have decided.
    pub ties: usize,
    /// Samples in front of which a face is seen edge-on or touched.
    pub hidden: usize,
    /// Edges that are drawn and should not be, or the other way round, or for another reason.
    pub wrong_kinds: usize,
    /// Samples of another invisibility.
    pub wrong_samples: usize,
}

impl Tally {
    fn add(&mut self, other: Self) {
        self.scenes += other.scenes;
        self.edges += other.edges;
        self.samples += other.samples;
        self.ties += other.ties;
        self.hidden += other.hidden;
        self.wrong_kinds += other.wrong_kinds;
        self.wrong_samples += other.wrong_samples;
    }

    fn is_right(&self) -> bool {
        self.wrong_kinds == 0 && self.wrong_samples == 0
    }
}

/// A stretch of an edge as drawn.
struct Stretch {
    range: [f64; 2],
    invisibility: u32,
}

/// The stretches of each edge that is drawn, with its kind.
fn stretches(mesh: &TriangleMesh, topology: &Topology, lines: &Lines) -> BTreeMap<[u32; 2], (LineKind, Vec<Stretch>)> {
    let mut drawn: BTreeMap<[u32; 2], (LineKind, Vec<Stretch>)> = BTreeMap::new();
    for chain in lines.chains.iter() {
        for (segment, source) in chain.sources.iter().enumerate() {
            let SegmentSource::Edge(edge) = *source else { panic!("only mesh edges were asked for") };
            let vertices = topology.end_points(edge).map(VertexId::get);
            let [a, b] = vertices.map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
            let ends = [segment, (segment + 1) % chain.points.len()].map(|index| chain.points[index]);
            let mut range = ends.map(|point| point.distance(a) / b.distance(a));
            range.sort_by(f64::total_cmp);
            let (kind, stretches) = drawn.entry(vertices).or_insert_with(|| (chain.style.kind, Vec::new()));
            assert_eq!(*kind, chain.style.kind, "an edge has one kind");
            stretches.push(Stretch { range, invisibility: chain.style.invisibility });
        }
    }
    drawn
}

/// Parameters along an edge at which anything may change, from its ends inwards.
fn places(mesh: &TriangleMesh, viewpoint: &Viewpoint, ends: [Vec3; 2]) -> Vec<f64> {
    let [a, b] = ends.map(Vec3::as_dvec3);
    let center = mesh.bounds().map_or(DVec3::ZERO, |bounds| bounds.center);
    let eye = match *viewpoint {
        Viewpoint::Perspective { eye } => (eye.as_dvec3(), 1.0),
        Viewpoint::Orthographic { toward_viewer } => (toward_viewer.as_dvec3(), 0.0),
    };
    let viewers = [eye, (center, 1.0), (DVec3::X, 0.0), (DVec3::Y, 0.0), (DVec3::Z, 0.0)];
    let mut places = vec![0.0, 1.0];
    let mut add = |at_a: f64, at_b: f64| {
        let t = at_a / (at_a - at_b);
        if t > 0.0 && t < 1.0 {
            places.push(t);
        }
    };
    for triangle in mesh.triangles() {
        let corners = triangle.map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        add(normal.dot(a - corners[0]), normal.dot(b - corners[0]));
        for slot in 0..3 {
            let (p, q) = (corners[slot], corners[(slot + 1) % 3]);
            for (viewer, weight) in viewers {
                let turn = |point: DVec3| (q - p).cross(point - p).dot(viewer - p * weight);
                add(turn(a), turn(b));
            }
        }
    }
    places.sort_by(f64::total_cmp);
    places
}

/// Whether the point appears inside the picture for certain, or for certain not.
fn is_inside(camera: &Camera, point: DVec3) -> Option<bool> {
    let view = camera.view_matrix().transform_point3(point);
    if matches!(camera.projection(), Projection::Perspective { .. }) && -view.z < 1e-6 {
        return if -view.z < -1e-6 { Some(false) } else { None };
    }
    let pixel = camera.view_to_pixel(view).pixel;
    let [width, height] = camera.size().map(f64::from);
    let inside = [pixel.x, pixel.y, width - pixel.x, height - pixel.y].into_iter().fold(f64::INFINITY, f64::min);
    (inside.abs() > BORDER_PX).then_some(inside > 0.0)
}

/// Compares one drawing; `mesh_edges` says whether every edge is drawn.
fn compare(mesh: &TriangleMesh, camera: &Camera, lines: &Lines, mesh_edges: bool) -> Tally {
    let topology = Topology::new(mesh);
    let oracle = Oracle::of_whole(mesh, &camera.viewpoint());
    let drawn = stretches(mesh, &topology, lines);
    let mut tally = Tally { scenes: 1, ..Tally::default() };
    for edge in topology.edges().ids() {
        let vertices = topology.end_points(edge).map(VertexId::get);
        let ends = vertices.map(|vertex| mesh.positions()[vertex as usize]);
        if ends[0] == ends[1] {
            continue;
        }
        tally.edges += 1;
        let expected = if oracle.is_silhouette(vertices) {
            Some(LineKind::Silhouette)
        } else if oracle.is_boundary(vertices) {
            Some(LineKind::Boundary)
        } else {
            mesh_edges.then_some(LineKind::Mesh)
        };
        let found = drawn.get(&vertices);
        if found.is_some_and(|(kind, _)| Some(*kind) != expected) {
            tally.wrong_kinds += 1;
            continue;
        }
        if expected.is_none() || is_end_on(camera, ends) {
            continue;
        }
        let none = Vec::new();
        let stretches = found.map_or(&none, |(_, stretches)| stretches);
        let length: f64 = stretches.iter().map(|stretch| stretch.range[1] - stretch.range[0]).sum();
        tally.wrong_kinds += usize::from(length > 1.0 + 1e-6);
        let places = places(mesh, &camera.viewpoint(), ends);
        for pair in places.windows(2).filter(|pair| pair[1] - pair[0] > LEAST_STRETCH) {
            let step = ((pair[0] + pair[1]) * 0.5 * STEPS as f64).round() as i64;
            let t = step as f64 / STEPS as f64;
            let point = ends[0].as_dvec3().lerp(ends[1].as_dvec3(), t);
            let Some(inside) = is_inside(camera, point) else { continue };
            let is_near_end = |stretch: &Stretch| stretch.range.iter().any(|end| (end - t).abs() < CLEARANCE);
            if stretches.iter().any(is_near_end) {
                continue;
            }
            let at = stretches.iter().find(|stretch| stretch.range[0] < t && t < stretch.range[1]);
            let (invisibility, is_tie) = oracle.invisibility(vertices, step);
            tally.samples += 1;
            tally.ties += usize::from(is_tie);
            tally.hidden += usize::from(invisibility > 0);
            let is_right = at.map_or(!inside, |stretch| inside && stretch.invisibility == invisibility);
            tally.wrong_samples += usize::from(!is_right);
        }
    }
    tally
}

fn is_end_on(camera: &Camera, ends: [Vec3; 2]) -> bool {
    let [a, b] = ends.map(Vec3::as_dvec3);
    let across = match camera.viewpoint() {
        Viewpoint::Perspective { eye } => (a - eye.as_dvec3()).cross(b - a),
        Viewpoint::Orthographic { toward_viewer } => toward_viewer.as_dvec3().cross(b - a),
    };
    across == DVec3::ZERO
}

fn check(family: Family) {
    let mut sum = Tally::default();
    for seed in 0..seeds(600) {
        let mut random = Random::new(seed);
        let mesh = scene(family, &mut random);
        let Some(camera) = camera(&mesh, &mut random) else { continue };
        for mesh_edges in [false, true] {
            let options = LineOptions { mesh: mesh_edges, ..LineOptions::default() };
            let tally = compare(&mesh, &camera, &all_lines(&mesh, &camera, &options), mesh_edges);
            assert!(
                tally.is_right(),
                "{family:?}, seed {seed}, every edge {mesh_edges}: {tally:?}\n{camera:?}\n{:?}\n{:?}",
                mesh.positions(),
                mesh.triangles()
            );
            sum.add(tally);
        }
    }
    eprintln!("{family:?}: {sum:?}");
    assert!(sum.ties * 20 > sum.samples, "ties are the rule: {sum:?}");
}

#[test]
fn closed_scenes_are_drawn_as_brute_force_has_them() {
    check(Family::Closed);
}

#[test]
fn damaged_scenes_are_drawn_as_brute_force_has_them() {
    check(Family::Damaged);
}

#[test]
fn sheets_are_drawn_as_brute_force_has_them() {
    check(Family::Sheets);
}

#[test]
fn triangles_that_share_vertices_are_drawn_as_brute_force_has_them() {
    check(Family::Shared);
}

#[test]
fn triangles_apart_are_drawn_as_brute_force_has_them() {
    check(Family::Apart);
}

#[test]
fn faces_listed_twice_are_drawn_as_brute_force_has_them() {
    check(Family::Twice);
}

/// The comparison can fail: lines that are all called visible, or that lack an edge, are wrong in many scenes.
#[test]
fn damaged_drawings_are_seen_to_be_wrong() {
    let (mut unhidden, mut of_other_view, mut scenes) = (0, 0, 0);
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let mesh = scene(FAMILIES[random.below(FAMILIES.len())], &mut random);
        let (Some(one), Some(other)) = (camera(&mesh, &mut random), camera(&mesh, &mut random)) else { continue };
        let options = LineOptions { mesh: true, ..LineOptions::default() };
        let mut lines = all_lines(&mesh, &one, &options);
        of_other_view += usize::from(!compare(&mesh, &other, &lines, true).is_right());
        let mut chains = silhouette_visibility::Chains::default();
        for mut chain in lines.chains.iter() {
            chain.style.invisibility = 0;
            chains.push(chain);
        }
        lines.chains = chains;
        unhidden += usize::from(!compare(&mesh, &one, &lines, true).is_right());
        scenes += 1;
    }
    assert!(unhidden * 2 > scenes && of_other_view * 2 > scenes, "{unhidden} and {of_other_view} of {scenes}");
}

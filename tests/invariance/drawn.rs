//! Lines and outlines.

use crate::invariance::change::{Change, changes, on_grid};
use glam::{DVec2, DVec3, Vec3};
use silhouette_core::view::Framing;
use silhouette_core::{Camera, NoProgress, Topology, VertexId};
use silhouette_testing::directions::spread;
use silhouette_testing::edits::mapped;
use silhouette_testing::prepare::prepared;
use silhouette_testing::views::{PERSPECTIVE, framed};
use silhouette_testing::{builtin, with_threads};
use silhouette_visibility::{LineFinder, LineKind, LineOptions, LineScene, Lines, SegmentSource};

/// A stretch of an edge: its vertices by their original numbers, why it is drawn, what lies in front of it, and where it
/// begins and ends from the lower vertex on.
type Stretch = ([u32; 2], LineKind, u32, [f64; 2]);

/// Most by which the place of an end may differ where coordinates are rounded elsewhere, as a share of its edge.
const MOST_OFF: f64 = 1e-8;

fn lines(change: &Change, camera: &Camera) -> Lines {
    let options = LineOptions {
        ridge_deg: Some(30.0),
        valley_deg: Some(30.0),
        max_invisibility: u32::MAX,
        outline: true,
        ..LineOptions::default()
    };
    let mut finder = LineFinder::new(LineScene::new(prepared(change.mesh.clone())), &NoProgress).unwrap();
    finder.find(&change.camera(camera), &options, &NoProgress).unwrap()
}

fn stretches(change: &Change, lines: &Lines) -> Vec<Stretch> {
    let (mesh, topology) = (&change.mesh, Topology::new(&change.mesh));
    let mut all: Vec<Stretch> = Vec::new();
    for chain in lines.chains.iter() {
        for (segment, source) in chain.sources.iter().enumerate() {
            let SegmentSource::Edge(edge) = *source else { panic!("only mesh edges were asked for") };
            let mut vertices = topology.end_points(edge).map(VertexId::get);
            vertices.sort_by_key(|vertex| change.original(*vertex));
            let [a, b] = vertices.map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
            let along = |index: usize| {
                let point: DVec3 = chain.points[index % chain.points.len()];
                point.distance(a) / b.distance(a)
            };
            let mut range = [along(segment), along(segment + 1)];
            range.sort_by(f64::total_cmp);
            all.push((vertices.map(|v| change.original(v)), chain.style.kind, chain.style.invisibility, range));
        }
    }
    all.sort_by(|one, other| one.0.cmp(&other.0).then(one.3[0].total_cmp(&other.3[0])));
    all
}

fn are_like(one: &[Stretch], other: &[Stretch]) -> bool {
    let is_like = |(one, other): (&Stretch, &Stretch)| {
        (one.0, one.1, one.2) == (other.0, other.1, other.2)
            && one.3.iter().zip(other.3).all(|(one, other)| (one - other).abs() <= MOST_OFF)
    };
    one.len() == other.len() && one.iter().zip(other).all(is_like)
}

/// Rings, points, area and length of an outline.
fn measures(lines: &Lines) -> [f64; 3] {
    let length = |ring: &Vec<DVec2>| -> f64 {
        ring.iter().zip(ring.iter().cycle().skip(1)).map(|(one, other)| one.distance(*other)).sum()
    };
    let rings = &lines.outline.rings;
    [rings.len() as f64, lines.outline.area_px(), rings.iter().map(length).sum()]
}

fn is_close(one: [f64; 3], other: [f64; 3]) -> bool {
    one.iter().zip(other).all(|(one, other)| (one - other).abs() <= 1e-6 * one.abs())
}

/// A camera whose numbers are on the grid.
fn camera(change: &Change, direction: DVec3, framing: Framing) -> Camera {
    let camera = framed(&change.mesh, direction, framing, [400; 2]);
    let [eye, target] = [camera.eye(), camera.target()].map(on_grid);
    Camera::new(eye, target, camera.up(), camera.projection(), camera.size()).unwrap()
}

/// Views that are generic: of ties, the displaced viewer's axes decide some, and a mirror turns one of them round.
fn cases() -> impl Iterator<Item = (&'static str, Change, Camera)> {
    ["knot", "gear", "blob:1500", "moebius", "grid:12,9", "torus:24,16"].into_iter().flat_map(|name| {
        let mesh = mapped(&builtin(name), on_grid);
        spread(3).zip([PERSPECTIVE, Framing::Orthographic, PERSPECTIVE]).map(move |(direction, framing)| {
            let change = Change::none(&mesh);
            let camera = camera(&change, direction, framing);
            (name, change, camera)
        })
    })
}

#[test]
fn lines_and_outlines_do_not_depend_on_the_place_of_a_mesh() {
    let mut compared = 0;
    for (name, none, camera) in cases() {
        let expected = lines(&none, &camera);
        let wanted = stretches(&none, &expected);
        assert!(wanted.len() > 10, "{name}");
        for change in changes(&none.mesh) {
            let found = lines(&change, &camera);
            assert!(are_like(&wanted, &stretches(&change, &found)), "{name}, {}", change.name);
            assert!(is_close(measures(&expected), measures(&found)), "{name}, {}: outline", change.name);
            compared += wanted.len();
        }
    }
    eprintln!("{compared} stretches compared");
}

/// Scaling by a power of two changes exponents alone.
#[test]
fn another_unit_of_length_draws_the_same_pixels_to_the_bit() {
    for (name, none, camera) in cases() {
        let expected = lines(&none, &camera);
        for change in changes(&none.mesh).filter(|change| ["smaller", "larger"].contains(&change.name)) {
            let found = lines(&change, &camera);
            assert_eq!(expected.chains.len(), found.chains.len(), "{name}");
            for (one, other) in expected.chains.iter().zip(found.chains.iter()) {
                assert!(one.pixels == other.pixels && one.sources == other.sources, "{name}, {}", change.name);
                let scale = f64::from(change.scale);
                assert!(one.points.iter().zip(other.points).all(|(one, other)| *one * scale == *other), "{name}");
            }
            assert!(expected.outline == found.outline, "{name}, {}: outline", change.name);
        }
    }
}

#[test]
fn lines_and_outlines_do_not_depend_on_the_number_of_threads() {
    for (name, none, camera) in cases() {
        let of = |threads| with_threads(threads, || lines(&none, &camera));
        let (one, two) = (of(1), of(2));
        assert!(one.chains == two.chains && one.outline == two.outline, "{name}");
    }
}

/// The comparisons can fail.
#[test]
fn lines_of_another_view_are_told() {
    for (name, none, camera) in cases().take(6) {
        let eye = camera.eye() + Vec3::new(0.01, 0.02, 0.0);
        let beside = Camera::new(eye, camera.target(), camera.up(), camera.projection(), camera.size()).unwrap();
        let (one, other) = (lines(&none, &camera), lines(&none, &beside));
        assert!(!are_like(&stretches(&none, &one), &stretches(&none, &other)), "{name}");
        assert!(!is_close(measures(&one), measures(&other)), "{name}");
    }
}

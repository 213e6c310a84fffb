use super::*;
use crate::truth::view_facts::SeenMesh;
use crate::truth::visible::VisibleLine;
use crate::truth::{Truth, TruthFinder};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::inside_out::turned;
use silhouette_core::view::Framing;
use silhouette_core::{Camera, EdgeId, NoProgress, PreparedMesh, TriangleMesh, shapes};
use silhouette_gpu::{Pen, PenPlacement};
use silhouette_visibility::{LineOptions, SegmentSource};
use std::sync::Arc;

const PEN: Pen = Pen { width_px: 2.0, placement: PenPlacement::Centred };

/// A mesh in a view, with its truth.
struct Scene {
    finder: TruthFinder,
    truth: Truth,
    facts: ViewFacts,
    pen: Ink,
}

impl Scene {
    fn new(mesh: TriangleMesh, direction: DVec3, size: u32) -> Self {
        let mesh = Arc::new(PreparedMesh::new(mesh));
        let bounds = mesh.mesh().bounds().unwrap();
        let camera = Camera::framing(&bounds, direction, Vec3::Y, Framing::Orthographic, [size; 2]).unwrap();
        let mut finder = TruthFinder::new(&mesh, &NoProgress).unwrap();
        let truth = finder.find(&camera, &NoProgress).unwrap();
        let facts = finder.facts(&truth, reach_px(PEN.width_px), &NoProgress).unwrap();
        let pen = truth.draw(PEN);
        Self { finder, truth, facts, pen }
    }

    fn of_shape(name: &str) -> Self {
        Self::new(shapes::by_name(name).unwrap(), DVec3::new(0.5, 0.8, 1.0), 256)
    }

    fn errors(&self, ink: &Ink) -> LineErrors {
        self.errors_seeing(ink, |_| None)
    }

    fn errors_seeing(&self, ink: &Ink, seen: impl Fn(DVec2) -> Option<Circumstance>) -> LineErrors {
        let pen = TruePen { picture: &self.pen, width_px: PEN.width_px };
        line_errors(ink, &self.truth.lines, pen, &self.facts, seen)
    }

    /// The true lines without those segments whose edges `is_left_out`.
    fn without(&self, is_left_out: impl Fn(EdgeId) -> bool) -> Ink {
        let segments = self.truth.visible.iter().flat_map(VisibleLine::segments);
        let kept = segments.filter(|(edge, _)| !is_left_out(*edge));
        let lines = kept.map(|(edge, ends)| VisibleLine { points: ends.to_vec(), edges: vec![edge], closed: false });
        crate::truth::pen::draw(&lines.collect::<Vec<_>>(), PEN, self.truth.camera.size())
    }

    /// The true lines and those of some options.
    fn with(&mut self, options: &LineOptions) -> Ink {
        let found = self.finder.find_lines(&self.truth.camera, options, &NoProgress).unwrap();
        let mut lines = self.truth.visible.clone();
        for chain in found.chains.iter() {
            for (at, source) in chain.sources.iter().enumerate() {
                let SegmentSource::Edge(edge) = source else { continue };
                let points = chain.segment_pixels(at).to_vec();
                lines.push(VisibleLine { points, edges: vec![*edge], closed: false });
            }
        }
        crate::truth::pen::draw(&lines, PEN, self.truth.camera.size())
    }

    fn seen(&self) -> SeenMesh<'_> {
        self.finder.seen(&self.truth.camera)
    }
}

/// A cube without its bottom and a side, so that its inside shows.
fn open_cube() -> TriangleMesh {
    let cube = shapes::by_name("cube").unwrap();
    let is_kept = |corners: &&[u32; 3]| {
        let corners = corners.map(|corner| cube.positions()[corner as usize]);
        !corners.iter().all(|corner| corner.z > 0.0)
    };
    TriangleMesh::new(cube.positions().to_vec(), cube.triangles().iter().filter(is_kept).copied().collect()).unwrap()
}

fn sums(errors: &LineErrors) -> [[f64; 2]; 3] {
    let by_cause = |parts: [f64; 4]| parts.iter().sum::<f64>();
    let e = errors;
    [
        [
            e.true_px(),
            by_cause([e.true_open_boundary_px, e.true_inward_winding_px, e.true_small_faces_px, e.true_unexplained_px]),
        ],
        [
            e.missed_px(),
            by_cause([
                e.missed_open_boundary_px,
                e.missed_inward_winding_px,
                e.missed_small_faces_px,
                e.missed_unexplained_px,
            ]),
        ],
        [
            e.spurious_px(),
            by_cause([
                e.spurious_open_boundary_px,
                e.spurious_inward_winding_px,
                e.spurious_small_faces_px,
                e.spurious_unexplained_px,
            ]),
        ],
    ]
}

#[test]
fn what_is_left_out_of_one_kind_is_missed_of_that_kind() {
    let scene = Scene::new(open_cube(), DVec3::new(0.5, 0.8, 1.0), 256);
    let of_kind = |kind| {
        let facts = scene.seen().facts;
        scene.errors(&scene.without(|edge| facts.kind(edge) == kind))
    };
    let whole = scene.errors(&scene.pen);
    assert!(whole.missed_px() < 1e-9 && whole.spurious_px() < 1e-9, "{whole:?}");
    let boundary = of_kind(EdgeKind::Boundary);
    assert!(boundary.missed_boundary_px > 0.9 * boundary.true_boundary_px && boundary.true_boundary_px > 100.0);
    assert!(boundary.missed_crease_px < 1e-9 && boundary.missed_silhouette_px < 1e-9, "{boundary:?}");
    assert!((boundary.missed_open_boundary_px - boundary.missed_boundary_px).abs() < 1e-9);
    let creases = of_kind(EdgeKind::Crease);
    assert!(creases.missed_crease_px > 0.9 * creases.true_crease_px && creases.true_crease_px > 100.0, "{creases:?}");
    assert!(creases.missed_unexplained_px > 100.0 && creases.missed_open_boundary_px < 1e-9, "{creases:?}");
    for errors in [whole, boundary, creases] {
        for [kinds, causes] in sums(&errors) {
            assert!((kinds - causes).abs() < 1e-6, "{errors:?}");
        }
    }
}

#[test]
fn ink_on_lines_that_are_not_true_is_spurious_of_their_kind() {
    let mut cube = Scene::of_shape("cube");
    let hidden = LineOptions { max_invisibility: u32::MAX, ..crate::truth::finder::silhouette_options() };
    let creases = LineOptions { ridge_deg: Some(30.0), silhouette: false, ..LineOptions::default() };
    let drawn = cube.with(&creases);
    let errors = cube.errors(&drawn);
    let all = errors.spurious_px();
    assert!(all > 50.0 && errors.spurious_crease_px > 0.99 * all, "{errors:?}");
    let mut torus = Scene::new(shapes::by_name("torus").unwrap(), DVec3::new(0.0, 0.35, 1.0), 256);
    let drawn = torus.with(&hidden);
    let errors = torus.errors(&drawn);
    let all = errors.spurious_px();
    assert!(all > 20.0 && errors.spurious_silhouette_px > 0.99 * all, "{errors:?}");
    let speck = |x: u32, y: u32| x % 32 == 3 && y % 32 == 5;
    let specked = Ink::from_fn(256, 256, |x, y| if speck(x, y) { 1.0 } else { torus.pen.coverage(x.into(), y.into()) });
    let errors = torus.errors(&specked);
    assert!(errors.spurious_nothing_px > 0.8 * errors.spurious_px() && errors.spurious_px() > 10.0, "{errors:?}");
    assert!((errors.spurious_px() * PEN.width_px).fract() < 1e-9, "whole pixels over the pen's width");
}

/// What is seen where ink lies decides which of them it is.
#[test]
fn a_back_face_that_is_seen_explains_ink_on_it() {
    let scene = Scene::of_shape("torus");
    let black = Ink::from_fn(256, 256, |_, _| 1.0);
    for (seen, value) in [
        (Circumstance::OpenBoundary, LENGTHS.iter().find(|length| length.name == "spurious_open_boundary_px")),
        (Circumstance::InwardWinding, LENGTHS.iter().find(|length| length.name == "spurious_inward_winding_px")),
    ] {
        let errors = scene.errors_seeing(&black, |_| Some(seen));
        let explained = (value.unwrap().value)(&errors).unwrap();
        assert!(explained > 1e4 && (explained - errors.spurious_px()).abs() < 1e-6, "{errors:?}");
    }
    let errors = scene.errors(&black);
    assert!(errors.spurious_unexplained_px > 0.9 * errors.spurious_px());
}

#[test]
fn the_same_mesh_wound_inwards_errs_for_its_winding() {
    let cube = shapes::by_name("cube").unwrap();
    let inverted = Scene::new(turned(&cube, &[true; 12]), DVec3::new(0.5, 0.8, 1.0), 256);
    let blank = Ink::blank(256, 256);
    let errors = inverted.errors(&blank);
    assert!((errors.missed_inward_winding_px - errors.true_px()).abs() < 1e-9 && errors.true_px() > 300.0);
    let errors = Scene::of_shape("cube").errors(&blank);
    assert!((errors.missed_unexplained_px - errors.true_px()).abs() < 1e-9, "{errors:?}");
}

#[test]
fn faces_below_a_pixel_depend_on_the_picture() {
    let ball = |size| Scene::new(shapes::by_name("icosphere:5").unwrap(), DVec3::new(0.5, 0.8, 1.0), size);
    let share = |size| {
        let errors = ball(size).errors(&Ink::blank(size, size));
        errors.missed_small_faces_px / errors.true_px()
    };
    assert!(share(64) > 0.99 && share(4096) < 0.3, "{} {}", share(64), share(4096));
}

/// From above one sees the hole of a torus: half of the lines, and more, are the outline; from the side its front rim is
/// inside.
#[test]
fn lines_inside_of_the_outline_are_known() {
    let tilted = Scene::new(shapes::by_name("torus").unwrap(), DVec3::new(0.0, 0.35, 1.0), 256);
    let outer = tilted.facts.is_inner.as_ref().unwrap();
    let inner = tilted.truth.lines.samples.iter().zip(outer).filter(|(_, is_inner)| **is_inner);
    let inner_px: f64 = inner.map(|(sample, _)| sample.length_px).sum();
    let blank = tilted.errors(&Ink::blank(256, 256));
    assert_eq!((blank.true_inner_px, blank.missed_inner_px), (Some(inner_px), Some(inner_px)));
    assert!(inner_px > 20.0 && inner_px < 0.5 * blank.true_px(), "{inner_px} of {}", blank.true_px());
    let cube = Scene::of_shape("cube").errors(&Ink::blank(256, 256));
    assert!(cube.true_inner_px.is_some_and(|inner| inner < 0.01 * cube.true_px()), "{cube:?}");
}

#[test]
fn views_are_averaged_and_what_one_lacks_is_lacking() {
    let known =
        LineErrors { true_crease_px: 2.0, true_inner_px: Some(4.0), missed_inner_px: Some(1.0), ..Default::default() };
    let unknown = LineErrors { true_crease_px: 4.0, ..LineErrors::default() };
    let mean = LineErrors::mean(&[known, known]).unwrap();
    assert_eq!((mean, mean.true_inner_px), (known, Some(4.0)));
    for pair in [[known, unknown], [unknown, known]] {
        let mean = LineErrors::mean(&pair).unwrap();
        assert!((mean.true_crease_px - 3.0).abs() < 1e-12 && mean.true_inner_px.is_none(), "{mean:?}");
    }
    assert_eq!(LineErrors::mean(&[]), None);
}

#[test]
fn the_documentation_holds_the_table() {
    let text = include_str!("../../../../../docs/METRICS.md");
    for LengthSpec { name, summary, .. } in LENGTHS {
        let row = format!("| `{name}` | {summary} |");
        assert!(text.contains(&row), "docs/METRICS.md lacks this row:\n{row}");
    }
    let json = serde_json::to_value(LineErrors::default()).unwrap();
    assert_eq!(json.as_object().unwrap().len(), LENGTHS.len());
}

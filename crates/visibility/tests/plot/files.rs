//! What is written, read by programs that others wrote.

use crate::scene::{Drawn, any_lines, drawn, lines, lines_of, orthographic, perspective};
use proptest::prelude::*;
use silhouette_core::glam::DVec2;
use silhouette_core::{NoProgress, VertexId};
use silhouette_testing::with_threads;
use silhouette_visibility::plot::{
    Dash, Drawing, Fit, GltfContainer, Hidden, Length, Page, PlotOptions, Sheet, Unit, placement, plot, write_gltf,
    write_json,
};
use silhouette_visibility::{LineKind, Lines, Outline};

const TITLE: &str = "a <mesh> & \"another\"";

fn svg(drawing: &Drawing) -> String {
    let mut bytes = Vec::new();
    drawing.write_svg(TITLE, &mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

fn parsed(text: &str) -> usvg::Tree {
    usvg::Tree::from_str(text, &usvg::Options::default()).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// All paths of a group and the groups in it.
fn paths_in(group: &usvg::Group) -> Vec<&usvg::Path> {
    let mut paths = Vec::new();
    for node in group.children() {
        match node {
            usvg::Node::Path(path) => paths.push(&**path),
            usvg::Node::Group(group) => paths.extend(paths_in(group)),
            other => panic!("{other:?}"),
        }
    }
    paths
}

fn house() -> Vec<Drawn> {
    vec![
        drawn(LineKind::Silhouette, &[[10.0, 90.0], [10.0, 40.0], [50.0, 10.0], [90.0, 40.0], [90.0, 90.0]]).closed(),
        drawn(LineKind::Ridge, &[[10.0, 40.0], [90.0, 40.0]]),
        drawn(LineKind::Ridge, &[[10.0, 60.0], [90.0, 60.0]]).hidden(2),
        drawn(LineKind::Curve, &[[30.0, 50.0], [40.0, 80.0], [50.0, 50.0]]).closed().bent(),
    ]
}

fn everything() -> PlotOptions {
    PlotOptions { hidden: Hidden::Solid, ..PlotOptions::default() }
}

#[test]
fn usvg_reads_pages_pens_and_layers() {
    let mut options = everything();
    options.pens.of_hidden_mut(LineKind::Ridge).width = Length::mm(0.25);
    options.pens.of_hidden_mut(LineKind::Ridge).colour = "#ff8000".parse().unwrap();
    let text = svg(&plot(&lines_of(orthographic(), &house()), &options, &NoProgress).unwrap());
    assert!(text.contains("width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\""), "{text}");
    let labels: Vec<_> = text.split("inkscape:label=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
    assert_eq!(labels, ["23 ridge hidden", "7 curve visible", "3 ridge visible", "1 silhouette visible"]);

    let tree = parsed(&text);
    assert!((f64::from(tree.size().width()) - 210.0 * 96.0 / 25.4).abs() < 1e-3);
    let paths = paths_in(tree.root());
    assert_eq!(paths.len(), 4);
    let page = tree.size().to_non_zero_rect(0.0, 0.0).to_rect();
    for path in &paths {
        let place = path.abs_bounding_box();
        assert!(place.left() >= page.left() && place.right() <= page.right());
        assert!(place.top() >= page.top() && place.bottom() <= page.bottom());
        assert_eq!(path.stroke().unwrap().linecap(), usvg::LineCap::Round);
    }
    let stroke = paths[0].stroke().unwrap();
    assert!((stroke.width().get() - 0.25).abs() < 1e-6);
    assert!(
        matches!(stroke.paint(), usvg::Paint::Color(colour) if [colour.red, colour.green, colour.blue] == [255, 128, 0])
    );
    let curves =
        paths[1].data().segments().filter(|segment| matches!(segment, usvg::tiny_skia_path::PathSegment::CubicTo(..)));
    assert_eq!(curves.count(), 3, "curves stay curves");
}

#[test]
fn the_page_may_be_the_view() {
    let options = PlotOptions { unit: Unit::Px, sheet: None, ..everything() };
    let drawing = plot(&lines_of(perspective(), &house()), &options, &NoProgress).unwrap();
    let text = svg(&drawing);
    assert!(text.contains("width=\"100px\" height=\"100px\" viewBox=\"0 0 100 100\""), "{text}");
    assert!(text.contains("d=\"M10 40L90 40\""), "pixels are left as they are: {text}");
    let page = drawing.placement.page(DVec2::new(12.5, 7.0));
    assert_eq!(page, DVec2::new(12.5, 7.0));
}

#[test]
fn true_scale_is_true() {
    let sheet = Sheet { fit: Fit::Scale { mm_per_unit: 2.0 }, ..Sheet::default() };
    let options = PlotOptions { sheet: Some(sheet), ..everything() };
    let ruler = [drawn(LineKind::Silhouette, &[[20.0, 50.0], [80.0, 50.0]])];
    // 60 of 100 pixels of a view 50 units high are 30 units: 60 mm.
    let drawing = plot(&lines_of(orthographic(), &ruler), &options, &NoProgress).unwrap();
    assert!((drawing.stats.drawn - 60.0).abs() < 1e-9, "{:?}", drawing.stats);
    assert!(drawing.stats.cut_off.abs() < 1e-9, "{:?}", drawing.stats);
    let path = drawing.layers[0].paths.get(0);
    assert!((path.start().midpoint(path.end()) - DVec2::new(105.0, 148.5)).length() < 1e-9, "in the middle");
    let in_pixels =
        plot(&lines_of(orthographic(), &ruler), &PlotOptions { unit: Unit::Px, ..options.clone() }, &NoProgress);
    assert!((in_pixels.unwrap().stats.drawn - 60.0 * 96.0 / 25.4).abs() < 1e-9);

    let sheet = Sheet { fit: Fit::Scale { mm_per_unit: 20.0 }, ..sheet };
    let large =
        plot(&lines_of(orthographic(), &ruler), &PlotOptions { sheet: Some(sheet), ..options }, &NoProgress).unwrap();
    assert!((large.stats.drawn - 190.0).abs() < 1e-9, "the page has room for 190 mm: {:?}", large.stats);
    assert!((large.stats.cut_off - 410.0).abs() < 1e-9, "{:?}", large.stats);
}

#[test]
fn an_outline_is_one_even_odd_path() {
    let mut found = lines(orthographic());
    let square = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]].map(DVec2::from).to_vec();
    found.outline = Outline::of_regions([vec![square(20.0, 60.0), square(30.0, 50.0)], vec![square(70.0, 130.0)]]);
    let drawing = plot(&found, &PlotOptions { unit: Unit::Px, sheet: None, ..everything() }, &NoProgress).unwrap();
    let tree = parsed(&svg(&drawing));
    let paths = paths_in(tree.root());
    assert_eq!(paths.len(), 1);
    let closed = paths[0].data().segments().filter(|segment| *segment == usvg::tiny_skia_path::PathSegment::Close);
    assert_eq!(closed.count(), 3);
    assert!(svg(&drawing).contains("fill-rule=\"evenodd\""));
    assert!(paths[0].abs_bounding_box().right() <= 100.0, "cut off at the viewport");
}

#[test]
fn a_view_without_lines_has_files_too() {
    let empty = lines(perspective());
    let drawing = plot(&empty, &PlotOptions::default(), &NoProgress).unwrap();
    assert!(drawing.layers.is_empty());
    assert_eq!(paths_in(parsed(&svg(&drawing)).root()).len(), 0);
    for container in [GltfContainer::Text, GltfContainer::Binary] {
        let file = gltf(&empty, &PlotOptions::default(), container);
        assert_eq!((file.document.nodes().len(), file.blob), (0, None));
    }
}

fn gltf(lines: &Lines, options: &PlotOptions, container: GltfContainer) -> gltf::Gltf {
    let mut bytes = Vec::new();
    write_gltf(lines, options, container, &mut bytes).unwrap();
    gltf::Gltf::from_slice(&bytes).unwrap()
}

#[test]
fn gltf_has_a_node_a_layer_and_every_segment() {
    let found = lines_of(orthographic(), &house());
    let text = gltf(&found, &everything(), GltfContainer::Text);
    let binary = gltf(&found, &everything(), GltfContainer::Binary);
    assert!(text.blob.is_none());
    let blob = binary.blob.unwrap();
    let scene = binary.document.default_scene().unwrap();
    assert_eq!(scene.nodes().count(), 4);
    for node in scene.nodes() {
        let primitive = node.mesh().unwrap().primitives().next().unwrap();
        assert_eq!(primitive.mode(), gltf::mesh::Mode::Lines);
        let (_, positions) = primitive.attributes().next().unwrap();
        let indices = primitive.indices().unwrap();
        let view = indices.view().unwrap();
        let bytes = &blob[view.offset()..view.offset() + view.length()];
        let indices: Vec<_> = bytes.chunks(4).map(|index| u32::from_le_bytes(index.try_into().unwrap())).collect();
        assert!(indices.iter().all(|&index| (index as usize) < positions.count()));
        assert_eq!(positions.view().unwrap().length(), 12 * positions.count());
    }
    let counts: Vec<_> = binary.document.accessors().map(|accessor| accessor.count()).collect();
    assert_eq!(counts, [2, 2, 3, 6, 2, 2, 5, 10], "points and ends of segments of each layer");
    let silhouette = binary.document.accessors().nth(6).unwrap();
    assert_eq!(silhouette.min().unwrap(), serde_json::json!([10.0, 10.0, 0.0]));
    assert_eq!(silhouette.max().unwrap(), serde_json::json!([90.0, 90.0, 0.0]));
    assert_eq!(
        gltf(&found, &PlotOptions::default(), GltfContainer::Text).document.nodes().len(),
        3,
        "hidden ones drop"
    );
}

#[test]
fn json_has_what_was_found() {
    let found = lines_of(orthographic(), &house());
    let place = placement(&found, &PlotOptions::default()).unwrap();
    let end_points = |edge: silhouette_core::EdgeId| [VertexId::new(edge.get()), VertexId::new(edge.get() + 1)];
    let mut bytes = Vec::new();
    write_json(&found, &place, &end_points, &mut bytes).unwrap();
    let document: serde_json::Value = serde_json::from_slice(&bytes).unwrap();
    assert_eq!(document["size"], serde_json::json!([100, 100]));
    assert_eq!(document["page"]["unit"], "mm");
    let chains = document["chains"].as_array().unwrap();
    assert_eq!(chains.len(), 4, "hidden ones, too, though nothing draws them");
    assert_eq!(chains[0]["kind"], "silhouette");
    assert_eq!(chains[0]["edges"], serde_json::json!([[0, 1], [1, 2], [2, 3], [3, 4], [4, 5]]));
    assert_eq!((&chains[2]["visible"], &chains[2]["invisibility"]), (&false.into(), &2.into()));
    assert_eq!(chains[2]["points"], serde_json::json!([[10.0, 60.0, 2.0], [90.0, 60.0, 2.0]]));
    assert_eq!(chains[3]["curves"], serde_json::json!([0, 1, 2]));
    assert_eq!(chains[3]["handles"].as_array().unwrap().len(), 3);
    assert_eq!(bytes.iter().filter(|&&byte| byte == b'\n').count(), 1);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Whatever the lines, usvg reads as many paths as were drawn, on the page, and every run writes the same bytes.
    #[test]
    fn every_drawing_is_read_and_is_the_same_on_one_thread(found in any_lines(), dashed in any::<bool>(), landscape in any::<bool>()) {
        let page = if landscape { Page::A4.landscape() } else { Page::A4 };
        let hidden = if dashed { Hidden::Dashed(Dash::HIDDEN) } else { Hidden::Solid };
        let options = PlotOptions { sheet: Some(Sheet { page, ..Sheet::default() }), hidden, ..everything() };
        let drawing = plot(&found, &options, &NoProgress).unwrap();
        let text = svg(&drawing);
        let tree = parsed(&text);
        prop_assert_eq!(paths_in(tree.root()).len() as u64, drawing.stats.paths);
        let [width, height] = page.size(Unit::Mm);
        for path in drawing.layers.iter().flat_map(|layer| layer.paths.iter()) {
            for point in path.points {
                prop_assert!(point.min_element() >= 10.0 - 1e-9 && point.x <= width - 10.0 + 1e-9 && point.y <= height - 10.0 + 1e-9);
            }
        }
        let again = with_threads(1, || plot(&found, &options, &NoProgress).unwrap());
        prop_assert_eq!(svg(&again), text);
        for container in [GltfContainer::Text, GltfContainer::Binary] {
            gltf(&found, &options, container);
        }
    }
}

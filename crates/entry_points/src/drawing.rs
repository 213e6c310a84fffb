//! [`drawing`].

use crate::bytes::{Bytes, Coordinates};
use crate::check_message;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::load::{Format, read};
use silhouette_core::view::Framing;
use silhouette_core::{Camera, NoProgress, Projection, TriangleMesh};
use silhouette_visibility::plot::{
    Cap, Colour, Dash, Drawing, Fit, GltfContainer, Hidden, LayersBy, Length, Page, PlotOptions, Sheet, Unit,
    placement, plot, write_gltf, write_json,
};
use silhouette_visibility::{LineFinder, LineOptions, LineScene, Lines, SectionPlane, SectionedMesh};

/// Most vertices and faces of an input.
const MOST: (usize, usize) = (24, 32);

/// Draws the visible and hidden lines of arbitrary triangles and writes them in every file format.
///
/// Pixels lie in the picture, no number that is written is infinite or none, and what is written as SVG, JSON and glTF can be read.
pub fn drawing(bytes: &[u8]) -> bool {
    let mut bytes = Bytes::new(bytes);
    let (positions, triangles) = bytes.triangles(MOST.0, MOST.1);
    let Ok(mesh) = TriangleMesh::new(positions, triangles) else { return false };
    let sections = bytes.below(3);
    let Some(scene) = scene(mesh, sections, &mut bytes) else { return false };
    let Some(camera) = camera(&scene, &mut bytes) else { return false };
    let options = line_options(&mut bytes);
    let mut finder = if bytes.is_set() {
        LineFinder::for_many_views(scene, &NoProgress).expect("nobody cancels")
    } else {
        LineFinder::new(scene, &NoProgress).expect("nobody cancels")
    };
    let lines = match finder.find(&camera, &options, &NoProgress) {
        Ok(lines) => lines,
        Err(error) => {
            check_message(&error.to_string());
            return false;
        }
    };
    check_pixels(&lines);
    let options = plot_options(&mut bytes);
    match plot(&lines, &options, &NoProgress) {
        Ok(drawing) => write_all(&lines, &options, &drawing, &finder),
        Err(error) => check_message(&error.to_string()),
    }
    true
}

fn scene(mesh: TriangleMesh, sections: usize, bytes: &mut Bytes<'_>) -> Option<LineScene> {
    let faces = mesh.face_count();
    let mut sectioned = SectionedMesh::whole(mesh);
    for _ in 0..sections {
        let made = bytes.coordinates();
        let plane = SectionPlane::new(bytes.vector(made), bytes.vector(Coordinates::Lattice))?;
        sectioned = sectioned.cut(&plane).expect("a few faces are cut into a few more");
    }
    let labels: Vec<u32> = (0..faces).map(|_| bytes.below(3) as u32).collect();
    let labels = sectioned.face_of.iter().map(|face| labels.get(face.index()).copied().unwrap_or(3)).collect();
    let scene = LineScene::new(std::sync::Arc::new(silhouette_core::PreparedMesh::new(sectioned.mesh)));
    let scene = scene.with_section_edges(sectioned.edges).expect("edges of the mesh that was cut");
    Some(scene.with_labels(labels).expect("one label per face"))
}

/// A camera that frames the mesh, or any other.
fn camera(scene: &LineScene, bytes: &mut Bytes<'_>) -> Option<Camera> {
    let size = [0; 2].map(|_| 1 + u32::from(bytes.byte()) * 4);
    let is_perspective = bytes.is_set();
    let fov_y_rad = f64::from(bytes.byte()) / 256.0 * std::f64::consts::PI;
    let camera = if bytes.is_set() {
        let bounds = scene.mesh().mesh().bounds()?;
        let framing = if is_perspective { Framing::Perspective { fov_y_rad } } else { Framing::Orthographic };
        let direction = bytes.vector(Coordinates::Lattice).as_dvec3();
        Camera::framing(&bounds, direction + DVec3::new(0.0, 0.0, 1e-3), Vec3::Y, framing, size)
    } else {
        let made = bytes.coordinates();
        let [eye, target] = [0; 2].map(|_| bytes.vector(made));
        let height = f64::from(bytes.byte()) + 0.01;
        let projection =
            if is_perspective { Projection::Perspective { fov_y_rad } } else { Projection::Orthographic { height } };
        Camera::new(eye, target, bytes.vector(Coordinates::Lattice), projection, size)
    };
    camera.inspect_err(|error| check_message(&error.to_string())).ok()
}

fn line_options(bytes: &mut Bytes<'_>) -> LineOptions {
    let angle = |byte: u8| (byte & 1 == 1).then(|| f64::from(byte) / 255.0 * 180.0);
    LineOptions {
        silhouette: !bytes.is_set(),
        boundary: !bytes.is_set(),
        back_boundary: !bytes.is_set(),
        ridge_deg: angle(bytes.byte()),
        valley_deg: angle(bytes.byte()),
        intersection: bytes.is_set(),
        mesh: bytes.is_set(),
        max_invisibility: [0, 1, u32::MAX][bytes.below(3)],
        outline: bytes.is_set(),
        ..LineOptions::default()
    }
}

fn plot_options(bytes: &mut Bytes<'_>) -> PlotOptions {
    let length = |byte: u8| Length::mm(f64::from(byte) * 0.05);
    let fits = [Fit::Lines, Fit::View, Fit::Scale { mm_per_unit: f64::from(bytes.byte()) + 0.1 }];
    let sheet = Sheet {
        page: Page {
            width: Length::mm(5.0 + f64::from(bytes.byte())),
            height: Length::mm(5.0 + f64::from(bytes.byte())),
        },
        margin: length(bytes.byte()),
        fit: fits[bytes.below(3)],
    };
    let mut options = PlotOptions {
        unit: [Unit::Mm, Unit::Px][bytes.below(2)],
        sheet: (!bytes.is_set()).then_some(sheet),
        hidden: [Hidden::Drop, Hidden::Dashed(Dash::HIDDEN), Hidden::Solid][bytes.below(3)],
        layers: [LayersBy::Kind, LayersBy::Object][bytes.below(2)],
        cap: [Cap::Round, Cap::Butt, Cap::Square][bytes.below(3)],
        merge_tolerance: length(bytes.byte()),
        min_length: length(bytes.byte()),
        bridge: bytes.is_set().then(|| length(bytes.byte())),
        curves: bytes.is_set(),
        dedupe: !bytes.is_set(),
        fill: bytes.is_set().then_some(Colour::BLACK),
        ..PlotOptions::default()
    };
    if bytes.is_set() {
        let dash = Dash { on: Length::mm(0.1 + f64::from(bytes.byte()) * 0.1), off: length(bytes.byte()) };
        options.pens.iter_mut().for_each(|pen| pen.dash = Some(dash));
    }
    options
}

fn check_pixels(lines: &Lines) {
    let [width, height] = lines.camera.size().map(f64::from);
    let margin = 1e-6 * width.max(height);
    for pixel in lines.chains.iter().flat_map(|chain| chain.pixels) {
        let is_inside = (-margin..=width + margin).contains(&pixel.x) && (-margin..=height + margin).contains(&pixel.y);
        assert!(is_inside, "{pixel} in a picture of {width} x {height}");
    }
    assert!(lines.outline.rings.iter().flatten().all(|point| point.is_finite()), "the outline goes nowhere");
}

/// What a writer writes.
fn written(write: impl FnOnce(&mut dyn std::io::Write) -> std::io::Result<()>) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(&mut bytes).expect("memory takes all that is written");
    bytes
}

fn write_all(lines: &Lines, options: &PlotOptions, drawing: &Drawing, finder: &LineFinder) {
    let svg = text("SVG", written(|out| drawing.write_svg("fuzzed", out)));
    roxmltree::Document::parse(&svg).unwrap_or_else(|error| panic!("no XML, {error}: {svg}"));
    text("DXF", written(|out| drawing.write_dxf(out)));
    text("HPGL", written(|out| drawing.write_hpgl(out)));
    let pdf = written(|out| drawing.write_pdf("fuzzed", out));
    assert!(pdf.starts_with(b"%PDF-") && pdf.trim_ascii_end().ends_with(b"%%EOF"), "no PDF");
    let topology = silhouette_core::Topology::new(finder.scene().mesh().mesh());
    let placed = placement(lines, options).expect("the same options were just honoured");
    let end_points = |edge| topology.end_points(edge);
    let json = text("JSON", written(|out| write_json(lines, &placed, &end_points, out)));
    serde_json::from_str::<serde_json::Value>(&json).unwrap_or_else(|error| panic!("no JSON, {error}: {json}"));
    for container in [GltfContainer::Binary, GltfContainer::Text] {
        let gltf = written(|out| write_gltf(lines, options, container, out));
        // A drawing has no faces, which is what a reader of meshes is to say of it and nothing else.
        let error = read(Format::Gltf, "drawing", &gltf, &NoProgress).expect_err("a drawing has no faces");
        assert!(error.to_string().contains("no face"), "{error}");
    }
}

/// A text without numbers that are none.
fn text(format: &str, bytes: Vec<u8>) -> String {
    let text = String::from_utf8(bytes).unwrap_or_else(|_| panic!("{format}: no UTF-8"));
    assert!(!["NaN", "inf"].iter().any(|word| text.contains(word)), "{format}: {text}");
    text
}

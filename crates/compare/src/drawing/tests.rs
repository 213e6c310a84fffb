//! Frames of every method.

use super::*;
use crate::metrics::Ink;
use crate::registry::Registry;
use silhouette_core::shapes;
use silhouette_core::view::{Framing, ViewPreset};
use silhouette_gpu::{Color, Cull, FillPipelines, FillRenderer, FillStyle, Shade};
use silhouette_testing::gpu_or_skip;
use silhouette_testing::prepare::cheap_options;

fn cube_and_camera() -> (Arc<PreparedMesh>, Camera) {
    let mesh = Arc::new(PreparedMesh::new(shapes::by_name("cube").unwrap()));
    let (direction, up) = ViewPreset::default().directions();
    let framing = Framing::Perspective { fov_y_rad: 0.8 };
    let bounds = mesh.mesh().bounds().unwrap();
    (mesh, Camera::framing(&bounds, direction, up, framing, [128, 96]).unwrap())
}

fn style(samples: u32, ground: Ground) -> FrameStyle {
    FrameStyle { size: [128, 96], pen_width_px: 2.0, samples, ground }
}

#[test]
fn a_mesh_without_faces_is_refused_as_such() {
    let Some(gpu) = gpu_or_skip("a_mesh_without_faces_is_refused_as_such") else { return };
    let (_, camera) = cube_and_camera();
    let empty = Arc::new(PreparedMesh::new(silhouette_core::TriangleMesh::new(vec![], vec![]).unwrap()));
    let registry = Registry::builtin();
    let entry = registry.find("brute-force").unwrap();
    let options = OptionValues::defaults(entry.info().options);
    let drawn = render_method(gpu, entry, &options, &empty, &camera, style(1, Ground::Paper), &NoProgress);
    assert!(matches!(drawn, Err(DrawError::NoFaces)));
}

#[test]
fn every_method_draws_lines_with_and_without_antialiasing() {
    let Some(gpu) = gpu_or_skip("every_method_draws_lines_with_and_without_antialiasing") else { return };
    let (mesh, camera) = cube_and_camera();
    for entry in Registry::builtin().entries() {
        let can = entry.capabilities();
        if !(can.lines || can.edges) {
            continue;
        }
        let options = cheap_options(entry.info().options);
        let [sharp, smooth] = [1, 4].map(|samples| {
            let style = style(samples, Ground::Paper);
            render_method(gpu, entry, &options, &mesh, &camera, style, &NoProgress).unwrap().image
        });
        let name = entry.info().name;
        let is_grey = |image: &Image| image.rgba.chunks(4).any(|pixel| !matches!(pixel[0], 0 | 255));
        assert!(!is_grey(&sharp) && is_grey(&smooth), "{name}");
        let inked = |image: &Image| {
            let ink = Ink::from_picture(image);
            let pixels = (0..i64::from(image.height)).flat_map(|y| (0..i64::from(image.width)).map(move |x| (x, y)));
            pixels.map(|(x, y)| f64::from(ink.coverage(x, y))).sum::<f64>()
        };
        let area = [inked(&sharp), inked(&smooth)];
        assert!(area[0] > 50.0 && (area[0] / area[1] - 1.0).abs() < 0.25, "{name}: {area:?}");
    }
}

#[test]
fn on_a_transparent_ground_only_lines_are_opaque() {
    let Some(gpu) = gpu_or_skip("on_a_transparent_ground_only_lines_are_opaque") else { return };
    let (mesh, camera) = cube_and_camera();
    let registry = Registry::builtin();
    for (name, words) in [("brute-force", &[][..]), ("image-precision", &["interior=depth-only"])] {
        let entry = registry.find(name).unwrap();
        let options = OptionValues::parse(entry.info().options, words.iter().copied()).unwrap();
        let style = style(1, Ground::Transparent);
        let image = render_method(gpu, entry, &options, &mesh, &camera, style, &NoProgress).unwrap().image;
        let [ink, ground] =
            [[0, 0, 0, 255], [0; 4]].map(|wanted| image.rgba.chunks(4).filter(|p| *p == wanted).count());
        assert!(ink > 100 && ink + ground == 128 * 96, "{name}: {ink} {ground}");
        let middle = &image.rgba[4 * (48 * 128 + 64)..][..4];
        assert_eq!(middle, [0; 4], "{name}: the interior");
    }
}

#[test]
fn a_fill_covers_the_mesh_and_a_method_of_lines_fills_nothing() {
    let Some(gpu) = gpu_or_skip("a_fill_covers_the_mesh_and_a_method_of_lines_fills_nothing") else { return };
    let (mesh, camera) = cube_and_camera();
    let registry = Registry::builtin();
    let drawn = |name: &str| {
        let entry = registry.find(name).unwrap();
        let prepared = entry.prepare(&mesh, &OptionValues::defaults(entry.info().options), &NoProgress).unwrap();
        let mut drawing = Drawing::new(gpu, &mesh, prepared, PictureKind::Fill, style(1, Ground::Transparent))?;
        drawing.draw(gpu, &camera)?;
        drawing.picture(gpu)
    };
    let image = drawn("fine-mesh").unwrap();
    let covered = image.rgba.chunks(4).filter(|pixel| pixel[3] == 255).count();
    assert!(covered > 1000 && covered < 128 * 96 / 2, "{covered}");
    assert!(matches!(drawn("brute-force"), Err(DrawError::Kind(PictureKind::Fill))));
}

#[test]
fn what_surrounds_a_method_is_drawn_below_and_above_it() {
    let Some(gpu) = gpu_or_skip("what_surrounds_a_method_is_drawn_below_and_above_it") else { return };
    let (mesh, camera) = cube_and_camera();
    let registry = Registry::builtin();
    let entry = registry.find("brute-force").unwrap();
    let prepared = entry.prepare(&mesh, &OptionValues::defaults(entry.info().options), &NoProgress).unwrap();
    let mut drawing = Drawing::new(gpu, &mesh, prepared, PictureKind::Lines, style(1, Ground::Paper)).unwrap();
    let mut ink_and_blue = |below: bool, above: bool| {
        let style = FillStyle { shade: Shade::Flat(Color { srgb: [0.0, 0.0, 1.0], alpha: 1.0 }), cull: Cull::None };
        let pipelines = Arc::new(FillPipelines::new(gpu.device(), drawing.target().formats(), style));
        let fill = |is_there: bool| -> Vec<Box<dyn FrameRenderer>> {
            let fill = FillRenderer::new(gpu.device(), &pipelines, drawing.mesh());
            if is_there { vec![Box::new(fill)] } else { Vec::new() }
        };
        let (below, above) = (fill(below), fill(above));
        drawing.surround(below, above);
        drawing.draw(gpu, &camera).unwrap();
        let picture = drawing.picture(gpu).unwrap();
        [[0, 0, 0, 255], [0, 0, 255, 255]].map(|wanted| picture.rgba.chunks(4).filter(|p| *p == wanted).count())
    };
    let [alone, below, above] = [(false, false), (true, false), (false, true)].map(|(b, a)| ink_and_blue(b, a));
    assert!(alone[0] > 100 && alone[1] == 0, "{alone:?}");
    assert!(below[0] == alone[0] && below[1] > 1000, "lines lie on what is below them: {below:?}");
    assert!(above[0] < alone[0] * 3 / 4 && above[1] > below[1], "and under what is above them: {above:?}");
}

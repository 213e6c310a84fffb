//! The gallery's pictures: one model from one camera by every method, at its default options.
//!
//! A method that yields curves alone has a line drawing, made by [`LineScene`]; all others draw themselves.

use silhouette_compare::drawing::{FrameStyle, Ground, render_method};
use silhouette_compare::registry::{Entry, Registry};
use silhouette_core::curves::{CurveSource, SilhouetteCurves, SmoothPiece};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::method::OptionValues;
use silhouette_core::view::{Camera, Framing};
use silhouette_core::{NoProgress, PreparedMesh, shapes};
use silhouette_render::{AdapterChoice, Gpu};
use silhouette_visibility::plot::{Hidden, Length, PlotOptions, Unit, plot};
use silhouette_visibility::{CurvePiece, LineFinder, LineKind, LineOptions, LineScene};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Why a picture could not be made: no adapter, or what a method, a line drawing or a file says.
pub type PictureError = Box<dyn Error + Send + Sync>;

/// The model: coarse enough that smoothing shows, and it hides itself.
pub const MODEL: &str = "knot:2,3,48,10";

/// The direction from the model to the camera: from above, where it is large and hides itself.
const FROM: DVec3 = DVec3::new(0.3, 0.9, 0.6);

/// Pixels of a picture.
const SIZE: [u32; 2] = [320, 240];
const PEN_PX: f64 = 2.0;

/// The folder of the pictures below the project's root.
pub const FOLDER: &str = "docs/images/methods";

/// The name of a method's picture.
pub fn file(entry: &Entry) -> String {
    let can = entry.capabilities();
    let draws = can.edges || can.lines || can.fill;
    format!("{}.{}", entry.info().name, if draws { "png" } else { "svg" })
}

/// Draws every method into [`FOLDER`] below `root` and yields the files. Seconds to minutes: silhouette textures are baked.
///
/// # Errors
/// [`PictureError`]; pictures that were made before stay.
pub fn write(root: &Path) -> Result<Vec<PathBuf>, PictureError> {
    let gpu = Gpu::new(AdapterChoice::from_env()?)?;
    let mesh = Arc::new(PreparedMesh::new(shapes::by_name(MODEL)?));
    let bounds = mesh.mesh().bounds().ok_or("the model has no faces")?;
    let camera = Camera::framing(&bounds, FROM, Vec3::Y, Framing::Perspective { fov_y_rad: 0.6 }, SIZE)?;
    let folder = root.join(FOLDER);
    std::fs::create_dir_all(&folder)?;
    let mut files = Vec::new();
    for entry in Registry::builtin().entries() {
        let path = folder.join(file(entry));
        if path.extension().is_some_and(|extension| extension == "svg") {
            draw_curves(entry, &mesh, &camera, &path)?;
        } else {
            let options = OptionValues::defaults(entry.info().options);
            let style = FrameStyle { size: SIZE, pen_width_px: PEN_PX, samples: 4, ground: Ground::Paper };
            let drawn = render_method(&gpu, entry, &options, &mesh, &camera, style, &NoProgress)?;
            std::fs::write(&path, drawn.image.to_png()?)?;
        }
        files.push(path);
    }
    Ok(files)
}

/// The curves that a method yields, as SVG, hidden ones as well: they lie on the faces of the mesh, half of them on faces that face
/// away, which the mesh itself hides.
fn draw_curves(entry: &Entry, mesh: &Arc<PreparedMesh>, camera: &Camera, path: &Path) -> Result<(), PictureError> {
    let options = OptionValues::defaults(entry.info().options);
    let mut prepared = entry.prepare(mesh, &options, &NoProgress)?;
    let mut curves = SilhouetteCurves::default();
    let method = prepared.curves().ok_or("the method yields nothing that can be drawn")?;
    method.extract_curves(&camera.viewpoint(), &mut curves);
    let piece = |piece: &SmoothPiece| CurvePiece {
        control: piece.control,
        on_faces: match piece.source {
            CurveSource::Face(face) => vec![face],
            CurveSource::Edge(_) => Vec::new(),
        },
        kind: LineKind::Curve,
        object: 0,
    };
    let scene = LineScene::of_meshes(&[mesh.mesh()])?.with_curves(curves.pieces().iter().map(piece).collect())?;
    let curves_alone = LineOptions {
        max_invisibility: u32::MAX,
        silhouette: false,
        boundary: false,
        ridge_deg: None,
        valley_deg: None,
        ..LineOptions::default()
    };
    let lines = LineFinder::new(scene, &NoProgress)?.find(camera, &curves_alone, &NoProgress)?;
    let mut options =
        PlotOptions { unit: Unit::Px, sheet: None, outline: false, hidden: Hidden::Solid, ..PlotOptions::default() };
    options.pens.iter_mut().for_each(|pen| pen.width = Length::px(PEN_PX));
    let mut svg = Vec::new();
    plot(&lines, &options, &NoProgress)?.write_svg(entry.info().name, &mut svg)?;
    // White paper, as the other pictures have: pages may be dark.
    let svg = String::from_utf8(svg)?;
    let head = svg.find("<svg").and_then(|svg_at| Some(svg_at + svg[svg_at..].find('>')? + 1)).ok_or("it is no SVG")?;
    let (head, rest) = svg.split_at(head);
    std::fs::write(path, format!("{head}\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>{rest}"))?;
    Ok(())
}

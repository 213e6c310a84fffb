//! Figs. 22 and 24: pictures of a knot and a bear, or of what stands for them, with what the figures leave to the eye as numbers.

use super::subjects::Subject;
use super::window::{Kind, Window, zoomed};
use crate::error::Cause;
use crate::picture::Picture;
use silhouette_compare::drawing::{DrawError, Drawing, FrameStyle, Ground};
use silhouette_compare::metrics::{FillMetrics, FilledPicture, PictureKind, measure_fill};
use silhouette_compare::registry::Entry;
use silhouette_compare::runner::DEFAULT_PEN_WIDTH_PX;
use silhouette_compare::truth::fill::FillTruth;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::method::OptionValues;
use silhouette_core::view::{Camera, ViewPreset};
use silhouette_core::{Method, MethodOptions, Progress};
use silhouette_gpu::FillsImage;
use silhouette_render::Gpu;
use silhouette_smoothing::{BoundaryCurve, MakesTriangles, PnTriangles, Remesher, Smoothing, SmoothingView, ViewMesh};

/// How much Fig. 24 magnifies; the paper does not say.
pub const ZOOM: f64 = 8.0;

/// One picture with its figures.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawn {
    /// What was drawn.
    pub label: String,
    /// Triangles.
    pub triangles: usize,
    /// The outline against that of the fine mesh.
    pub against_fine: FillMetrics,
    /// The outline against that of the same method with many more triangles: how polygonal it is.
    pub against_limit: Option<FillMetrics>,
}

/// A figure of the paper.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PaperFigure {
    /// Its pictures with their figures, in order.
    pub drawn: Vec<Drawn>,
    /// The pictures as files.
    pub pictures: Vec<Picture>,
}

/// What makes the triangles of a picture: its words for people, and options.
struct Variant {
    label: String,
    file: &'static str,
    make: Make,
    words: String,
    /// The options of the same method with many more triangles.
    limit: Option<String>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Make {
    Pn,
    BoundaryCurve,
    Smoothing,
}

impl Make {
    fn remesher(self, subject: &Subject, words: &str) -> Result<Box<dyn Remesher>, Cause> {
        fn method<M: Method>(subject: &Subject, words: &str) -> Result<M, Cause> {
            Ok(M::new(&subject.mesh, M::Options::parse(words.split_whitespace())?)?)
        }
        Ok(match self {
            Self::Pn => Box::new(method::<PnTriangles>(subject, words)?.remesher()),
            Self::BoundaryCurve => Box::new(method::<BoundaryCurve>(subject, words)?.remesher()),
            Self::Smoothing => Box::new(method::<Smoothing>(subject, words)?.drawn()),
        })
    }

    fn drawing(self, gpu: &Gpu, subject: &Subject, words: &str, progress: &dyn Progress) -> Result<Drawing, Cause> {
        fn entry<M: FillsImage + 'static>() -> Entry {
            Entry::of::<M>().fill().into()
        }
        let entry = match self {
            Self::Pn => entry::<PnTriangles>(),
            Self::BoundaryCurve => entry::<BoundaryCurve>(),
            Self::Smoothing => entry::<Smoothing>(),
        };
        let options = OptionValues::parse(entry.info().options, words.split_whitespace())?;
        let size = super::printed::WINDOW_PX;
        let style = FrameStyle { size, pen_width_px: DEFAULT_PEN_WIDTH_PX, samples: 4, ground: Ground::Paper };
        let prepared = entry.prepare(&subject.mesh, &options, progress)?;
        Ok(Drawing::new(gpu, &subject.mesh, prepared, PictureKind::Fill, style)?)
    }
}

/// Fig. 22: the mesh as it is, boundary curves, smoothing without perturbation and with it.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn fig_22(gpu: &Gpu, subject: &Subject, window: &Window, progress: &dyn Progress) -> Result<PaperFigure, Cause> {
    let camera = window.camera(ViewPreset::default().directions().0, Kind::Perspective)?;
    let crease = format!("crease={}", subject.crease_deg);
    let variant = |label: &str, file, make, words: &str| {
        let words = format!("{words} {crease}");
        Variant { label: label.to_owned(), file, make, words, limit: None }
    };
    let variants = [
        variant("as it is", "fig-22-raw.png", Make::Pn, "level=0"),
        variant("boundary curve", "fig-22-boundary-curve.png", Make::BoundaryCurve, ""),
        variant("not perturbed", "fig-22-not-perturbed.png", Make::Smoothing, "perturbation=off"),
        variant("smoothing", "fig-22-smoothing.png", Make::Smoothing, ""),
    ];
    let mut figure = PaperFigure::default();
    add(gpu, subject, &camera, &variants, progress, &mut figure)?;
    Ok(figure)
}

/// Fig. 24: PN triangles and smoothing, whole and magnified about the rightmost point of the silhouette.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn fig_24(gpu: &Gpu, subject: &Subject, window: &Window, progress: &dyn Progress) -> Result<PaperFigure, Cause> {
    let camera = window.camera(ViewPreset::default().directions().0, Kind::Perspective)?;
    let target = rightmost(subject, &camera)?;
    let close = zoomed(&camera, target, ZOOM)?;
    let crease = format!("crease={}", subject.crease_deg);
    let pn = |level: u32| format!("level={level} {crease}");
    let mut figure = PaperFigure::default();
    for (camera, suffix, files) in [
        (camera, String::new(), ["fig-24-raw.png", "fig-24-pn.png", "fig-24-smoothing.png"]),
        (close, format!(", {ZOOM} x"), ["fig-24-raw-close.png", "fig-24-pn-close.png", "fig-24-smoothing-close.png"]),
    ] {
        let variant = |label: &str, file, make, words, limit| Variant {
            label: format!("{label}{suffix}"),
            file,
            make,
            words,
            limit,
        };
        let smooth = [&crease, &format!("tolerance=0.01 {crease}")].map(String::clone);
        let [words, limit] = smooth;
        let variants = [
            variant("as it is", files[0], Make::Pn, pn(0), None),
            variant("PN level 3", files[1], Make::Pn, pn(3), Some(pn(15))),
            variant("smoothing", files[2], Make::Smoothing, words, Some(limit)),
        ];
        add(gpu, subject, &camera, &variants, progress, &mut figure)?;
    }
    Ok(figure)
}

/// The silhouette point that appears farthest to the right.
fn rightmost(subject: &Subject, camera: &Camera) -> Result<Vec3, Cause> {
    let mut smoothing = Smoothing::new(&subject.mesh, subject.options())?;
    let view = SmoothingView::from_camera(camera);
    smoothing.find_silhouette(view.eye());
    let points = smoothing.silhouette().points().iter().map(|point| point.position);
    let rightmost = points.max_by(|a, b| view.pixel(*a).0.x.total_cmp(&view.pixel(*b).0.x));
    Ok(rightmost.map_or(camera.target(), DVec3::as_vec3))
}

fn add(
    gpu: &Gpu,
    subject: &Subject,
    camera: &Camera,
    variants: &[Variant],
    progress: &dyn Progress,
    figure: &mut PaperFigure,
) -> Result<(), Cause> {
    let fine = subject.fine.as_ref().unwrap_or(subject.mesh.mesh());
    let truth = FillTruth::new(gpu, fine)?.find(gpu, camera)?;
    for Variant { label, file, make, words, limit } in variants {
        progress.check()?;
        let (drawn, triangles) = outline(gpu, camera, make.remesher(subject, words)?)?;
        let against_limit = limit.as_ref().map(|limit| -> Result<FillMetrics, Cause> {
            Ok(measure_fill(&drawn, &outline(gpu, camera, make.remesher(subject, limit)?)?.0))
        });
        let against_limit = against_limit.transpose()?;
        figure.drawn.push(Drawn {
            label: label.clone(),
            triangles,
            against_fine: measure_fill(&drawn, &truth),
            against_limit,
        });
        let mut drawing = make.drawing(gpu, subject, words, progress)?;
        drawing.draw(gpu, camera)?;
        let title = format!("{}: {label}, {triangles} triangles", subject.label);
        figure.pictures.push(Picture { file_name: file, title, image: drawing.picture(gpu)? });
    }
    Ok(())
}

/// The triangles of a view at 16 samples per pixel, and how many they are.
fn outline(gpu: &Gpu, camera: &Camera, mut remesher: Box<dyn Remesher>) -> Result<(FilledPicture, usize), Cause> {
    let mut made = ViewMesh::default();
    remesher.remesh(&SmoothingView::from_camera(camera), &mut made);
    let mesh = made.to_mesh().map_err(|_| DrawError::NoFaces)?;
    Ok((FillTruth::new(gpu, &mesh)?.find(gpu, camera)?, made.triangles.len()))
}

#[cfg(test)]
mod tests {
    use super::super::subjects::subjects;
    use super::*;
    use silhouette_compare::NamedMesh;
    use silhouette_core::{NoProgress, PreparedMesh, shapes};
    use silhouette_testing::gpu_or_skip;

    #[test]
    fn magnified_pn_triangles_are_polygons_and_smoothing_is_not() {
        let Some(gpu) = gpu_or_skip("magnified_pn_triangles_are_polygons_and_smoothing_is_not") else { return };
        let mesh = std::sync::Arc::new(PreparedMesh::new(shapes::by_name("blob:500").unwrap()));
        let named = NamedMesh { name: "builtin:blob:500".to_owned(), mesh };
        let subject = &subjects(&[named]).unwrap().0[0];
        let window = Window::new(gpu, &subject.mesh).unwrap();
        let figure = fig_24(gpu, subject, &window, &NoProgress).unwrap();
        let [raw, _, smooth, raw_close, pn_close, smooth_close] = &figure.drawn[..] else { panic!("six pictures") };
        let off = |drawn: &Drawn| drawn.against_fine.boundary_chamfer_px;
        assert!(off(smooth) < 0.75 * off(raw), "{smooth:?}, {raw:?}");
        assert!(off(raw_close) > 4.0 * off(raw), "{raw_close:?}, {raw:?}");
        let polygonal = |drawn: &Drawn| drawn.against_limit.unwrap().boundary_hausdorff_95_px;
        assert!(polygonal(pn_close) > 2.0 && polygonal(smooth_close) < 1.2, "{pn_close:?}, {smooth_close:?}");
        assert!(figure.pictures.iter().all(|picture| picture.image.width == 1280));
    }
}

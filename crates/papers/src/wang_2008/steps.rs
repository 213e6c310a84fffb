//! What each step of smoothing takes on the CPU, without drawing.

use super::growth::VIEWS;
use super::subjects::Subject;
use super::timed::on_path;
use super::window::{Kind, Window};
use crate::error::Cause;
use silhouette_core::{Method, Progress};
use silhouette_smoothing::silhouette_triangles::silhouette_triangles;
use silhouette_smoothing::vertex_visibility::VertexVisibility;
use silhouette_smoothing::{Smoothing, SmoothingView, ViewMesh};
use std::hint::black_box;
use std::time::Instant;

/// How often the path is flown; the least time of each view counts.
const ROUNDS: u32 = 5;

/// Mean microseconds per view, along a path of [`VIEWS`] views a degree apart.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Steps {
    /// Visibility of vertices, and the silhouette triangles.
    pub extraction_us: f64,
    /// Silhouette points and segments.
    pub curves_us: f64,
    /// How finely the curves are sampled.
    pub sampling_us: f64,
    /// Local re-meshing, the samples themselves included.
    pub remeshing_us: f64,
    /// Perturbation.
    pub perturbation_us: f64,
    /// Silhouette triangles.
    pub silhouette_triangles: f64,
}

impl Steps {
    /// All steps together, in microseconds.
    pub fn total_us(&self) -> f64 {
        self.extraction_us + self.curves_us + self.sampling_us + self.remeshing_us + self.perturbation_us
    }

    /// Nanoseconds per silhouette triangle.
    pub fn ns_per_silhouette_triangle(&self) -> f64 {
        1e3 * self.total_us() / self.silhouette_triangles
    }
}

/// Times the steps in perspective, with the default options. Extraction is timed alone as well, so that what
/// [`Smoothing::find_silhouette`] does beyond it is known.
///
/// # Errors
/// [`Cause`]: cancelled.
pub fn measure(subject: &Subject, window: &Window, progress: &dyn Progress) -> Result<Steps, Cause> {
    let options = subject.options();
    let mut smoothing = Smoothing::new(&subject.mesh, options)?;
    let mut visibility = VertexVisibility::new(smoothing.shading_mesh(), options.cells);
    // As drawn: of closed meshes, parts that are seen from behind are left out.
    let is_closed = smoothing.shading_mesh().is_closed();
    let (mut triangles, mut out) = (Vec::new(), ViewMesh::default());
    let views: Vec<SmoothingView> = (0..VIEWS)
        .map(|frame| Ok(SmoothingView::from_camera(&window.camera(on_path(frame), Kind::Perspective)?)))
        .collect::<Result<_, Cause>>()?;
    let mut least = vec![[f64::INFINITY; 5]; views.len()];
    let mut silhouette = 0;
    for round in 0..=ROUNDS {
        progress.check()?;
        for (view, least) in views.iter().zip(&mut least) {
            let view = black_box(view);
            let mut times = [0.0; 5];
            times[0] = timed_us(|| {
                visibility.classify(smoothing.shading_mesh(), view.eye());
                let corners = smoothing.shading_mesh().triangles();
                silhouette_triangles(corners, visibility.is_visible(), &mut triangles);
            });
            times[1] = timed_us(|| {
                black_box(smoothing.find_silhouette(view.eye()));
            });
            times[2] = timed_us(|| smoothing.sample(view));
            times[4] = timed_us(|| {
                black_box(smoothing.perturb(view.eye()));
            });
            times[3] = timed_us(|| smoothing.local_remeshing(is_closed.then(|| view.eye()), &mut out));
            if round == 0 {
                silhouette += triangles.len();
            } else {
                least.iter_mut().zip(times).for_each(|(least, time)| *least = least.min(time));
            }
        }
    }
    let count = views.len() as f64;
    let [extraction_us, found_us, sampling_us, remeshing_us, perturbation_us] =
        [0, 1, 2, 3, 4].map(|step| least.iter().map(|times| times[step]).sum::<f64>() / count);
    Ok(Steps {
        extraction_us,
        curves_us: (found_us - extraction_us).max(0.0),
        sampling_us,
        remeshing_us,
        perturbation_us,
        silhouette_triangles: silhouette as f64 / count,
    })
}

fn timed_us(step: impl FnOnce()) -> f64 {
    let start = Instant::now();
    step();
    start.elapsed().as_secs_f64() * 1e6
}

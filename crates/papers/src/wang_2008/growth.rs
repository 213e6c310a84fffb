//! How many triangles smoothing draws, over views and tolerances; the paper names neither.

use super::subjects::Subject;
use super::window::{KINDS, Kind, Window};
use crate::directions::spread;
use crate::error::Cause;
use crate::table::Range;
use silhouette_core::{Method, Progress};
use silhouette_smoothing::{Remesher, Smoothing, SmoothingOptions, SmoothingView, ViewMesh};

/// Views that ranges are over, spread evenly.
pub const VIEWS: u32 = 50;

/// What the ranges are over, in words.
pub const OVER_VIEWS: &str = "fifty views spread evenly";

/// Tolerances in pixels; the one in the middle is the default.
pub const TOLERANCES_PX: [f64; 3] = [0.5, 1.0, 2.0];

/// Triangles drawn at one tolerance in one projection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growth {
    /// Tolerance in pixels.
    pub tolerance_px: f64,
    /// The projection.
    pub kind: Kind,
    /// Triangles.
    pub triangles: Range,
}

/// Re-meshes for all views at each tolerance, in each projection. O(views x faces).
///
/// # Errors
/// [`Cause`]: cancelled.
pub fn measure(subject: &Subject, window: &Window, progress: &dyn Progress) -> Result<Vec<Growth>, Cause> {
    let mut all = Vec::new();
    for tolerance_px in TOLERANCES_PX {
        let options = SmoothingOptions { tolerance_px, ..subject.options() };
        let mut smoothing = Smoothing::new(&subject.mesh, options)?.drawn();
        let mut out = ViewMesh::default();
        for kind in KINDS {
            progress.check()?;
            let mut counts = Vec::new();
            for direction in spread(VIEWS) {
                smoothing.remesh(&SmoothingView::from_camera(&window.camera(direction, kind)?), &mut out);
                counts.push(out.triangles.len() as f64);
            }
            let triangles = Range::of(counts, OVER_VIEWS);
            all.extend(triangles.map(|triangles| Growth { tolerance_px, kind, triangles }));
        }
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::super::subjects::subjects;
    use super::*;
    use silhouette_compare::NamedMesh;
    use silhouette_core::{NoProgress, PreparedMesh, shapes};
    use silhouette_testing::gpu_or_skip;

    #[test]
    fn finer_tolerances_draw_more_triangles_of_no_other_faces() {
        let Some(gpu) = gpu_or_skip("finer_tolerances_draw_more_triangles_of_no_other_faces") else { return };
        let mesh = std::sync::Arc::new(PreparedMesh::new(shapes::by_name("blob:500").unwrap()));
        let named = NamedMesh { name: "builtin:blob:500".to_owned(), mesh };
        let subject = &subjects(&[named]).unwrap().0[0];
        let window = Window::new(gpu, &subject.mesh).unwrap();
        let all = measure(subject, &window, &NoProgress).unwrap();
        for kind in KINDS {
            let medians: Vec<f64> = all.iter().filter(|g| g.kind == kind).map(|g| g.triangles.median).collect();
            assert!(medians.len() == 3 && medians.is_sorted_by(|fine, coarse| fine > coarse), "{medians:?}");
            assert!(medians[2] > 500.0 && medians[0] < 2000.0, "{medians:?}");
        }
    }
}

//! Table I of each mesh: frames, triangles, steps.

use super::growth::{self, Growth};
use super::steps::{self, Steps};
use super::subjects::Subject;
use super::timed::{FrameTimes, time};
use super::window::Window;
use crate::error::Cause;
use silhouette_compare::Profile;
use silhouette_core::Progress;
use silhouette_render::Gpu;

/// What was measured on one mesh.
#[derive(Debug, Clone)]
pub struct MeshResult {
    /// The mesh.
    pub subject: Subject,
    /// How it is seen.
    pub window: Window,
    /// Frame times.
    pub times: FrameTimes,
    /// Triangles drawn, by tolerance and projection.
    pub growth: Vec<Growth>,
    /// Time of each step.
    pub steps: Steps,
}

/// Rounds of timing.
fn rounds(profile: Profile) -> u32 {
    match profile {
        Profile::Quick => 5,
        Profile::Full => 15,
    }
}

/// Measures one mesh.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed or cannot hold the mesh.
pub fn measure(gpu: &Gpu, profile: Profile, subject: Subject, progress: &dyn Progress) -> Result<MeshResult, Cause> {
    let rounds = rounds(profile);
    progress.stage(&subject.label, u64::from(rounds) + 1);
    let window = Window::new(gpu, &subject.mesh)?;
    let growth = growth::measure(&subject, &window, progress)?;
    let steps = steps::measure(&subject, &window, progress)?;
    progress.advance(1);
    let times = time(gpu, &window, &subject, rounds, progress)?;
    Ok(MeshResult { subject, window, times, growth, steps })
}

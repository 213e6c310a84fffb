//! Step 2: every value of a scene within its range, and the whole small enough to be run.

use super::error::SceneFault;
use super::model::{MeshSpec, ProjectionKind, Scene};
use crate::coherence::Motion;
use std::fmt::Display;
use std::ops::RangeInclusive;

/// Width and height of pictures, in pixels.
pub const SIDES: RangeInclusive<u32> = 16..=4096;

/// Most pixels of all scored frames of a cell together: their pictures, truths and pens are kept at the same time, some 24
/// bytes per pixel.
pub const MAX_SCORED_PIXELS: u64 = 1 << 26;

/// Most frames that are timed.
pub const MAX_FRAMES: u32 = 100_000;

/// Most passes over the timed path.
pub const MAX_PASSES: u32 = 1000;

/// Most frames that are drawn before.
pub const MAX_WARM_UP: u32 = 10_000;

/// Frames along which coherence is measured: enough that a line can come and go within three, and so few that a dolly stays
/// before the mesh.
pub const COHERENCE_FRAMES: RangeInclusive<u32> = 6..=60;

/// Elevations stay this far from straight up and down, in degrees: there is no up in the picture there.
const HIGHEST_ELEVATION_DEG: f64 = 89.0;

impl Scene {
    /// Checks all values; methods and options are checked by [`choices`](super::cells::choices).
    ///
    /// # Errors
    /// [`SceneFault::Value`] names the key and what fits.
    pub fn check(&self) -> Result<(), SceneFault> {
        let (path, picture) = (&self.path, &self.picture);
        for faces in self.meshes.iter().filter_map(MeshSpec::simplify) {
            require(faces > 0, "meshes.simplify", faces, "1 or more faces")?;
        }
        within("picture.width", picture.width, SIDES)?;
        within("picture.height", picture.height, SIDES)?;
        let samples = [1, 4];
        require(samples.contains(&picture.samples), "picture.samples", picture.samples, "1 or 4")?;
        within("pen.width-px", self.pen.width_px, 0.1..=64.0)?;

        match (path.projection, path.fov_deg) {
            (ProjectionKind::Perspective, Some(fov_deg)) => within("path.fov-deg", fov_deg, 1.0..=170.0)?,
            (ProjectionKind::Perspective, None) => {
                require(false, "path.projection", "perspective", "give path.fov-deg as well")?;
            }
            (ProjectionKind::Orthographic, Some(fov_deg)) => {
                require(false, "path.fov-deg", fov_deg, "an orthographic view has none; leave it out")?;
            }
            (ProjectionKind::Orthographic, None) => {}
        }
        within("path.first-azimuth-deg", path.first_azimuth_deg, -360.0..=360.0)?;
        within("path.elevation-deg", path.elevation_deg, -HIGHEST_ELEVATION_DEG..=HIGHEST_ELEVATION_DEG)?;
        let room = HIGHEST_ELEVATION_DEG - path.elevation_deg.abs();
        within("path.swing-deg", path.swing_deg, -room..=room)?;
        within("path.step-deg", path.step_deg, -180.0..=180.0)?;

        if let Some(coherence) = &self.coherence {
            let motions = &coherence.motions;
            let is_once = |motion: &Motion| motions.iter().filter(|other| *other == motion).count() == 1;
            let names: Vec<&str> = motions.iter().map(|motion| motion.name()).collect();
            let expected = "one or more of orbit, dolly, jitter and wave, each once";
            let fits = !motions.is_empty() && motions.iter().all(is_once);
            require(fits, "coherence.motions", format!("[{}]", names.join(", ")), expected)?;
            within("coherence.frames", coherence.frames, COHERENCE_FRAMES)?;
        }

        within("path.warm-up", path.warm_up, 0..=MAX_WARM_UP)?;
        within("path.frames", path.frames, 1..=MAX_FRAMES)?;
        within("path.passes", path.passes, 1..=MAX_PASSES)?;
        let expected = format!("at least 1 and at most path.frames = {}, since timed frames are scored", path.frames);
        require((1..=path.frames).contains(&path.scored), "path.scored", path.scored, &expected)?;
        let pixels = u64::from(picture.width) * u64::from(picture.height);
        let most = MAX_SCORED_PIXELS / pixels;
        let expected = format!("at most {most} frames of {} x {} pixels", picture.width, picture.height);
        require(u64::from(path.scored) <= most, "path.scored", path.scored, &expected)
    }
}

fn within<T: PartialOrd + Display + Copy>(
    key: &'static str,
    value: T,
    range: RangeInclusive<T>,
) -> Result<(), SceneFault> {
    require(range.contains(&value), key, value, &format!("{} to {}", range.start(), range.end()))
}

fn require(holds: bool, key: &'static str, value: impl Display, expected: &str) -> Result<(), SceneFault> {
    let fault = || SceneFault::Value { key, value: value.to_string(), expected: expected.to_owned() };
    if holds { Ok(()) } else { Err(fault()) }
}

#[cfg(test)]
mod tests {
    use super::super::model::CoherenceSpec;
    use super::super::profile::Profile;
    use super::*;

    #[test]
    fn values_beyond_their_range_are_refused_by_name() {
        let quick = Profile::Quick.scene();
        let refused = |change: &dyn Fn(&mut Scene)| {
            let mut scene = quick.clone();
            change(&mut scene);
            scene.check().unwrap_err().to_string()
        };
        type Change<'a> = &'a dyn Fn(&mut Scene);
        let coherence = |motions: &[Motion], frames| Some(CoherenceSpec { motions: motions.to_vec(), frames });
        let cases: [(Change<'_>, &str); 17] = [
            (&|s| s.coherence = coherence(&[], 9), "coherence.motions = [] does not fit: one or more of orbit"),
            (&|s| s.coherence = coherence(&[Motion::Wave; 2], 9), "coherence.motions = [wave, wave]"),
            (&|s| s.coherence = coherence(&[Motion::Wave], 5), "coherence.frames = 5 does not fit: 6 to 60"),
            (&|s| s.simplify_meshes(0).unwrap(), "meshes.simplify = 0 does not fit: 1 or more faces"),
            (&|s| s.picture.width = 15, "picture.width = 15 does not fit: 16 to 4096"),
            (&|s| s.picture.height = 4097, "picture.height = 4097"),
            (&|s| s.picture.samples = 2, "picture.samples = 2 does not fit: 1 or 4"),
            (&|s| s.pen.width_px = f64::NAN, "pen.width-px = NaN"),
            (&|s| s.path.fov_deg = Some(171.0), "path.fov-deg = 171"),
            (&|s| s.path.fov_deg = None, "give path.fov-deg as well"),
            (&|s| s.path.projection = ProjectionKind::Orthographic, "leave it out"),
            (&|s| s.path.elevation_deg = 90.0, "path.elevation-deg = 90"),
            (&|s| s.path.swing_deg = 80.0, "path.swing-deg = 80"),
            (&|s| s.path.step_deg = f64::INFINITY, "path.step-deg = inf"),
            (&|s| s.path.frames = 0, "path.frames = 0 does not fit: 1 to 100000"),
            (&|s| s.path.scored = 31, "at most path.frames = 30, since timed frames are scored"),
            (&|s| (s.path.frames, s.path.scored) = (9999, 9999), "at most 256 frames of 512 x 512 pixels"),
        ];
        for (change, expected) in cases {
            let message = refused(change);
            assert!(message.contains(expected), "{message}");
        }
        assert!(quick.check().is_ok());
    }
}

//! What a frame takes in faces: the same on every machine.
//!
//! Counted over one flight from a frame that is found by brute force, as the paper's first is: each variant is its own, has
//! no other past, and counts all frames but that first one.

use super::variants::Flier;
use silhouette_compare::record::Profile;
use silhouette_core::{Cancelled, Progress, Viewpoint};

/// Frames of the flight: with [`Profile::Full`] a whole turn.
pub fn flight_frames(profile: Profile) -> u32 {
    match profile {
        Profile::Quick => 360,
        Profile::Full => 3600,
    }
}

/// Flies around a mesh of `faces` faces and counts.
///
/// # Errors
/// [`Cancelled`].
pub fn count_flight(
    flier: &mut Flier,
    flight: impl Iterator<Item = Viewpoint>,
    faces: usize,
    progress: &dyn Progress,
) -> Result<Counted, Cancelled> {
    let mut counted = Counted::default();
    for (frame, view) in flight.enumerate() {
        progress.check()?;
        flier.frame(&view);
        if frame > 0 {
            counted.count(flier, faces);
        }
    }
    Ok(counted)
}

/// Faces evaluated over some frames.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counted {
    /// Faces evaluated, frame by frame added up: distinct ones by Hall's methods.
    pub evaluated: u64,
    /// Faces of the mesh, added up in the same way: what brute force evaluates.
    pub all: u64,
    /// Frames that a tracker found by brute force.
    pub fallbacks: u32,
}

impl Counted {
    /// Counts the last frame of a mesh of `faces` faces.
    pub fn count(&mut self, flier: &Flier, faces: usize) {
        self.evaluated += flier.faces_evaluated();
        self.all += faces as u64;
        self.fallbacks += u32::from(flier.fell_back());
    }

    /// All faces over those evaluated; `None` where none was. Below 1 for a method that looks at faces twice.
    pub fn speed_up(&self) -> Option<f64> {
        (self.evaluated > 0).then(|| self.all as f64 / self.evaluated as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_speed_up_is_one_over_the_share_of_faces() {
        let counted = |evaluated| Counted { evaluated, all: 400, fallbacks: 0 };
        assert_eq!([400, 100, 0].map(|evaluated| counted(evaluated).speed_up()), [Some(1.0), Some(4.0), None]);
    }
}

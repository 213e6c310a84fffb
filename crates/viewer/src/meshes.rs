//! [`Opened`]: the mesh on screen, read beside the window, by its name on the command line.

use crate::background::{Job, Stage, Wake};
use crate::messages::Messages;
use silhouette_compare::runner::NamedMesh;
use silhouette_core::Progress;
use silhouette_core::mesh::Bounds;
use silhouettes::application::{Failure, MeshArgument, open};

/// A mesh that was read.
pub struct Shown {
    /// How the command line names it.
    pub argument: MeshArgument,
    /// Whether parts of it that are wound inside out were turned: `--orient`.
    pub is_oriented: bool,
    /// The mesh.
    pub named: NamedMesh,
    /// What it spans.
    pub bounds: Bounds,
}

/// The mesh on screen.
#[derive(Default)]
pub struct Opened {
    shown: Option<Shown>,
    reading: Option<(MeshArgument, Job<Result<Shown, Failure>>)>,
}

impl Opened {
    /// Begins to read a mesh; one that is being read is not read on.
    pub fn open(&mut self, wake: &Wake, argument: MeshArgument, orient: bool) {
        let named = argument.clone();
        self.reading = Some((argument, Job::start(wake, move |progress| read(named, orient, progress))));
    }

    /// Takes what was read. `true` where another mesh is on screen from now on; one that cannot be read leaves the old one there.
    pub fn update(&mut self, messages: &mut Messages) -> bool {
        let Some((_, job)) = &self.reading else { return false };
        let Some(result) = job.poll() else { return false };
        let notes = job.notes();
        self.reading = None;
        match result {
            Ok(Ok(shown)) => {
                messages.clear();
                notes.iter().for_each(|note| messages.note(note));
                if let Some(old) = self.shown.replace(shown) {
                    // Giving back the memory of a large mesh takes longer than a frame of the window.
                    std::thread::spawn(move || drop(old));
                }
                return true;
            }
            Ok(Err(failure)) => messages.error(failure),
            Err(died) => messages.error(died),
        }
        false
    }

    /// Reads no further.
    pub fn cancel(&mut self) {
        self.reading = None;
    }

    /// How far reading is, while a mesh is being read, and its name.
    pub fn stage(&self) -> Option<(String, Stage)> {
        self.reading.as_ref().map(|(argument, job)| (argument.to_string(), job.stage()))
    }

    /// The mesh on screen.
    pub fn shown(&self) -> Option<&Shown> {
        self.shown.as_ref()
    }
}

fn read(argument: MeshArgument, orient: bool, progress: &dyn Progress) -> Result<Shown, Failure> {
    let named = open(&argument, orient, progress)?;
    let bounds = named.mesh.mesh().bounds().ok_or_else(|| Failure::Input(format!("{}: has no face", named.name)))?;
    Ok(Shown { argument, is_oriented: orient, named, bounds })
}

//! [`Opened`]: the mesh on screen, read beside the window, by its name on the command line.

use crate::background::{Job, Stage, Wake};
use crate::messages::Messages;
use silhouette_compare::runner::NamedMesh;
use silhouette_core::Progress;
use silhouettes::application::{Failure, MeshArgument, load, note_of_winding};

/// What reading a mesh yields: the mesh, and what its user should know.
type Read = Result<(NamedMesh, Vec<String>), Failure>;

/// The mesh on screen.
#[derive(Default)]
pub struct Opened {
    mesh: Option<(MeshArgument, NamedMesh)>,
    reading: Option<(MeshArgument, Job<Read>)>,
}

impl Opened {
    /// Begins to read a mesh; one that is being read is not read on.
    pub fn open(&mut self, wake: &Wake, argument: MeshArgument) {
        let named = argument.clone();
        self.reading = Some((argument, Job::start(wake, move |progress| read(&named, progress))));
    }

    /// Takes what was read. `true` where another mesh is on screen from now on; one that cannot be read leaves the old one there.
    pub fn update(&mut self, messages: &mut Messages) -> bool {
        let Some((argument, job)) = &self.reading else { return false };
        let Some(result) = job.poll() else { return false };
        let argument = argument.clone();
        self.reading = None;
        match result {
            Ok(Ok((mesh, notes))) => {
                messages.clear();
                notes.iter().for_each(|note| messages.note(note));
                self.mesh = Some((argument, mesh));
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
    pub fn mesh(&self) -> Option<&NamedMesh> {
        self.mesh.as_ref().map(|(_, mesh)| mesh)
    }

    /// How the command line names the mesh on screen.
    pub fn argument(&self) -> Option<&MeshArgument> {
        self.mesh.as_ref().map(|(argument, _)| argument)
    }
}

fn read(argument: &MeshArgument, progress: &dyn Progress) -> Read {
    let (mesh, notes) = load(argument, progress)?;
    if mesh.mesh.mesh().face_count() == 0 {
        return Err(Failure::Input(format!("{}: has no face", mesh.name)));
    }
    let notes = notes.iter().map(|note| format!("{argument}: {note}")).chain(note_of_winding(&mesh)).collect();
    Ok((mesh, notes))
}

//! `--orient`, and the note that says where it helps: faces that point inwards.

use crate::failure::note;
use clap::Args;
use silhouette_core::inside_out::{inside_out_faces_with_progress, turned};
use silhouette_core::load::LabelledMesh;
use silhouette_core::{Cancelled, Progress, Topology};

/// Which way faces are wanted to point.
#[derive(Debug, Clone, Copy, PartialEq, Args)]
pub struct OrientArgument {
    /// Turn parts that are wound inside out, so that faces point outwards: exact for closed parts, a guess for open ones; the
    /// wall of a cavity points into it
    #[arg(long)]
    pub orient: bool,
}

/// What is done about faces that point inwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Winding {
    /// Nothing: the result does not depend on them.
    AsItIs,
    /// They are reported, as the result depends on them.
    Noted,
    /// They are turned.
    Turned,
}

impl OrientArgument {
    /// What is done where the result depends on the winding or does not.
    pub fn winding(self, matters: bool) -> Winding {
        match (self.orient, matters) {
            (true, _) => Winding::Turned,
            (false, true) => Winding::Noted,
            (false, false) => Winding::AsItIs,
        }
    }
}

impl Winding {
    /// Turns the faces of a mesh, or notes that they should be; stops when `progress` asks to.
    pub fn apply(self, name: &str, loaded: &mut LabelledMesh, progress: &dyn Progress) -> Result<(), Cancelled> {
        if self == Self::AsItIs {
            return Ok(());
        }
        let mesh = &loaded.mesh;
        let is_inside_out = inside_out_faces_with_progress(mesh, &Topology::new(mesh), progress)?;
        let (count, faces) = (is_inside_out.iter().filter(|&&turned| turned).count(), mesh.face_count());
        if count == 0 {
            return Ok(());
        }
        if self == Self::Turned {
            loaded.mesh = turned(mesh, &is_inside_out);
            note(format_args!("{name}: {count} of {faces} faces were turned, so that they point outwards"));
        } else {
            note(format_args!(
                "{name}: {count} of {faces} faces are in parts that are wound inside out, so that lines may be drawn that are hidden; \
                 --orient turns them"
            ));
        }
        Ok(())
    }
}

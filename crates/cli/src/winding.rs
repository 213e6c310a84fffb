//! `--orient`, and the note that says where it helps: faces that point inwards.

use crate::failure::note;
use clap::Args;
use silhouette_core::inside_out::{inside_out_faces, turned};
use silhouette_core::load::LabelledMesh;
use silhouette_core::{Topology, TriangleMesh};

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
    /// Turns the faces of a mesh, or notes that they should be.
    pub fn apply(self, name: &str, loaded: &mut LabelledMesh) {
        if self == Self::AsItIs {
            return;
        }
        let mesh = &loaded.mesh;
        let is_inside_out = inside_out_faces(mesh, &Topology::new(mesh));
        let (count, faces) = (is_inside_out.iter().filter(|&&turned| turned).count(), mesh.face_count());
        if count == 0 {
            return;
        }
        if self == Self::Turned {
            loaded.mesh = turned(mesh, &is_inside_out);
            note(format_args!("{name}: {count} of {faces} faces were turned, so that they point outwards"));
        } else {
            note(format_args!("{}; --orient turns them", inside_out(name, count, faces)));
        }
    }

    /// That some faces of a mesh are wound inside out, if any is. O(F log F).
    pub fn of_inside_out(name: &str, mesh: &TriangleMesh) -> Option<String> {
        let count = inside_out_faces(mesh, &Topology::new(mesh)).into_iter().filter(|&is| is).count();
        (count > 0).then(|| inside_out(name, count, mesh.face_count()))
    }
}

fn inside_out(name: &str, count: usize, faces: usize) -> String {
    format!(
        "{name}: {count} of {faces} faces are in parts that are wound inside out, so that lines may be drawn that are hidden"
    )
}

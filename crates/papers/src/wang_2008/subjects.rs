//! What is drawn: a coarse mesh, the fine surface that it stands for, and the row of Table I that is about the same shape.

use super::printed::{COPIES, PaperRow, row_of};
use crate::error::Cause;
use crate::label::mesh_label;
use silhouette_compare::{NamedMesh, Subject as Simplified};
use silhouette_core::{PreparedMesh, TriangleMesh, shapes};
use silhouette_smoothing::SmoothingOptions;
use std::sync::Arc;

/// A mesh of more faces is fine: it is drawn once, and its simplification in copies, as the paper does.
pub const COARSE: usize = 600;

/// Faces that fine meshes without a row are simplified to.
const SIMPLIFIED: usize = 500;

/// Level of PN triangles for meshes without a row: the one of most rows for coarse meshes, and that of the fine one.
const LEVELS: [u32; 2] = [3, 2];

/// A built-in mesh that stands in for a model of the paper, with a fine mesh of the same surface.
struct StandIn {
    name: &'static str,
    model: &'static str,
    fine: &'static str,
}

/// Of the same number of faces as in the paper, exactly. The last is fine itself.
const STAND_INS: [StandIn; 5] = [
    StandIn { name: "builtin:blob:200,0", model: "Sphere", fine: "icosphere:6" },
    StandIn { name: "builtin:knot:2,3,40,6", model: "Knot", fine: "knot:2,3,480,72" },
    StandIn { name: "builtin:blob:500", model: "Bear", fine: "blob:80000" },
    StandIn { name: "builtin:torus:24,12", model: "Torus", fine: "torus:240,120" },
    StandIn { name: "builtin:blob:43288", model: "Hippo", fine: "blob:400000" },
];

/// The meshes that are measured where none is named: one of each of the [`STAND_INS`].
pub const DEFAULT_MESHES: [&str; 5] = {
    let mut names = [""; 5];
    let mut at = 0;
    while at < names.len() {
        names[at] = STAND_INS[at].name;
        at += 1;
    }
    names
};

/// Models of the paper that files are named after.
const FILES: [(&str, &str); 5] =
    [("bunny", "Bunny"), ("bear", "Bear"), ("head", "Head"), ("cow", "Cow"), ("knot", "Knot")];

/// One mesh to draw.
#[derive(Debug, Clone)]
pub struct Subject {
    /// What tables call it.
    pub label: String,
    /// Where it comes from.
    pub origin: String,
    /// What is drawn.
    pub mesh: Arc<PreparedMesh>,
    /// The surface that it stands for, in the same coordinates; `None`: itself.
    pub fine: Option<Arc<TriangleMesh>>,
    /// How many copies are drawn.
    pub copies: usize,
    /// Level of PN triangles.
    pub pn_level: u32,
    /// Dihedral angle from which on an edge is a feature edge: the default, or 180 for shapes that are known to be smooth.
    pub crease_deg: f64,
    /// The row of Table I about the same shape.
    pub row: Option<&'static PaperRow>,
}

impl Subject {
    /// Number of its faces.
    pub fn faces(&self) -> usize {
        self.mesh.mesh().face_count()
    }

    /// The options of smoothing, but for feature edges the defaults.
    pub fn options(&self) -> SmoothingOptions {
        SmoothingOptions { crease_deg: self.crease_deg, ..SmoothingOptions::default() }
    }
}

/// What is drawn of some meshes, and notes on what is not: each coarse mesh as it is; each fine one simplified, then in full.
///
/// # Errors
/// [`Cause::Shape`], which a test rules out.
pub fn subjects(meshes: &[NamedMesh]) -> Result<(Vec<Subject>, Vec<String>), Cause> {
    let (mut all, mut notes) = (Vec::new(), Vec::new());
    for named in meshes {
        if let Some(stand_in) = STAND_INS.iter().find(|stand_in| stand_in.name == named.name) {
            all.push(built_in(stand_in, named)?);
            continue;
        }
        let label = mesh_label(&named.name);
        let row = FILES.iter().find(|(word, _)| label.to_lowercase().contains(word));
        let row = row.and_then(|(_, model)| row_of(model));
        if named.mesh.mesh().face_count() <= COARSE {
            let origin = named.name.clone();
            all.push(subject(label, origin, Arc::clone(&named.mesh), None, row));
            continue;
        }
        let faces = row.map_or(SIMPLIFIED, |row| row.triangles as usize);
        match Simplified::simplified(named, faces) {
            Ok(Simplified { mesh, truth }) => {
                let label = format!("{label}, {}", mesh.mesh.mesh().face_count());
                all.push(subject(label, mesh.name, mesh.mesh, truth, row));
            }
            Err(fault) => notes.push(format!("{} is drawn in full only: {fault}", named.name)),
        }
        all.push(subject(format!("{label}, full"), named.name.clone(), Arc::clone(&named.mesh), None, None));
    }
    Ok((all, notes))
}

fn built_in(stand_in: &StandIn, named: &NamedMesh) -> Result<Subject, Cause> {
    let fine = shapes::by_name(stand_in.fine)?;
    let row = row_of(stand_in.model);
    let (label, origin) = (stand_in.model.to_owned(), named.name.clone());
    Ok(Subject { crease_deg: 180.0, ..subject(label, origin, Arc::clone(&named.mesh), Some(Arc::new(fine)), row) })
}

fn subject(
    label: String,
    origin: String,
    mesh: Arc<PreparedMesh>,
    fine: Option<Arc<TriangleMesh>>,
    row: Option<&'static PaperRow>,
) -> Subject {
    let is_coarse = mesh.mesh().face_count() <= COARSE;
    let pn_level = row.map_or(LEVELS[usize::from(!is_coarse)], |row| row.pn_level);
    let copies = if is_coarse { COPIES } else { 1 };
    let SmoothingOptions { crease_deg, .. } = SmoothingOptions::default();
    Subject { label, origin, mesh, fine, copies, pn_level, crease_deg, row }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str, shape: &str) -> NamedMesh {
        NamedMesh { name: name.to_owned(), mesh: Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap())) }
    }

    #[test]
    fn stand_ins_have_the_faces_of_the_paper_and_lie_on_their_fine_surface() {
        let meshes = DEFAULT_MESHES.map(|name| named(name, name.strip_prefix("builtin:").unwrap()));
        let (all, notes) = subjects(&meshes).unwrap();
        assert!(notes.is_empty() && all.len() == 5);
        for subject in all {
            assert_eq!(subject.row.unwrap().triangles as usize, subject.faces(), "{}", subject.label);
            assert_eq!(subject.copies == 1, subject.label == "Hippo");
            let [coarse, fine] = [subject.mesh.mesh(), subject.fine.as_ref().unwrap()].map(|m| m.bounds().unwrap());
            assert!(coarse.radius / fine.radius > 0.85 && coarse.radius / fine.radius < 1.01, "{}", subject.label);
        }
    }

    #[test]
    fn fine_meshes_are_drawn_simplified_and_in_full() {
        let (all, notes) = subjects(&[named("folder/my-bear.obj", "blob:2000"), named("small.off", "cube")]).unwrap();
        let labels: Vec<_> = all.iter().map(|subject| (subject.label.as_str(), subject.copies)).collect();
        if cfg!(feature = "simplify") {
            assert_eq!(labels, [("my-bear, 500", 60), ("my-bear, full", 1), ("small", 60)]);
            assert_eq!(all[0].row.map(|row| row.model), Some("Bear"));
            assert!(all[0].fine.is_some() && notes.is_empty());
        } else {
            assert_eq!(labels, [("my-bear, full", 1), ("small", 60)]);
            assert!(notes[0].contains("feature"), "{notes:?}");
        }
    }
}

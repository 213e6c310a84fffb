//! [`Key`]: all that decides what the cells of a comparison are.

use crate::machine::program;
use crate::options::OptionSettings;
use crate::runner::{CompareConfig, Subject};
use crate::scene::{MethodChoice, Scene};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use silhouette_core::{TriangleMesh, VertexId};

/// All that decides what the cells of a comparison are, and what their pictures are worth: two processes with the same key measure
/// the same cells. What decides times alone is not in it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Key {
    /// Version and commit of the program.
    pub program: [String; 2],
    /// The scene's name.
    pub name: String,
    /// The scene as a file of it would be, without its name, with what the command line overrides.
    pub scene: Value,
    /// The methods with their options, in the order of the cells of a mesh.
    pub methods: Vec<MethodKey>,
    /// The meshes, in the order of the cells.
    pub meshes: Vec<MeshKey>,
}

/// A method with its options.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MethodKey {
    /// The method.
    pub name: String,
    /// All of its options.
    pub options: OptionSettings,
}

/// A mesh, by what it holds.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct MeshKey {
    /// Its name.
    pub name: String,
    /// Vertices, faces and a checksum of both and of the feature edges.
    pub drawn: [u64; 3],
    /// The same of what filled pictures are measured against, where that is another mesh.
    pub truth: Option<[u64; 3]>,
}

impl Key {
    /// The key of a comparison. O(V + F) of all meshes.
    pub fn of(config: &CompareConfig, subjects: &[Subject]) -> Self {
        let meshes = subjects.iter().map(|subject| MeshKey {
            name: subject.mesh.name.clone(),
            drawn: contents(subject.mesh.mesh.mesh(), subject.mesh.mesh.feature_edges()),
            truth: subject.truth.as_deref().map(|mesh| contents(mesh, &[])),
        });
        Self {
            program: program(),
            name: config.scene().name.clone(),
            scene: nameless(config.scene()),
            methods: methods(config),
            meshes: meshes.collect(),
        }
    }

    /// The key of the same comparison with other methods: that of `config`, whose scene differs from this one's in them alone.
    pub fn with_methods(&self, config: &CompareConfig) -> Self {
        Self { scene: nameless(config.scene()), methods: methods(config), ..self.clone() }
    }

    /// The scene with its name.
    ///
    /// # Errors
    /// What the key was read from held another one.
    pub fn scene(&self) -> Result<Scene, serde_json::Error> {
        Ok(Scene { name: self.name.clone(), ..serde_json::from_value(self.scene.clone())? })
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.methods.len() * self.meshes.len()
    }

    /// Eight hexadecimal digits that differ, almost always, where keys do.
    pub fn digest(&self) -> String {
        let text = serde_json::to_vec(self).unwrap_or_default();
        format!("{:08x}", crc32fast::hash(&text))
    }
}

fn methods(config: &CompareConfig) -> Vec<MethodKey> {
    let key = |choice: &MethodChoice| MethodKey {
        name: choice.entry.info().name.to_owned(),
        options: OptionSettings::from(&choice.options),
    };
    config.methods().iter().map(key).collect()
}

/// A scene without its name, which a scene's file does not hold.
fn nameless(scene: &Scene) -> Value {
    let mut value = serde_json::to_value(scene).unwrap_or_default();
    if let Value::Object(entries) = &mut value {
        entries.remove("name");
    }
    value
}

/// Number of vertices, of faces, and a checksum of both and of the feature edges. O(V + F).
pub(crate) fn contents(mesh: &TriangleMesh, feature_edges: &[[VertexId; 2]]) -> [u64; 3] {
    let mut hasher = crc32fast::Hasher::new();
    for position in mesh.positions() {
        position.to_array().iter().for_each(|value| hasher.update(&value.to_le_bytes()));
    }
    for triangle in mesh.triangles() {
        triangle.iter().for_each(|vertex| hasher.update(&vertex.to_le_bytes()));
    }
    for edge in feature_edges {
        edge.iter().for_each(|vertex| hasher.update(&vertex.get().to_le_bytes()));
    }
    [mesh.vertex_count() as u64, mesh.face_count() as u64, hasher.finalize().into()]
}

//! [`OpenedScene`]: a scene file of `compare`, read beside the window: its meshes, methods, pen and camera path.

use crate::background::{Job, Wake};
use crate::messages::Messages;
use crate::pane::Choice;
use silhouette_compare::registry::Registry;
use silhouette_compare::scene::Scene;
use silhouette_compare::scene::cells::choices;
use silhouettes::application::{Failure, MeshArgument};
use std::path::{Path, PathBuf};

/// A scene and what of it is shown.
#[derive(Debug, Clone)]
pub struct ShownScene {
    /// The scene.
    pub scene: Scene,
    /// Those of its methods that are shown, the first two; none where it names none.
    pub choices: Vec<Choice>,
}

impl ShownScene {
    /// Reads a scene file, as `compare --scene` does.
    ///
    /// # Errors
    /// [`Failure::Input`] names file, place and mend.
    pub fn read(path: &Path, registry: &Registry) -> Result<Self, Failure> {
        let scene = Scene::load(path).map_err(Failure::input)?;
        let in_file = |fault| Failure::Input(format!("{}: {fault}", path.display()));
        let mut shown: Vec<Choice> = Vec::new();
        if !scene.methods.is_empty() {
            for choice in choices(&scene, registry).map_err(|fault| in_file(fault.to_string()))? {
                let choice = Choice { entry: choice.entry, values: choice.options };
                if !shown.contains(&choice) && shown.len() < 2 {
                    shown.push(choice);
                }
            }
        }
        Ok(Self { scene, choices: shown })
    }

    /// Its meshes, as the command line names them.
    pub fn meshes(&self) -> impl Iterator<Item = MeshArgument> + '_ {
        self.scene.meshes.iter().map(|spec| MeshArgument::from(spec.mesh()))
    }

    /// How one of its meshes is compared, where it is not shown so.
    pub fn note_on(&self, mesh: &MeshArgument) -> Option<String> {
        let spec = self.scene.meshes.iter().find(|spec| MeshArgument::from(spec.mesh()) == *mesh)?;
        let simplified = spec.simplify().map(|faces| format!("is shown whole, not simplified to {faces} faces"));
        let finer = spec.truth().map(|truth| format!("is measured against itself here, not against {truth}"));
        simplified.or(finer).map(|note| format!("{mesh}: {note}, unlike in the scene {}", self.scene.name))
    }
}

/// The scene on screen, if there is one.
#[derive(Default)]
pub struct OpenedScene {
    shown: Option<ShownScene>,
    reading: Option<Job<Result<ShownScene, Failure>>>,
}

impl OpenedScene {
    /// Begins to read a file.
    pub fn open(&mut self, wake: &Wake, registry: &Registry, path: PathBuf) {
        let registry = registry.clone();
        self.reading = Some(Job::start(wake, move |_| ShownScene::read(&path, &registry)));
    }

    /// Has a scene shown that was read already.
    pub fn show(&mut self, scene: ShownScene) {
        self.shown = Some(scene);
    }

    /// Takes what was read. `true` where another scene is shown from now on; one that cannot be read leaves the old one there.
    pub fn update(&mut self, messages: &mut Messages) -> bool {
        let Some(result) = self.reading.as_ref().and_then(Job::poll) else { return false };
        self.reading = None;
        match result {
            Ok(Ok(scene)) => {
                messages.clear();
                self.shown = Some(scene);
                return true;
            }
            Ok(Err(failure)) => messages.error(failure),
            Err(died) => messages.error(died),
        }
        false
    }

    /// Whether a file is being read.
    pub fn is_busy(&self) -> bool {
        self.reading.is_some()
    }

    /// The scene.
    pub fn shown(&self) -> Option<&ShownScene> {
        self.shown.as_ref()
    }
}

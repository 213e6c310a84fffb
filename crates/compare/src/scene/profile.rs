//! [`Profile`]: the names of the built-in scenes.

use super::model::Scene;

/// A built-in scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Profile {
    /// `scenes/quick.toml`: about a minute per mesh on two cores without a graphics card, most of it for silhouette textures.
    Quick,
    /// `scenes/full.toml`: a whole turn in large pictures.
    Full,
}

impl Profile {
    /// Every profile with the name the command line uses.
    pub const NAMED: [(&'static str, Self); 2] = [("quick", Self::Quick), ("full", Self::Full)];

    /// Name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Quick => "quick",
            Self::Full => "full",
        }
    }

    /// The scene.
    ///
    /// # Panics
    /// Never: a test parses every built-in scene.
    pub fn scene(self) -> Scene {
        let text = match self {
            Self::Quick => include_str!("../../scenes/quick.toml"),
            Self::Full => include_str!("../../scenes/full.toml"),
        };
        Scene::parse(text, self.name().to_owned()).expect("built-in scenes are tested")
    }

    /// Width and height of its pictures in pixels.
    pub fn size(self) -> [u32; 2] {
        self.scene().picture.size()
    }
}

#[cfg(test)]
mod tests {
    use super::super::cells::choices;
    use super::*;
    use crate::coherence::Motion;
    use crate::registry::Registry;

    #[test]
    fn every_profile_is_a_scene_of_its_name() {
        for (name, profile) in Profile::NAMED {
            let scene = profile.scene();
            assert_eq!((scene.name.as_str(), profile.name()), (name, name));
            assert!(!scene.meshes.is_empty() && scene.path.scored >= 6, "{name}");
        }
        assert_eq!([Profile::Quick, Profile::Full].map(Profile::size), [[512; 2], [1024; 2]]);
    }

    #[test]
    fn the_scene_of_coherence_can_be_run() {
        let text = include_str!("../../scenes/coherence.toml");
        let scene = Scene::parse(text, "coherence".to_owned()).unwrap();
        assert_eq!(scene.coherence.as_ref().unwrap().motions, Motion::ALL);
        assert!(choices(&scene, &Registry::builtin()).is_ok());
    }

    /// Views that scores come from differ by several degrees, or all of them would show the same side.
    #[test]
    fn scored_frames_see_the_mesh_from_different_sides() {
        for (name, profile) in Profile::NAMED {
            let path = profile.scene().path;
            let scored = path.scored_frames();
            let turned = f64::from(scored[scored.len() - 1] - scored[0]) * path.step_deg;
            assert!(turned >= 45.0, "{name}: {turned} degrees");
        }
    }
}

//! Step 1: a scene from its file.

use super::error::{SceneError, SceneFault};
use super::model::Scene;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Most bytes of a scene's file: some ten thousand methods.
pub const MAX_BYTES: u64 = 1 << 20;

impl Scene {
    /// Reads and checks a file; paths of meshes in it are relative to its folder. Methods and options are looked up later, by
    /// [`choices`](super::cells::choices).
    ///
    /// # Errors
    /// [`SceneError`] names the file, the key and what fits.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let text = read(path).map_err(|fault| fault.in_file(path))?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let mut scene = Self::parse(&text, name).map_err(|fault| fault.in_file(path))?;
        let folder = path.parent().unwrap_or(Path::new(""));
        scene.meshes = scene.meshes.into_iter().map(|mesh| mesh.relative_to(folder)).collect();
        Ok(scene)
    }

    /// Parses and checks the text of a file.
    ///
    /// # Errors
    /// [`SceneFault`] names the key and what fits.
    pub fn parse(text: &str, name: String) -> Result<Self, SceneFault> {
        let parsed: Self = toml::from_str(text).map_err(|error| form(text, &error))?;
        let scene = Self { name, ..parsed };
        scene.check()?;
        Ok(scene)
    }

    /// The text of a file of this scene, without its name, which is the file's.
    ///
    /// # Panics
    /// Never: every field is a value of TOML.
    pub fn to_toml(&self) -> String {
        let mut table = toml::Table::try_from(self).expect("a scene is a table");
        table.remove("name");
        toml::to_string(&table).expect("a table is a document")
    }
}

fn read(path: &Path) -> Result<String, SceneFault> {
    let mut text = String::new();
    File::open(path)?.take(MAX_BYTES + 1).read_to_string(&mut text)?;
    if text.len() as u64 > MAX_BYTES { Err(SceneFault::TooLong { limit: MAX_BYTES }) } else { Ok(text) }
}

/// The parser's message on one line, with the line and the key that it is about.
fn form(text: &str, error: &toml::de::Error) -> SceneFault {
    let at = error.span().map_or(0, |span| span.start.min(text.len()));
    let before = &text.as_bytes()[..at];
    let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
    let source = text.lines().nth(line - 1).unwrap_or_default().trim();
    let key = match source.split_once('=') {
        Some((key, _)) => format!("{}: ", key.trim()),
        None if source.starts_with('[') => format!("{source}: "),
        None => String::new(),
    };
    let message = error.message().split_whitespace().collect::<Vec<_>>().join(" ");
    SceneFault::Form { line, key, message }
}

#[cfg(test)]
mod tests {
    use super::super::model::{MeshSpec, OptionSpread};
    use super::*;
    use crate::options::OptionSetting;

    const QUICK: &str = include_str!("../../scenes/quick.toml");

    fn refused(text: &str) -> String {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("mine.toml");
        std::fs::write(&path, text).unwrap();
        let message = Scene::load(&path).unwrap_err().to_string();
        assert!(message.contains("mine.toml: ") && message.lines().count() == 1, "{message}");
        message
    }

    #[test]
    fn a_scene_holds_what_its_file_says() {
        let text =
            format!("{QUICK}\n[[methods]]\nname = 'tracking'\noptions = {{ concavity = [0, 0.5], mesh = 'cut' }}\n")
                .replace(
                    "[\"builtin:torus\",",
                    "[{ mesh = \"a.obj\", truth = \"b.obj\" }, { mesh = \"c.obj\", simplify = 500 },",
                );
        let scene = Scene::parse(&text, "mine".to_owned()).unwrap();
        assert_eq!((scene.name.as_str(), scene.picture.size(), scene.path.frames), ("mine", [512; 2], 30));
        assert_eq!((scene.meshes[0].mesh(), scene.meshes[0].truth()), ("a.obj", Some("b.obj")));
        let simplified = &scene.meshes[1];
        assert_eq!((simplified.mesh(), simplified.simplify(), simplified.truth()), ("c.obj", Some(500), None));
        assert_eq!(scene.meshes[2], MeshSpec::Plain("builtin:gear".to_owned()));
        let options = &scene.methods[0].options;
        assert_eq!(options["mesh"], OptionSpread::One(OptionSetting::Word("cut".to_owned())));
        assert_eq!(options["concavity"].values(), [0.0, 0.5].map(OptionSetting::Number));
        // What is written into results can be read again.
        let written = scene.to_toml();
        assert_eq!(Scene::parse(&written, "mine".to_owned()).unwrap(), scene, "{written}");
    }

    #[test]
    fn paths_are_relative_to_the_file() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("mine.toml");
        let meshes = "meshes = [\"builtin:cube\", \"/a.obj\", { mesh = \"b.obj\", truth = \"c/d.obj\" }, \
                      { mesh = \"e.obj\", simplify = 9 }]";
        let rest = QUICK.lines().filter(|line| !line.starts_with("meshes")).collect::<Vec<_>>().join("\n");
        std::fs::write(&path, format!("{meshes}\n{rest}")).unwrap();
        let scene = Scene::load(&path).unwrap();
        let beside = |name: &str| dir.path().join(name).to_string_lossy().into_owned();
        let names: Vec<&str> = scene.meshes.iter().map(MeshSpec::mesh).collect();
        assert_eq!(names, ["builtin:cube", "/a.obj", &beside("b.obj"), &beside("e.obj")]);
        assert_eq!(scene.meshes[2].truth(), Some(beside("c/d.obj").as_str()));
    }

    #[test]
    fn what_is_wrong_is_named_with_its_file_line_and_key() {
        let changed = |from: &str, to: &str| refused(&QUICK.replace(from, to));
        let line = |needle: &str| QUICK.lines().position(|line| line.starts_with(needle)).unwrap() + 1;
        let unknown = changed("swing-deg", "swing");
        assert!(unknown.contains(&format!("line {}: ", line("swing-deg"))), "{unknown}");
        assert!(unknown.contains("unknown field `swing`") && unknown.contains("swing-deg"), "{unknown}");
        let wrong_type = changed("frames = 30 ", "frames = \"many\" ");
        assert!(wrong_type.contains(&format!("line {}: frames: ", line("frames = 30"))), "{wrong_type}");
        assert!(changed("kind = \"orbit\"", "kind = \"flight\"").contains("orbit"));
        assert!(changed("height = 512", "").contains("missing field `height`"));
        for mesh in ["7", "{ mesh = 'a.obj', simplify = -1 }", "{ mesh = 'a.obj', truth = 'b.obj', simplify = 9 }"] {
            let message = changed("[\"builtin:torus\",", &format!("[{mesh},"));
            assert!(message.contains("truth = \"fine.obj\"") && message.contains("simplify = 500"), "{message}");
        }
        assert!(changed("frames = 30 ", "frames = -1 ").contains("frames"));
        assert!(refused("[path").contains("line 1: "));
        let long = refused(&format!("# {}", "x".repeat(MAX_BYTES as usize)));
        assert!(long.contains("no scene"), "{long}");
        let missing = Scene::load("missing.toml".as_ref()).unwrap_err().to_string();
        assert!(missing.starts_with("missing.toml: "), "{missing}");
    }
}

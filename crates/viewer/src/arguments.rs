//! The program's arguments, those of the command line where they mean the same.

use crate::pane::Choice;
use crate::scenes::ShownScene;
use crate::viewer::Start;
use clap::Parser;
use silhouette_compare::registry::Registry;
use silhouettes::application::{CameraArguments, Failure, MeshArgument};
use std::path::PathBuf;
use std::time::Duration;

/// Look at a mesh as silhouette methods draw it, and at what they miss, while it moves
#[derive(Debug, Parser)]
#[command(name = "silhouettes-viewer", version)]
pub struct Arguments {
    /// Mesh file, .siltex file or builtin:NAME [default: the first of the scene, or none; open one from the window]
    pub mesh: Option<MeshArgument>,
    /// Name of the method; given twice, both are shown side by side [default: those of the scene, or brute-force]
    #[arg(long, value_name = "NAME")]
    pub method: Vec<String>,
    /// An option of the first method; may be given several times
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub set: Vec<String>,
    /// Scene file of `silhouettes compare`: its camera path, and its meshes, methods and pen unless they are named here
    #[arg(long, value_name = "FILE")]
    pub scene: Option<PathBuf>,
    /// Turn parts that are wound inside out, so that faces point outwards
    #[arg(long)]
    pub orient: bool,
    /// Turn the eye about the mesh for so long, print frames per second and the longest frame, and end
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub measure: Option<Duration>,
    /// The view that the window begins with; --size is that of what is left for pictures
    #[command(flatten)]
    pub camera: CameraArguments,
}

impl Arguments {
    /// What the window begins with.
    ///
    /// # Errors
    /// [`Failure::Input`] names the argument that does not fit, and what would.
    pub fn start(self, registry: &Registry) -> Result<Start, Failure> {
        if self.method.len() > 2 {
            return Err(Failure::Input("--method: two are shown at most; name one or two".to_owned()));
        }
        if self.mesh == Some(MeshArgument::StandardInput) {
            return Err(Failure::Input(
                "standard input: cannot be shown, as it is read only once; name a file".to_owned(),
            ));
        }
        let scene = self.scene.map(|path| ShownScene::read(&path, registry)).transpose()?;
        let of_scene = scene.as_ref().map(|scene| scene.choices.clone()).unwrap_or_default();
        let choices = if self.method.is_empty() && self.set.is_empty() && !of_scene.is_empty() {
            of_scene
        } else {
            let default = [DEFAULT_METHOD.to_owned()];
            let names = if self.method.is_empty() { &default[..] } else { &self.method };
            let none: &[String] = &[];
            let words = [&self.set[..], none];
            let choices = names.iter().zip(words).map(|(name, words)| Choice::of_words(registry, name, words));
            choices.collect::<Result<_, _>>()?
        };
        let mesh = self.mesh.or_else(|| scene.as_ref()?.meshes().next());
        if self.measure.is_some() && mesh.is_none() {
            return Err(Failure::Input("--measure: there is nothing to look at; name a mesh".to_owned()));
        }
        Ok(Start { mesh, scene, choices, orient: self.orient, measure: self.measure, camera: self.camera })
    }
}

/// The method where none is named.
const DEFAULT_METHOD: &str = "brute-force";

/// How long can be measured, in seconds.
const MEASURED_SECONDS: std::ops::RangeInclusive<f64> = 0.1..=3600.0;

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().ok().filter(|seconds| MEASURED_SECONDS.contains(seconds));
    let (least, most) = (MEASURED_SECONDS.start(), MEASURED_SECONDS.end());
    seconds.map(Duration::from_secs_f64).ok_or_else(|| format!("expected {least} to {most} seconds"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn start(words: &[&str]) -> Result<Start, Failure> {
        let words = ["silhouettes-viewer"].iter().chain(words);
        Arguments::try_parse_from(words).unwrap().start(&Registry::builtin())
    }

    #[test]
    fn methods_and_options_are_the_command_line_s() {
        let begun =
            start(&["builtin:torus", "--method", "tracking", "--method", "fine-mesh", "--set", "concavity=0.5"]);
        let begun = begun.unwrap();
        let names: Vec<_> = begun.choices.iter().map(Choice::name).collect();
        assert_eq!((names, begun.mesh), (vec!["tracking", "fine-mesh"], Some("builtin:torus".into())));
        assert!(begun.choices[0].values.to_string().contains("concavity=0.5"));
        assert_eq!(start(&[]).unwrap().choices[0].name(), "brute-force");
    }

    #[test]
    fn what_does_not_fit_is_named() {
        for (words, expected) in [
            (&["--method", "brute-farce"][..], "there is no method 'brute-farce'"),
            (&["--method", "interpolated-contours"], "yields curves alone"),
            (&["--method", "tracking", "--set", "concavity=2x"], "concavity=2x does not fit"),
            (&["--method", "tracking", "--method", "tracking", "--method", "tracking"], "two are shown at most"),
            (&["-"], "name a file"),
        ] {
            let message = start(words).unwrap_err().to_string();
            assert!(message.contains(expected) && message.lines().count() == 1, "{message}");
        }
    }
}

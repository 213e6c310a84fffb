//! The program's arguments, those of the command line where they mean the same.

use crate::pane::Choice;
use crate::viewer::Start;
use clap::Parser;
use silhouette_compare::registry::Registry;
use silhouettes::application::{CameraArguments, Failure, MeshArgument};

/// Look at a mesh as silhouette methods draw it, and at what they miss, while it moves
#[derive(Debug, Parser)]
#[command(name = "silhouettes-viewer", version)]
pub struct Arguments {
    /// Mesh file or builtin:NAME [default: none; open one from the window]
    pub mesh: Option<MeshArgument>,
    /// Name of the method; given twice, both are shown side by side
    #[arg(long, value_name = "NAME", default_value = "brute-force")]
    pub method: Vec<String>,
    /// An option of the first method; may be given several times
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub set: Vec<String>,
    /// The view that the window begins with; --size is that of the window
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
        let none: &[String] = &[];
        let words = [&self.set[..], none];
        let choices = self.method.iter().zip(words).map(|(name, words)| Choice::of_words(registry, name, words));
        Ok(Start { mesh: self.mesh, choices: choices.collect::<Result<_, _>>()?, camera: self.camera })
    }
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

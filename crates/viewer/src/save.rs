//! [`Saving`]: the view as a file, written by the command line itself.
//!
//! What is on screen is put into the words of a command, which is then run: `lines` for drawings, `render` for pictures. So the files are
//! the command line's, byte for byte, and the words can be repeated without the window. A scene is for `compare --scene`.

use crate::background::{Job, Stage, Wake};
use crate::messages::Messages;
use crate::pane::{Choice, Look};
use crate::path::Path;
use crate::view::View;
use silhouette_compare::options::OptionSettings;
use silhouette_compare::registry::Registry;
use silhouette_compare::scene::{
    MeshSpec, MethodSpec, OptionSpread, PathSpec, PenSpec, PictureSpec, ProjectionKind, Scene,
};
use silhouettes::application::{Failure, MeshArgument, write};
use silhouettes::execute;
use std::path::{Path as FilePath, PathBuf};

/// What is saved.
pub struct Shown<'a> {
    /// The mesh, as the command line names it.
    pub mesh: &'a MeshArgument,
    /// Whether parts of it that were wound inside out are turned.
    pub is_oriented: bool,
    /// The view.
    pub view: &'a View,
    /// Width and height of the picture in pixels.
    pub size: [u32; 2],
    /// The methods on screen.
    pub choices: Vec<&'a Choice>,
    /// How they are drawn.
    pub look: Look,
    /// The camera path.
    pub path: &'a Path,
}

/// What the name of a file asks for.
#[derive(Debug, Clone, PartialEq)]
pub enum Order {
    /// A command, with its words.
    Command(Vec<String>),
    /// The text of a scene.
    Scene(String),
}

impl Shown<'_> {
    /// What writes this to a file of this name: `.png` is a picture by the first method, `.toml` a scene, and anything else what
    /// `lines` makes of it.
    ///
    /// # Errors
    /// [`Failure::Input`]: a scene cannot be as this is.
    pub fn order(&self, file: &str) -> Result<Order, Failure> {
        let ending = FilePath::new(file).extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        match ending.as_str() {
            "toml" => self.scene().map(|scene| Order::Scene(scene.to_toml())),
            "png" => Ok(Order::Command(self.command("render", file, &self.method_words()))),
            _ => Ok(Order::Command(self.command("lines", file, &self.line_words()))),
        }
    }

    fn command(&self, name: &str, file: &str, options: &[String]) -> Vec<String> {
        let view = self.view.words(self.size);
        let orient = self.is_oriented.then(|| "--orient".to_owned());
        let output = ["-o".to_owned(), file.to_owned(), "--".to_owned(), named(self.mesh)];
        [name.to_owned()].into_iter().chain(options.iter().cloned()).chain(orient).chain(view).chain(output).collect()
    }

    /// The first method with what is not at its default.
    fn method_words(&self) -> Vec<String> {
        let choice = self.choices[0];
        let mut words = vec!["--method".to_owned(), choice.name().to_owned()];
        for (name, value) in changed(choice) {
            words.extend(["--set".to_owned(), format!("{name}={value}")]);
        }
        let Look { pen_width_px, samples, .. } = self.look;
        words.extend(["--width".to_owned(), pen_width_px.to_string(), "--samples".to_owned(), samples.to_string()]);
        words
    }

    fn line_words(&self) -> Vec<String> {
        let layers = self.look.layers;
        let hidden = layers.hidden.then(|| vec!["--hidden=dashed".to_owned()]);
        let creases = layers.creases.then(|| vec!["--creases".to_owned(), layers.crease_deg.to_string()]);
        [hidden, creases].into_iter().flatten().flatten().collect()
    }

    /// The scene: this mesh, these methods and this pen along the path, which begins where the eye is now.
    ///
    /// # Errors
    /// [`Failure::Input`]: a value is beyond what scenes hold.
    pub fn scene(&self) -> Result<Scene, Failure> {
        let [azimuth_deg, elevation_deg] = self.view.azimuth_and_elevation_deg();
        let spec = self.path.spec;
        // The path swings about its elevation, as `camera_path` has it, and stays off the poles.
        let room = (HIGHEST_ELEVATION_DEG - elevation_deg.abs()).max(0.0) * 0.5;
        let swing_deg = spec.swing_deg.clamp(-room, room);
        let swung_deg = swing_deg * (azimuth_deg.to_radians() + 1.0).sin();
        let first = elevation_deg.clamp(-HIGHEST_ELEVATION_DEG, HIGHEST_ELEVATION_DEG) - swung_deg;
        let is_orthographic = self.view.is_orthographic();
        let [width, height] = self.size;
        let methods = self.choices.iter().map(|choice| {
            let options = changed(choice).map(|(name, value)| (name, OptionSpread::One(value))).collect();
            MethodSpec { name: choice.name().to_owned(), options }
        });
        let scene = Scene {
            name: String::new(),
            meshes: vec![MeshSpec::Plain(absolute(self.mesh))],
            path: PathSpec {
                projection: if is_orthographic { ProjectionKind::Orthographic } else { ProjectionKind::Perspective },
                fov_deg: (!is_orthographic).then(|| self.view.fov_deg()),
                up_axis: self.view.up_axis,
                first_azimuth_deg: azimuth_deg,
                elevation_deg: first,
                swing_deg,
                ..spec
            },
            picture: PictureSpec { width, height, samples: self.look.samples },
            pen: PenSpec { width_px: self.look.pen_width_px },
            coherence: None,
            methods: methods.collect(),
        };
        scene.check().map_err(Failure::input)?;
        Ok(scene)
    }
}

/// Scenes stay this far from the poles, in degrees, with some room for rounding.
const HIGHEST_ELEVATION_DEG: f64 = 88.9;

/// The options of a choice that are not at their defaults.
fn changed(choice: &Choice) -> impl Iterator<Item = (String, silhouette_compare::options::OptionSetting)> {
    let defaults = OptionSettings::from(&Choice::new(&choice.entry).values);
    let settings = OptionSettings::from(&choice.values).0.into_iter();
    settings.filter(move |(name, value)| defaults.0.get(name) != Some(value))
}

/// A mesh as a word of a command.
fn named(mesh: &MeshArgument) -> String {
    match mesh.path() {
        Some(path) => path.to_string_lossy().into_owned(),
        None => mesh.to_string(),
    }
}

/// The same wherever it is read from.
fn absolute(mesh: &MeshArgument) -> String {
    let path = mesh.path().map(|path| std::path::absolute(path).unwrap_or_else(|_| path.to_owned()));
    path.map_or_else(|| mesh.to_string(), |path| path.to_string_lossy().into_owned())
}

/// Words as a shell takes them.
pub fn for_shell(words: &[String]) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./:,=+%@".contains(c);
    let quoted = words.iter().map(|word| {
        let needs_quotes = word.is_empty() || !word.chars().all(is_plain);
        if needs_quotes { format!("'{}'", word.replace('\'', r"'\''")) } else { word.clone() }
    });
    ["silhouettes".to_owned()].into_iter().chain(quoted).collect::<Vec<_>>().join(" ")
}

/// Files that are being written.
#[derive(Default)]
pub struct Saving {
    /// The name of the file to write.
    pub file: String,
    writing: Option<(String, Job<Result<(), Failure>>)>,
    is_cancelled: bool,
    asked: Option<Job<Option<PathBuf>>>,
}

impl Saving {
    /// Begins to write what is on screen.
    pub fn begin(&mut self, wake: &Wake, registry: &Registry, shown: &Shown<'_>, messages: &mut Messages) {
        let file = self.file.trim().to_owned();
        if file.is_empty() {
            return messages.error("give the file a name that ends in .svg, .pdf, .dxf, .png or .toml");
        }
        match shown.order(&file) {
            Ok(order) => {
                let registry = registry.clone();
                let named = file.clone();
                self.is_cancelled = false;
                self.writing = Some((file, Job::start(wake, move |_| carry_out(order, &named, &registry))));
            }
            Err(failure) => messages.error(failure),
        }
    }

    /// Asks the system's dialog for a name.
    pub fn browse(&mut self, wake: &Wake) {
        let asked = rfd::AsyncFileDialog::new().set_file_name(&self.file).save_file();
        let name = move || pollster::block_on(asked).map(|file| file.path().to_owned());
        self.asked = Some(Job::start(wake, move |_| name()));
    }

    /// Takes what has been done.
    pub fn update(&mut self, messages: &mut Messages) {
        if let Some((file, job)) = &self.writing
            && let Some(result) = job.poll()
        {
            job.notes().iter().for_each(|note| messages.note(note));
            match result {
                Ok(Ok(())) => messages.note(format_args!("{file}: written")),
                Ok(Err(_)) if self.is_cancelled => messages.note(format_args!("{file}: cancelled, not written")),
                Ok(Err(failure)) => messages.error(failure),
                Err(died) => messages.error(died),
            }
            self.writing = None;
        }
        if let Some(result) = self.asked.as_ref().and_then(Job::poll) {
            self.asked = None;
            if let Ok(Some(path)) = result {
                self.file = path.to_string_lossy().into_owned();
            }
        }
    }

    /// Whether a file is being written.
    pub fn is_busy(&self) -> bool {
        self.writing.is_some()
    }

    /// How far that is, while a file is being written, and the name of the file.
    pub fn stage(&self) -> Option<(String, Stage)> {
        self.writing.as_ref().map(|(file, job)| (file.clone(), job.stage()))
    }

    /// Writes the file no further, unless it is whole by then; what was there before stays.
    pub fn cancel(&mut self) {
        if let Some((_, job)) = &self.writing {
            job.cancel();
            self.is_cancelled = true;
        }
    }
}

fn carry_out(order: Order, file: &str, registry: &Registry) -> Result<(), Failure> {
    match order {
        Order::Command(words) => execute(words, registry),
        Order::Scene(text) => write(FilePath::new(file), text.as_bytes()),
    }
}

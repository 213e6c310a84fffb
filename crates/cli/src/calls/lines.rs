//! Lines of meshes that the caller has in memory, by words of the command `lines`.

use super::{IN_MEMORY, of_words, with};
use crate::PROGRAM;
use crate::args::Command;
use crate::failure::{Failure, usage};
use crate::lines::{self, LinesArguments, Shown};
use crate::methods;
use clap::ArgMatches;
use clap::parser::ValueSource;
use silhouette_compare::Registry;
use silhouette_core::Progress;
use silhouette_core::load::LabelledMesh;
use silhouette_visibility::{LineOptions, LineScene};
use std::path::Path;

/// Options that are of a file alone, besides those of pages and pens.
const OF_FILES: [&str; 6] = ["output", "threads", "quick", "smooth", "stats", "layers"];

fn arguments(words: &[String], registry: &Registry) -> Result<Box<LinesArguments>, Failure> {
    match of_words("lines", words, registry)? {
        Command::Lines(arguments) => Ok(arguments),
        _ => unreachable!("the command is lines"),
    }
}

/// What words of `lines` want of a mesh.
pub struct WantedLines(Box<LinesArguments>);

impl WantedLines {
    /// The lines that words want.
    ///
    /// # Errors
    /// [`Failure::Input`]: a word does not fit, or is of cameras or of files.
    pub fn of_words(words: &[String], registry: &Registry) -> Result<Self, Failure> {
        let command = methods::command(registry);
        let given = [PROGRAM, "lines"].into_iter().chain(words.iter().map(String::as_str)).chain([IN_MEMORY]);
        let matches = command.clone().try_get_matches_from(given).map_err(|error| usage(&error, PROGRAM))?;
        if let (Some(lines), Some(matches)) = (command.find_subcommand("lines"), matches.subcommand_matches("lines")) {
            refuse_what_would_be_ignored(lines, matches)?;
        }
        Ok(Self(arguments(&with(words, [IN_MEMORY]), registry)?))
    }

    /// Which kinds of line.
    pub fn options(&self) -> LineOptions {
        self.0.line_options()
    }

    /// Whether the scene is the mesh itself: nothing is left out, joined, turned or cut, and no border of materials is wanted.
    pub fn takes_mesh_as_it_is(&self) -> bool {
        let LinesArguments { weld, heal, orient, parts, .. } = &*self.0;
        let is_whole = parts.only.is_empty() && parts.without.is_empty() && parts.mask.is_empty();
        let is_unchanged = weld.is_none() && heal.is_none() && !orient.orient && self.0.sections().is_empty();
        is_whole && is_unchanged && !self.0.wants_materials()
    }

    /// The scene in which the lines of a mesh are found: of an outline, without masks.
    ///
    /// # Errors
    /// [`Failure`]: an option does not fit the mesh, or the work was cancelled.
    pub fn scene(&self, name: &str, mesh: LabelledMesh, progress: &dyn Progress) -> Result<LineScene, Failure> {
        let shown = Shown::of(vec![(name.to_owned(), mesh)], &self.0, progress)?;
        match &shown.drawn {
            Some(drawn) if self.options().outline => Ok(drawn.clone()),
            _ => shown.masked_scene(),
        }
    }
}

/// Refuses options of the command `lines` that say nothing of which lines are found.
fn refuse_what_would_be_ignored(lines: &clap::Command, matches: &ArgMatches) -> Result<(), Failure> {
    for option in lines.get_arguments() {
        let (id, heading) = (option.get_id().as_str(), option.get_help_heading().unwrap_or_default());
        if matches.value_source(id) != Some(ValueSource::CommandLine) {
            continue;
        }
        let name = option.get_long().unwrap_or(id);
        if heading == "Camera" {
            return Err(Failure::Input(format!("--{name}: is an option of cameras; give it to the camera")));
        }
        if heading.starts_with("Page") || heading.starts_with("Pens") || OF_FILES.contains(&id) {
            return Err(Failure::Input(format!("--{name}: is an option of files; give it to what writes one")));
        }
    }
    Ok(())
}

/// What words of `lines` make of a mesh before its lines are found: some of its parts, welded, healed, turned, cut open.
///
/// # Errors
/// [`Failure`]: a word does not fit the mesh, or the work was cancelled.
pub fn changed_mesh(
    words: &[String],
    name: &str,
    mesh: LabelledMesh,
    registry: &Registry,
    progress: &dyn Progress,
) -> Result<LabelledMesh, Failure> {
    lines::changed(name, mesh, &*arguments(&with(words, [IN_MEMORY]), registry)?, progress)
}

/// Writes the file that words of `lines`, a camera's among them, make of these meshes.
///
/// # Errors
/// [`Failure`]: a word or a mesh does not fit, the file cannot be written, or the work was cancelled.
pub fn write_lines(
    words: &[String],
    meshes: Vec<(String, LabelledMesh)>,
    path: &Path,
    registry: &Registry,
    progress: &dyn Progress,
) -> Result<(), Failure> {
    let words = with(words, meshes.iter().map(|_| IN_MEMORY));
    let mut arguments = arguments(&words, registry)?;
    arguments.output = Some(path.to_owned());
    lines::write(&arguments, meshes, progress)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wanted(words: &[&str]) -> Result<WantedLines, Failure> {
        let words: Vec<String> = words.iter().copied().map(str::to_owned).collect();
        WantedLines::of_words(&words, &Registry::builtin())
    }

    #[test]
    fn options_that_would_be_ignored_are_refused() {
        for word in ["--page=a4", "--width=2", "--stats", "--output=x.svg", "--view=front", "--views=top", "--smooth"] {
            let refused = wanted(&[word]).err().map(|failure| failure.to_string()).unwrap_or_default();
            assert!(refused.contains("is an option of"), "{word}: {refused}");
        }
    }

    #[test]
    fn a_mesh_is_taken_as_it_is_unless_an_option_changes_it() {
        for words in [&[][..], &["--hidden=solid", "--creases=30"], &["--outline=only"]] {
            assert!(wanted(words).unwrap().takes_mesh_as_it_is(), "{words:?}");
        }
        for word in ["--weld", "--heal", "--orient", "--only=a", "--without=a", "--mask=a", "--materials"] {
            assert!(!wanted(&[word]).unwrap().takes_mesh_as_it_is(), "{word}");
        }
        assert!(!wanted(&["--section=0,0,0,1,0,0"]).unwrap().takes_mesh_as_it_is());
    }
}

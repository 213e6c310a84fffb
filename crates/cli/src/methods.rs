//! `silhouettes methods`: what each method says of itself, and its options.

use crate::args::{Arguments, MethodsArguments};
use crate::failure::Failure;
use crate::output::Output;
use clap::CommandFactory;
use serde::Serialize;
use silhouette_compare::registry::{Capabilities, Entry, Registry};
use silhouette_core::MethodInfo;
use std::fmt::Write;

/// Runs the command.
pub fn run(arguments: &MethodsArguments, registry: &Registry) -> Result<(), Failure> {
    let entries = match &arguments.method {
        Some(name) => std::slice::from_ref(registry.find(name).map_err(Failure::input)?),
        None => registry.entries(),
    };
    let text = if arguments.json {
        json(entries)?
    } else if arguments.method.is_some() {
        entries.iter().map(in_full).collect()
    } else {
        entries.iter().map(in_short).collect::<Vec<_>>().join("\n")
    };
    Output::Stdout.write(text.as_bytes())
}

/// Has every option take a number below 0 for its value, and not for another option: what refuses it then says what fits.
fn with_numbers_below_0(command: clap::Command) -> clap::Command {
    command.mut_args(|argument| {
        let takes_values = argument.get_long().is_some() && argument.get_action().takes_values();
        if takes_values { argument.allow_negative_numbers(true) } else { argument }
    })
}

/// The command line with the names of this registry's methods where one is asked for.
pub fn command(registry: &Registry) -> clap::Command {
    let names = |is_wanted: fn(Capabilities) -> bool| registry.names(|entry| is_wanted(entry.capabilities()));
    let with_names = |command: clap::Command, argument: &'static str, names: String| {
        command.mut_arg(argument, |argument| {
            let help = argument.get_help().map(ToString::to_string).unwrap_or_default();
            argument.help(format!("{help}: {names}. `silhouettes methods` describes them"))
        })
    };
    Arguments::command()
        .mut_subcommands(with_numbers_below_0)
        .mut_subcommand("extract", |command| with_names(command, "method", names(|can| can.edges || can.curves)))
        .mut_subcommand("render", |command| {
            with_names(command, "method", names(|can| can.edges || can.lines || can.fill))
        })
        .mut_subcommand("smooth", |command| with_names(command, "method", names(|can| can.triangles || can.fill)))
        .mut_subcommand("compare", |command| with_names(command, "methods", names(|_| true)))
}

/// One method as JSON.
#[derive(Serialize)]
struct Row {
    #[serde(flatten)]
    info: &'static MethodInfo,
    capabilities: Capabilities,
}

fn json(entries: &[Entry]) -> Result<String, Failure> {
    let rows: Vec<Row> =
        entries.iter().map(|entry| Row { info: entry.info(), capabilities: entry.capabilities() }).collect();
    Ok(serde_json::to_string_pretty(&rows).map_err(Failure::run)? + "\n")
}

/// A paragraph: the name, what it yields, and when to choose it.
fn in_short(entry: &Entry) -> String {
    let guide = &entry.info().guide;
    let said = |heading: &str, text: &str| if text.is_empty() { String::new() } else { format!("  {heading}{text}\n") };
    format!("{}\n{}{}", entry.info().name, said("yields ", guide.yields), said("choose it when ", guide.choose_when))
}

/// All that a method says of itself.
fn in_full(entry: &Entry) -> String {
    let info = entry.info();
    let source = &info.source;
    let mut text = format!("{}\n  {}\n\n", info.name, info.summary);
    let published = format!("{}, \"{}\", {} {}", source.authors, source.title, source.venue, source.year);
    let needs = if info.needs.is_empty() { "triangles".to_owned() } else { info.needs.join(", ") };
    let texts = info.guide.texts().map(|(heading, text)| (heading, text.to_owned()));
    for (heading, said) in [("published", published), ("needs", needs)].into_iter().chain(texts) {
        if !said.is_empty() {
            let _ = writeln!(text, "  {heading:<15} {said}");
        }
    }
    let headings = ["option", "default", "what it sets"];
    let mut rows = vec![headings.map(str::to_owned)];
    for option in info.options {
        let swept = option.sweep.map(|sweep| format!("; swept over {sweep}")).unwrap_or_default();
        let sets = format!("{}; {}{swept}", option.summary.trim_end_matches('.'), option.expected());
        rows.push([option.name.to_owned(), option.default_value().to_string(), sets]);
    }
    if rows.len() > 1 {
        let [name, value] = [0, 1].map(|column| rows.iter().map(|row| row[column].len()).max().unwrap_or(0));
        text.push('\n');
        for [option, default, sets] in rows {
            let _ = writeln!(text, "  {option:<name$}  {default:<value$}  {sets}");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn help_names_the_methods_of_the_registry() {
        let registry = Registry::builtin();
        let mut command = command(&registry);
        command.build();
        for (name, known, foreign) in [
            ("extract", "tracking-exact", "jump-flood"),
            ("render", "jump-flood", "interpolated-contours"),
            ("smooth", "pn-triangles", "brute-force"),
            ("compare", "texture", "no-such"),
        ] {
            let help = command.find_subcommand_mut(name).expect("it is a command").render_long_help().to_string();
            let help = help.split_whitespace().collect::<Vec<_>>().join(" ");
            let methods = &help[help.find("silhouettes methods").map_or(0, |at| at.saturating_sub(600))..];
            assert!(methods.contains(known), "{name}: {help}");
            assert!(!help.contains(&format!(", {foreign}")), "{name}: {help}");
        }
    }

    #[test]
    fn a_number_below_0_is_taken_for_a_value_and_refused_by_what_fits() {
        let refused = |words: &[&str]| {
            let words = ["silhouettes"].iter().chain(words);
            let error = command(&Registry::builtin()).try_get_matches_from(words).unwrap_err();
            match crate::failure::usage(&error, crate::PROGRAM) {
                Failure::Input(line) => line,
                other => panic!("{other:?}"),
            }
        };
        for (words, expected) in [
            (["lines", "builtin:cube", "--ortho", "-1"], "a height above 0"),
            (["lines", "builtin:cube", "--fov", "-1"], "--fov"),
            (["compare", "-oreport", "--budget", "-1"], "seconds above 0"),
        ] {
            let line = refused(&words);
            assert!(line.contains(expected) && !line.contains("-- -1"), "{line}");
        }
    }
}

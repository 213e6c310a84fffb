//! `docs/STABILITY.md`: a table per family, what is expected and why, the texts of refusals.

use crate::cell::{Aspect, Cell, Outcome};
use crate::families::Family;
use crate::row::Row;
use std::collections::BTreeMap;
use std::fmt::Write;

/// The page, below the project's root.
pub const FILE: &str = "docs/STABILITY.md";

/// What stands on the page of a family: what goes in, the outcomes, the reasons, the refusals.
pub fn section(family: &Family, rows: &[Row], cells: &[Cell]) -> String {
    let mut text = String::new();
    for row in rows {
        let beside = if row.plain_name == "torus" { String::new() } else { format!("; beside: {}", row.plain_name) };
        let _ = writeln!(text, "- **{}**: {}{beside}.", row.name, row.input);
    }
    text += "\n";
    text += &if family.is_about_options { list(rows, cells) } else { table(rows, cells) };
    text += &reasons(rows, cells);
    text += &refusals(rows, cells);
    text
}

/// A row for each method and what it yields, a column for each extreme.
fn table(rows: &[Row], cells: &[Cell]) -> String {
    let mut lines: Vec<(&str, Aspect)> = Vec::new();
    for cell in cells {
        if !lines.contains(&(cell.method, cell.aspect)) {
            lines.push((cell.method, cell.aspect));
        }
    }
    let head: String = rows.iter().map(|row| format!(" {} |", row.name)).collect();
    let mut text = format!("| method, yields |{head}\n|---|{}\n", "---|".repeat(rows.len()));
    for aspect in Aspect::ALL {
        for &(method, _) in lines.iter().filter(|line| line.1 == aspect) {
            let of_row = |row: &Row| {
                let is_it = |cell: &&Cell| (cell.row, cell.method, cell.aspect) == (row.name, method, aspect);
                cells.iter().find(is_it).map_or(String::new(), shown)
            };
            let outcomes: String = rows.iter().map(|row| format!(" {} |", of_row(row))).collect();
            let _ = writeln!(text, "| `{method}` {} |{outcomes}", aspect.name());
        }
    }
    text + "\n"
}

/// A line for each extreme, with the methods that it concerns.
fn list(rows: &[Row], cells: &[Cell]) -> String {
    let mut text =
        "| extreme | outcomes; of all other methods n/a, as they have no such option |\n|---|---|\n".to_owned();
    for row in rows {
        let concerned = cells.iter().filter(|cell| cell.row == row.name);
        let concerned = concerned.filter(|cell| cell.found.outcome != Outcome::NotApplicable);
        let outcomes = concerned.map(|cell| format!("`{}` {}: {}", cell.method, cell.aspect.name(), shown(cell)));
        let _ = writeln!(text, "| {} | {} |", row.name, outcomes.collect::<Vec<_>>().join("<br>"));
    }
    text + "\n"
}

/// The word, and what was measured where it is short.
fn shown(cell: &Cell) -> String {
    let word = cell.found.outcome.word();
    match cell.found.outcome {
        Outcome::Refused | Outcome::Fault | Outcome::NotApplicable => word.to_owned(),
        _ if cell.found.text.is_empty() => word.to_owned(),
        _ => format!("{word} {}", cell.found.text),
    }
}

/// Names with what they yield, those of one text together, in order.
fn grouped<'a>(cells: impl Iterator<Item = (&'a Cell, String)>) -> Vec<(String, Vec<&'a Cell>)> {
    let mut groups: Vec<(String, Vec<&Cell>)> = Vec::new();
    for (cell, key) in cells {
        match groups.iter_mut().find(|(known, _)| *known == key) {
            Some((_, cells)) => cells.push(cell),
            None => groups.push((key, vec![cell])),
        }
    }
    groups
}

fn names(cells: &[&Cell], all: usize) -> String {
    if cells.len() == all {
        return "every method".to_owned();
    }
    let mut by_aspect: BTreeMap<Aspect, Vec<String>> = BTreeMap::new();
    for cell in cells {
        by_aspect.entry(cell.aspect).or_default().push(format!("`{}`", cell.method));
    }
    let parts = by_aspect.iter().map(|(aspect, names)| format!("{} of {}", aspect.name(), names.join(", ")));
    parts.collect::<Vec<_>>().join("; ")
}

fn reasons(rows: &[Row], cells: &[Cell]) -> String {
    let mut text = String::new();
    for row in rows {
        let of_row: Vec<&Cell> = cells.iter().filter(|cell| cell.row == row.name).collect();
        let with_reason = of_row.iter().filter_map(|cell| {
            let expected = row.expected_of(cell.method, cell.aspect);
            let is_told = !expected.why.is_empty() && cell.found.outcome != Outcome::NotApplicable;
            is_told.then(|| (*cell, format!("{}: {}", expected.outcome.word(), expected.why)))
        });
        for (why, of) in grouped(with_reason) {
            // What holds in every row is said once, above the tables.
            if of.iter().all(|cell| cell.method == "randomized") {
                continue;
            }
            let _ = writeln!(text, "- *{}*, {}: {why}.", row.name, names(&of, of_row.len()));
        }
    }
    if text.is_empty() { text } else { format!("Why:\n\n{text}\n") }
}

fn refusals(rows: &[Row], cells: &[Cell]) -> String {
    let mut text = String::new();
    for row in rows {
        let of_row: Vec<&Cell> = cells.iter().filter(|cell| cell.row == row.name).collect();
        let refused = of_row.iter().filter(|cell| cell.found.outcome == Outcome::Refused);
        for (message, of) in grouped(refused.map(|cell| (*cell, cell.found.text.clone()))) {
            let _ = writeln!(text, "- *{}*, {}: “{message}”", row.name, names(&of, of_row.len()));
        }
    }
    if text.is_empty() { text } else { format!("Refusals:\n\n{text}\n") }
}

/// A section without the numbers that a device had a part in: of lines and fills, the words are left.
pub fn comparable(section: &str) -> String {
    let cell = |text: &str| {
        let words: Vec<&str> = text.split("<br>").map(|part| part.trim().split(' ').next().unwrap_or("")).collect();
        words.join(" ")
    };
    let line = |line: &str| {
        let mut cells = line.trim_matches('|').split('|').map(str::trim);
        let head = cells.next().unwrap_or("");
        let is_drawn = [Aspect::Lines, Aspect::Fill].iter().any(|aspect| head.ends_with(aspect.name()));
        let is_list = cells.clone().any(|cell| cell.contains("lines: ") || cell.contains("fill: "));
        if !line.starts_with('|') || !(is_drawn || is_list) {
            return line.to_owned();
        }
        if is_list {
            let parts = cells.flat_map(|cell| cell.split("<br>").map(without_measure).collect::<Vec<_>>());
            return format!("{head} {}", parts.collect::<Vec<_>>().join(" "));
        }
        format!("{head} {}", cells.map(cell).collect::<Vec<_>>().join(" "))
    };
    section.lines().map(line).collect::<Vec<_>>().join("\n")
}

/// `` `method` lines: same 0.1 % `` without what follows the word.
fn without_measure(part: &str) -> String {
    part.split(' ').take(3).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_pictures_do_not_count_and_all_else_does() {
        let page = |edges: &str, lines: &str, fill: &str| {
            format!(
                "- **a**: b.\n| `m` edges | exact {edges} |\n| `m` lines | same {lines} |\n| a | `n` fill: {fill} |"
            )
        };
        let same = |a: String, b: String| comparable(&a) == comparable(&b);
        let plain = || page("0/74", "0.1 %", "same 0.2 %");
        assert!(same(plain(), page("0/74", "0.3 %", "same 9.9 %")));
        assert!(!same(plain(), page("1/74", "0.1 %", "same 0.2 %")));
        assert!(!same(plain(), page("0/74", "0.1 %", "differs 0.2 %")));
        assert!(!same(plain(), plain().replace("same 0.1", "differs 0.1")));
        assert!(!same(plain(), plain().replace("b.", "c.")));
    }
}

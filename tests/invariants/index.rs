//! The index names each invariant once, with tests that exist.

use crate::tidy::root;
use std::path::Path;

const COUNT: usize = 46;

/// What the index says wrongly: numbers out of order, rows without a test, and tests that are not there.
fn faults(index: &str, root: &Path) -> Vec<String> {
    let mut faults = Vec::new();
    let rows: Vec<&str> = index.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| |")).collect();
    for (row, number) in rows.iter().zip(1..) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        if cells[1] != number.to_string() {
            faults.push(format!("row {number} is numbered {}", cells[1]));
        }
        let tests: Vec<&str> = cells[3].split('`').skip(1).step_by(2).collect();
        if tests.is_empty() {
            faults.push(format!("{number} has no test"));
        }
        faults.extend(tests.into_iter().filter(|test| !is_test(test, root)).map(|test| format!("{number}: no {test}")));
    }
    if rows.len() != COUNT {
        faults.push(format!("{} invariants", rows.len()));
    }
    faults
}

/// Whether `FILE: NAME` is a function with `#[test]` before it.
fn is_test(test: &str, root: &Path) -> bool {
    let Some((file, name)) = test.split_once(": ") else { return false };
    let Ok(text) = std::fs::read_to_string(root.join(file)) else { return false };
    let Some(at) = text.find(&format!("fn {name}(")) else { return false };
    let before: Vec<&str> = text[..at].lines().rev().take_while(|line| !line.trim_start().starts_with('}')).collect();
    before.iter().any(|line| line.trim() == "#[test]")
}

#[test]
fn every_invariant_has_a_test_that_exists() {
    let index = std::fs::read_to_string(root().join("docs/INVARIANTS.md")).unwrap();
    assert_eq!(faults(&index, &root()), Vec::<String>::new());
}

#[test]
fn a_wrong_index_is_reported() {
    let index = std::fs::read_to_string(root().join("docs/INVARIANTS.md")).unwrap();
    for (right, wrong) in [
        ("any_soup_makes_loops", "any_soup_makes_hoops"),
        ("tests/cut_sets.rs: front", "tests/cut.rs: front"),
        ("| 7 |", "| 70 |"),
        ("`crates/render/tests/gpu/hidden_lines.rs: the", "`crates/render/tests/gpu/hidden_lines.rs, the"),
        // A function that is no test.
        ("any_soup_makes_loops", "check_loops"),
    ] {
        assert!(index.contains(right), "{right}");
        assert_eq!(faults(&index.replacen(right, wrong, 1), &root()).len(), 1, "{wrong}");
    }
    let without_a_row: Vec<&str> = index.lines().filter(|line| !line.starts_with("| 46 |")).collect();
    assert_eq!(faults(&without_a_row.join("\n"), &root()), ["45 invariants"]);
}

//! What a cell is called where a method may occur several times.

use super::Cell;
use crate::options::OptionSettings;

/// The options in which a cell differs from some other cell of the same method. Empty where the method occurs with one set
/// of options only. O(cells x options).
pub fn distinguishing_options(cell: &Cell, cells: &[Cell]) -> OptionSettings {
    let others = || cells.iter().filter(|other| other.method == cell.method);
    let differs = |name: &String| others().any(|other| other.options.0.get(name) != cell.options.0.get(name));
    let options = cell.options.0.iter().filter(|(name, _)| differs(name));
    OptionSettings(options.map(|(name, value)| (name.clone(), value.clone())).collect())
}

/// The method's name, followed by [`distinguishing_options`] in parentheses where there are some. O(cells x options).
pub fn label(cell: &Cell, cells: &[Cell]) -> String {
    let options = distinguishing_options(cell, cells).to_string();
    if options.is_empty() { cell.method.clone() } else { format!("{} ({options})", cell.method) }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{cell, with_option};
    use super::*;
    use crate::options::OptionSetting;

    #[test]
    fn only_options_that_differ_are_named() {
        let tracking = |level: f64| {
            let jump = with_option(cell("a", "tracking", 1.0, 1.0), "jump", OptionSetting::Number(0.5));
            with_option(jump, "concavity", OptionSetting::Number(level))
        };
        let cells = [tracking(0.0), tracking(0.25), cell("a", "brute-force", 1.0, 1.0)];
        let labels = cells.each_ref().map(|cell| label(cell, &cells));
        assert_eq!(labels, ["tracking (concavity=0)", "tracking (concavity=0.25)", "brute-force"]);
        assert_eq!(label(&cells[1], &cells[1..2]), "tracking", "alone it needs no options");
    }
}

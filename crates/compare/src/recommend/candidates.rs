//! Step 2: which methods with which options come into question.

use super::goal::Goal;
use crate::registry::{Entry, Registry};
use silhouette_core::method::{OptionValue, OptionValues};

/// How many values of a swept option are tried, both ends of its sweep among them.
pub const SWEEP_VALUES: usize = 3;

/// A method with options.
#[derive(Debug, Clone)]
pub struct Candidate {
    /// The method.
    pub entry: Entry,
    /// Its options.
    pub options: OptionValues,
    /// The option that is not at its default, if one is not.
    pub changed: Option<(&'static str, OptionValue)>,
}

impl Candidate {
    /// Name of the method.
    pub fn method(&self) -> &'static str {
        self.entry.info().name
    }

    /// What is not at its default, as `--set` takes it.
    pub fn set(&self) -> Option<String> {
        self.changed.map(|(name, value)| format!("{name}={value}"))
    }
}

/// The candidates for a goal: every method that can do it with its default options, in the order of the registry, and after them
/// the same methods with one option at a time at the values of its [sweep](silhouette_core::method::Sweep). O(values).
pub fn candidates(goal: Goal, registry: &Registry) -> Vec<Candidate> {
    let of_goal = || registry.entries().iter().filter(|entry| goal.is_met_by(entry.capabilities()));
    let default = |entry: &Entry| Candidate {
        entry: entry.clone(),
        options: OptionValues::defaults(entry.info().options),
        changed: None,
    };
    of_goal().map(default).chain(of_goal().flat_map(swept)).collect()
}

fn swept(entry: &Entry) -> Vec<Candidate> {
    let specs = entry.info().options;
    let mut candidates = Vec::new();
    for spec in specs {
        for value in spec.sweep_values(SWEEP_VALUES) {
            let word = format!("{}={value}", spec.name);
            // A sweep that leaves the range of its option is a slip of whoever declared it; its values that fit are tried.
            let Ok(options) = OptionValues::parse(specs, [word.as_str()]) else { continue };
            if value != spec.default_value() {
                candidates.push(Candidate { entry: entry.clone(), options, changed: Some((spec.name, value)) });
            }
        }
    }
    candidates
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn defaults_come_first_and_no_candidate_comes_twice() {
        for goal in Goal::ALL {
            let all = candidates(goal, &Registry::builtin());
            let defaults = all.iter().take_while(|candidate| candidate.changed.is_none()).count();
            assert!(all[defaults..].iter().all(|candidate| candidate.changed.is_some()));
            assert!(defaults < all.len(), "{}: nothing is swept", goal.name());
            let names: BTreeSet<_> = all.iter().map(|one| (one.method(), one.options.to_string())).collect();
            assert_eq!(names.len(), all.len(), "{}", goal.name());
            for candidate in &all {
                let words = candidate.set();
                let again = OptionValues::parse(candidate.entry.info().options, words.as_deref());
                assert_eq!(again.unwrap(), candidate.options);
            }
        }
    }
}

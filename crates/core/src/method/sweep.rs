//! [`Sweep`]: which values of an option are worth comparing, where the option trades speed for accuracy.

use super::options::{OptionKind, OptionSpec, OptionValue};
use std::collections::BTreeSet;

/// The values of an option that are worth comparing. [`method_options!`](crate::method_options) declares it beside the option;
/// options that trade nothing, such as colours, have none.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Sweep {
    /// Numbers between two ends, spaced evenly.
    Linear {
        /// Smallest.
        from: f64,
        /// Largest.
        to: f64,
    },
    /// Positive numbers between two ends, spaced evenly in their logarithm.
    Log {
        /// Smallest.
        from: f64,
        /// Largest.
        to: f64,
    },
    /// These words.
    Words(&'static [&'static str]),
}

impl Sweep {
    /// The number at a place from 0 to 1, to three significant digits, which is as fine as a sweep needs and a label bears.
    fn at(&self, place: f64) -> f64 {
        let number = match *self {
            // Not the product with the width alone, of which the last one could miss the end.
            Self::Linear { from, to } => from * (1.0 - place) + to * place,
            Self::Log { from, to } => (from.ln() * (1.0 - place) + to.ln() * place).exp(),
            Self::Words(_) => return f64::NAN,
        };
        format!("{number:.2e}").parse().unwrap_or(number)
    }

    /// Where a number lies between the ends: 0 to 1, beyond them where it lies outside. NaN for words, and where there is no logarithm.
    pub fn place(&self, number: f64) -> f64 {
        match *self {
            Self::Linear { from, to } => (number - from) / (to - from),
            Self::Log { from, to } => (number / from).ln() / (to / from).ln(),
            Self::Words(_) => f64::NAN,
        }
    }
}

impl std::fmt::Display for Sweep {
    /// As in `0.001 to 0.3, logarithmically`.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Linear { from, to } => write!(f, "{from} to {to}"),
            Self::Log { from, to } => write!(f, "{from} to {to}, logarithmically"),
            Self::Words(words) => f.write_str(&words.join(", ")),
        }
    }
}

impl OptionSpec {
    /// At most `count` values of the [sweep](Self::sweep), spread over it with both ends among them, ascending; whole numbers are
    /// rounded, and of words there are always all. Empty where there is no sweep. O(count log count).
    pub fn sweep_values(&self, count: usize) -> Vec<OptionValue> {
        let Some(sweep) = self.sweep else { return Vec::new() };
        if let Sweep::Words(words) = sweep {
            return words.iter().map(|&word| OptionValue::Choice(word)).collect();
        }
        let numbers = (0..count).map(|at| sweep.at(at as f64 / (count.max(2) - 1) as f64));
        if let OptionKind::Whole { .. } = self.kind {
            let whole: BTreeSet<u32> = numbers.map(|number| number.round() as u32).collect();
            return whole.into_iter().map(OptionValue::Whole).collect();
        }
        numbers.map(OptionValue::Number).collect()
    }

    /// The value in the middle of two by the scale of the [sweep](Self::sweep); `None` where nothing lies between them, as between
    /// words, consecutive whole numbers, or a number where a logarithm has none.
    pub fn sweep_between(&self, one: OptionValue, other: OptionValue) -> Option<OptionValue> {
        let sweep = self.sweep?;
        let number = |value: OptionValue| match value {
            OptionValue::Number(number) => Some(number),
            OptionValue::Whole(number) => Some(f64::from(number)),
            OptionValue::Choice(_) => None,
        };
        let (one, other) = (number(one)?, number(other)?);
        let middle = sweep.at((sweep.place(one) + sweep.place(other)) * 0.5);
        let whole = matches!(self.kind, OptionKind::Whole { .. });
        let middle = if whole { middle.round() } else { middle };
        let is_between = one.min(other) < middle && middle < one.max(other);
        is_between.then_some(if whole { OptionValue::Whole(middle as u32) } else { OptionValue::Number(middle) })
    }
}

#[cfg(test)]
mod tests {
    use crate::method::{MethodOptions, OptionValue};

    crate::option_choice! {
        /// A rule.
        enum Rule {
            /// One.
            Fast = "fast",
            /// Another.
            Good = "good",
            /// A third.
            Printed = "as-printed",
        }
    }

    crate::method_options! {
        /// Options.
        struct Options {
            /// A level.
            level: f64 = number("level", 0.0..=3.2 "rad", default 0.5, sweep linear 0.0..=1.6),
            /// A share.
            share: f64 = number("share", 0.0..=1.0, default 0.01, sweep log 0.001..=0.3),
            /// A count.
            count: u32 = whole("count", 0..=99, default 3, sweep linear 0..=4),
            /// A rule.
            rule: Rule = choice("rule", sweep ["fast", "good"]),
            /// A colour.
            red: f64 = number("red", 0.0..=1.0, default 0.0),
        }
    }

    fn texts(name: usize, count: usize) -> Vec<String> {
        Options::SPECS[name].sweep_values(count).iter().map(OptionValue::to_string).collect()
    }

    #[test]
    fn values_are_spread_over_the_sweep_with_both_ends() {
        assert_eq!(texts(0, 5), ["0", "0.4", "0.8", "1.2", "1.6"]);
        assert_eq!(texts(1, 3), ["0.001", "0.0173", "0.3"]);
        assert_eq!(texts(2, 3), ["0", "2", "4"]);
        assert_eq!(texts(2, 50), ["0", "1", "2", "3", "4"], "each whole number once");
        assert_eq!(texts(3, 1), ["fast", "good"]);
        assert!(texts(4, 9).is_empty() && texts(0, 0).is_empty());
        assert_eq!(texts(0, 1), ["0"]);
    }

    #[test]
    fn the_middle_is_that_of_the_scale() {
        let between = |name: usize, one, other| Options::SPECS[name].sweep_between(one, other);
        assert_eq!(between(0, OptionValue::Number(0.4), OptionValue::Number(0.0)), Some(OptionValue::Number(0.2)));
        assert_eq!(between(1, OptionValue::Number(0.01), OptionValue::Number(0.1)), Some(OptionValue::Number(0.0316)));
        assert_eq!(between(2, OptionValue::Whole(1), OptionValue::Whole(4)), Some(OptionValue::Whole(3)));
        assert_eq!(between(2, OptionValue::Whole(1), OptionValue::Whole(2)), None);
        assert_eq!(between(1, OptionValue::Number(0.0), OptionValue::Number(0.1)), None, "zero has no logarithm");
        assert_eq!(between(0, OptionValue::Number(0.5), OptionValue::Number(0.5)), None);
        assert_eq!(between(3, OptionValue::Choice("fast"), OptionValue::Choice("good")), None);
    }

    #[test]
    fn every_value_of_a_sweep_fits_its_option() {
        for spec in Options::SPECS {
            for value in spec.sweep_values(17) {
                assert!(Options::parse([format!("{}={value}", spec.name).as_str()]).is_ok(), "{} {value}", spec.name);
            }
        }
    }
}

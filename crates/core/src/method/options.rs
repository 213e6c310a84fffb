//! Options of a method as data: specified once, parsed from `name=value`, checked against their range.
//!
//! A method's options are a struct ([`MethodOptions`](super::MethodOptions)); what is here is the form that a command line,
//! a report or a file of results needs of any method's options.

use super::sweep::Sweep;
use std::collections::BTreeMap;

/// One option of a method. [`method_options!`](crate::method_options) makes them from the fields of a struct.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct OptionSpec {
    /// Name in kebab case.
    pub name: &'static str,
    /// What it sets, with its effect at both ends.
    pub summary: &'static str,
    /// Unit of the value; empty for a ratio or a choice.
    pub unit: &'static str,
    /// Type, range and default.
    pub kind: OptionKind,
    /// Values worth comparing, where the option trades speed for accuracy.
    pub sweep: Option<Sweep>,
}

/// Type, range and default of an option.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum OptionKind {
    /// A number in a closed range.
    Number {
        /// Smallest value.
        min: f64,
        /// Largest value.
        max: f64,
        /// Value where none is given.
        default: f64,
    },
    /// A whole number in a closed range.
    Whole {
        /// Smallest value.
        min: u32,
        /// Largest value.
        max: u32,
        /// Value where none is given.
        default: u32,
    },
    /// One of several words; the first is the default.
    Choice(&'static [&'static str]),
}

/// Why an option was refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OptionError {
    /// Not of the form `name=value`.
    #[error("'{text}' is not of the form name=value")]
    Form {
        /// What was given.
        text: String,
    },
    /// The method has no option of this name.
    #[error("there is no option '{name}'; {known}")]
    Unknown {
        /// What was given.
        name: String,
        /// The options that exist, as a clause.
        known: String,
    },
    /// The value is not a number, out of range or not one of the choices.
    #[error("{name}={value} does not fit: {expected}")]
    Value {
        /// The option.
        name: &'static str,
        /// What was given.
        value: String,
        /// What fits.
        expected: String,
    },
    /// The values were made from the options of another method.
    #[error("there is no value for '{name}'; make the values from this method's own options")]
    Foreign {
        /// The option that is missing.
        name: &'static str,
    },
}

/// The value of an option. Serialises as the bare number or word.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[serde(untagged)]
pub enum OptionValue {
    /// Of a [number](OptionKind::Number).
    Number(f64),
    /// Of a [whole number](OptionKind::Whole).
    Whole(u32),
    /// Of a [choice](OptionKind::Choice).
    Choice(&'static str),
}

/// A checked value for every option of one method. Serialises as a map, sorted by name.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[serde(transparent)]
pub struct OptionValues(BTreeMap<&'static str, OptionValue>);

impl OptionSpec {
    /// The value where none is given.
    pub fn default_value(&self) -> OptionValue {
        match self.kind {
            OptionKind::Number { default, .. } => OptionValue::Number(default),
            OptionKind::Whole { default, .. } => OptionValue::Whole(default),
            OptionKind::Choice(words) => OptionValue::Choice(words.first().copied().unwrap_or_default()),
        }
    }

    /// What fits, as a noun phrase such as `a number from 0 to 1 px`.
    pub fn expected(&self) -> String {
        match self.kind {
            OptionKind::Number { min, max, .. } => {
                format!("a number from {min} to {max} {}", self.unit).trim_end().to_owned()
            }
            OptionKind::Whole { min, max, .. } => {
                format!("a whole number from {min} to {max} {}", self.unit).trim_end().to_owned()
            }
            OptionKind::Choice(words) => format!("one of {}", words.join(", ")),
        }
    }

    fn fits(&self, value: OptionValue) -> bool {
        match (self.kind, value) {
            (OptionKind::Number { min, max, .. }, OptionValue::Number(number)) => (min..=max).contains(&number),
            (OptionKind::Whole { min, max, .. }, OptionValue::Whole(number)) => (min..=max).contains(&number),
            (OptionKind::Choice(words), OptionValue::Choice(word)) => words.contains(&word),
            _ => false,
        }
    }

    /// The value that a text stands for, whether it fits or not.
    fn read(&self, text: &str) -> Option<OptionValue> {
        match self.kind {
            OptionKind::Number { .. } => text.parse().ok().map(OptionValue::Number),
            OptionKind::Whole { .. } => text.parse().ok().map(OptionValue::Whole),
            OptionKind::Choice(words) => {
                words.iter().find(|&&word| word == text).map(|&word| OptionValue::Choice(word))
            }
        }
    }

    fn check(&self, value: Option<OptionValue>, text: impl std::fmt::Display) -> Result<OptionValue, OptionError> {
        value.filter(|&value| self.fits(value)).ok_or_else(|| OptionError::Value {
            name: self.name,
            value: text.to_string(),
            expected: self.expected(),
        })
    }
}

impl OptionValues {
    /// Every option of `specs` at its default.
    pub fn defaults(specs: &'static [OptionSpec]) -> Self {
        Self(specs.iter().map(|spec| (spec.name, spec.default_value())).collect())
    }

    /// Given values, one for each of `specs` and in their order; missing ones are left at their defaults.
    ///
    /// # Errors
    /// [`OptionError::Value`] names the first that is out of range.
    pub fn checked(
        specs: &'static [OptionSpec],
        values: impl IntoIterator<Item = OptionValue>,
    ) -> Result<Self, OptionError> {
        let mut checked = Self::defaults(specs);
        for (spec, value) in specs.iter().zip(values) {
            checked.0.insert(spec.name, spec.check(Some(value), value)?);
        }
        Ok(checked)
    }

    /// Defaults overridden by `name=value` words; of two for the same name the later one counts.
    ///
    /// # Errors
    /// [`OptionError`] names the first word that does not fit and what would.
    pub fn parse<'a>(
        specs: &'static [OptionSpec],
        words: impl IntoIterator<Item = &'a str>,
    ) -> Result<Self, OptionError> {
        let mut values = Self::defaults(specs);
        for word in words {
            let (name, text) = word.split_once('=').ok_or_else(|| OptionError::Form { text: word.to_owned() })?;
            let spec = specs.iter().find(|spec| spec.name == name).ok_or_else(|| unknown(name, specs))?;
            values.0.insert(spec.name, spec.check(spec.read(text), text)?);
        }
        Ok(values)
    }

    /// The value of an option, if there is one of this name.
    pub fn get(&self, name: &str) -> Option<OptionValue> {
        self.0.get(name).copied()
    }

    /// Names and values, sorted by name.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (&'static str, OptionValue)> + '_ {
        self.0.iter().map(|(&name, &value)| (name, value))
    }
}

impl std::fmt::Display for OptionValue {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Whole(number) => write!(f, "{number}"),
            Self::Choice(word) => f.write_str(word),
        }
    }
}

impl std::fmt::Display for OptionValues {
    /// `name=value` words separated by spaces; parsing them gives the same values.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (index, (name, value)) in self.iter().enumerate() {
            let gap = if index == 0 { "" } else { " " };
            write!(f, "{gap}{name}={value}")?;
        }
        Ok(())
    }
}

fn unknown(name: &str, specs: &[OptionSpec]) -> OptionError {
    let known = match specs {
        [] => "the method has none".to_owned(),
        specs => format!("there are {}", specs.iter().map(|spec| spec.name).collect::<Vec<_>>().join(", ")),
    };
    OptionError::Unknown { name: name.to_owned(), known }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPECS: &[OptionSpec] = &[
        OptionSpec {
            name: "scale",
            summary: "",
            unit: "px",
            kind: OptionKind::Number { min: 0.0, max: 1.0, default: 0.5 },
            sweep: None,
        },
        OptionSpec {
            name: "seed",
            summary: "",
            unit: "",
            kind: OptionKind::Whole { min: 1, max: 9, default: 3 },
            sweep: None,
        },
        OptionSpec { name: "mode", summary: "", unit: "", kind: OptionKind::Choice(&["screen", "paper"]), sweep: None },
    ];

    #[test]
    fn values_round_trip_through_their_text() {
        let values = OptionValues::parse(SPECS, ["scale=0.25", "mode=paper"]).unwrap();
        let expected = [OptionValue::Number(0.25), OptionValue::Whole(3), OptionValue::Choice("paper")];
        assert_eq!(["scale", "seed", "mode"].map(|name| values.get(name).unwrap()), expected);
        assert_eq!(values.to_string(), "mode=paper scale=0.25 seed=3");
        assert_eq!(OptionValues::parse(SPECS, values.to_string().split(' ')).unwrap(), values);
        assert_eq!(OptionValues::checked(SPECS, expected).unwrap(), values);
        assert_ne!(OptionValues::defaults(SPECS), values);
    }

    #[test]
    fn refusals_say_what_would_fit() {
        let message = |word| OptionValues::parse(SPECS, [word]).unwrap_err().to_string();
        assert_eq!(message("scale=2"), "scale=2 does not fit: a number from 0 to 1 px");
        assert_eq!(message("scale=NaN"), "scale=NaN does not fit: a number from 0 to 1 px");
        assert_eq!(message("seed=1.5"), "seed=1.5 does not fit: a whole number from 1 to 9");
        assert_eq!(message("seed=10"), "seed=10 does not fit: a whole number from 1 to 9");
        assert_eq!(message("mode=x"), "mode=x does not fit: one of screen, paper");
        assert_eq!(message("width=1"), "there is no option 'width'; there are scale, seed, mode");
        assert_eq!(message("scale"), "'scale' is not of the form name=value");
    }

    #[test]
    fn values_out_of_range_or_of_another_kind_are_refused() {
        let error = |value| OptionValues::checked(SPECS, [value]).unwrap_err().to_string();
        assert_eq!(error(OptionValue::Number(2.0)), "scale=2 does not fit: a number from 0 to 1 px");
        assert_eq!(error(OptionValue::Number(f64::NAN)), "scale=NaN does not fit: a number from 0 to 1 px");
        assert_eq!(error(OptionValue::Whole(1)), "scale=1 does not fit: a number from 0 to 1 px");
    }
}

//! Options of a method as data: specified once, parsed from `name=value`, checked against their range.

use std::collections::BTreeMap;

/// One option of a method.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct OptionSpec {
    /// Name in kebab case.
    pub name: &'static str,
    /// What it sets, in one sentence, with its effect at both ends.
    pub summary: &'static str,
    /// Unit of the value; empty for a ratio or a choice.
    pub unit: &'static str,
    /// Type, range and default.
    pub kind: OptionKind,
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
    /// The value is no number, out of range or none of the choices.
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

#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[serde(untagged)]
enum Value {
    Number(f64),
    Choice(&'static str),
}

/// A checked value for every option of one method, defaults filled in. Serialises as a map, sorted by name.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[serde(transparent)]
pub struct OptionValues(BTreeMap<&'static str, Value>);

impl OptionSpec {
    fn default(&self) -> Value {
        match self.kind {
            OptionKind::Number { default, .. } => Value::Number(default),
            OptionKind::Choice(choices) => Value::Choice(choices[0]),
        }
    }

    fn expected(&self) -> String {
        match self.kind {
            OptionKind::Number { min, max, .. } => {
                format!("a number from {min} to {max} {}", self.unit).trim_end().to_owned()
            }
            OptionKind::Choice(choices) => format!("one of {}", choices.join(", ")),
        }
    }

    fn parse(&self, text: &str) -> Result<Value, OptionError> {
        let value = match self.kind {
            OptionKind::Number { min, max, .. } => {
                text.parse().ok().filter(|number| (min..=max).contains(number)).map(Value::Number)
            }
            OptionKind::Choice(choices) => {
                choices.iter().find(|&&choice| choice == text).map(|&choice| Value::Choice(choice))
            }
        };
        value.ok_or_else(|| OptionError::Value { name: self.name, value: text.to_owned(), expected: self.expected() })
    }
}

impl OptionValues {
    /// Every option of `specs` at its default.
    pub fn defaults(specs: &'static [OptionSpec]) -> Self {
        Self(specs.iter().map(|spec| (spec.name, spec.default())).collect())
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
            values.0.insert(spec.name, spec.parse(text)?);
        }
        Ok(values)
    }

    /// The value of a number option.
    ///
    /// # Errors
    /// [`OptionError::Foreign`] where there is no such number: the values were made for another method.
    pub fn number(&self, name: &'static str) -> Result<f64, OptionError> {
        match self.0.get(name) {
            Some(Value::Number(number)) => Ok(*number),
            _ => Err(OptionError::Foreign { name }),
        }
    }

    /// The value of a choice option.
    ///
    /// # Errors
    /// [`OptionError::Foreign`] where there is no such choice: the values were made for another method.
    pub fn choice(&self, name: &'static str) -> Result<&'static str, OptionError> {
        match self.0.get(name) {
            Some(Value::Choice(choice)) => Ok(choice),
            _ => Err(OptionError::Foreign { name }),
        }
    }
}

impl std::fmt::Display for OptionValues {
    /// `name=value` words separated by spaces; parsing them gives the same values.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (index, (name, value)) in self.0.iter().enumerate() {
            let gap = if index == 0 { "" } else { " " };
            match value {
                Value::Number(number) => write!(f, "{gap}{name}={number}")?,
                Value::Choice(choice) => write!(f, "{gap}{name}={choice}")?,
            }
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
        },
        OptionSpec { name: "mode", summary: "", unit: "", kind: OptionKind::Choice(&["screen", "paper"]) },
    ];

    #[test]
    fn values_round_trip_through_their_text() {
        let values = OptionValues::parse(SPECS, ["scale=0.25", "mode=paper"]).unwrap();
        assert_eq!((values.number("scale"), values.choice("mode")), (Ok(0.25), Ok("paper")));
        let text = values.to_string();
        assert_eq!(OptionValues::parse(SPECS, text.split(' ')).unwrap(), values);
        assert_ne!(OptionValues::defaults(SPECS), values);
    }

    #[test]
    fn refusals_say_what_would_fit() {
        let message = |word| OptionValues::parse(SPECS, [word]).unwrap_err().to_string();
        assert_eq!(message("scale=2"), "scale=2 does not fit: a number from 0 to 1 px");
        assert_eq!(message("scale=NaN"), "scale=NaN does not fit: a number from 0 to 1 px");
        assert_eq!(message("mode=x"), "mode=x does not fit: one of screen, paper");
        assert_eq!(message("width=1"), "there is no option 'width'; there are scale, mode");
        assert_eq!(message("scale"), "'scale' is not of the form name=value");
    }

    #[test]
    fn values_of_another_method_are_refused() {
        let values = OptionValues::defaults(&[]);
        assert_eq!(values.number("scale"), Err(OptionError::Foreign { name: "scale" }));
        assert_eq!(OptionValues::defaults(SPECS).choice("scale"), Err(OptionError::Foreign { name: "scale" }));
    }
}

//! [`OptionSettings`]: a method's options as scenes and results hold them.

use serde::{Deserialize, Serialize};
use silhouette_core::method::OptionValues;
use std::collections::BTreeMap;
use std::fmt;

/// The value of an option.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged, expecting = "a number or a word")]
pub enum OptionSetting {
    /// A number.
    Number(f64),
    /// A word.
    Word(String),
}

impl From<&str> for OptionSetting {
    /// A number where the text is a finite one, otherwise a word.
    fn from(text: &str) -> Self {
        let number = text.parse().ok().filter(|number: &f64| number.is_finite());
        number.map_or_else(|| Self::Word(text.to_owned()), Self::Number)
    }
}

impl fmt::Display for OptionSetting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => number.fmt(f),
            Self::Word(word) => word.fmt(f),
        }
    }
}

/// Options by name.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(transparent)]
pub struct OptionSettings(pub BTreeMap<String, OptionSetting>);

impl From<&OptionValues> for OptionSettings {
    /// Every option with its value, defaults too.
    fn from(values: &OptionValues) -> Self {
        let text = values.to_string();
        let words = text.split_whitespace().filter_map(|word| word.split_once('='));
        Self(words.map(|(name, value)| (name.to_owned(), value.into())).collect())
    }
}

impl fmt::Display for OptionSettings {
    /// `name=value` words separated by spaces.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words: Vec<String> = self.0.iter().map(|(name, value)| format!("{name}={value}")).collect();
        f.write_str(&words.join(" "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::registry::Registry;

    #[test]
    fn settings_hold_what_a_method_was_given() {
        let specs = Registry::builtin().find("tracking").unwrap().info().options;
        let values = OptionValues::parse(specs, ["concavity=0.25", "mesh=cut"]).unwrap();
        let settings = OptionSettings::from(&values);
        assert_eq!(settings.0.len(), specs.len(), "defaults are among them");
        assert_eq!(settings.0["concavity"], OptionSetting::Number(0.25));
        assert_eq!(settings.0["mesh"], OptionSetting::Word("cut".to_owned()));
        assert_eq!(OptionValues::parse(specs, settings.to_string().split(' ')).unwrap(), values);
        let json = serde_json::to_string(&settings).unwrap();
        assert_eq!(serde_json::from_str::<OptionSettings>(&json).unwrap(), settings);
    }
}

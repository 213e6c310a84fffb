//! A method by its name with keyword options.

use crate::errors::{bad_input, exception};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyList, PyTuple};
use silhouette_compare::registry::{Entry, Registry};
use silhouette_core::method::OptionValues;
use silhouettes::application::Failure;
use std::sync::OnceLock;

/// The methods of this package.
pub fn registry() -> &'static Registry {
    static REGISTRY: OnceLock<Registry> = OnceLock::new();
    REGISTRY.get_or_init(Registry::builtin)
}

/// The method of a name.
pub fn find(name: &str) -> PyResult<&'static Entry> {
    registry().find(name).map_err(bad_input)
}

/// Keyword options as `name=value` words: underscores stand for the hyphens of names.
pub fn words(options: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<String>> {
    let Some(options) = options else { return Ok(Vec::new()) };
    let word = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        Ok(format!("{}={}", name.extract::<String>()?.replace('_', "-"), value.str()?))
    };
    options.iter().map(word).collect()
}

/// The options of a method, checked.
pub fn options(entry: &Entry, words: &[String]) -> PyResult<OptionValues> {
    let values = OptionValues::parse(entry.info().options, words.iter().map(String::as_str));
    values.map_err(|error| exception(&Failure::from(error)))
}

/// Keyword options as words of a command: `--name=value`, `--name` for True, nothing for False and None, a word for each of a list,
/// and numbers of a tuple with commas between.
pub fn command_words(options: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<String>> {
    let mut words = Vec::new();
    let Some(options) = options else { return Ok(words) };
    for (name, value) in options.iter() {
        let name = name.extract::<String>()?.replace('_', "-");
        let values = match value.cast::<PyList>() {
            Ok(list) => list.iter().collect(),
            Err(_) => vec![value],
        };
        for value in values {
            if let Ok(is_on) = value.cast::<PyBool>() {
                words.extend(is_on.is_true().then(|| format!("--{name}")));
            } else if let Ok(numbers) = value.cast::<PyTuple>() {
                let numbers =
                    numbers.iter().map(|number| Ok(number.str()?.to_string())).collect::<PyResult<Vec<_>>>()?;
                words.push(format!("--{name}={}", numbers.join(",")));
            } else if !value.is_none() {
                words.push(format!("--{name}={}", value.str()?));
            }
        }
    }
    Ok(words)
}

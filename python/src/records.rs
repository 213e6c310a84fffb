//! Results as dicts and lists.

use crate::errors::exception;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde::Serialize;
use silhouettes::application::Failure;

/// A result as Python's `json` reads it: dicts, lists, numbers, words and None.
pub fn to_python<'py>(py: Python<'py>, value: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    let text = serde_json::to_string(value).map_err(|error| exception(&Failure::run(error)))?;
    py.import("json")?.call_method1("loads", (text,))
}

/// Columns of words, in which a number is a name.
const WORDS: [&str; 4] = ["mesh", "method", "picture", "pen_placement"];

/// A row of a table as a dict: numbers as such, what is empty as None.
pub fn record_of_row<'py>(py: Python<'py>, columns: &[String], row: &[String]) -> PyResult<Bound<'py, PyDict>> {
    let record = PyDict::new(py);
    for (column, value) in columns.iter().zip(row) {
        if WORDS.contains(&column.as_str()) {
            record.set_item(column, value)?;
        } else if value.is_empty() {
            record.set_item(column, py.None())?;
        } else if let Ok(whole) = value.parse::<i64>() {
            record.set_item(column, whole)?;
        } else if let Ok(number) = value.parse::<f64>() {
            record.set_item(column, number)?;
        } else {
            record.set_item(column, value)?;
        }
    }
    Ok(record)
}

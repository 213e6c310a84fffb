//! Committed results, as tables of text.

use serde::de::DeserializeOwned;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Why results could not be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ResultError {
    /// A file could not be read, or not as CSV.
    #[error("{}: {cause}", file.display())]
    Csv {
        /// The file.
        file: PathBuf,
        /// Why.
        cause: csv::Error,
    },
    /// A file could not be read.
    #[error("{}: {cause}", file.display())]
    File {
        /// The file.
        file: PathBuf,
        /// Why.
        cause: std::io::Error,
    },
    /// A line of a file is no row.
    #[error("{}, line {line}: {cause}", file.display())]
    Row {
        /// The file.
        file: PathBuf,
        /// The line, from 1.
        line: usize,
        /// Why.
        cause: serde_json::Error,
    },
    /// A column is missing, or holds no number where one must be.
    #[error("{}: no number in column '{column}' of {row}", file.display())]
    Number {
        /// The file.
        file: PathBuf,
        /// The column.
        column: String,
        /// Which row.
        row: String,
    },
    /// There is no row.
    #[error("{}: no row of {row}", file.display())]
    Missing {
        /// The file.
        file: PathBuf,
        /// Which row.
        row: String,
    },
}

/// Rows of a `results.csv`.
#[derive(Debug, Clone)]
pub struct Sheet {
    file: PathBuf,
    rows: Vec<HashMap<String, String>>,
}

/// The rows of one method on one mesh.
#[derive(Debug, Clone)]
pub struct Rows<'a> {
    file: &'a Path,
    name: String,
    rows: Vec<&'a HashMap<String, String>>,
}

impl Sheet {
    /// Reads a file.
    ///
    /// # Errors
    /// [`ResultError`].
    pub fn read(file: PathBuf) -> Result<Self, ResultError> {
        let read = || csv::Reader::from_path(&file)?.deserialize().collect::<Result<Vec<_>, _>>();
        match read() {
            Ok(rows) => Ok(Self { file, rows }),
            Err(cause) => Err(ResultError::Csv { file, cause }),
        }
    }

    /// The rows of a method on a mesh: at least one.
    ///
    /// # Errors
    /// [`ResultError::Missing`].
    pub fn rows(&self, mesh: &str, method: &str) -> Result<Rows<'_>, ResultError> {
        let is =
            |row: &HashMap<String, String>, column: &str, text: &str| row.get(column).is_some_and(|cell| cell == text);
        let rows: Vec<_> = self.rows.iter().filter(|row| is(row, "mesh", mesh) && is(row, "method", method)).collect();
        let name = format!("{method} on {mesh}");
        if rows.is_empty() {
            return Err(ResultError::Missing { file: self.file.clone(), row: name });
        }
        Ok(Rows { file: &self.file, name, rows })
    }
}

impl Rows<'_> {
    /// The number in a column of the first row; `None` where it is empty.
    ///
    /// # Errors
    /// [`ResultError::Number`].
    pub fn first(&self, column: &str) -> Result<Option<f64>, ResultError> {
        self.number(self.rows[0], column)
    }

    /// The sum of several columns over all rows.
    ///
    /// # Errors
    /// [`ResultError::Number`], also where a cell is empty.
    pub fn sum(&self, columns: &[&str]) -> Result<f64, ResultError> {
        let mut sum = 0.0;
        for row in &self.rows {
            for column in columns {
                sum += self.number(row, column)?.ok_or_else(|| self.no_number(column))?;
            }
        }
        Ok(sum)
    }

    /// The text in a column of the first row.
    pub fn text(&self, column: &str) -> &str {
        self.rows[0].get(column).map_or("", String::as_str)
    }

    fn number(&self, row: &HashMap<String, String>, column: &str) -> Result<Option<f64>, ResultError> {
        match row.get(column).map(String::as_str) {
            Some("") => Ok(None),
            Some(text) => text.parse().map(Some).map_err(|_| self.no_number(column)),
            None => Err(self.no_number(column)),
        }
    }

    fn no_number(&self, column: &str) -> ResultError {
        ResultError::Number { file: self.file.to_owned(), column: column.to_owned(), row: self.name.clone() }
    }
}

/// The rows of a file of JSON Lines.
///
/// # Errors
/// [`ResultError`].
pub fn lines<T: DeserializeOwned>(file: &Path) -> Result<Vec<T>, ResultError> {
    let text = std::fs::read_to_string(file).map_err(|cause| ResultError::File { file: file.to_owned(), cause })?;
    let row = |(line, text): (usize, &str)| {
        serde_json::from_str(text).map_err(|cause| ResultError::Row { file: file.to_owned(), line: line + 1, cause })
    };
    text.lines().enumerate().map(row).collect()
}

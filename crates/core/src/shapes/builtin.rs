//! What describes a built-in shape: its name, its arguments with ranges and defaults, how they are parsed, and why one was
//! refused.

use super::contour::AnalyticContour;
use crate::mesh::TriangleMesh;
use std::fmt;

/// Most faces that a built-in shape may have: the icosphere of level 10, 20 * 4^10. A mesh of that size takes 0.4 GB;
/// that icosphere takes 1.7 GB while it is generated.
pub const MAX_FACES: u64 = 20_971_520;

/// Makes a smooth surface from one value per argument.
type SurfaceOf = fn(&[f64]) -> Result<Box<dyn AnalyticContour>, ShapeError>;

/// One built-in shape. Its [`Display`](fmt::Display) form is its usage, `torus[:around,across,major-radius,…]`.
#[derive(Debug)]
pub struct Builtin {
    /// Name on the command line, in kebab case.
    pub name: &'static str,
    /// What it is and what it is good for, in one sentence.
    pub summary: &'static str,
    /// Arguments in their order; trailing ones may be left out.
    pub arguments: &'static [ArgumentSpec],
    /// Genus where the shape is closed, of its components where it has several (each at least this); `None` where it has a
    /// boundary.
    pub genus: Option<u32>,
    /// Meshes the shape for one value per argument.
    pub(super) build: fn(&[f64]) -> Result<TriangleMesh, ShapeError>,
    /// The smooth surface behind the mesh, for one value per argument, where its contour has a closed form.
    pub(super) contour: Option<SurfaceOf>,
}

/// One argument of a built-in shape.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct ArgumentSpec {
    /// Name in kebab case, as refusals and lists show it.
    pub name: &'static str,
    /// What it sets, in a few words.
    pub summary: &'static str,
    /// Whether fractions are allowed.
    pub kind: ArgumentKind,
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// Value where none is given.
    pub default: f64,
}

/// What an argument counts or measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ArgumentKind {
    /// A whole number.
    Count,
    /// A length in the mesh's units, or a ratio.
    Number,
}

/// Why a built-in shape was not made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ShapeError {
    /// No shape has this name.
    #[error("there is no built-in shape '{name}'; choose one of {known}")]
    UnknownName {
        /// What was given.
        name: String,
        /// The names that exist.
        known: String,
    },
    /// More arguments than the shape takes.
    #[error("{given} arguments were given to {usage}")]
    TooManyArguments {
        /// How many.
        given: usize,
        /// How the shape is written.
        usage: String,
    },
    /// An argument is no number or out of its range.
    #[error("{shape}: {argument} cannot be {value}; give {expected}")]
    Argument {
        /// The shape.
        shape: &'static str,
        /// Its argument.
        argument: &'static str,
        /// What was given.
        value: String,
        /// Kind and range.
        expected: String,
    },
    /// Arguments that fit one by one, but not together.
    #[error("{shape}: {rule}")]
    Combination {
        /// The shape.
        shape: &'static str,
        /// What has to hold.
        rule: &'static str,
    },
    /// More faces than [`MAX_FACES`].
    #[error("{shape}: these arguments make {faces} faces; at most {MAX_FACES} are made, so lower {arguments}")]
    TooManyFaces {
        /// The shape.
        shape: &'static str,
        /// How many it would have.
        faces: u64,
        /// The arguments that set the number of faces.
        arguments: String,
    },
}

impl ArgumentSpec {
    pub(super) const fn count(name: &'static str, summary: &'static str, range: [u32; 2], default: u32) -> Self {
        let [min, max] = range;
        Self { name, summary, kind: ArgumentKind::Count, min: min as f64, max: max as f64, default: default as f64 }
    }

    pub(super) const fn number(name: &'static str, summary: &'static str, range: [f64; 2], default: f64) -> Self {
        let [min, max] = range;
        Self { name, summary, kind: ArgumentKind::Number, min, max, default }
    }

    /// A length between a hundredth and a hundred units: far enough from the ends of 32-bit floats that no face of any
    /// built-in shape collapses.
    pub(super) const fn length(name: &'static str, summary: &'static str, default: f64) -> Self {
        Self::number(name, summary, [0.01, 100.0], default)
    }

    /// Kind and range as a clause, such as `a whole number from 3 to 4096`.
    pub fn expected(&self) -> String {
        let kind = match self.kind {
            ArgumentKind::Count => "a whole number",
            ArgumentKind::Number => "a number",
        };
        format!("{kind} from {} to {}", self.min, self.max)
    }

    fn parse(&self, shape: &'static str, text: &str) -> Result<f64, ShapeError> {
        let number = match self.kind {
            ArgumentKind::Count => text.parse::<u32>().ok().map(f64::from),
            ArgumentKind::Number => text.parse::<f64>().ok(),
        };
        number.ok_or_else(|| self.refusal(shape, format!("'{text}'")))
    }

    fn refusal(&self, shape: &'static str, value: String) -> ShapeError {
        ShapeError::Argument { shape, argument: self.name, value, expected: self.expected() }
    }
}

impl Builtin {
    /// The value of every argument where none is given.
    pub fn defaults(&self) -> Vec<f64> {
        self.arguments.iter().map(|argument| argument.default).collect()
    }

    /// Refuses values out of range and too many faces. `values` has one entry per argument; called by the generators
    /// themselves, so that a Rust caller meets the same ranges as the command line.
    pub(super) fn check(&self, values: &[f64], faces: u64) -> Result<(), ShapeError> {
        debug_assert_eq!(values.len(), self.arguments.len(), "{}", self.name);
        let misfit = self.arguments.iter().zip(values).find(|(spec, value)| !(spec.min..=spec.max).contains(value));
        if let Some((spec, value)) = misfit {
            return Err(spec.refusal(self.name, value.to_string()));
        }
        if faces > MAX_FACES {
            let counts = self.arguments.iter().filter(|argument| argument.kind == ArgumentKind::Count);
            let arguments = counts.map(|argument| argument.name).collect::<Vec<_>>().join(" or ");
            return Err(ShapeError::TooManyFaces { shape: self.name, faces, arguments });
        }
        Ok(())
    }

    /// One value per argument from `ARG[,ARG…]`.
    pub(super) fn parse(&self, text: Option<&str>) -> Result<Vec<f64>, ShapeError> {
        let words: Vec<&str> = text.map_or_else(Vec::new, |text| text.split(',').map(str::trim).collect());
        if words.len() > self.arguments.len() {
            return Err(ShapeError::TooManyArguments { given: words.len(), usage: self.to_string() });
        }
        let mut values = self.defaults();
        for ((value, spec), word) in values.iter_mut().zip(self.arguments).zip(words) {
            *value = spec.parse(self.name, word)?;
        }
        Ok(values)
    }
}

impl fmt::Display for Builtin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)?;
        if !self.arguments.is_empty() {
            let names: Vec<&str> = self.arguments.iter().map(|argument| argument.name).collect();
            write!(f, "[:{}]", names.join(","))?;
        }
        Ok(())
    }
}

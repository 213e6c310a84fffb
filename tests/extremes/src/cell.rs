//! [`Cell`]: the outcome of one method at one extreme.

/// What of a method is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Aspect {
    /// Edges that it extracts.
    Edges,
    /// Curves that it extracts.
    Curves,
    /// Lines that it draws.
    Lines,
    /// Surfaces that it fills.
    Fill,
}

impl Aspect {
    /// All, in the order of the tables.
    pub const ALL: [Self; 4] = [Self::Edges, Self::Curves, Self::Lines, Self::Fill];

    /// Its name in the tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Edges => "edges",
            Self::Curves => "curves",
            Self::Lines => "lines",
            Self::Fill => "fill",
        }
    }

    /// Whether a device draws it, so that its numbers may differ by a rounding from driver to driver.
    pub const fn is_drawn(self) -> bool {
        matches!(self, Self::Lines | Self::Fill)
    }
}

/// What came out, in a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Outcome {
    /// The edges of exact arithmetic, and no others.
    Exact,
    /// Some of the edges of exact arithmetic, and no others.
    Subset,
    /// As far from the truth as in the plain case, within the stated bound.
    Same,
    /// Nothing: no edge, no curve, no ink, no covered pixel.
    Empty,
    /// An error, in one line.
    Refused,
    /// Farther from the truth than in the plain case.
    Differs,
    /// The extreme is none for the method.
    NotApplicable,
    /// A panic, NaN, an index out of range, a device that complains, an error of more than one line.
    Fault,
}

impl Outcome {
    /// The word of the tables.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Subset => "subset",
            Self::Same => "same",
            Self::Empty => "empty",
            Self::Refused => "refused",
            Self::Differs => "differs",
            Self::NotApplicable => "n/a",
            Self::Fault => "FAULT",
        }
    }
}

/// An outcome, with what was measured or said.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// The outcome.
    pub outcome: Outcome,
    /// The measured error, as the tables state it; the text of a refusal or of a fault.
    pub text: String,
}

impl Found {
    /// An outcome with what was measured.
    pub fn new(outcome: Outcome, text: impl Into<String>) -> Self {
        Self { outcome, text: text.into() }
    }

    /// An error of the product: a refusal where it is one line, a fault otherwise.
    pub fn refused(error: &dyn std::error::Error) -> Self {
        let text = error.to_string();
        let is_line = !text.trim().is_empty() && text.lines().count() == 1;
        Self::new(if is_line { Outcome::Refused } else { Outcome::Fault }, text)
    }

    /// What must not be.
    pub fn fault(text: impl Into<String>) -> Self {
        Self::new(Outcome::Fault, text)
    }
}

/// One method at one extreme.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// Name of the row.
    pub row: &'static str,
    /// Name of the method.
    pub method: &'static str,
    /// What of it is looked at.
    pub aspect: Aspect,
    /// What came out.
    pub found: Found,
}

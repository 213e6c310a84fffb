//! [`Length`]: a length on paper, in millimetres or pixels.

use std::fmt;
use std::str::FromStr;

/// What lengths on paper are measured in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Unit {
    /// Millimetres.
    #[default]
    Mm,
    /// Pixels of CSS and SVG: 96 to an inch of 25.4 mm.
    Px,
}

impl Unit {
    /// The suffix in SVG attributes and on command lines: `mm` or `px`.
    pub const fn suffix(self) -> &'static str {
        match self {
            Self::Mm => "mm",
            Self::Px => "px",
        }
    }

    /// How many of it make an inch.
    const fn per_inch(self) -> f64 {
        match self {
            Self::Mm => 25.4,
            Self::Px => 96.0,
        }
    }
}

/// What may follow a number: the unit that it is kept in, and how many of that it is.
pub(super) const SUFFIXES: [(&str, Unit, f64); 5] = [
    ("mm", Unit::Mm, 1.0),
    ("px", Unit::Px, 1.0),
    ("cm", Unit::Mm, 10.0),
    ("in", Unit::Mm, 25.4),
    ("pt", Unit::Mm, 25.4 / 72.0),
];

/// A length in the unit it was given in, so that round numbers stay round.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Length {
    value: f64,
    unit: Unit,
}

impl Length {
    /// A length of this many of a unit.
    pub const fn new(value: f64, unit: Unit) -> Self {
        Self { value, unit }
    }

    /// A length in millimetres.
    pub const fn mm(value: f64) -> Self {
        Self::new(value, Unit::Mm)
    }

    /// A length in pixels.
    pub const fn px(value: f64) -> Self {
        Self::new(value, Unit::Px)
    }

    /// How many of `unit` it is; exactly the number it was given as where that was its unit.
    pub fn to(self, unit: Unit) -> f64 {
        if self.unit == unit { self.value } else { self.value * unit.per_inch() / self.unit.per_inch() }
    }

    /// Reads `0.3mm`, `2px`, `1cm`, `0.5in`, `3pt` or, in `default`, `2`. The number is finite. Centimetres, inches and points (72
    /// to an inch) are kept as millimetres.
    ///
    /// # Errors
    /// [`ParseLengthError`] for anything else.
    pub fn parse(text: &str, default: Unit) -> Result<Self, ParseLengthError> {
        let text = text.trim();
        let (number, unit, factor) = SUFFIXES
            .into_iter()
            .find_map(|(suffix, unit, factor)| Some((text.strip_suffix(suffix)?, unit, factor)))
            .unwrap_or((text, default, 1.0));
        let value = number.trim().parse().ok().map(|value: f64| value * factor).filter(|value| value.is_finite());
        Ok(Self { value: value.ok_or(ParseLengthError)?, unit })
    }
}

impl FromStr for Length {
    type Err = ParseLengthError;

    /// As [`Length::parse`], in millimetres where no unit is given.
    fn from_str(text: &str) -> Result<Self, ParseLengthError> {
        Self::parse(text, Unit::Mm)
    }
}

impl fmt::Display for Length {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.value, self.unit.suffix())
    }
}

/// Text that is no length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("expected a length such as 0.3mm, 1cm, 0.5in, 3pt or 2px")]
pub struct ParseLengthError;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_read_with_their_units() {
        assert_eq!("0.3mm".parse(), Ok(Length::mm(0.3)));
        assert_eq!(" 2 px".parse(), Ok(Length::px(2.0)));
        assert_eq!(Length::parse("7", Unit::Px), Ok(Length::px(7.0)));
        assert_eq!(["1cm", "2in"].map(str::parse), [Ok(Length::mm(10.0)), Ok(Length::mm(50.8))]);
        assert!(("72 pt".parse::<Length>().unwrap().to(Unit::Px) - 96.0).abs() < 1e-12);
        for bad in ["", "mm", "1km", "nan", "infmm", "1e308in", "1,5mm"] {
            assert_eq!(bad.parse::<Length>(), Err(ParseLengthError), "{bad}");
        }
        assert_eq!(Length::px(0.5).to_string(), "0.5px");
    }

    #[test]
    fn an_inch_is_an_inch() {
        assert!((Length::mm(25.4).to(Unit::Px) - 96.0).abs() < 1e-12);
        assert!((Length::px(96.0).to(Unit::Mm) - 25.4).abs() < 1e-12);
        assert_eq!(Length::mm(0.1).to(Unit::Mm).to_bits(), 0.1_f64.to_bits());
    }
}

//! [`Pen`]: with what a layer is drawn.

use super::length::Length;
use crate::kind::LineKind;
use std::fmt;
use std::str::FromStr;

/// A colour: red, green and blue of sRGB.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Colour(pub [u8; 3]);

impl Colour {
    /// Black.
    pub const BLACK: Self = Self([0; 3]);
}

impl fmt::Display for Colour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [red, green, blue] = self.0;
        write!(f, "#{red:02x}{green:02x}{blue:02x}")
    }
}

impl FromStr for Colour {
    type Err = ParseColourError;

    /// Reads `#rrggbb`.
    fn from_str(text: &str) -> Result<Self, ParseColourError> {
        let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6 && digits.is_ascii());
        let number =
            digits.filter(|digits| !digits.starts_with('+')).and_then(|digits| u32::from_str_radix(digits, 16).ok());
        let [_, red, green, blue] = number.ok_or(ParseColourError)?.to_be_bytes();
        Ok(Self([red, green, blue]))
    }
}

/// Text that is no colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("expected a colour such as #1a2b3c")]
pub struct ParseColourError;

/// A pattern of strokes and gaps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dash {
    /// Length of a stroke, at least 0.1 mm.
    pub on: Length,
    /// Length of a gap, at least 0.1 mm.
    pub off: Length,
}

impl Dash {
    /// Strokes of 2 mm, gaps of 1 mm.
    pub const HIDDEN: Self = Self { on: Length::mm(2.0), off: Length::mm(1.0) };
}

/// Width, colour and pattern of a layer's lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pen {
    /// Above 0.
    pub width: Length,
    /// Default: black.
    pub colour: Colour,
    /// Cut into the geometry, since plotters and the programs that feed them pass over `stroke-dasharray`.
    /// Default: none.
    pub dash: Option<Dash>,
}

impl Pen {
    /// A black pen without pattern.
    pub const fn new(width: Length) -> Self {
        Self { width, colour: Colour::BLACK, dash: None }
    }
}

/// Two pens per kind of line, for its visible and for its hidden parts, and one for the outline.
///
/// Default: black; widths of ISO 128, 0.5 mm for silhouettes, boundaries and smooth curves, 0.7 mm for sections and the outline,
/// 0.18 mm for plain mesh edges and 0.35 mm for the others; hidden parts as visible ones.
#[derive(Debug, Clone, PartialEq)]
pub struct Pens {
    of_kind: [Pen; LineKind::ALL.len()],
    of_hidden: [Pen; LineKind::ALL.len()],
    /// The outline's.
    pub outline: Pen,
}

impl Pens {
    /// The pen of a kind's visible parts.
    pub fn of(&self, kind: LineKind) -> &Pen {
        &self.of_kind[kind as usize]
    }

    /// The pen of a kind's visible parts, to be changed.
    pub fn of_mut(&mut self, kind: LineKind) -> &mut Pen {
        &mut self.of_kind[kind as usize]
    }

    /// The pen of a kind's hidden parts. Its pattern takes the place of [`Hidden::Dashed`](super::Hidden::Dashed)'s.
    pub fn of_hidden(&self, kind: LineKind) -> &Pen {
        &self.of_hidden[kind as usize]
    }

    /// The pen of a kind's hidden parts, to be changed.
    pub fn of_hidden_mut(&mut self, kind: LineKind) -> &mut Pen {
        &mut self.of_hidden[kind as usize]
    }

    /// All pens, the outline's last.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut Pen> {
        self.of_kind.iter_mut().chain(&mut self.of_hidden).chain([&mut self.outline])
    }

    /// All pens, the outline's last.
    pub fn iter(&self) -> impl Iterator<Item = &Pen> {
        self.of_kind.iter().chain(&self.of_hidden).chain([&self.outline])
    }
}

impl Default for Pens {
    fn default() -> Self {
        let width_mm = |kind| match kind {
            LineKind::Section => 0.7,
            LineKind::Silhouette | LineKind::Boundary | LineKind::Curve => 0.5,
            LineKind::Ridge | LineKind::Valley | LineKind::Material | LineKind::Intersection => 0.35,
            LineKind::Mesh => 0.18,
        };
        let of_kind = LineKind::ALL.map(|kind| Pen::new(Length::mm(width_mm(kind))));
        Self { of_kind, of_hidden: of_kind, outline: Pen::new(Length::mm(0.7)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_read_and_written() {
        let colour = Colour([0x1a, 0x2b, 0xff]);
        assert_eq!(colour.to_string(), "#1a2bff");
        assert_eq!("#1A2bfF".parse(), Ok(colour));
        for bad in ["", "1a2b3c", "#1a2b3", "#1a2b3g", "#+a2b3c", "#1a2bé"] {
            assert_eq!(bad.parse::<Colour>(), Err(ParseColourError), "{bad}");
        }
    }

    #[test]
    fn each_kind_has_its_own_pen() {
        let mut pens = Pens::default();
        for kind in LineKind::ALL {
            pens.of_mut(kind).width = Length::mm(f64::from(kind as u8) + 1.0);
            pens.of_hidden_mut(kind).width = Length::mm(f64::from(kind as u8) + 51.0);
        }
        for kind in LineKind::ALL {
            assert_eq!(pens.of(kind).width, Length::mm(f64::from(kind as u8) + 1.0));
            assert_eq!(pens.of_hidden(kind).width, Length::mm(f64::from(kind as u8) + 51.0));
        }
        assert_eq!(pens.iter().count(), 2 * LineKind::ALL.len() + 1);
    }
}

//! [`Page`]: the paper, and how a picture is fitted to it.

use super::length::{Length, SUFFIXES, Unit};
use std::str::FromStr;

/// Width and height of paper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Page {
    /// From left to right.
    pub width: Length,
    /// From top to bottom.
    pub height: Length,
}

impl Page {
    /// Named sizes with width and height in millimetres, upright.
    pub const NAMED: [(&'static str, [f64; 2]); 9] = [
        ("a0", [841.0, 1189.0]),
        ("a1", [594.0, 841.0]),
        ("a2", [420.0, 594.0]),
        ("a3", [297.0, 420.0]),
        ("a4", [210.0, 297.0]),
        ("a5", [148.0, 210.0]),
        ("letter", [215.9, 279.4]),
        ("legal", [215.9, 355.6]),
        ("tabloid", [279.4, 431.8]),
    ];

    /// A page of 210 by 297 millimetres.
    pub const A4: Self = Self { width: Length::mm(210.0), height: Length::mm(297.0) };

    /// The same page with its longer side across.
    #[must_use]
    pub fn landscape(self) -> Self {
        if self.width.to(Unit::Mm) < self.height.to(Unit::Mm) {
            Self { width: self.height, height: self.width }
        } else {
            self
        }
    }

    /// Width and height in a unit.
    pub fn size(&self, unit: Unit) -> [f64; 2] {
        [self.width.to(unit), self.height.to(unit)]
    }
}

impl FromStr for Page {
    type Err = ParsePageError;

    /// Reads a name of [`Page::NAMED`] in either case, or width and height such as `200x150`, `200x150mm`, `11x17in`, `800x600px`.
    fn from_str(text: &str) -> Result<Self, ParsePageError> {
        if let Some((_, [width, height])) = Self::NAMED.iter().find(|(name, _)| name.eq_ignore_ascii_case(text)) {
            return Ok(Self { width: Length::mm(*width), height: Length::mm(*height) });
        }
        // The height's unit is the width's, too: "px" holds the letter that separates them.
        let suffix = SUFFIXES.into_iter().map(|(suffix, ..)| suffix).find(|suffix| text.ends_with(suffix));
        let suffix = suffix.unwrap_or(Unit::Mm.suffix());
        let sides = text.strip_suffix(suffix).unwrap_or(text).split_once('x');
        let number = |text: &str| text.strip_suffix(suffix).unwrap_or(text).trim().parse::<f64>().ok();
        let side =
            |text| format!("{}{suffix}", number(text)?).parse().ok().filter(|side: &Length| side.to(Unit::Mm) > 0.0);
        let sides = sides.and_then(|(width, height)| Some(Self { width: side(width)?, height: side(height)? }));
        sides.ok_or(ParsePageError)
    }
}

/// Text that is no page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "expected a0, a1, a2, a3, a4, a5, letter, legal, tabloid, or width and height such as 200x150mm, 11x17in or 800x600px"
)]
pub struct ParsePageError;

/// How large a picture becomes on its page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fit {
    /// The lines that are drawn fill the page within its margins.
    Lines,
    /// The camera's viewport fills the page within its margins, so that pictures of one camera lie upon each other.
    View,
    /// True scale: a unit of the mesh takes this many millimetres. For orthographic cameras. What the page cannot hold
    /// is cut off.
    Scale {
        /// Above 0.
        mm_per_unit: f64,
    },
}

/// A page with margins, and how a picture is fitted to it. The picture lies in the middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sheet {
    /// The paper. At most ten metres a side.
    pub page: Page,
    /// Left free on all four sides, by every line's middle. Less than half the page. Default: 10 mm.
    pub margin: Length,
    /// How large the picture becomes. Default: as large as its lines can be.
    pub fit: Fit,
}

impl Default for Sheet {
    fn default() -> Self {
        Self { page: Page::A4, margin: Length::mm(10.0), fit: Fit::Lines }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_are_read_by_name_or_size() {
        assert_eq!("A4".parse(), Ok(Page::A4));
        assert_eq!("210x297".parse(), Ok(Page::A4));
        assert_eq!("210mmx297mm".parse(), Ok(Page::A4));
        assert_eq!("800x600px".parse(), Ok(Page { width: Length::px(800.0), height: Length::px(600.0) }));
        for bad in ["", "a9", "x", "0x3", "-1x2", "3", "1x2x3", "800px"] {
            assert_eq!(bad.parse::<Page>(), Err(ParsePageError), "{bad}");
        }
        let error = ParsePageError.to_string();
        assert!(Page::NAMED.iter().all(|(name, _)| error.contains(name)), "{error}");
    }

    #[test]
    fn landscape_lies() {
        assert_eq!(format!("{:?}", Page::A4.landscape().size(Unit::Mm)), "[297.0, 210.0]");
        assert_eq!(Page::A4.landscape().landscape(), Page::A4.landscape());
    }
}

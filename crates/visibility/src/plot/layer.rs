//! [`Layer`]: what is drawn with one pen, and the order in which pens are taken up.

use super::length::Unit;
use super::options::{Hidden, PlotOptions};
use super::paths::Paths;
use super::pen::{Dash, Pen};
use crate::chains::ChainStyle;
use crate::kind::LineKind;
use std::fmt;

/// What a layer holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LayerName {
    /// Lines of one kind, visible or hidden.
    Lines {
        /// Their kind.
        kind: LineKind,
        /// Whether they are visible.
        visible: bool,
    },
    /// The outermost outline.
    Outline,
}

impl LayerName {
    /// The layer that chains of this style belong to.
    pub const fn of(style: ChainStyle) -> Self {
        Self::Lines { kind: style.kind, visible: style.invisibility == 0 }
    }

    /// All layers in the order of drawing: hidden lines first, and the kinds from the last to the first, so that
    /// sections and silhouettes cover what they cross; the outline at the end.
    pub fn all() -> impl Iterator<Item = Self> {
        let lines = |visible| LineKind::ALL.into_iter().rev().map(move |kind| Self::Lines { kind, visible });
        lines(false).chain(lines(true)).chain([Self::Outline])
    }

    /// Whether it holds hidden lines.
    pub const fn is_hidden(self) -> bool {
        matches!(self, Self::Lines { visible: false, .. })
    }

    /// An identifier such as `silhouette-visible`.
    pub fn id(self) -> String {
        self.to_string().replace(' ', "-")
    }

    /// Its pen and its pattern; `None` where the options drop it.
    pub(super) fn pen(self, options: &PlotOptions) -> Option<(Pen, Option<Dash>)> {
        let pen = match self {
            Self::Lines { kind, .. } => *options.pens.of(kind),
            Self::Outline if !options.outline => return None,
            Self::Outline => options.pens.outline,
        };
        match options.hidden {
            Hidden::Drop if self.is_hidden() => None,
            Hidden::Dashed(dash) if self.is_hidden() => Some((pen, Some(dash))),
            _ => Some((pen, pen.dash)),
        }
    }
}

impl fmt::Display for LayerName {
    /// Words such as `silhouette visible`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lines { kind, visible } => {
                write!(f, "{} {}", kind.name(), if *visible { "visible" } else { "hidden" })
            }
            Self::Outline => f.write_str("outline"),
        }
    }
}

/// What is drawn with one pen.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// What it holds.
    pub name: LayerName,
    /// With what it is drawn. The pattern is already cut into the paths.
    pub pen: Pen,
    /// Its paths in page units, in the order in which they are drawn. Those of the outline are polygons that belong
    /// together, to be filled by the even-odd rule.
    pub paths: Paths,
}

impl Layer {
    /// The pen's width in a unit.
    pub fn width(&self, unit: Unit) -> f64 {
        self.pen.width.to(unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_layer_is_drawn_once_and_sections_late() {
        let all: Vec<_> = LayerName::all().collect();
        let mut ids: Vec<_> = all.iter().map(|name| name.id()).collect();
        assert_eq!(all.len(), 2 * LineKind::ALL.len() + 1);
        assert_eq!(ids[2 * LineKind::ALL.len() - 2..], ["silhouette-visible", "section-visible", "outline"]);
        assert!(all[..LineKind::ALL.len()].iter().all(|name| name.is_hidden()));
        ids.sort();
        ids.dedup();
        assert_eq!(ids.len(), all.len());
    }
}

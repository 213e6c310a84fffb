//! [`Layer`]: what is drawn with one pen, and the order in which pens are taken up.

use super::length::Unit;
use super::options::{Hidden, PlotOptions};
use super::paths::Paths;
use super::pen::Pen;
use crate::chains::ChainStyle;
use crate::kind::LineKind;
use std::fmt;
use std::ops::Range;

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

/// The number of the first hidden kind less that of the first visible one.
const HIDDEN: u32 = 20;
/// The number of the outline.
const OUTLINE: u32 = 40;
/// The number of the fill, which is no layer of strokes.
pub(super) const FILL: u32 = 99;
/// Numbers that layers of one object may have.
const PER_OBJECT: u64 = 100;

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

    /// Its number, the same in every drawing, so that files of different views have each kind in the same layer: from 1 for
    /// visible lines and from 21 for hidden ones, in the order of [`LineKind::ALL`] with sections last; 40 for the outline.
    pub const fn number(self) -> u32 {
        match self {
            Self::Lines { kind, visible } => {
                let number = match kind {
                    LineKind::Section => LineKind::ALL.len() as u32,
                    other => other as u32,
                };
                number + if visible { 0 } else { HIDDEN }
            }
            Self::Outline => OUTLINE,
        }
    }

    /// An identifier such as `silhouette-visible`.
    pub fn id(self) -> String {
        self.to_string().replace(' ', "-")
    }

    /// Its pen, with its pattern; `None` where the options drop it.
    pub(super) fn pen(self, options: &PlotOptions) -> Option<Pen> {
        let pen = match self {
            Self::Lines { kind, visible: true } => *options.pens.of(kind),
            Self::Lines { kind, visible: false } => *options.pens.of_hidden(kind),
            Self::Outline if !options.outline => return None,
            Self::Outline => options.pens.outline,
        };
        match options.hidden {
            Hidden::Drop if self.is_hidden() => None,
            Hidden::Dashed(dash) if self.is_hidden() => Some(Pen { dash: pen.dash.or(Some(dash)), ..pen }),
            _ => Some(pen),
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

/// What the lines of a drawing are parted by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum LayersBy {
    /// One layer per kind of line, visible and hidden apart.
    #[default]
    Kind,
    /// One layer per object, all kinds in it.
    Object,
    /// One layer per kind of each object.
    Both,
}

/// What is drawn with one pen.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// What it holds.
    pub name: LayerName,
    /// The number of the file's layer that it is, or a part of: those of one number follow each other.
    pub number: u64,
    /// What the file calls that layer.
    pub label: String,
    /// With what it is drawn. The pattern is already cut into the paths.
    pub pen: Pen,
    /// Its paths in page units, in the order in which they are drawn. Those of the outline are polygons that belong
    /// together, to be filled by the even-odd rule.
    pub paths: Paths,
    /// Which paths belong to which view, where there are several on the page.
    pub views: Vec<(&'static str, Range<usize>)>,
    /// Its place in the file: object, if layers are by object, and rank of its name.
    pub(super) order: (u32, usize),
    /// What layers are parted by; the outline is a kind of its own.
    by: LayersBy,
}

impl Layer {
    /// An empty one at a place in the file.
    pub(super) fn new((object, rank): (u32, usize), name: LayerName, pen: Pen, options: &PlotOptions) -> Self {
        let called = || options.object_names.get(object as usize).map_or("object", String::as_str);
        let (number, label) = match options.layers {
            _ if name == LayerName::Outline => (u64::from(name.number()), name.to_string()),
            LayersBy::Kind => (u64::from(name.number()), name.to_string()),
            LayersBy::Object => {
                // The numbers of the outline and of the fill stay free.
                let number = u64::from(object) + 1;
                let skipped = [OUTLINE, FILL - 1].iter().filter(|&&taken| number >= u64::from(taken)).count();
                (number + skipped as u64, called().to_owned())
            }
            LayersBy::Both => {
                let number = (u64::from(object) + 1) * PER_OBJECT + u64::from(name.number());
                (number, format!("{} {name}", called()))
            }
        };
        let by = if name == LayerName::Outline { LayersBy::Kind } else { options.layers };
        Self { name, number, label, pen, paths: Paths::default(), views: Vec::new(), order: (object, rank), by }
    }

    /// An identifier of the file's layer, such as `silhouette-visible`; `layer-2` and so on where layers are by object.
    pub fn id(&self) -> String {
        if self.by == LayersBy::Kind { self.name.id() } else { format!("layer-{}", self.number) }
    }

    /// An identifier of what one pen draws in the file's layer: that of the layer, with its own name where the layer has several.
    pub(super) fn entry_id(&self) -> String {
        if self.by == LayersBy::Kind { self.id() } else { format!("{}-{}", self.id(), self.name.id()) }
    }

    /// What a format calls it whose layers have one pen each.
    pub(super) fn entry_label(&self) -> String {
        match self.by {
            LayersBy::Object => format!("{} {} {}", self.number, self.label, self.name),
            LayersBy::Kind | LayersBy::Both => format!("{} {}", self.number, self.label),
        }
    }

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

    #[test]
    fn numbers_are_fixed_and_differ() {
        let mut numbers: Vec<u32> = LayerName::all().map(LayerName::number).collect();
        numbers.sort_unstable();
        let kinds = LineKind::ALL.len() as u32;
        let expected: Vec<u32> = (1..=kinds).chain(21..=20 + kinds).chain([40]).collect();
        assert_eq!(numbers, expected);
        let pen = Pen::new(super::super::length::Length::mm(0.5));
        let ridge = LayerName::Lines { kind: LineKind::Ridge, visible: true };
        for layers in [LayersBy::Object, LayersBy::Both] {
            let options = PlotOptions { layers, object_names: vec!["a".to_owned()], ..PlotOptions::default() };
            let numbers: Vec<u64> = (0..200).map(|at| Layer::new((at, 0), ridge, pen, &options).number).collect();
            assert!(numbers.is_sorted() && !numbers.contains(&u64::from(OUTLINE)));
            assert_eq!(numbers[0], if layers == LayersBy::Object { 1 } else { 103 });
            assert!(Layer::new((0, 0), ridge, pen, &options).label.starts_with('a'));
        }
    }
}

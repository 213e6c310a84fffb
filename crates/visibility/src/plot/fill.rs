//! What is filled beneath the strokes: all that the meshes cover.

use super::merge;
use super::options::PlotOptions;
use super::paths::Paths;
use super::pen::Colour;
use super::place::{Placement, place_outline};
use crate::lines::Lines;

/// The area that the meshes cover on the page, in a colour.
#[derive(Debug, Clone, PartialEq)]
pub struct Fill {
    /// With what it is filled.
    pub colour: Colour,
    /// Polygons in page units that belong together, to be filled by the even-odd rule.
    pub paths: Paths,
}

impl Fill {
    /// The fill that the options name: that of the outline, cut off as lines are; `None` where nothing is covered. O(points).
    pub(super) fn of(lines: &Lines, options: &PlotOptions, placement: &Placement) -> Option<Self> {
        let colour = options.fill?;
        let mut paths = Paths::default();
        place_outline(&lines.outline.rings, &lines.camera, placement, &mut paths);
        let paths = merge::merge(&paths, options.merge_tolerance.to(options.unit));
        (!paths.is_empty()).then_some(Self { colour, paths })
    }
}

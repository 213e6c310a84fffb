//! Step 3: the union of what is inside of closed polygons.

use super::lattice::{Point, area};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::{IntOverlayOptions, Overlay, ShapeType};
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::core::solver::{Precision, Solver};
use i_overlay::i_float::int::point::IntPoint;

/// Regions and holes smaller than this are rounding: two edges of a T junction that lie on each other may be projected
/// `1e-12` pixels apart.
const LEAST_AREA_PX: f64 = 1e-6;

/// How near to an end of an edge a crossing falls on that end: `2^-20` pixels at first, being `2^16` lines of the lattice of
/// which `i_overlay` takes the square, and 16 times as much each time that new crossings have to be looked for. Edges that
/// coincide but for rounding cross in many places; without this, each of those makes more of them.
const SNAPPING: Precision = Precision { start: 2 * 16, progression: 2 * 4 };

/// The rings around what has a winding number above 0, and around the holes in it. Winding
/// numbers below 0 come from rounding only.
pub fn union(polygons: &[Vec<Point>]) -> Vec<Vec<Point>> {
    let options = IntOverlayOptions { min_output_area: area(LEAST_AREA_PX) as u128, ..IntOverlayOptions::ogc() };
    let count = polygons.iter().map(Vec::len).sum();
    let mut overlay = Overlay::<i64>::new_custom(count, options, Solver::with_precision(SNAPPING));
    for polygon in polygons {
        overlay.add_path_iter(polygon.iter().map(|&[x, y]| IntPoint::new(x, y)), ShapeType::Subject);
    }
    let ring = |ring: Vec<IntPoint<i64>>| ring.into_iter().map(|point| [point.x, point.y]).collect();
    overlay.overlay(OverlayRule::Subject, FillRule::Positive).into_iter().flatten().map(ring).collect()
}

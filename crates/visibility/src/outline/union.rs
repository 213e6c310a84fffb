//! Step 3: the union of what is inside of closed polygons.

use super::Outline;
use super::lattice::{Point, area, pixel};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::{IntOverlayOptions, Overlay, ShapeType};
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::i_float::int::point::IntPoint;

/// Regions and holes smaller than this are rounding: two edges of a T junction that lie on each other may be projected
/// `1e-12` pixels apart.
const LEAST_AREA_PX: f64 = 1e-6;

/// The outline of what has a winding number above 0. Below it is only what rounding has turned over.
pub fn union(polygons: &[Vec<Point>]) -> Outline {
    let options = IntOverlayOptions { min_output_area: area(LEAST_AREA_PX) as u128, ..IntOverlayOptions::ogc() };
    let count = polygons.iter().map(Vec::len).sum();
    let mut overlay = Overlay::<i64>::new_custom(count, options, i_overlay::core::solver::Solver::default());
    for polygon in polygons {
        overlay.add_path_iter(polygon.iter().map(|&[x, y]| IntPoint::new(x, y)), ShapeType::Subject);
    }
    let ring = |ring: Vec<IntPoint<i64>>| ring.into_iter().map(|point| pixel([point.x, point.y])).collect();
    let regions = overlay.overlay(OverlayRule::Subject, FillRule::Positive);
    Outline::of_regions(regions.into_iter().map(|region| region.into_iter().map(ring).collect()))
}

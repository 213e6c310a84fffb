//! How large the arcs of path data are, before they are followed. An arc becomes cubics that keep within a tenth of a unit, and their
//! number grows as the sixth root of its radius: a radius with too many digits would make more of them than fit in memory.

use glam::DVec2;
use svgtypes::{PathParser, PathSegment};

/// Largest radius of an arc in its own units, which some fifty cubics follow.
pub const MAX_ARC_RADIUS: f64 = 1e9;

/// A smaller radius makes a straight line of an arc.
const LEAST_RADIUS: f64 = 1e-5;

/// Whether the radii of all arcs stay below [`MAX_ARC_RADIUS`], also where they have to grow for the arc to reach its end (SVG 2, section
/// 9.5.1). Data is looked at up to its first fault.
pub fn are_small(data: &str) -> bool {
    let (mut from, mut begin) = (DVec2::ZERO, DVec2::ZERO);
    for segment in PathParser::from(data).map_while(Result::ok) {
        let base = if segment.is_abs() { DVec2::ZERO } else { from };
        let to = match segment {
            PathSegment::MoveTo { x, y, .. }
            | PathSegment::LineTo { x, y, .. }
            | PathSegment::CurveTo { x, y, .. }
            | PathSegment::SmoothCurveTo { x, y, .. }
            | PathSegment::Quadratic { x, y, .. }
            | PathSegment::SmoothQuadratic { x, y, .. }
            | PathSegment::EllipticalArc { x, y, .. } => base + DVec2::new(x, y),
            PathSegment::HorizontalLineTo { x, .. } => DVec2::new(base.x + x, from.y),
            PathSegment::VerticalLineTo { y, .. } => DVec2::new(from.x, base.y + y),
            PathSegment::ClosePath { .. } => begin,
        };
        if let PathSegment::EllipticalArc { rx, ry, x_axis_rotation, .. } = segment {
            let radii = DVec2::new(rx, ry).abs();
            // Half of the chord in the ellipse's own axes.
            let chord = DVec2::from_angle(-x_axis_rotation.to_radians()).rotate(0.5 * (from - to));
            let growth = if radii.min_element() > LEAST_RADIUS { (chord / radii).length().max(1.0) } else { 1.0 };
            let is_small = radii.max_element() * growth <= MAX_ARC_RADIUS;
            if !is_small {
                return false;
            }
        }
        if matches!(segment, PathSegment::MoveTo { .. }) {
            begin = to;
        }
        from = to;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radii_count_as_large_as_the_end_of_the_arc_makes_them() {
        for small in [
            "M0 0 A5 3 0 0 1 10 0",
            "M0 0 A1e9 1 0 0 1 10 0",
            "M0 0 A5 1e-9 0 0 1 1e30 0",
            "M1e30 0 L 0 0 a 5 3 0 0 1 1e9 0 h 1e30 V 4 H 0 a 5 3 0 0 1 1e9 0",
            "M7 7 h 1e30 z a 5 3 30 0 1 1e9 0",
            "M1 1 L",
        ] {
            assert!(are_small(small), "{small}");
        }
        for large in [
            "M0 0 A1.1e9 1 0 0 1 10 0",
            "M0 0 A5 3 0 0 1 0 1e10",
            // The chord lies along the short axis, which is a thousandth of the long one.
            "M0 0 A1 1e-3 90 0 1 1e7 0",
            "M0 0 h 1e30 A5 3 0 0 1 0 0",
            "M0 0 v 1e10 a 5 3 0 0 1 0 0 5 3 0 0 1 -9 -1e10",
            "M7 7 l 1e300 1e300 l 1e300 1e300 A5 3 0 0 1 0 0",
        ] {
            assert!(!are_small(large), "{large}");
        }
    }
}

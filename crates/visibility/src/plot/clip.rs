//! [`clip`]: segments and polygons are cut off at a rectangle.

use super::paths::Segment;
use silhouette_core::glam::DVec2;

/// A rectangle with its sides along the axes; without area, or with nothing, where `max` is not above `min`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rectangle {
    pub min: DVec2,
    pub max: DVec2,
}

impl Rectangle {
    pub fn size(&self) -> DVec2 {
        self.max - self.min
    }

    pub fn middle(&self) -> DVec2 {
        (self.min + self.max) * 0.5
    }

    pub fn common_with(&self, other: &Self) -> Self {
        Self { min: self.min.max(other.min), max: self.max.min(other.max) }
    }

    pub fn holds(&self, point: DVec2) -> bool {
        point.cmpge(self.min).all() && point.cmple(self.max).all()
    }
}

/// Hands the parts of a segment that lie in the rectangle to `take`, in order. Ends that lie inside are kept to the bit.
/// A segment with a coordinate that is not finite lies nowhere.
pub(super) fn clip(segment: &Segment, rectangle: &Rectangle, mut take: impl FnMut(Segment)) {
    let handles = segment.handles.iter().flatten();
    if [segment.from, segment.to].iter().chain(handles).any(|point| !point.is_finite()) {
        return;
    }
    match segment.handles {
        None => {
            if let Some([from_t, to_t]) = span_inside(segment.from, segment.to, rectangle) {
                let cut = |t| segment.at(t).clamp(rectangle.min, rectangle.max);
                take(Segment { from: cut(from_t), to: cut(to_t), handles: None });
            }
        }
        Some(handles) => {
            if [segment.from, segment.to].iter().chain(&handles).all(|&point| rectangle.holds(point)) {
                return take(*segment);
            }
            let cuts = crossings(segment, rectangle);
            let parts = cuts.windows(2).filter(|cut| cut[0] < cut[1]);
            parts
                .filter(|cut| rectangle.holds(segment.at((cut[0] + cut[1]) * 0.5)))
                .for_each(|cut| take(segment.part(cut[0], cut[1])));
        }
    }
}

/// The parameters between which a straight segment lies inside (Liang and Barsky 1984).
fn span_inside(from: DVec2, to: DVec2, rectangle: &Rectangle) -> Option<[f64; 2]> {
    let way = to - from;
    let mut span = [0.0_f64, 1.0];
    for axis in 0..2 {
        let [near, far] = [rectangle.min[axis], rectangle.max[axis]].map(|side| side - from[axis]);
        if way[axis] == 0.0 {
            if near > 0.0 || far < 0.0 {
                return None;
            }
            continue;
        }
        let [near, far] = [near / way[axis], far / way[axis]];
        span = [span[0].max(near.min(far)), span[1].min(near.max(far))];
    }
    (span[0] < span[1]).then_some(span)
}

/// 0, 1 and the parameters between them at which a curve crosses a side of the rectangle, ascending.
fn crossings(segment: &Segment, rectangle: &Rectangle) -> Vec<f64> {
    let mut cuts = vec![0.0, 1.0];
    let Some([a, b]) = segment.handles else { return cuts };
    for axis in 0..2 {
        let [p, a, b, q] = [segment.from, a, b, segment.to].map(|point| point[axis]);
        // Between its turning points a coordinate is monotone, so that bisection finds where it passes a side.
        let mut turns = vec![0.0, 1.0];
        turns.extend(roots(3.0 * (q - p) - 9.0 * (b - a), 6.0 * (p - 2.0 * a + b), 3.0 * (a - p)));
        turns.sort_by(f64::total_cmp);
        for side in [rectangle.min[axis], rectangle.max[axis]] {
            for pair in turns.windows(2) {
                let [low, high] = [pair[0], pair[1]].map(|t| segment.at(t)[axis] < side);
                if low != high {
                    cuts.push(bisect(pair[0], pair[1], |t| (segment.at(t)[axis] < side) == low));
                }
            }
        }
    }
    cuts.sort_by(f64::total_cmp);
    cuts
}

/// Roots of `a t^2 + b t + c` between 0 and 1.
fn roots(a: f64, b: f64, c: f64) -> impl Iterator<Item = f64> {
    let root = (b * b - 4.0 * a * c).sqrt();
    let far = -0.5 * (b + root.copysign(b));
    [far / a, c / far].into_iter().filter(|&t| t > 0.0 && t < 1.0)
}

/// The least number from which on `holds` is false.
fn bisect(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..f64::MANTISSA_DIGITS {
        let middle = (low + high) * 0.5;
        if holds(middle) { low = middle } else { high = middle }
    }
    high
}

/// The part of a polygon that lies in the rectangle (Sutherland and Hodgman 1974). Where the polygon leaves the rectangle
/// the part runs along its side, so that the even-odd rule fills what it did before. O(corners).
pub(super) fn clip_polygon(polygon: &[DVec2], rectangle: &Rectangle) -> Vec<DVec2> {
    let mut corners: Vec<_> = polygon.iter().copied().filter(|corner| corner.is_finite()).collect();
    for axis in 0..2 {
        for (side, sign) in [(rectangle.min[axis], 1.0), (rectangle.max[axis], -1.0)] {
            let depth = |corner: DVec2| (corner[axis] - side) * sign;
            let Some(&last) = corners.last() else { return corners };
            let mut kept = Vec::with_capacity(corners.len() + 2);
            let mut from = last;
            for &to in &corners {
                let (before, after) = (depth(from), depth(to));
                if (before < 0.0) != (after < 0.0) {
                    let mut cut = from.lerp(to, before / (before - after));
                    cut[axis] = side;
                    kept.push(cut);
                }
                if after >= 0.0 {
                    kept.push(to);
                }
                from = to;
            }
            corners = kept;
        }
    }
    corners
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const ROOM: Rectangle = Rectangle { min: DVec2::new(0.0, 0.0), max: DVec2::new(4.0, 3.0) };

    fn parts(segment: Segment) -> Vec<Segment> {
        let mut parts = Vec::new();
        clip(&segment, &ROOM, |part| parts.push(part));
        parts
    }

    fn straight(from: [f64; 2], to: [f64; 2]) -> Segment {
        Segment { from: from.into(), to: to.into(), handles: None }
    }

    #[test]
    fn straight_segments_are_cut_at_the_sides() {
        assert_eq!(parts(straight([-1.0, 1.0], [9.0, 1.0])), [straight([0.0, 1.0], [4.0, 1.0])]);
        assert_eq!(parts(straight([1.0, 1.0], [2.0, 2.5])), [straight([1.0, 1.0], [2.0, 2.5])]);
        for outside in
            [straight([-1.0, 1.0], [-1.0, 2.0]), straight([-1.0, 1.0], [1.0, -3.0]), straight([5.0, 0.0], [9.0, 9.0])]
        {
            assert_eq!(parts(outside), []);
        }
        assert_eq!(parts(straight([f64::NAN, 1.0], [2.0, 2.5])), []);
        assert_eq!(parts(straight([1.0, 1.0], [f64::INFINITY, 2.5])), []);
        let far = parts(straight([-1e9, 1.0], [1e9, 1.0]));
        assert_eq!((far[0].from.x, far[0].to.x), (0.0, 4.0));
    }

    #[test]
    fn a_curve_that_leaves_and_returns_has_two_parts() {
        let arch = Segment {
            from: DVec2::new(0.5, 2.0),
            to: DVec2::new(3.5, 2.0),
            handles: Some([DVec2::new(0.5, 6.0), DVec2::new(3.5, 6.0)]),
        };
        let found = parts(arch);
        assert_eq!(found.len(), 2);
        assert_eq!((found[0].from, found[1].to), (arch.from, arch.to));
        for y in [found[0].to.y, found[1].from.y] {
            assert!((y - 3.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_polygon_around_the_room_becomes_the_room() {
        let around = [[-9.0, -9.0], [9.0, -9.0], [9.0, 9.0], [-9.0, 9.0]].map(DVec2::from);
        assert!((area(&clip_polygon(&around, &ROOM)) - 12.0).abs() < 1e-12);
        assert!(clip_polygon(&around.map(|corner| corner + 100.0), &ROOM).is_empty());
    }

    fn area(polygon: &[DVec2]) -> f64 {
        let next = polygon.iter().cycle().skip(1);
        polygon.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum::<f64>() * 0.5
    }

    fn point() -> impl Strategy<Value = DVec2> {
        (-3.0..7.0, -3.0..6.0).prop_map(|(x, y)| DVec2::new(x, y))
    }

    proptest! {
        /// A sample of the curve is inside exactly where a part passes through it.
        #[test]
        fn parts_of_a_curve_are_what_lies_inside(from in point(), a in point(), b in point(), to in point()) {
            let curve = Segment { from, to, handles: Some([a, b]) };
            let found = parts(curve);
            let samples = |segment: &Segment| (0..=400).map(|i| segment.at(f64::from(i) / 400.0)).collect::<Vec<_>>();
            let margin = |point: DVec2| (point - ROOM.min).min(ROOM.max - point).min_element();
            let inside: Vec<_> = found.iter().flat_map(samples).collect();
            prop_assert!(inside.iter().all(|&point| margin(point) > -1e-9));
            for point in samples(&curve).into_iter().filter(|&point| margin(point) > 0.0) {
                let nearest = inside.iter().map(|sample| sample.distance(point)).fold(f64::INFINITY, f64::min);
                prop_assert!(nearest < 0.1, "{point} is missing by {nearest}");
            }
        }

        #[test]
        fn a_polygons_part_is_no_larger(corners in prop::collection::vec(point(), 3..4)) {
            let part = clip_polygon(&corners, &ROOM);
            prop_assert!(part.iter().all(|&corner| ROOM.holds(corner)));
            prop_assert!(area(&part).abs() <= area(&corners).abs() + 1e-9);
            let kept = corners.iter().filter(|&&corner| ROOM.holds(corner));
            prop_assert!(kept.clone().all(|corner| part.iter().any(|other| other.distance(*corner) < 1e-12)));
        }
    }
}

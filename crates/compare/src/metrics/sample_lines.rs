//! Lines drawn by arithmetic, with their truth, and the ways in which the tests make a picture worse.

use super::ink::Ink;
use crate::truth::samples::TrueLines;
use crate::truth::visible::VisibleLine;
use glam::DVec2;
use silhouette_core::EdgeId;

/// Width of the pen in every sample.
pub const PEN_PX: f64 = 3.0;

const SIZE: u32 = 128;

pub struct SampleLines {
    pub lines: TrueLines,
    pub pen: Ink,
}

/// A long line, a second one that crosses it, and a third apart from both.
pub fn crossing_lines() -> SampleLines {
    let point = DVec2::new;
    draw(&[
        (vec![point(12.3, 20.1), point(115.2, 71.7)], false),
        (vec![point(30.6, 90.4), point(72.8, 14.2)], false),
        (vec![point(20.5, 110.5), point(110.5, 110.5)], false),
    ])
}

/// A closed square.
pub fn square() -> SampleLines {
    let corners = [(30.2, 30.6), (100.2, 30.6), (100.2, 100.6), (30.2, 100.6), (30.2, 30.6)];
    draw(&[(corners.map(|(x, y)| DVec2::new(x, y)).to_vec(), true)])
}

fn draw(polylines: &[(Vec<DVec2>, bool)]) -> SampleLines {
    let mut drawn = Vec::new();
    let mut segments = Vec::new();
    for (points, closed) in polylines {
        let edges = (0..).map(|at| EdgeId::from_usize(segments.len() + at)).take(points.len() - 1).collect();
        // The last point of a closed line repeats the first.
        let distinct = if *closed { &points[1..] } else { &points[..] };
        segments.extend(points.windows(2).map(|pair| (pair[0], pair[1])));
        drawn.push(VisibleLine { points: distinct.to_vec(), edges, closed: *closed });
    }
    let lines = TrueLines::of(&drawn);
    let distance = |p: DVec2, (a, b): (DVec2, DVec2)| {
        let share = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        p.distance(a.lerp(b, share))
    };
    let pen = Ink::from_fn(SIZE, SIZE, |x, y| {
        let inside = (0..64).filter(|sub| {
            let offset = DVec2::new(f64::from(sub % 8) + 0.5, f64::from(sub / 8) + 0.5) / 8.0;
            let point = DVec2::new(f64::from(x), f64::from(y)) + offset;
            segments.iter().any(|&segment| distance(point, segment) <= PEN_PX * 0.5)
        });
        inside.count() as f32 / 64.0
    });
    SampleLines { lines, pen }
}

/// Erases a band of columns.
pub fn erase_stretch(ink: &Ink) -> Ink {
    Ink::from_fn(SIZE, SIZE, |x, y| if (40..60).contains(&x) { 0.0 } else { ink.coverage(x.into(), y.into()) })
}

/// Erases a disc.
pub fn erase_around(ink: &Ink, center: DVec2, radius: f64) -> Ink {
    Ink::from_fn(SIZE, SIZE, |x, y| {
        let point = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        if point.distance(center) < radius { 0.0 } else { ink.coverage(x.into(), y.into()) }
    })
}

/// Erases every fourth band of five columns.
pub fn punch_holes(ink: &Ink) -> Ink {
    Ink::from_fn(SIZE, SIZE, |x, y| if x / 5 % 4 == 0 { 0.0 } else { ink.coverage(x.into(), y.into()) })
}

/// Moves the picture to the right.
pub fn shift_right(ink: &Ink, by: u32) -> Ink {
    Ink::from_fn(SIZE, SIZE, |x, y| ink.coverage(i64::from(x) - i64::from(by), y.into()))
}

/// Adds a regular pattern of single black pixels.
pub fn add_specks(ink: &Ink) -> Ink {
    Ink::from_fn(SIZE, SIZE, |x, y| if x % 16 == 3 && y % 16 == 5 { 1.0 } else { ink.coverage(x.into(), y.into()) })
}

/// Spreads the ink by a pixel in all directions.
pub fn thicken(ink: &Ink) -> Ink {
    let spread = |x: u32, y: u32| {
        let around = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (i64::from(x) + dx, i64::from(y) + dy)));
        around.map(|(x, y)| ink.coverage(x, y)).fold(0.0, f32::max)
    };
    Ink::from_fn(SIZE, SIZE, spread)
}

/// Spreads the ink by a pixel in the left half of the picture only.
pub fn thicken_left_half(ink: &Ink) -> Ink {
    let thick = thicken(ink);
    let side = |x: u32| if x < SIZE / 2 { &thick } else { ink };
    Ink::from_fn(SIZE, SIZE, |x, y| side(x).coverage(x.into(), y.into()))
}

//! Merging and ordering, measured by other means than their own.

use crate::scene::{SIDE, drawn, lines_of, orthographic};
use proptest::prelude::*;
use silhouette_core::NoProgress;
use silhouette_core::glam::DVec2;
use silhouette_testing::Random;
use silhouette_visibility::LineKind;
use silhouette_visibility::plot::{Drawing, Length, PlotOptions, Unit, plot};

fn plotted(paths: &[(Vec<[f64; 2]>, bool)], tolerance: f64, order: bool) -> Drawing {
    let all: Vec<_> = paths
        .iter()
        .map(|(points, closed)| {
            let path = drawn(LineKind::Silhouette, points);
            if *closed { path.closed() } else { path }
        })
        .collect();
    let options = PlotOptions {
        unit: Unit::Px,
        sheet: None,
        merge_tolerance: Length::px(tolerance),
        min_length: Length::px(0.0),
        dedupe: false,
        order,
        ..PlotOptions::default()
    };
    plot(&lines_of(orthographic(), &all), &options, &NoProgress).unwrap()
}

fn distance_to_segment(point: DVec2, from: DVec2, to: DVec2) -> f64 {
    let way = to - from;
    let share = if way == DVec2::ZERO { 0.0 } else { ((point - from).dot(way) / way.length_squared()).clamp(0.0, 1.0) };
    point.distance(from + way * share)
}

/// Whether the points can be assigned to segments in order, each within the tolerance of its segment.
fn follows(points: &[DVec2], merged: &[DVec2], tolerance: f64) -> bool {
    let mut segment = 0;
    points.iter().all(|&point| {
        while distance_to_segment(point, merged[segment], merged[segment + 1]) > tolerance {
            segment += 1;
            if segment + 1 >= merged.len() {
                return false;
            }
        }
        true
    })
}

/// A wandering path: smooth enough that points can be dropped, with turns back.
fn wandering() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let step = (0.0..3.0_f64, prop_oneof![4 => -0.2..0.2_f64, 1 => -3.2..3.2_f64]);
    prop::collection::vec(step, 2..60).prop_map(|steps| {
        let (mut at, mut angle) = (DVec2::splat(50.0), 0.0);
        let mut points = vec![at.to_array()];
        for (length, turn) in steps {
            angle += turn;
            at = (at + DVec2::from_angle(angle) * length).clamp(DVec2::ZERO, DVec2::splat(100.0));
            points.push(at.to_array());
        }
        points
    })
}

proptest! {
    #[test]
    fn merging_stays_within_its_tolerance(points in wandering(), closed in any::<bool>(), tolerance in 0.0..1.0_f64) {
        let drawing = plotted(&[(points.clone(), closed && points.len() > 2)], tolerance, false);
        prop_assume!(!drawing.layers.is_empty());
        let path = drawing.layers[0].paths.get(0);
        let mut points: Vec<_> = points.into_iter().map(DVec2::from).collect();
        let mut merged = path.points.to_vec();
        prop_assert!(merged.iter().all(|corner| points.contains(corner)), "no point is new");
        if path.closed {
            let first = points.iter().position(|&point| point == merged[0]).unwrap();
            points.rotate_left(first);
            points.push(points[0]);
            merged.push(merged[0]);
        }
        let slack = tolerance + 1e-9;
        if path.closed || !closed {
            prop_assert!(follows(&points, &merged, slack));
            // The check can fail: one corner less, or a line elsewhere, and points are farther away.
            let elsewhere: Vec<_> = merged.iter().map(|&corner| corner + 3.0 * slack).collect();
            prop_assert!(!follows(&points, &elsewhere, slack));
        }
        for &point in &points {
            let nearest = merged.windows(2).map(|pair| distance_to_segment(point, pair[0], pair[1]));
            prop_assert!(nearest.fold(f64::INFINITY, f64::min) <= slack);
        }
    }
}

#[test]
fn collinear_pieces_become_one_and_corners_stay() {
    let merged = |points: &[[f64; 2]], closed| {
        let drawing = plotted(&[(points.to_vec(), closed)], 0.01, false);
        drawing.layers[0].paths.get(0).points.to_vec()
    };
    let ruler: Vec<_> = (0..=50).map(|step| [10.0 + f64::from(step), 20.0 + 0.1 * f64::from(step)]).collect();
    assert_eq!(merged(&ruler, false), [[10.0, 20.0], [60.0, 25.0]].map(DVec2::from));
    let back = [[10.0, 10.0], [20.0, 10.0], [30.0, 10.0], [20.0, 10.0], [15.0, 10.0]];
    assert_eq!(merged(&back, false), [[10.0, 10.0], [30.0, 10.0], [15.0, 10.0]].map(DVec2::from));
    let square = [[15.0, 10.0], [20.0, 10.0], [20.0, 20.0], [10.0, 20.0], [10.0, 10.0]];
    assert_eq!(merged(&square, true).len(), 4, "also where the path begins in the middle of a side");
    let circle: Vec<_> = (0..1000)
        .map(|step| (DVec2::from_angle(f64::from(step) * 0.002 * std::f64::consts::PI) * 40.0 + 50.0).to_array())
        .collect();
    let corners = merged(&circle, true).len();
    // A chord of a circle of radius r that is s off at its middle spans an angle of about sqrt(8 s / r).
    let least = std::f64::consts::TAU / (8.0 * 0.01 / 40.0_f64).sqrt();
    assert!(corners as f64 >= least && (corners as f64) < 1.5 * least, "{corners} corners, at least {least:.0}");
}

/// Strokes of a comb, shuffled: the best way between them is known.
#[test]
fn a_shuffled_comb_is_drawn_to_and_fro() {
    let count = 64;
    let tooth = |index: usize| (vec![[10.0 + index as f64, 20.0], [10.0 + index as f64, 60.0]], false);
    let teeth: Vec<_> = (0..count).map(|index| tooth(index * 37 % count)).collect();
    let stats = plotted(&teeth, 0.0, true).stats;
    assert!((stats.travel.after - (count as f64 - 1.0)).abs() < 1e-9, "{:?}", stats.travel);
    assert!(stats.travel.before > 20.0 * stats.travel.after, "{:?}", stats.travel);
}

#[test]
fn closed_paths_begin_where_the_pen_is() {
    let square = |x: f64| (vec![[x + 8.0, 28.0], [x, 28.0], [x, 20.0], [x + 8.0, 20.0]], true);
    let travel = plotted(&[square(10.0), square(30.0), square(20.0)], 0.0, true).stats.travel;
    assert!((travel.after - 20.0).abs() < 1e-9, "each square is left where it was begun: {travel:?}");
}

/// The shortest tour of small sets, by trying all.
#[test]
fn small_tours_are_close_to_the_best() {
    let mut random = Random::new(1);
    let mut point = || DVec2::new(random.unit(), random.unit()) * SIDE;
    let (mut found, mut best) = (0.0, 0.0);
    for _ in 0..40 {
        let paths: Vec<[DVec2; 2]> = (0..6).map(|_| [point(), point()]).collect();
        let strokes: Vec<_> = paths.iter().map(|ends| (ends.map(|end| end.to_array()).to_vec(), false)).collect();
        found += plotted(&strokes, 0.0, true).stats.travel.after;
        best += shortest(&paths, None, 0);
    }
    assert!(found >= best - 1e-6 && found < 1.1 * best, "{found:.1} against {best:.1}");
}

/// The shortest way through the paths that `done` does not hold, from a place or from anywhere.
fn shortest(paths: &[[DVec2; 2]], from: Option<DVec2>, done: u32) -> f64 {
    let left = (0..paths.len()).filter(|path| done & 1 << path == 0);
    let ways = left.flat_map(|path| {
        [0, 1].map(|end| {
            let hop = from.map_or(0.0, |from| from.distance(paths[path][end]));
            hop + shortest(paths, Some(paths[path][1 - end]), done | 1 << path)
        })
    });
    ways.reduce(f64::min).unwrap_or(0.0)
}

//! Strokes of a pattern where lines lie on each other.

use crate::scene::{Drawn, drawn, lines_of, orthographic};
use proptest::prelude::*;
use silhouette_core::NoProgress;
use silhouette_core::glam::DVec2;
use silhouette_visibility::LineKind;
use silhouette_visibility::plot::{Dash, Drawing, Hidden, Layer, LayerName, Length, PlotOptions, Segment, Unit, plot};

/// Side of the squares that the paths of these tests lead along, in pixels.
const GRID: f64 = 10.0;

fn dashed(all: &[Drawn], [on, off]: [f64; 2]) -> Drawing {
    let all: Vec<Drawn> = all.iter().map(|path| path.clone().hidden(1)).collect();
    let options = PlotOptions {
        unit: Unit::Px,
        sheet: None,
        hidden: Hidden::Dashed(Dash { on: Length::px(on), off: Length::px(off) }),
        merge_tolerance: Length::px(0.0),
        min_length: Length::px(0.0),
        dedupe: false,
        order: false,
        ..PlotOptions::default()
    };
    plot(&lines_of(orthographic(), &all), &options, &NoProgress).unwrap()
}

/// A side of a square of the grid: where it begins, and whether it leads down rather than right.
type Side = ([i64; 2], bool);

/// The sides that a path leads along, each as often as it does.
fn sides(path: &Drawn) -> Vec<Side> {
    let count = path.pixels.len();
    let segments = count - usize::from(!path.closed);
    let ends = (0..segments).map(|index| [path.pixels[index], path.pixels[(index + 1) % count]]);
    ends.flat_map(|[from, to]| {
        let [from, to] = [from, to].map(|point| (point / GRID).round().as_i64vec2());
        let (low, high, down) = (from.min(to), from.max(to), from.x == to.x);
        (low.x..high.x.max(low.x + i64::from(down)))
            .flat_map(move |x| (low.y..high.y.max(low.y + i64::from(!down))).map(move |y| ([x, y], down)))
    })
    .collect()
}

/// What of a side the strokes of a layer cover, in pixels from its begin, with what two of them cover twice.
fn covered(layer: &Layer, (begin, down): Side) -> Vec<[f64; 2]> {
    let begin = DVec2::new(begin[0] as f64, begin[1] as f64) * GRID;
    let way = if down { DVec2::Y } else { DVec2::X };
    let segments = layer.paths.iter().flat_map(|path| path.segments().collect::<Vec<_>>());
    let parts = segments.filter_map(|segment| {
        let [from, to] = [segment.from, segment.to].map(|point| point - begin);
        let beside = [from, to].iter().all(|point| way.perp_dot(*point).abs() < 1e-6);
        let [from, to] = [from, to].map(|point| way.dot(point).clamp(0.0, GRID));
        (beside && (from < to || to < from)).then_some([from.min(to), from.max(to)])
    });
    let mut parts: Vec<_> = parts.collect();
    parts.sort_by(|one, other| one[0].total_cmp(&other[0]));
    parts
}

/// Length of what intervals cover, which come by their begins, each place once.
fn union(parts: &[[f64; 2]]) -> f64 {
    let (mut length, mut done) = (0.0, 0.0);
    for &[from, to] in parts {
        length += f64::max(to - f64::max(from, done), 0.0);
        done = f64::max(done, to);
    }
    length
}

/// How far the strokes of paths that lie on each other do not: the strokes of each layer cover each side of the grid that its path
/// leads along, once or several times, where those of all layers together do. The length by which they do not, in pixels; 0 at best.
fn out_of_phase(all: &[Drawn], layers: &[&Layer]) -> f64 {
    let sides_of: Vec<Vec<Side>> = all.iter().map(sides).collect();
    let mut every: Vec<Side> = sides_of.iter().flatten().copied().collect();
    every.sort_unstable();
    every.dedup();
    let mut off = 0.0;
    for side in every {
        let of_layers: Vec<_> = layers.iter().map(|layer| covered(layer, side)).collect();
        let mut together = of_layers.concat();
        together.sort_by(|one, other| one[0].total_cmp(&other[0]));
        let together = union(&together);
        for (path, sides) in all.iter().zip(&sides_of) {
            let times = sides.iter().filter(|&&other| other == side).count();
            let layer = layers.iter().position(|layer| is_of(layer, path.kind)).expect("the kind is drawn");
            let drawn: f64 = of_layers[layer].iter().map(|[from, to]| to - from).sum();
            // A loop without an inside is drawn as one line.
            off += (1..=times).map(|times| (times as f64 * together - drawn).abs()).reduce(f64::min).unwrap_or(0.0);
        }
    }
    off
}

fn is_of(layer: &Layer, kind: LineKind) -> bool {
    layer.name == LayerName::Lines { kind, visible: false }
}

/// Paths along the grid, of a kind each, some of them closed.
fn walks() -> impl Strategy<Value = Vec<Drawn>> {
    let steps = prop::collection::vec((0..4_usize, 1..4_i32), 1..10);
    let walk = (steps, 0..11_i32, 0..11_i32, any::<bool>()).prop_map(|(steps, x, y, closes)| {
        let mut at = [x, y];
        let mut points = vec![at];
        for (way, count) in steps {
            let step = [[1, 0], [0, 1], [-1, 0], [0, -1]][way];
            at = [0, 1].map(|axis| (at[axis] + step[axis] * count).clamp(0, 10));
            points.push(at);
        }
        if closes {
            points.push([points[0][0], at[1]]);
        }
        points.dedup();
        let closed = closes && points.len() > 3 && points[0] != points[points.len() - 1];
        (points.into_iter().map(|point| point.map(|at| f64::from(at) * GRID)).collect::<Vec<_>>(), closed)
    });
    prop::collection::vec(walk, 1..6).prop_map(|walks| {
        let kinds = LineKind::ALL.into_iter();
        let walks = walks.into_iter().filter(|(points, _)| points.len() > 1);
        let path = |(kind, (points, closed)): (LineKind, (Vec<[f64; 2]>, bool))| {
            let path = drawn(kind, &points);
            if closed { path.closed() } else { path }
        };
        kinds.zip(walks).map(path).collect()
    })
}

proptest! {
    #[test]
    fn strokes_of_lines_that_lie_on_each_other_coincide(all in walks(), on in 1.0..9.0_f64, off in 1.0..5.0_f64) {
        let drawing = dashed(&all, [on, off]);
        let off = out_of_phase(&all, &drawing.layers.iter().collect::<Vec<_>>());
        // Only what is left of a stroke at the end of a line, too short to be drawn, may differ.
        let lines = all.iter().map(|path| path.pixels.len() as f64).sum::<f64>();
        prop_assert!(off <= 0.04 * on * lines, "{off} px of strokes without a partner");
    }

    #[test]
    fn backwards_is_the_same(all in walks(), on in 1.0..9.0_f64, off in 1.0..5.0_f64) {
        let backwards = |path: &Drawn| Drawn { pixels: path.pixels.iter().rev().copied().collect(), ..path.clone() };
        let mut both: Vec<Drawn> = all.iter().take(1).cloned().collect();
        both.extend(all.iter().take(1).map(|path| Drawn { kind: LineKind::Mesh, ..backwards(path) }));
        let drawing = dashed(&both, [on, off]);
        let off = out_of_phase(&both, &drawing.layers.iter().collect::<Vec<_>>());
        prop_assert!(off <= 0.04 * on * both.iter().map(|path| path.pixels.len() as f64).sum::<f64>(), "{off}");
    }
}

/// The measure of this file moves where each line has a phase of its own.
#[test]
fn lines_dashed_each_by_itself_are_out_of_phase() {
    let all = [
        drawn(LineKind::Silhouette, &[[10.0, 10.0], [90.0, 10.0]]),
        drawn(LineKind::Ridge, &[[70.0, 10.0], [20.0, 10.0], [20.0, 50.0]]),
        drawn(LineKind::Mesh, &[[20.0, 10.0], [50.0, 10.0], [50.0, 50.0], [20.0, 50.0]]).closed(),
    ];
    let pattern = [6.0, 3.0];
    let together = dashed(&all, pattern);
    let alone: Vec<Drawing> = all.iter().map(|path| dashed(std::slice::from_ref(path), pattern)).collect();
    let together = out_of_phase(&all, &together.layers.iter().collect::<Vec<_>>());
    let alone = out_of_phase(&all, &alone.iter().flat_map(|drawing| &drawing.layers).collect::<Vec<_>>());
    assert!(together < 0.1 && alone > 20.0, "{together} px together, {alone} px alone");
}

/// A loop keeps its whole number of periods, and what lies on it has its strokes, through the loop's first point.
#[test]
fn a_line_on_a_loop_has_the_strokes_of_the_loop() {
    let square = drawn(LineKind::Ridge, &[[10.0, 10.0], [70.0, 10.0], [70.0, 70.0], [10.0, 70.0]]).closed();
    let corner = drawn(LineKind::Silhouette, &[[10.0, 50.0], [10.0, 10.0], [50.0, 10.0]]);
    let drawing = dashed(&[square.clone(), corner.clone()], [5.0, 3.0]);
    let [on_corner, on_square] = [LineKind::Silhouette, LineKind::Ridge]
        .map(|kind| drawing.layers.iter().find(|layer| is_of(layer, kind)).expect("the kind is drawn"));
    // 240 px are 30 periods of 8 px.
    assert_eq!(on_square.paths.len(), 30);
    assert!(on_square.paths.iter().all(|stroke| (stroke.length() - 5.0).abs() < 1e-9));
    for side in sides(&corner) {
        let (one, other) = (covered(on_corner, side), covered(on_square, side));
        assert!((union(&one) - union(&other)).abs() < 1e-6, "{side:?}: {one:?} {other:?}");
    }
    assert!(out_of_phase(&[square, corner], &[on_corner, on_square]) < 1e-6);
}

/// Where a line leaves another, its strokes run on, and it ends with a whole one.
#[test]
fn strokes_run_on_where_a_line_leaves_another() {
    let long = drawn(LineKind::Ridge, &[[5.0, 10.0], [95.0, 10.0]]);
    let leaving = drawn(LineKind::Silhouette, &[[30.0, 10.0], [57.0, 10.0], [57.0, 60.0]]);
    let drawing = dashed(&[long, leaving], [4.0, 2.0]);
    let strokes = &drawing.layers.iter().find(|layer| is_of(layer, LineKind::Silhouette)).unwrap().paths;
    assert_eq!(strokes.get(strokes.len() - 1).end(), DVec2::new(57.0, 60.0));
    let lengths: Vec<f64> = strokes.iter().map(|stroke| stroke.length()).collect();
    let inner = &lengths[1..lengths.len() - 1];
    assert!(inner.iter().all(|length| (3.7..4.3).contains(length)), "{lengths:?}");
}

/// Parts of a curve are other curves, drawn with other chords.
#[test]
fn strokes_of_a_part_of_a_curve_lie_on_those_of_the_curve() {
    let whole = Segment {
        from: DVec2::new(5.0, 80.0),
        to: DVec2::new(95.0, 70.0),
        handles: Some([DVec2::new(20.0, -60.0), DVec2::new(60.0, 60.0)]),
    };
    let part = whole.part(0.2, 0.83).reversed();
    let of = |kind, segment: &Segment| Drawn {
        handles: vec![segment.handles.unwrap()],
        ..drawn(kind, &[segment.from.to_array(), segment.to.to_array()])
    };
    let all = [of(LineKind::Ridge, &whole), of(LineKind::Curve, &part)];
    let samples = |layer: &Layer| -> Vec<DVec2> {
        let strokes = layer.paths.iter().flat_map(|stroke| stroke.segments().collect::<Vec<_>>());
        strokes.flat_map(|segment| (0..=50).map(move |step| segment.at(f64::from(step) / 50.0))).collect()
    };
    // How far strokes of the part reach beyond those of the curve.
    let beyond = |layers: &[&Layer]| {
        let [one, other] = [LineKind::Ridge, LineKind::Curve]
            .map(|kind| samples(layers.iter().find(|layer| is_of(layer, kind)).expect("the kind is drawn")));
        let nearest = |point: &DVec2| one.iter().map(|near| near.distance(*point)).fold(f64::INFINITY, f64::min);
        other.iter().map(nearest).fold(0.0, f64::max)
    };
    let pattern = [5.0, 3.0];
    let together = dashed(&all, pattern);
    let alone = all.clone().map(|path| dashed(&[path], pattern));
    let alone: Vec<&Layer> = alone.iter().flat_map(|drawing| &drawing.layers).collect();
    let (together, alone) = (beyond(&together.layers.iter().collect::<Vec<_>>()), beyond(&alone));
    assert!(together < 0.1 && alone > 1.0, "{together} px together, {alone} px alone");
}

//! From lines to strokes: what the options do.

use crate::scene::{any_lines, drawn, lines_of, orthographic, perspective};
use proptest::prelude::*;
use silhouette_core::glam::DVec2;
use silhouette_core::{Cancelled, NoProgress};
use silhouette_testing::Cancelling;
use silhouette_visibility::plot::{
    Dash, Drawing, Fit, Hidden, LayerName, Length, Page, PlotError, PlotOptions, Sheet, Unit, plot,
};
use silhouette_visibility::{LineKind, Lines};

/// Pixels as they are, and no step but those that a test switches on.
fn plain() -> PlotOptions {
    PlotOptions {
        unit: Unit::Px,
        sheet: None,
        hidden: Hidden::Solid,
        merge_tolerance: Length::px(0.0),
        min_length: Length::px(0.0),
        dedupe: false,
        order: false,
        ..PlotOptions::default()
    }
}

fn plotted(lines: &Lines, options: &PlotOptions) -> Drawing {
    plot(lines, options, &NoProgress).unwrap()
}

fn ids(drawing: &Drawing) -> Vec<String> {
    drawing.layers.iter().map(|layer| layer.name.id()).collect()
}

#[test]
fn visible_and_silhouette_lines_win_over_those_they_cover() {
    let ends = [[10.0, 10.0], [60.0, 10.0]];
    let back = [[60.0, 10.0], [10.0, 10.0]];
    let all = [
        drawn(LineKind::Silhouette, &ends).hidden(1),
        drawn(LineKind::Ridge, &back),
        drawn(LineKind::Silhouette, &back),
        drawn(LineKind::Boundary, &ends),
    ];
    let options = PlotOptions { dedupe: true, ..plain() };
    let drawing = plotted(&lines_of(orthographic(), &all), &options);
    assert_eq!((ids(&drawing), drawing.stats.repeats), (vec!["silhouette-visible".to_owned()], 3));
    let hidden_beside_visible = plotted(&lines_of(orthographic(), &all[..2]), &options);
    assert_eq!(ids(&hidden_beside_visible), ["ridge-visible"]);
    assert_eq!(plotted(&lines_of(orthographic(), &all), &plain()).stats.paths, 4, "switched off");
}

#[test]
fn a_loop_that_loses_a_side_is_open() {
    let square = [[10.0, 10.0], [60.0, 10.0], [60.0, 60.0], [10.0, 60.0]];
    let all = [drawn(LineKind::Silhouette, &[square[1], square[2]]), drawn(LineKind::Ridge, &square).closed()];
    let drawing = plotted(&lines_of(orthographic(), &all), &PlotOptions { dedupe: true, ..plain() });
    let rest = drawing.layers[0].paths.get(0);
    assert!(!rest.closed);
    assert_eq!(rest.points, [square[2], square[3], square[0], square[1]].map(DVec2::from));
}

#[test]
fn lines_that_overlap_in_part_are_drawn_once() {
    let all = [
        drawn(LineKind::Silhouette, &[[20.0, 10.0], [50.0, 10.0]]),
        drawn(LineKind::Ridge, &[[10.0, 10.0], [30.0, 10.0], [30.0, 40.0]]),
        drawn(LineKind::Silhouette, &[[0.0, 10.0], [90.0, 10.0]]).hidden(1),
    ];
    let drawing = plotted(&lines_of(orthographic(), &all), &PlotOptions { dedupe: true, ..plain() });
    let paths = |id: &str| -> Vec<Vec<DVec2>> {
        let layer = drawing.layers.iter().find(|layer| layer.name.id() == id).unwrap();
        layer.paths.iter().map(|path| path.points.to_vec()).collect()
    };
    let placed = |points: &[[f64; 2]]| points.iter().copied().map(DVec2::from).collect::<Vec<_>>();
    assert_eq!(paths("silhouette-visible"), [placed(&[[20.0, 10.0], [50.0, 10.0]])]);
    let ridges = paths("ridge-visible");
    assert_eq!(ridges, [placed(&[[10.0, 10.0], [20.0, 10.0]]), placed(&[[30.0, 10.0], [30.0, 40.0]])]);
    assert_eq!(
        paths("silhouette-hidden"),
        [placed(&[[0.0, 10.0], [10.0, 10.0]]), placed(&[[50.0, 10.0], [90.0, 10.0]])]
    );
}

#[test]
fn hidden_lines_of_several_depths_are_one_path() {
    let all = [
        drawn(LineKind::Ridge, &[[10.0, 10.0], [20.0, 10.0]]).hidden(1),
        drawn(LineKind::Ridge, &[[30.0, 10.0], [20.0, 10.0]]).hidden(2),
        drawn(LineKind::Ridge, &[[30.0, 10.0], [40.0, 10.0]]).hidden(1),
        drawn(LineKind::Ridge, &[[40.0, 10.0], [50.0, 10.0]]),
    ];
    let drawing = plotted(&lines_of(orthographic(), &all), &plain());
    assert_eq!(ids(&drawing), ["ridge-hidden", "ridge-visible"]);
    let hidden = &drawing.layers[0].paths;
    assert_eq!(hidden.len(), 1);
    assert_eq!(hidden.get(0).points, [[10.0, 10.0], [40.0, 10.0]].map(DVec2::from), "and merged");
}

#[test]
fn lines_that_leave_the_viewport_are_cut_off() {
    let all = [drawn(LineKind::Silhouette, &[[-50.0, 50.0], [50.0, 50.0], [50.0, 250.0], [-50.0, 250.0]]).closed()];
    let drawing = plotted(&lines_of(orthographic(), &all), &plain());
    let path = drawing.layers[0].paths.get(0);
    assert_eq!(path.points, [[0.0, 50.0], [50.0, 50.0], [50.0, 100.0]].map(DVec2::from));
    assert!(!path.closed);
}

#[test]
fn pictures_fill_the_page_or_keep_their_place() {
    let all = [drawn(LineKind::Silhouette, &[[40.0, 40.0], [60.0, 50.0]])];
    let on = |fit| {
        let sheet = Sheet { page: Page::A4.landscape(), margin: Length::mm(15.0), fit };
        let options = PlotOptions { unit: Unit::Mm, sheet: Some(sheet), ..plain() };
        let drawing = plotted(&lines_of(orthographic(), &all), &options);
        let path = drawing.layers[0].paths.get(0);
        [path.start(), path.end()]
    };
    let [from, to] = on(Fit::Lines);
    assert!(
        from.distance(DVec2::new(15.0, 38.25)) < 1e-9 && to.distance(DVec2::new(282.0, 171.75)) < 1e-9,
        "{from} {to}"
    );
    let [from, to] = on(Fit::View);
    assert!(
        from.distance(DVec2::new(130.5, 87.0)) < 1e-9 && to.distance(DVec2::new(166.5, 105.0)) < 1e-9,
        "{from} {to}"
    );
}

#[test]
fn short_paths_are_counted_and_left_out() {
    let all = [
        drawn(LineKind::Silhouette, &[[10.0, 10.0], [10.4, 10.0]]),
        drawn(LineKind::Silhouette, &[[20.0, 10.0], [20.4, 10.0], [20.4, 10.4]]),
        drawn(LineKind::Silhouette, &[[30.0, 10.0], [30.0, 10.0]]),
    ];
    let drawing = plotted(&lines_of(orthographic(), &all), &PlotOptions { min_length: Length::px(0.5), ..plain() });
    assert_eq!((drawing.stats.paths, drawing.stats.dropped.paths), (1, 2));
    assert!((drawing.stats.dropped.length - 0.4).abs() < 1e-9);
    assert_eq!(plotted(&lines_of(orthographic(), &all), &plain()).stats.paths, 2, "a point is no path");
}

#[test]
fn dashes_begin_and_end_with_a_stroke() {
    let all = [drawn(LineKind::Silhouette, &[[10.0, 10.0], [40.0, 10.0], [40.0, 50.0]]).hidden(1)];
    let hidden = Hidden::Dashed(Dash { on: Length::px(6.0), off: Length::px(2.0) });
    let drawing = plotted(&lines_of(orthographic(), &all), &PlotOptions { hidden, ..plain() });
    let paths = &drawing.layers[0].paths;
    // 70 + 2 is 9 periods of 8.
    assert_eq!(paths.len(), 9);
    assert_eq!((paths.get(0).start(), paths.get(8).end()), (DVec2::new(10.0, 10.0), DVec2::new(40.0, 50.0)));
    assert!((paths.length() - 54.0).abs() < 1e-9);
    assert!(paths.iter().all(|stroke| (stroke.length() - 6.0).abs() < 1e-9));
}

#[test]
fn options_that_cannot_be_honoured_are_refused() {
    let found = lines_of(perspective(), &[]);
    let refused = |change: &dyn Fn(&mut PlotOptions)| {
        let mut options = PlotOptions::default();
        change(&mut options);
        plot(&found, &options, &NoProgress).unwrap_err()
    };
    let sheet = |sheet: Sheet| refused(&|options| options.sheet = Some(sheet));
    let page = |side| Page { width: Length::mm(side), height: Length::mm(100.0) };
    for side in [0.0, -1.0, 1e9, f64::NAN] {
        assert_eq!(sheet(Sheet { page: page(side), ..Sheet::default() }), PlotError::Page);
    }
    for margin in [-1.0, 105.0, f64::INFINITY].map(Length::mm) {
        assert_eq!(sheet(Sheet { margin, ..Sheet::default() }), PlotError::Margin { margin });
    }
    let scale = |mm_per_unit| sheet(Sheet { fit: Fit::Scale { mm_per_unit }, ..Sheet::default() });
    assert_eq!((scale(0.0), scale(1.0)), (PlotError::Scale, PlotError::ScaleOfPerspective));
    let length = Length::mm(-0.1);
    assert!(matches!(refused(&|options| options.merge_tolerance = length), PlotError::Negative { .. }));
    assert!(matches!(refused(&|options| options.min_length = length), PlotError::Negative { .. }));
    assert!(matches!(refused(&|options| options.pens.outline.width = Length::mm(0.0)), PlotError::Width { .. }));
    let dash = Dash { on: Length::mm(1e-6), off: Length::mm(1.0) };
    assert!(matches!(refused(&|options| options.hidden = Hidden::Dashed(dash)), PlotError::Dash { .. }));
}

#[test]
fn plotting_stops_on_demand() {
    let stopped = plot(&lines_of(perspective(), &[]), &plain(), &Cancelling::at_once());
    assert_eq!(stopped, Err(PlotError::Cancelled(Cancelled)));
}

/// Unit segments of the viewport's grid that the layers cover, each as often as it is drawn.
fn grid_cells(drawing: &Drawing, keep: impl Fn(LayerName) -> bool) -> Vec<[i64; 4]> {
    let mut cells = Vec::new();
    for layer in drawing.layers.iter().filter(|layer| keep(layer.name)) {
        for segment in layer.paths.iter().flat_map(|path| path.segments().collect::<Vec<_>>()) {
            let [a, b] = [segment.from, segment.to].map(|point| (point / 10.0).round().as_i64vec2());
            let [low, high] = if (a.x, a.y) < (b.x, b.y) { [a, b] } else { [b, a] };
            cells.push([low.x, low.y, high.x, high.y]);
        }
    }
    cells.sort_unstable();
    cells
}

proptest! {
    /// Segments along the lines of a grid, which overlap in part: after removing repeats each stretch is drawn once, and
    /// none is lost.
    #[test]
    fn dedupe_keeps_the_union(
        steps in prop::collection::vec((0..6_i32, 0..6_i32, 0..4_usize, 0..2_u32, 1..4_u32), 1..80),
    ) {
        let all: Vec<_> = steps.iter().map(|&(x, y, direction, invisibility, count)| {
            let from = [f64::from(x) * 10.0 + 30.0, f64::from(y) * 10.0 + 30.0];
            let (dx, dy) = [(10.0, 0.0), (0.0, 10.0), (-10.0, 0.0), (0.0, -10.0)][direction];
            let to = [from[0] + dx * f64::from(count), from[1] + dy * f64::from(count)];
            drawn(LineKind::ALL[direction], &[from, to]).hidden(invisibility)
        }).collect();
        let found = lines_of(orthographic(), &all);
        // A negative tolerance of merging is not to be had, so segments are compared before any is merged.
        let with = |dedupe| plotted(&found, &PlotOptions { dedupe, ..plain() });
        let (before, after) = (with(false), with(true));
        let (mut union, mut once) = (cells_of(&before), cells_of(&after));
        let drawn = once.len();
        once.dedup();
        prop_assert_eq!(once.len(), drawn, "drawn once");
        union.dedup();
        prop_assert_eq!(once, union, "none is lost");
        prop_assert!((after.stats.drawn - 10.0 * drawn as f64).abs() < 1e-9);
        prop_assert!(after.stats.repeats as usize <= steps.len());
    }

    /// Reordered paths are the paths, none twice and none lost, and the way between them is never longer.
    #[test]
    fn order_is_a_permutation_and_no_longer(found in any_lines()) {
        let before = plotted(&found, &plain());
        let after = plotted(&found, &PlotOptions { order: true, ..plain() });
        prop_assert!(after.stats.travel.after <= after.stats.travel.before);
        prop_assert_eq!(after.stats.travel.before.to_bits(), before.stats.travel.after.to_bits());
        for (before, after) in before.layers.iter().zip(&after.layers) {
            prop_assert_eq!(segments(&before.paths), segments(&after.paths));
            prop_assert_eq!(before.paths.len(), after.paths.len());
        }
    }
}

fn cells_of(drawing: &Drawing) -> Vec<[i64; 4]> {
    let mut cells = Vec::new();
    for [ax, ay, bx, by] in grid_cells(drawing, |_| true) {
        // Merged segments come apart into unit ones again.
        let steps = (bx - ax).abs().max((by - ay).abs()).max(1);
        let (dx, dy) = ((bx - ax) / steps, (by - ay) / steps);
        for step in 0..steps {
            let (x, y) = (ax + dx * step, ay + dy * step);
            let ends = [[x, y], [x + dx, y + dy]];
            let [low, high] = if ends[0] < ends[1] { ends } else { [ends[1], ends[0]] };
            cells.push([low[0], low[1], high[0], high[1]]);
        }
    }
    cells.sort_unstable();
    cells
}

/// Segments in no direction and no order.
fn segments(paths: &silhouette_visibility::plot::Paths) -> Vec<[u64; 8]> {
    let mut all: Vec<_> = paths
        .iter()
        .flat_map(|path| path.segments().collect::<Vec<_>>())
        .map(|segment| {
            let bits = |segment: silhouette_visibility::plot::Segment| {
                let [a, b] = segment.handles.unwrap_or_default();
                [segment.from.x, segment.from.y, segment.to.x, segment.to.y, a.x, a.y, b.x, b.y].map(f64::to_bits)
            };
            bits(segment).min(bits(segment.reversed()))
        })
        .collect();
    all.sort_unstable();
    all
}

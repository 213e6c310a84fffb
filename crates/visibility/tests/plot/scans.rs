//! What keeps drawings of scans from falling to pieces, and what it may not change.

use crate::scene::{drawn, lines_of, orthographic};
use silhouette_core::glam::DVec2;
use silhouette_core::view::{Framing, ViewPreset};
use silhouette_core::{Camera, NoProgress, PreparedMesh};
use silhouette_testing::real_meshes;
use silhouette_visibility::plot::{Cap, Drawing, Length, PlotOptions, Unit, plot};
use silhouette_visibility::{LineFinder, LineKind, LineOptions, LineScene, Lines};
use std::sync::Arc;

fn in_pixels(width: f64) -> PlotOptions {
    let mut options = PlotOptions { unit: Unit::Px, sheet: None, ..PlotOptions::default() };
    options.pens.iter_mut().for_each(|pen| pen.width = Length::px(width));
    options
}

fn paths(lines: &Lines, options: &PlotOptions) -> (u64, u64) {
    let stats = plot(lines, options, &NoProgress).unwrap().stats;
    (stats.paths, stats.bridged.gaps)
}

/// A line that is hidden from 50 to 50 + gap, where it goes on as `behind` says.
fn broken(gap: f64, behind: &[([f64; 2], u32)], kind: LineKind) -> Lines {
    let mut all = vec![drawn(LineKind::Silhouette, &[[10.0, 50.0], [50.0, 50.0]])];
    let mut from = [50.0, 50.0];
    for &(to, invisibility) in behind {
        all.push(drawn(LineKind::Silhouette, &[from, to]).hidden(invisibility));
        from = to;
    }
    all.push(drawn(kind, &[[50.0 + gap, 50.0], [90.0, 50.0]]));
    lines_of(orthographic(), &all)
}

#[test]
fn a_contour_goes_on_across_gaps_as_wide_as_its_pen() {
    let silhouette = LineKind::Silhouette;
    let straight = |gap: f64| broken(gap, &[([50.0 + gap, 50.0], 1)], silhouette);
    assert_eq!(paths(&straight(1.5), &in_pixels(2.0)), (1, 1));
    assert_eq!(paths(&straight(2.5), &in_pixels(2.0)), (2, 0), "wider than the pen");
    let wide = PlotOptions { bridge: Some(Length::px(3.0)), ..in_pixels(2.0) };
    assert_eq!(paths(&straight(2.5), &wide), (1, 1));
    let off = PlotOptions { bridge: Some(Length::px(0.0)), ..in_pixels(2.0) };
    assert_eq!(paths(&straight(1.5), &off), (2, 0));
    let butt = PlotOptions { cap: Cap::Butt, ..in_pixels(2.0) };
    assert_eq!(paths(&straight(1.5), &butt), (2, 0), "no end closes the gap");

    // Behind the fold it may zigzag, through several layers.
    let zigzag = [([51.0, 53.0], 1), ([50.5, 52.0], 2), ([51.5, 50.0], 1)];
    assert_eq!(paths(&broken(1.5, &zigzag, silhouette), &in_pixels(2.0)), (1, 1));
    let far = [([51.0, 75.0], 1), ([51.5, 50.0], 1)];
    assert_eq!(paths(&broken(1.5, &far, silhouette), &in_pixels(2.0)), (2, 0), "another part of the thing");
}

#[test]
fn what_is_not_one_contour_is_not_joined() {
    let silhouette = LineKind::Silhouette;
    assert_eq!(paths(&broken(1.5, &[], silhouette), &in_pixels(2.0)), (2, 0), "nothing goes on underneath");
    let to_elsewhere = [([50.7, 51.0], 1)];
    assert_eq!(paths(&broken(1.5, &to_elsewhere, silhouette), &in_pixels(2.0)), (2, 0));
    assert_eq!(paths(&broken(1.5, &[([51.5, 50.0], 1)], LineKind::Ridge), &in_pixels(2.0)), (2, 0));
    // A circle of hidden pieces without length does not hang.
    let nowhere = [([50.0, 50.0], 1), ([50.0, 50.0], 2)];
    assert_eq!(paths(&broken(1.5, &nowhere, silhouette), &in_pixels(2.0)), (2, 0));
}

/// Points along straight segments, a quarter of a pixel apart.
fn points<'a>(segments: impl Iterator<Item = [DVec2; 2]> + 'a) -> impl Iterator<Item = DVec2> + 'a {
    segments.flat_map(|[from, to]| {
        let steps = (from.distance(to) * 4.0).ceil().max(1.0) as u32;
        (0..=steps).map(move |step| from.lerp(to, f64::from(step) / f64::from(steps)))
    })
}

fn segments(drawing: &Drawing) -> impl Iterator<Item = [DVec2; 2]> {
    let paths = drawing.layers.iter().flat_map(|layer| layer.paths.iter());
    paths.flat_map(|path| path.segments().map(|segment| [segment.from, segment.to]).collect::<Vec<_>>())
}

/// How far the farthest point of some segments lies from others, as far as a limit.
fn farthest(from: &[[DVec2; 2]], to: &[[DVec2; 2]], limit: f64) -> f64 {
    let cell = |point: DVec2| (point / limit).floor().to_array().map(|coordinate| coordinate as i64);
    let mut cells: std::collections::HashMap<[i64; 2], Vec<DVec2>> = std::collections::HashMap::new();
    points(to.iter().copied()).for_each(|point| cells.entry(cell(point)).or_default().push(point));
    let distance = |point: DVec2| {
        let [column, row] = cell(point);
        let around = (-1..=1).flat_map(|x| (-1..=1).map(move |y| [column + x, row + y]));
        let near = around.filter_map(|cell| cells.get(&cell)).flatten();
        near.map(|other| point.distance(*other)).fold(limit, f64::min)
    };
    points(from.iter().copied()).map(distance).fold(0.0, f64::max)
}

/// Fewer strokes, but nothing drawn farther than half a pen from a true line, and no true line farther than that from what is drawn.
#[test]
fn drawings_stay_within_half_a_pen_of_the_exact_lines() {
    let width = 2.0;
    let mut strokes = [0, 0];
    for (name, mesh) in real_meshes("drawings_stay_within_half_a_pen") {
        if mesh.face_count() > 100_000 {
            continue;
        }
        let (direction, up) = ViewPreset::ThreeQuarter.directions();
        let bounds = mesh.bounds().unwrap();
        let camera = Camera::framing(&bounds, direction, up, Framing::Orthographic, [600, 600]).unwrap();
        let mut finder = LineFinder::new(LineScene::new(Arc::new(PreparedMesh::new(mesh))), &NoProgress).unwrap();
        let options = LineOptions { max_invisibility: 1, ..LineOptions::default() };
        let lines = finder.find(&camera, &options, &NoProgress).unwrap();
        let exact = PlotOptions {
            dedupe: false,
            bridge: Some(Length::px(0.0)),
            merge_tolerance: Length::px(0.0),
            min_length: Length::px(0.0),
            ..in_pixels(width)
        };
        let exact = plot(&lines, &exact, &NoProgress).unwrap();
        for curves in [false, true] {
            let options = PlotOptions { curves, merge_tolerance: Length::px(0.2), ..in_pixels(width) };
            let chained = plot(&lines, &options, &NoProgress).unwrap();
            strokes = [strokes[0] + exact.stats.paths, strokes[1] + chained.stats.paths];
            let [true_lines, drawn]: [Vec<_>; 2] = [segments(&exact).collect(), segments(&chained).collect()];
            // Half a pen, the tolerance, chords of curves, what is too short, and the distance of the points.
            let limit = width * 0.5 + 0.2 + 0.2 + 0.4 + 0.25;
            if !curves {
                let lost = farthest(&true_lines, &drawn, 4.0);
                assert!(lost <= limit, "{name}: {lost} px of lines are lost");
                let added = farthest(&drawn, &true_lines, 4.0);
                assert!(added <= limit, "{name}: {added} px beside true lines");
            }
        }
    } // Repeats that are cut out of a path part it; all in all there are fewer.
    assert!(strokes[1] < strokes[0] || strokes == [0, 0], "{strokes:?}");
}

//! Step 9, dash: paths are cut into strokes and gaps.

use super::layer::Layer;
use super::length::Unit;
use super::paths::{Path, Paths, Segment};
use super::pen::Dash;
use super::phase::{Chord, LaidPatterns, Pattern, chords_of, strokes};

/// What is left of a stroke where a line ends, shorter than this share of a stroke, is not worth putting the pen down for.
const LEAST_STROKE: f64 = 0.01;

/// Lines this close are one in any file, in page units: twice the last decimal that is printed.
const LEAST_TOLERANCE: f64 = 0.002;

/// Cuts the paths of layers whose pens have a pattern into its strokes. Where lines of one pattern lie on each other, in the same
/// layer or in several, their strokes lie on each other, too: those of the longest path, by [`LaidPatterns::lay`]. `moved` is how
/// far earlier steps may have moved a line that lay on another, in page units, from 0. O(points + strokes + pairs that pass the
/// same place), expected.
pub fn dash(layers: &mut [Layer], unit: Unit, moved: f64) {
    let patterns: Vec<Option<Dash>> = layers.iter().map(|layer| layer.pen.dash).collect();
    for (index, pattern) in patterns.iter().enumerate() {
        let Some(dash) = pattern else { continue };
        if patterns[..index].contains(pattern) {
            continue;
        }
        let alike: Vec<&mut Paths> =
            layers.iter_mut().filter(|layer| layer.pen.dash == Some(*dash)).map(|layer| &mut layer.paths).collect();
        dash_alike(alike, Pattern { on: dash.on.to(unit), off: dash.off.to(unit) }, moved);
    }
}

/// Cuts paths of several layers into strokes of one pattern.
fn dash_alike(mut layers: Vec<&mut Paths>, pattern: Pattern, moved: f64) {
    let chord_tolerance = (0.5 * moved).max(0.25 * LEAST_TOLERANCE);
    // Both lines may have been moved, and chords stray from both.
    let tolerance = (2.0 * (moved + chord_tolerance)).max(LEAST_TOLERANCE);
    let mut laid = LaidPatterns::of(layers.iter().map(|paths| &**paths), pattern, tolerance);
    let places = layers.iter().enumerate().flat_map(|(layer, paths)| (0..paths.len()).map(move |path| (layer, path)));
    let mut order: Vec<(usize, usize)> = places.collect();
    // Equal ones in their order.
    order.sort_by_cached_key(|&(layer, path)| std::cmp::Reverse(ordered(layers[layer].get(path).length())));
    let mut dashed: Vec<Vec<Paths>> = layers.iter().map(|paths| vec![Paths::default(); paths.len()]).collect();
    for (layer, index) in order {
        let path = layers[layer].get(index);
        let chords = chords_of(path, chord_tolerance);
        let knots = laid.lay(&chords, path.closed);
        cut(path, &chords, &strokes(&knots, pattern), pattern.on * LEAST_STROKE, &mut dashed[layer][index]);
    }
    for (paths, strokes) in layers.iter_mut().zip(dashed) {
        **paths = Paths::default();
        strokes.iter().flat_map(Paths::iter).for_each(|stroke| paths.push(stroke));
    }
}

/// A length, from 0, as a number that is ordered as it is.
fn ordered(length: f64) -> u64 {
    length.max(0.0).to_bits()
}

/// Appends the strokes of a path that are at least `least` long, or all of it.
fn cut(path: Path<'_>, chords: &[Chord], strokes: &[[f64; 2]], least: f64, dashed: &mut Paths) {
    let length = chords.last().map_or(0.0, |chord| chord.along[1]);
    if *strokes == [[0.0, length]] {
        dashed.push(path);
        return;
    }
    let mut strokes = strokes.to_vec();
    // The stroke across the first point of a closed path is one.
    let across = match *strokes {
        [first, .., last] if path.closed && first[0] <= 0.0 && last[1] >= length => {
            strokes.pop();
            strokes[0] = [last[0], first[1]];
            true
        }
        _ => false,
    };
    for (index, &[from, to]) in strokes.iter().enumerate() {
        let parts: &[[f64; 2]] = if across && index == 0 { &[[from, length], [0.0, to]] } else { &[[from, to]] };
        if parts.iter().map(|[from, to]| to - from).sum::<f64>() < least {
            continue;
        }
        dashed.begin();
        parts.iter().for_each(|&part| push_part(path, chords, part, dashed));
        dashed.finish(false);
    }
}

/// Adds what lies between two places along the path, `from < to`, to the path under way.
fn push_part(path: Path<'_>, chords: &[Chord], [from, to]: [f64; 2], dashed: &mut Paths) {
    // The first chord that ends behind `from`, and the last that begins before `to`.
    let first = chords.partition_point(|chord| chord.along[1] <= from).min(chords.len() - 1);
    let last = chords.partition_point(|chord| chord.along[0] < to).max(first + 1) - 1;
    let [begin, end] = [(first, from), (last, to)].map(|(index, at)| parameter(&chords[index], at));
    let (first, last) = (chords[first].segment, chords[last].segment);
    for index in first..=last {
        let segment = path.segment(index);
        dashed.extend(&between(
            &segment,
            if index == first { begin } else { 0.0 },
            if index == last { end } else { 1.0 },
        ));
    }
}

/// The parameter of a chord's segment at a place along the path.
fn parameter(chord: &Chord, at: f64) -> f64 {
    let ([from, to], [begin, end]) = (chord.along, chord.parameters);
    if at <= from {
        begin
    } else if at >= to {
        end
    } else {
        begin + (end - begin) * (at - from) / (to - from)
    }
}

/// The part of a segment between two parameters.
fn between(segment: &Segment, from: f64, to: f64) -> Segment {
    if from <= 0.0 && to >= 1.0 { *segment } else { segment.part(from, to) }
}

//! Step 9, dash: paths are cut into strokes and gaps.

use super::paths::{Path, Paths, Segment};

/// Cuts paths into strokes of about `on` with gaps of about `off` between them (page units, above 0). The pattern is
/// stretched to a whole number of periods, so that an open path begins and ends with a whole stroke and a closed one has
/// no seam. A path too short for two strokes stays whole. O(points + strokes).
pub fn dash(paths: &Paths, on: f64, off: f64) -> Paths {
    let mut dashed = Paths::default();
    for path in paths.iter() {
        let length = path.length();
        // Ahead of an open path lies a gap in thought, so that its strokes and gaps are as many.
        let lead = if path.closed { 0.0 } else { off };
        let strokes = ((length + lead) / (on + off)).round();
        if strokes < 2.0 {
            dashed.push(path);
            continue;
        }
        let stretch = length / (strokes * (on + off) - lead);
        cut(path, on * stretch, off * stretch, &mut dashed);
    }
    dashed
}

/// Appends strokes of `on` after each of which `off` is left out, beginning with a stroke.
fn cut(path: Path<'_>, on: f64, off: f64, dashed: &mut Paths) {
    let mut draws = true;
    let mut rest = on;
    dashed.begin();
    for segment in path.segments() {
        let length = segment.length();
        let mut done = 0.0;
        // What rounding leaves of the last gap or stroke is no stroke of its own.
        while length - done > rest + on * 1e-9 {
            let until = done + rest.max(0.0);
            if draws {
                if until > done {
                    dashed.extend(&between(&segment, done / length, until / length));
                }
                dashed.finish(false);
            } else {
                dashed.begin();
            }
            draws = !draws;
            rest = if draws { on } else { off };
            done = until;
        }
        if draws && length > done {
            dashed.extend(&between(&segment, done / length, 1.0));
        }
        rest -= length - done;
    }
    if draws {
        dashed.finish(false);
    }
}

/// The part of a segment between two shares of its length; of a curve, of the parameter.
fn between(segment: &Segment, from: f64, to: f64) -> Segment {
    if from <= 0.0 && to >= 1.0 { *segment } else { segment.part(from.max(0.0), to.min(1.0)) }
}

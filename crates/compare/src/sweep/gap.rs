//! Where the front is coarse: which value of a swept option to measure next.
//!
//! Each mesh has its own front of time and error, and each kind of picture. Two cells of a method that differ in one swept option
//! alone, and next to each other in it, bound a *gap*. Its width is the distance of the two in a chart whose axes, the logarithm of time
//! and the error, run over the front; times whose intervals overlap are as good as equal, while errors are the same however often they are
//! measured. Gaps of which neither end is in the front, nor becomes so by what could lie between, do not count.
//! The value in the middle of the widest gap of any mesh is next. Gaps narrower than [`RESOLUTION`] are fine enough, and so are those
//! whose ends are that close in the sweep: where the error jumps, halving would go on for ever.

use crate::interval;
use crate::metrics::table::{MetricSpec, PictureKind};
use crate::options::OptionSettings;
use crate::pareto::pareto_front;
use crate::record::Cell;
use crate::registry::Registry;
use silhouette_core::method::{OptionSpec, OptionValue, OptionValues};

/// Width of a gap, as a share of the front's extent and as one of the sweep's, below which nothing is measured between its ends.
pub const RESOLUTION: f64 = 0.02;

/// The errors that fronts are refined in, one for each kind of picture.
#[derive(Debug, Clone, Copy)]
pub struct Errors {
    /// Of pictures of lines.
    pub lines: &'static MetricSpec,
    /// Of filled pictures.
    pub fill: &'static MetricSpec,
}

/// A method with options that nobody measured yet.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The method.
    pub method: String,
    /// All of its options.
    pub options: OptionSettings,
    /// Width of the gap that it is in the middle of.
    pub width: f64,
}

impl Errors {
    /// The metric of a kind.
    fn of(&self, kind: PictureKind) -> &'static MetricSpec {
        match kind {
            PictureKind::Lines => self.lines,
            PictureKind::Fill => self.fill,
        }
    }
}

/// The middle of the widest gap of any front; `None` where all are fine enough. Nothing is proposed that `cells` hold on some mesh
/// already. O(cells squared x options).
pub fn next(cells: &[Cell], errors: &Errors, registry: &Registry) -> Option<Candidate> {
    let mut widest: Option<Candidate> = None;
    for group in groups(cells) {
        let points: Vec<[f64; 2]> = group.iter().map(|cell| point(cell, errors)).collect();
        let times: Vec<[f64; 2]> = group.iter().map(|cell| cell.frame.frame_ms.interval).collect();
        let chart = Chart::of(&points, &times);
        for (at, cell) in group.iter().enumerate() {
            let Ok(entry) = registry.find(&cell.method) else { continue };
            for spec in entry.info().options.iter().filter(|spec| spec.sweep.is_some()) {
                let Some(upper) = neighbour(&group, cell, spec) else { continue };
                let width = chart.width(at, upper);
                if width < RESOLUTION
                    || distance(cell, group[upper], spec) < RESOLUTION
                    || widest.as_ref().is_some_and(|found| found.width >= width)
                {
                    continue;
                }
                let Some(options) = between(cell, group[upper], spec) else { continue };
                let is_known = |other: &Cell| other.method == cell.method && other.options == options;
                if !cells.iter().any(is_known) {
                    widest = Some(Candidate { method: cell.method.clone(), options, width });
                }
            }
        }
    }
    widest
}

/// The cells of each mesh and kind of picture.
fn groups(cells: &[Cell]) -> Vec<Vec<&Cell>> {
    let mut groups: Vec<Vec<&Cell>> = Vec::new();
    for cell in cells {
        let is_same = |group: &&mut Vec<&Cell>| {
            let first = group[0];
            first.mesh.name == cell.mesh.name && first.picture == cell.picture && first.run == cell.run
        };
        match groups.iter_mut().find(is_same) {
            Some(group) => group.push(cell),
            None => groups.push(vec![cell]),
        }
    }
    groups
}

/// Logarithm of time, and the error, lower the better.
fn point(cell: &Cell, errors: &Errors) -> [f64; 2] {
    let error = cell.mean_metrics().and_then(|metrics| errors.of(cell.picture).error(&metrics));
    [cell.frame.frame_ms.median.max(f64::MIN_POSITIVE).ln(), error.unwrap_or(f64::NAN)]
}

/// The front of a group, and how far it extends.
struct Chart<'a> {
    points: &'a [[f64; 2]],
    /// Intervals of the times, in milliseconds.
    times: &'a [[f64; 2]],
    front: Vec<usize>,
    extent: [f64; 2],
}

impl<'a> Chart<'a> {
    fn of(points: &'a [[f64; 2]], times: &'a [[f64; 2]]) -> Self {
        let front = pareto_front(points);
        let extent = [0, 1].map(|axis| {
            let values = || front.iter().map(|&at| points[at][axis]);
            values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
        });
        Self { points, times, front, extent }
    }

    /// Distance of two points, as a share of the front's extent; 0 where what lies between could not be in the front.
    fn width(&self, one: usize, other: usize) -> f64 {
        // The best that could lie between is as fast as the faster and as good as the better.
        let best = [0, 1].map(|axis| self.points[one][axis].min(self.points[other][axis]));
        let is_beaten = self.front.iter().filter(|&&at| at != one && at != other).any(|&at| {
            let point = self.points[at];
            point[0] <= best[0] && point[1] <= best[1]
        });
        if is_beaten || self.lacks(one) || self.lacks(other) {
            return 0.0;
        }
        let share = |axis: usize| {
            let distance = (self.points[one][axis] - self.points[other][axis]).abs();
            // A front of one point has no extent, and what differs from it differs altogether.
            if distance == 0.0 { 0.0 } else { (distance / self.extent[axis]).min(1.0) }
        };
        let time = if interval::overlap(self.times[one], self.times[other]) { 0.0 } else { share(0) };
        time.hypot(share(1))
    }

    /// Whether a cell lacks the error.
    fn lacks(&self, at: usize) -> bool {
        self.points[at].iter().any(|value| value.is_nan())
    }
}

/// The cell that differs from another in one option alone, by the least that is more.
fn neighbour(group: &[&Cell], cell: &Cell, spec: &OptionSpec) -> Option<usize> {
    let own = value(cell, spec)?;
    let above = |other: &Cell| {
        let is_other = |(name, value)| name == spec.name || cell.options.0.get::<str>(name) == Some(value);
        let same =
            other.method == cell.method && other.options.0.iter().all(|(name, value)| is_other((name.as_str(), value)));
        value(other, spec).filter(|&value| same && value > own)
    };
    let above = group.iter().enumerate().filter_map(|(at, other)| Some((at, above(other)?)));
    above.min_by(|one, other| one.1.total_cmp(&other.1)).map(|(at, _)| at)
}

/// The number that an option has in a cell.
fn value(cell: &Cell, spec: &OptionSpec) -> Option<f64> {
    match cell.options.0.get(spec.name)? {
        crate::options::OptionSetting::Number(number) => Some(*number),
        crate::options::OptionSetting::Word(_) => None,
    }
}

/// How far apart two values of an option are, as a share of its sweep.
fn distance(cell: &Cell, other: &Cell, spec: &OptionSpec) -> f64 {
    let place = |cell: &Cell| Some(spec.sweep?.place(value(cell, spec)?));
    place(cell).zip(place(other)).map_or(0.0, |(one, other)| (one - other).abs())
}

/// The options of a cell, with one of them between its values there and in another.
fn between(cell: &Cell, other: &Cell, spec: &'static OptionSpec) -> Option<OptionSettings> {
    let read = |cell: &Cell| -> Option<OptionValue> {
        let word = format!("{}={}", spec.name, cell.options.0.get(spec.name)?);
        OptionValues::parse(std::slice::from_ref(spec), [word.as_str()]).ok()?.get(spec.name)
    };
    let middle = spec.sweep_between(read(cell)?, read(other)?)?;
    let mut options = cell.options.clone();
    options.0.insert(spec.name.to_owned(), middle.to_string().as_str().into());
    Some(options)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::table::find;
    use crate::options::OptionSetting;
    use crate::record::tests::{cell, with_option};
    use silhouette_core::method::OptionValues;

    fn errors() -> Errors {
        Errors { lines: find("chamfer_px").unwrap(), fill: find("boundary_chamfer_px").unwrap() }
    }

    fn tracking(mesh: &str, level: f64, frame_ms: f64, chamfer_px: f64) -> Cell {
        let specs = Registry::builtin().find("tracking").unwrap().info().options;
        let options = OptionSettings::from(&OptionValues::defaults(specs));
        let cell = Cell { options, ..cell(mesh, "tracking", frame_ms, chamfer_px) };
        with_option(cell, "concavity", OptionSetting::Number(level))
    }

    fn next_level(cells: &[Cell]) -> Option<f64> {
        let candidate = next(cells, &errors(), &Registry::builtin())?;
        match candidate.options.0["concavity"] {
            OptionSetting::Number(level) => Some(level),
            OptionSetting::Word(_) => None,
        }
    }

    #[test]
    fn the_widest_gap_of_the_front_is_halved() {
        let cells = [tracking("a", 0.0, 8.0, 0.0), tracking("a", 0.8, 7.0, 0.1), tracking("a", 1.6, 1.0, 2.0)];
        assert_eq!(next_level(&cells), Some(1.2));
        // The same with two meshes: the wider gap of either.
        let other = [tracking("b", 0.0, 8.0, 0.0), tracking("b", 0.8, 1.0, 2.0), tracking("b", 1.6, 1.0, 2.0)];
        assert_eq!(next_level(&[&cells[..], &other[..]].concat()), Some(0.4));
    }

    #[test]
    fn gaps_that_another_method_beats_do_not_count() {
        let swept = [tracking("a", 0.0, 8.0, 1.0), tracking("a", 0.8, 4.0, 2.0)];
        assert_eq!(next_level(&swept), Some(0.4));
        let beaten = [&swept[..], &[cell("a", "brute-force", 1.0, 0.5)]].concat();
        assert_eq!(next_level(&beaten), None);
        let elsewhere = [&swept[..], &[cell("b", "brute-force", 1.0, 0.5)]].concat();
        assert_eq!(next_level(&elsewhere), Some(0.4), "what is measured on another mesh beats nothing on this one");
    }

    #[test]
    fn times_that_differ_by_chance_are_no_gap() {
        let timed = |level: f64, interval: [f64; 2]| {
            let mut cell = tracking("a", level, (interval[0] + interval[1]) / 2.0, 1.0);
            cell.frame.frame_ms.interval = interval;
            cell
        };
        assert_eq!(next_level(&[timed(0.0, [7.0, 8.0]), timed(0.8, [5.0, 6.9])]), Some(0.4));
        assert_eq!(next_level(&[timed(0.0, [7.0, 8.0]), timed(0.8, [5.0, 7.1])]), None);
    }

    #[test]
    fn what_is_fine_enough_or_cannot_be_halved_ends_it() {
        assert_eq!(next_level(&[]), None);
        assert_eq!(next_level(&[tracking("a", 0.5, 1.0, 1.0)]), None);
        let alike = [tracking("a", 0.0, 8.0, 1.0), tracking("a", 0.8, 8.0, 1.0)];
        assert_eq!(next_level(&alike), None);
        let lacking = [tracking("a", 0.0, 8.0, f64::NAN), tracking("a", 0.8, 1.0, f64::NAN)];
        assert_eq!(next_level(&lacking), None);
    }

    /// Halving again and again ends, and only where the front bends.
    #[test]
    fn refinement_ends_and_gathers_where_the_front_bends() {
        // An error that jumps at 0.6, as it does where a level loses a whole loop.
        let measured = |level: f64| tracking("a", level, 8.0 - level, if level < 0.6 { 0.0 } else { 5.0 });
        let mut cells = vec![measured(0.0), measured(1.6)];
        while let Some(level) = next_level(&cells) {
            cells.push(measured(level));
            assert!(cells.len() < 200);
        }
        let near = cells.iter().filter(|cell| value(cell, spec()).is_some_and(|level| (level - 0.6).abs() < 0.05));
        assert!(near.count() >= 3, "{}", cells.len());
    }

    fn spec() -> &'static OptionSpec {
        let registry = Registry::builtin();
        let specs = registry.find("tracking").unwrap().info().options;
        specs.iter().find(|spec| spec.name == "concavity").unwrap()
    }
}

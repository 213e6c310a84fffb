//! The trade: time of a frame against the share of the silhouette's length that it misses, one panel a mesh.

use super::measure::{MeshResult, Reproduction, VariantResult};
use super::variants::{Asked, Variant};
use silhouette_compare::plot::{FAINT_GRID, GRID, INK, LogAxis, line, paper, rounded, text};
use silhouette_compare::report::COLORS;
use silhouette_tracking::TestedEdges;
use svg::node::element::{Group, Polyline, Text};

/// Panels side by side.
const PER_ROW: usize = 3;

/// Size of a panel with its axes' words, in pixels; one alone is as wide as two.
const PANEL: [f64; 2] = [420.0, 420.0];

/// Height of the legend above the panels.
const LEGEND: f64 = 76.0;

/// Where the plot is in its panel: left, right of the panel's end, top, bottom.
const LEFT: f64 = 64.0;
const RIGHT_MARGIN: f64 = 16.0;
const TOP: f64 = 36.0;
const BOTTOM: f64 = 364.0;

/// Marks nearer to each other than this, in pixels, share their words.
const NEAR: f64 = 5.0;

/// Height of a line of small words, and the width of one of their letters on the mean.
const SMALL: [f64; 2] = [12.0, 6.5];

/// Corners of a plus sign around the origin.
const PLUS: [[f64; 2]; 12] = [
    [-1.5, -5.5],
    [1.5, -5.5],
    [1.5, -1.5],
    [5.5, -1.5],
    [5.5, 1.5],
    [1.5, 1.5],
    [1.5, 5.5],
    [-1.5, 5.5],
    [-1.5, 1.5],
    [-5.5, 1.5],
    [-5.5, -1.5],
    [-1.5, -1.5],
];

/// What is drawn alike: told apart by shape as well as by colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Family {
    BruteForce,
    Levels,
    Single,
    Exact,
    Budget,
    Today(&'static str, Asked),
}

/// All families in the order of the legend.
const FAMILIES: [Family; 9] = [
    Family::BruteForce,
    Family::Levels,
    Family::Single,
    Family::Exact,
    Family::Budget,
    Family::Today("brute-force-simd", Asked::Edges),
    Family::Today("brute-force-simd", Asked::Loops),
    Family::Today("cluster-cones", Asked::Edges),
    Family::Today("cluster-cones", Asked::Loops),
];

impl Family {
    fn of(variant: Variant) -> Self {
        match variant {
            Variant::BruteForce | Variant::BruteForceInFours => Self::BruteForce,
            Variant::Level(_, TestedEdges::All) => Self::Levels,
            Variant::Level(_, TestedEdges::Single) => Self::Single,
            Variant::Exact => Self::Exact,
            Variant::Budget => Self::Budget,
            Variant::Today(name, asked) => Self::Today(name, asked),
        }
    }

    fn label(self) -> String {
        match self {
            Self::Levels => "tracking by level N".to_owned(),
            Self::Single => "tracking, single edges".to_owned(),
            Self::BruteForce => "brute force (Hall; in fours)".to_owned(),
            Self::Exact => Variant::Exact.label(),
            Self::Budget => Variant::Budget.label(),
            Self::Today(name, asked) => Variant::Today(name, asked).label(),
        }
    }

    fn color(self) -> &'static str {
        match self {
            Self::Levels => COLORS[0],
            Self::Single => COLORS[1],
            Self::Exact => COLORS[2],
            Self::Budget => COLORS[3],
            Self::BruteForce => COLORS[6],
            Self::Today("cluster-cones", _) => COLORS[4],
            Self::Today(..) => COLORS[5],
        }
    }

    /// Corners around the origin.
    fn shape(self) -> Vec<[f64; 2]> {
        let turn = |corners: u32, first: f64, radius: f64| {
            let corner = |index: u32| {
                let (sin, cos) = (first + std::f64::consts::TAU * f64::from(index) / f64::from(corners)).sin_cos();
                [rounded(radius * sin), rounded(radius * cos)]
            };
            (0..corners).map(corner).collect::<Vec<_>>()
        };
        let quarter = std::f64::consts::FRAC_PI_4;
        match self {
            Self::BruteForce => PLUS.to_vec(),
            Self::Levels => turn(24, 0.0, 4.5),
            Self::Single => turn(4, quarter, 6.0),
            Self::Exact => turn(4, 0.0, 7.0),
            Self::Budget => turn(3, std::f64::consts::PI, 6.5),
            Self::Today("cluster-cones", _) => turn(6, 0.0, 6.0),
            Self::Today(..) => turn(3, 0.0, 6.5),
        }
    }

    /// Edges are hollow, loops are filled: they tell more.
    fn is_hollow(self) -> bool {
        matches!(self, Self::Today(_, Asked::Edges))
    }
}

/// The chart, as SVG.
pub fn trade(reproduction: &Reproduction) -> String {
    let meshes = &reproduction.meshes;
    let columns = meshes.len().clamp(1, PER_ROW);
    let rows = meshes.len().div_ceil(PER_ROW).max(1);
    let width = (PANEL[0] * columns as f64).max(2.0 * PANEL[0]);
    let mut document = paper([width, LEGEND + PANEL[1] * rows as f64]).add(legend(width));
    let panel_width = width / columns as f64;
    for (index, mesh) in meshes.iter().enumerate() {
        let at = [panel_width * (index % PER_ROW) as f64, LEGEND + PANEL[1] * (index / PER_ROW) as f64];
        document = document
            .add(panel(mesh, panel_width - RIGHT_MARGIN).set("transform", format!("translate({} {})", at[0], at[1])));
    }
    format!("{document}\n")
}

fn mark(family: Family, [x, y]: [f64; 2]) -> Polyline {
    let shape = family.shape();
    let points = shape
        .iter()
        .chain(shape.first())
        .map(|corner| format!("{},{}", rounded(x + corner[0]), rounded(y + corner[1])));
    Polyline::new()
        .set("points", points.collect::<Vec<_>>().join(" "))
        .set("stroke", family.color())
        .set("stroke-width", 1.5)
        .set("fill", if family.is_hollow() { "#ffffff" } else { family.color() })
}

fn small(words: impl Into<String>, at: [f64; 2], anchor: &str) -> Text {
    text(words, at, anchor).set("font-size", 12).set("fill", INK)
}

fn legend(width: f64) -> Group {
    let column = (width - 2.0 * 24.0) / if width > 1000.0 { 5.0 } else { 3.0 };
    let columns = ((width - 48.0) / column).round() as usize;
    let mut group = Group::new();
    for (index, &family) in FAMILIES.iter().enumerate() {
        let at = [24.0 + column * (index % columns) as f64, 20.0 + 22.0 * (index / columns) as f64];
        group = group.add(mark(family, at)).add(small(family.label(), [at[0] + 14.0, at[1] + 4.0], "start"));
    }
    group
}

/// Shares from nothing to a round number that holds them all.
struct ShareAxis {
    end: f64,
    step: f64,
    /// Right end of the plot in pixels.
    right: f64,
}

impl ShareAxis {
    fn new(shares: impl Iterator<Item = f64>, right: f64) -> Self {
        let largest = shares.fold(0.0, f64::max);
        let steps = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0];
        let step = steps.into_iter().find(|step| largest <= 5.0 * step).unwrap_or(20.0);
        Self { end: (largest / step).ceil().max(1.0) * step, step, right }
    }

    /// Nothing missed is a little right of the left end, so that marks stand clear of it.
    fn pixel(&self, share: f64) -> f64 {
        rounded(LEFT + 16.0 + share / self.end * (self.right - LEFT - 44.0))
    }

    fn ticks(&self) -> impl Iterator<Item = f64> {
        let count = (self.end / self.step).round() as u32;
        (0..=count).map(|index| f64::from(index) * self.step)
    }
}

fn panel(mesh: &MeshResult, right: f64) -> Group {
    let share = |result: &VariantResult| result.missed.length.percent();
    let x = ShareAxis::new(mesh.variants.iter().map(share), right);
    let y = LogAxis::around(mesh.variants.iter().map(|result| result.median_us), BOTTOM..TOP);
    let at = |result: &VariantResult| [x.pixel(share(result)), y.pixel(result.median_us)];

    let mut group = Group::new().add(grid(&x, &y));
    let title = format!("{}, {} faces", mesh.name, mesh.faces);
    group = group.add(text(title, [LEFT, TOP - 14.0], "start").set("fill", INK).set("font-weight", 600));
    let mut taken: Vec<Extent> = Vec::new();
    let levels = mesh.variants.iter().filter(|result| Family::of(result.variant) == Family::Levels);
    let corners: Vec<[f64; 2]> = levels.map(at).collect();
    taken.extend(corners.windows(2).flat_map(|ends| Extent::along(ends[0], ends[1])));
    let points: Vec<String> = corners.iter().map(|[x, y]| format!("{x},{y}")).collect();
    let way = Polyline::new().set("points", points.join(" ")).set("fill", "none");
    group = group.add(way.set("stroke", Family::Levels.color()).set("stroke-width", 1.5));
    for result in &mesh.variants {
        group = group.add(mark(Family::of(result.variant), at(result)));
    }
    let marks: Vec<[f64; 2]> = mesh.variants.iter().map(at).collect();
    taken.extend(marks.iter().map(|&[x, y]| Extent { from: [x - 6.0, y - 6.0], to: [x + 6.0, y + 6.0] }));
    for Label { family, mark, label } in labels(&mesh.variants, &marks) {
        let place = Extent::free_beside(mark, &label, &taken);
        let color = family.color();
        let words = small(label, [place.from[0], place.to[1] - 3.0], "start");
        group = group.add(words.set("fill", color));
        taken.push(place);
    }
    group
}

/// Words for a mark, or for several that are as good as one.
#[derive(Debug, Clone, PartialEq)]
struct Label {
    family: Family,
    mark: [f64; 2],
    label: String,
}

/// The levels of all variants that have one.
fn labels(variants: &[VariantResult], marks: &[[f64; 2]]) -> Vec<Label> {
    let mut labels: Vec<Label> = Vec::new();
    for (result, &mark) in variants.iter().zip(marks) {
        let Some(label) = level_label(result.variant) else { continue };
        let family = Family::of(result.variant);
        let is_near = |last: &Label| (last.mark[0] - mark[0]).hypot(last.mark[1] - mark[1]) < NEAR;
        match labels.last_mut().filter(|last| last.family == family && is_near(last)) {
            Some(last) => last.label = format!("{}, {label}", last.label),
            None => labels.push(Label { family, mark, label }),
        }
    }
    labels
}

/// The level, for variants that have one.
fn level_label(variant: Variant) -> Option<String> {
    match variant {
        Variant::Level(Some(level_rad), _) => Some(format!("{level_rad}")),
        Variant::Level(None, _) => Some("none".to_owned()),
        _ => None,
    }
}

/// A rectangle that is taken by a mark or by words.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Extent {
    from: [f64; 2],
    to: [f64; 2],
}

impl Extent {
    /// A place for words beside a mark, if possible one that is not taken: right, left, above, below.
    fn free_beside([x, y]: [f64; 2], words: &str, taken: &[Self]) -> Self {
        let [height, letter] = SMALL;
        let width = letter * words.chars().count() as f64;
        let place = |left: f64, top: f64| Self {
            from: [rounded(left), rounded(top)],
            to: [rounded(left + width), rounded(top + height)],
        };
        let (middle, half) = (x - 0.5 * width, 0.5 * height);
        let places = [
            place(x + 9.0, y - half),
            place(x - 9.0 - width, y - half),
            place(middle, y + 8.0),
            place(middle, y - 9.0 - height),
            place(x - 5.0 - width, y + 6.0),
            place(x + 6.0, y - 6.0 - height),
            place(x + 6.0, y + 6.0),
            place(x - 5.0 - width, y - 6.0 - height),
            place(x - 9.0 - width, y + 14.0),
            place(x + 9.0, y - 14.0 - height),
        ];
        let is_free = |place: &&Self| place.from[0] > LEFT && !taken.iter().any(|other| place.overlaps(other));
        *places.iter().find(is_free).unwrap_or(&places[0])
    }

    /// What a straight line takes, bit by bit.
    fn along([x, y]: [f64; 2], [to_x, to_y]: [f64; 2]) -> impl Iterator<Item = Self> {
        let steps = ((to_x - x).hypot(to_y - y) / 3.0).ceil().max(1.0);
        (0..=steps as u32).map(move |step| {
            let share = f64::from(step) / steps;
            let [x, y] = [x + share * (to_x - x), y + share * (to_y - y)];
            Self { from: [x - 1.0, y - 1.0], to: [x + 1.0, y + 1.0] }
        })
    }

    fn overlaps(&self, other: &Self) -> bool {
        (0..2).all(|axis| self.from[axis] < other.to[axis] && other.from[axis] < self.to[axis])
    }
}

fn grid(x: &ShareAxis, y: &LogAxis) -> Group {
    let mut group = Group::new();
    for (value, label) in y.ticks() {
        let at = y.pixel(value);
        let stroke = if label.is_some() { GRID } else { FAINT_GRID };
        group = group.add(line([LEFT, at], [x.right, at]).set("stroke", stroke));
        if let Some(label) = label {
            group = group.add(text(label, [LEFT - 8.0, at + 4.0], "end"));
        }
    }
    for value in x.ticks() {
        let at = x.pixel(value);
        group = group.add(line([at, TOP], [at, BOTTOM]).set("stroke", if value > 0.0 { FAINT_GRID } else { GRID }));
        let label = if x.step < 1.0 { format!("{value:.1}") } else { format!("{value:.0}") };
        group = group.add(text(label, [at, BOTTOM + 20.0], "middle"));
    }
    let middle = [(LEFT + x.right) * 0.5, (TOP + BOTTOM) * 0.5];
    let turned = format!("rotate(-90 16 {})", middle[1]);
    group.add(text("length of silhouette missed in %", [middle[0], BOTTOM + 42.0], "middle").set("fill", INK)).add(
        text("median time of a frame in µs", [16.0, middle[1]], "middle").set("fill", INK).set("transform", turned),
    )
}

#[cfg(test)]
mod tests {
    use super::super::measure::tests::reproduction;
    use super::*;

    #[test]
    fn every_variant_is_marked_and_every_mark_explained() {
        let chart = trade(reproduction());
        let variants = Variant::all();
        let way = 1;
        let marks = reproduction().meshes.len() * (variants.len() + way) + FAMILIES.len();
        assert_eq!(chart.matches("<polyline").count(), marks);
        assert!(variants.iter().all(|&variant| FAMILIES.contains(&Family::of(variant))));
        for family in FAMILIES {
            assert!(
                chart.contains(&format!("\n{}\n", family.label())) || chart.contains(&format!(">{}<", family.label()))
            );
        }
        assert!(!chart.contains("NaN") && !chart.contains("inf") && !chart.contains("<b>"));
    }

    #[test]
    fn families_differ_in_shape_where_colours_may_look_alike() {
        for (index, &family) in FAMILIES.iter().enumerate() {
            for &other in &FAMILIES[..index] {
                let same = family.shape() == other.shape() && family.is_hollow() == other.is_hollow();
                assert!(!same || family.color() != other.color(), "{family:?} {other:?}");
            }
        }
    }

    #[test]
    fn shares_have_round_steps_from_nothing() {
        for (largest, end, count) in [(0.0, 0.1, 2), (0.43, 0.5, 6), (7.9, 8.0, 5), (28.0, 30.0, 4), (93.0, 100.0, 6)] {
            let axis = ShareAxis::new([0.0, largest].into_iter(), 400.0);
            assert!((axis.end - end).abs() < 1e-9 && axis.ticks().count() == count, "{largest}: {}", axis.end);
            assert!(axis.pixel(largest) <= 400.0 && axis.pixel(0.0) > LEFT);
        }
    }

    #[test]
    fn marks_that_are_as_good_as_one_share_their_words() {
        let variants = &reproduction().meshes[0].variants[2..5];
        let texts =
            |marks: [[f64; 2]; 3]| labels(variants, &marks).into_iter().map(|label| label.label).collect::<Vec<_>>();
        assert_eq!(texts([[0.0, 0.0], [3.0, 0.0], [90.0, 0.0]]), ["0, 0.01", "0.1"]);
        assert_eq!(texts([[0.0, 0.0], [0.0, 30.0], [0.0, 60.0]]), ["0", "0.01", "0.1"]);
    }

    #[test]
    fn words_avoid_what_is_there() {
        let first = Extent::free_beside([200.0, 100.0], "0.1", &[]);
        let second = Extent::free_beside([200.0, 100.0], "0.1", &[first]);
        assert!(!second.overlaps(&first) && first.overlaps(&first));
        let line: Vec<Extent> = Extent::along([200.0, 100.0], [300.0, 100.0]).collect();
        let beside = Extent::free_beside([200.0, 100.0], "0.1", &line);
        assert!(line.iter().all(|bit| !beside.overlaps(bit)) && line.iter().any(|bit| first.overlaps(bit)));
    }
}

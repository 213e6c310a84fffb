//! Charts with a panel per sweep: both axes logarithmic, with a place of its own for 0.

use silhouette_compare::plot::{FAINT_GRID, GRID, INK, LogAxis, line, paper, rounded, text};
use svg::node::element::{Circle, Group, Polyline};

/// A method, or the control.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// What the legend calls it.
    pub name: String,
    /// Whether it is what the others are compared with: drawn dashed and black.
    pub is_control: bool,
    /// Places along the sweep, and errors.
    pub points: Vec<[f64; 2]>,
}

/// A sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// What stands below its axis.
    pub label: &'static str,
    /// What is drawn in it, the same names in the same order in each panel of a chart.
    pub series: Vec<Series>,
}

/// Panels below each other.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// Its file.
    pub file: &'static str,
    /// What stands beside the axes.
    pub y_label: &'static str,
    /// The sweeps.
    pub panels: Vec<Panel>,
}

/// Colours that differ in lightness, too.
const COLORS: [&str; 10] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#8c6d00", "#7a3db8", "#b22222", "#4f7f2f", "#6e6e6e"];

/// Panels side by side.
const PER_ROW: usize = 2;
const PANEL: [f64; 2] = [430.0, 300.0];
const LEFT: f64 = 72.0;
const RIGHT: f64 = 412.0;
const TOP: f64 = 16.0;
/// Where the logarithmic axis ends, and where 0 is.
const BOTTOM: f64 = 220.0;
const ZERO: f64 = 240.0;
const LEGEND_LINE: f64 = 20.0;
const LEGEND_COLUMN: f64 = 200.0;

/// Errors below this count as 0: pictures and places are not measured so finely.
const LEAST: f64 = 1e-6;

impl Chart {
    /// The chart, as SVG.
    pub fn svg(&self) -> String {
        let width = PANEL[0] * PER_ROW as f64;
        let names: Vec<&Series> = self.panels.first().map_or(Vec::new(), |panel| panel.series.iter().collect());
        let per_line = (width / LEGEND_COLUMN) as usize;
        let legend_height = LEGEND_LINE * (names.len().div_ceil(per_line) as f64 + 1.0);
        let rows = self.panels.len().div_ceil(PER_ROW) as f64;
        let mut document = paper([width, legend_height + rows * PANEL[1]]);
        for (index, series) in names.iter().enumerate() {
            let at =
                [24.0 + LEGEND_COLUMN * (index % per_line) as f64, LEGEND_LINE * (1.0 + (index / per_line) as f64)];
            let words = text(series.name.clone(), [at[0] + 28.0, at[1] + 4.0], "start").set("fill", INK);
            document = document.add(way(&[at, [at[0] + 20.0, at[1]]], index, series)).add(words);
        }
        for (index, panel) in self.panels.iter().enumerate() {
            let at = [PANEL[0] * (index % PER_ROW) as f64, legend_height + PANEL[1] * (index / PER_ROW) as f64];
            let group = self.panel(panel).set("transform", format!("translate({} {})", at[0], at[1]));
            document = document.add(group);
        }
        format!("{document}\n")
    }

    fn panel(&self, panel: &Panel) -> Group {
        let points = || panel.series.iter().flat_map(|series| &series.points);
        let x = LogAxis::around(points().map(|point| point[0]), LEFT + 8.0..RIGHT);
        let above = self.panels.iter().flat_map(|panel| &panel.series).flat_map(|series| &series.points);
        let y = LogAxis::around(above.map(|point| point[1]).filter(|&error| error >= LEAST), BOTTOM..TOP);
        let mut group = Group::new();
        let mut labels = 0;
        for (value, label) in x.ticks() {
            let Some(label) = label else { continue };
            let at = x.pixel(value);
            group = group.add(line([at, TOP], [at, ZERO]).set("stroke", FAINT_GRID));
            // A long axis has room for the numbers of some decades.
            if labels % x.ticks().filter(|(_, label)| label.is_some()).count().div_ceil(8) == 0 {
                group = group.add(text(short(value, label), [at, ZERO + 20.0], "middle"));
            }
            labels += 1;
        }
        for (value, label) in y.ticks() {
            let Some(label) = label else { continue };
            let at = y.pixel(value);
            group = group.add(line([LEFT, at], [RIGHT, at]).set("stroke", GRID));
            group = group.add(text(short(value, label), [LEFT - 8.0, at + 4.0], "end"));
        }
        group = group.add(line([LEFT, ZERO], [RIGHT, ZERO]).set("stroke", GRID));
        group = group.add(text("0", [LEFT - 8.0, ZERO + 4.0], "end"));
        for (index, series) in panel.series.iter().enumerate().rev() {
            let place =
                |&[at, error]: &[f64; 2]| [x.pixel(at), if error < LEAST { ZERO } else { rounded(y.pixel(error)) }];
            group = group.add(way(&series.points.iter().map(place).collect::<Vec<_>>(), index, series));
        }
        let middle = 0.5 * (TOP + ZERO);
        let beside = text(self.y_label, [14.0, middle], "middle").set("fill", INK).set("font-size", 11);
        let below = text(panel.label, [0.5 * (LEFT + RIGHT), ZERO + 42.0], "middle").set("fill", INK);
        group.add(beside.set("transform", format!("rotate(-90 14 {middle})"))).add(below)
    }
}

/// A number of an axis: far decades as powers.
fn short(value: f64, label: String) -> String {
    if (1e-2..1e6).contains(&value) { label } else { format!("{value:.0e}") }
}

/// A line through places, with a mark at each.
fn way(places: &[[f64; 2]], index: usize, series: &Series) -> Group {
    let color = if series.is_control { INK } else { COLORS[index % COLORS.len()] };
    let corners: Vec<String> = places.iter().map(|[x, y]| format!("{x},{y}")).collect();
    let way = Polyline::new().set("points", corners.join(" ")).set("fill", "none").set("stroke", color);
    let way = way.set("stroke-width", if series.is_control { 2.5 } else { 1.5 });
    let way = if series.is_control { way.set("stroke-dasharray", "6 3") } else { way };
    let mark = |&[x, y]: &[f64; 2]| Circle::new().set("cx", x).set("cy", y).set("r", 3).set("fill", color);
    places.iter().map(mark).fold(Group::new().add(way), Group::add)
}

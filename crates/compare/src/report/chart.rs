//! The interactive chart: error over frame time, the cells that are worth their time joined by a line.
//!
//! The page holds charts as JSON; `script.js` draws them, in the colours of light or dark mode.

use super::measure::Measure;
use super::summary::CellSummary;
use crate::metrics::PictureKind;
use plotly::common::{HoverInfo, Line, LineShape, Marker, MarkerSymbol, Mode, Position, Title};
use plotly::layout::{Axis, AxisType, HoverMode, Margin, RangeMode};
use plotly::{Configuration, Layout, Plot, Scatter};
use serde_json::{Value, json};

/// Colours of series in their order, repeated when they run out: distinguishable for people with colour-blindness too
/// (Okabe and Ito).
pub const COLORS: [&str; 8] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#999999"];

/// The same on a dark ground.
pub(super) const DARK_COLORS: [&str; 8] =
    ["#3d9be0", "#f0803c", "#22b68b", "#dd97bd", "#ebb035", "#86cbf3", "#ffffff", "#9aa2ab"];

/// Shapes of the dots: the first for as many series as there are colours, then the next.
const SYMBOLS: [MarkerSymbol; 4] =
    [MarkerSymbol::Circle, MarkerSymbol::Diamond, MarkerSymbol::Square, MarkerSymbol::TriangleUp];

/// Colour and shape of the dots of a series, as indices into [`COLORS`] and the shapes.
pub(super) fn look(series: usize) -> [usize; 2] {
    [series % COLORS.len(), series / COLORS.len() % SYMBOLS.len()]
}

/// The shape of the dots of a series.
pub(super) fn symbol(series: usize) -> MarkerSymbol {
    SYMBOLS[look(series)[1]].clone()
}

/// The script that draws charts, as an element of a page.
pub fn script() -> String {
    // The crate's bundle is the chart library followed by a typesetter of formulas, for which there is no use here.
    let bundle = Plot::offline_js_sources();
    let end = "</script>";
    let length = bundle.find(end).map_or(bundle.len(), |at| at + end.len());
    bundle[..length].to_owned()
}

/// JSON that may stand in a page: no text of it ends the element, or begins another.
pub(super) fn in_page(json: &Value) -> String {
    let text = json.to_string();
    text.replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026")
}

/// A chart as `script.js` takes it: what the chart library draws, and the index of each trace's colour, `None` for that of
/// words.
pub(super) fn with_colors(mut plot: Plot, colors: &[Option<usize>]) -> Value {
    plot.set_configuration(Configuration::new().display_logo(false).responsive(true));
    let plot: Value = serde_json::from_str(&plot.to_json()).unwrap_or_default();
    json!({ "plot": plot, "colors": colors })
}

/// The chart of the cells of a mesh that draw one kind of picture, with what it shows of each measure. `first` of the
/// measures is shown first.
pub fn chart(cells: &[&CellSummary<'_>], measures: &[Measure], first: usize) -> Value {
    let shown: Vec<Value> = measures.iter().map(|measure| shown(cells, measure)).collect();
    let mut plot = Plot::new();
    // The numbers are those of a measure, which the script puts in.
    plot.add_trace(
        Scatter::<f64, f64>::new(vec![], vec![])
            .name("not beaten in both")
            .mode(Mode::Lines)
            .hover_info(HoverInfo::Skip)
            .line(Line::new().width(1.5).shape(LineShape::Hv)),
    );
    let mut colors = vec![None];
    for cell in cells {
        let marker = Marker::new().size(13).symbol(symbol(cell.series));
        plot.add_trace(
            Scatter::<f64, f64>::new(vec![], vec![])
                .name(&cell.label)
                .mode(Mode::Markers)
                .hover_info(HoverInfo::Text)
                .clip_on_axis(false)
                .marker(marker),
        );
        colors.push(Some(look(cell.series)[0]));
    }
    // Names of the front's cells, above all dots.
    plot.add_trace(
        Scatter::<f64, f64>::new(vec![], vec![])
            .mode(Mode::Text)
            .text_position(Position::TopRight)
            .hover_info(HoverInfo::Skip)
            .clip_on_axis(false),
    );
    colors.push(None);
    let axis = || Axis::new().zero_line(false).auto_margin(true);
    plot.set_layout(
        Layout::new()
            .auto_size(true)
            .show_legend(false)
            .margin(Margin::new().left(64).right(24).top(24).bottom(56))
            .hover_mode(HoverMode::Closest)
            .x_axis(axis().type_(AxisType::Log).title(Title::with_text("median frame time in ms")))
            .y_axis(axis().range_mode(RangeMode::ToZero).title(Title::with_text(""))),
    );
    let mut chart = with_colors(plot, &colors);
    chart["measures"] = shown.into();
    chart["first"] = first.into();
    chart
}

/// The measures of a kind of picture that any of the cells has, and which of them is shown first.
pub(super) fn measures(kind: PictureKind, cells: &[&CellSummary<'_>]) -> (Vec<Measure>, usize) {
    let has_value = |measure: &Measure| cells.iter().any(|cell| measure.value(cell).is_some());
    let measures: Vec<Measure> = Measure::of_kind(kind).into_iter().filter(has_value).collect();
    let first = measures.iter().position(|measure| measure.title == kind.leading_metric().title).unwrap_or(0);
    (measures, first)
}

/// What the chart shows of a measure: the data of every trace in their order (the front, the cells, the front's names), and the
/// axis's title.
fn shown(cells: &[&CellSummary<'_>], measure: &Measure) -> Value {
    let milliseconds = |cell: &CellSummary<'_>| cell.cell.frame.frame_ms.median;
    let front = measure.front(cells);
    let on_front = || front.iter().map(|&index| cells[index]);
    let x: Vec<f64> = on_front().map(milliseconds).collect();
    let y: Vec<Option<f64>> = on_front().map(|cell| measure.value(cell)).collect();
    let labels: Vec<&str> = on_front().map(|cell| cell.label.as_str()).collect();
    let names = names(&labels, &x, &y);
    let mut traces = vec![json!({ "x": x, "y": y })];
    traces.extend(cells.iter().map(|cell| match measure.value(cell) {
        Some(value) => json!({
            "x": [milliseconds(cell)],
            "y": [value],
            "hovertext": [hover_text(cell, measure)],
            "error_x": error_bar(milliseconds(cell), Some(cell.cell.frame.frame_ms.interval)),
            "error_y": error_bar(value, measure.interval(cell)),
        }),
        None => json!({ "x": [], "y": [], "hovertext": [] }),
    }));
    traces.push(json!({ "x": x, "y": y, "text": names }));
    json!({ "traces": traces, "axis": format!("{} in {}", measure.title, measure.unit) })
}

/// An error bar from one end of an interval to the other.
fn error_bar(value: f64, interval: Option<[f64; 2]>) -> Value {
    let [low, high] = interval.unwrap_or([value; 2]);
    let array = [(high - value).max(0.0)];
    let below = [(value - low).max(0.0)];
    json!({ "type": "data", "symmetric": false, "array": array, "arrayminus": below, "thickness": 1, "width": 3 })
}

/// What stands beside the dots of the front: spaces keep a name off its dot, empty lines below it off the name before, where the
/// two dots are near each other.
fn names(labels: &[&str], x: &[f64], y: &[Option<f64>]) -> Vec<String> {
    let reach = y.iter().flatten().fold(0.0, |most: f64, value| most.max(*value)) * 0.1;
    let is_near = |at: usize| {
        let [before, here] = [at - 1, at].map(|at| y[at].unwrap_or_default());
        x[at] < 2.0 * x[at - 1] && (before - here).abs() < reach
    };
    let mut lines = 0;
    let place = |(at, label): (usize, &&str)| {
        lines = if at > 0 && is_near(at) { lines + 1 } else { 0 };
        format!("\u{a0}\u{a0}{label}{}", "<br>\u{a0}".repeat(lines))
    };
    labels.iter().enumerate().map(place).collect()
}

/// The chart library reads labels as a little HTML; names of methods and options hold none of its characters.
fn hover_text(summary: &CellSummary<'_>, measure: &Measure) -> String {
    let ratio =
        summary.frame_ratio.map(|ratio| format!("<br>{ratio:.2} x the time of the baseline")).unwrap_or_default();
    let value = measure.value(summary).map_or_else(|| "–".to_owned(), |value| format!("{value:.4} {}", measure.unit));
    let between = measure.interval(summary).map(|[low, high]| format!(" ({low:.4} to {high:.4})")).unwrap_or_default();
    let frame_ms = summary.cell.frame.frame_ms;
    let [low, high] = frame_ms.interval;
    format!(
        "<b>{}</b><br>{}: {value}{between}<br>frame: {:.2} ms median ({low:.2} to {high:.2}), {:.2} ms p95{ratio}<br>row {}",
        summary.label, measure.title, frame_ms.median, frame_ms.p95, summary.row,
    )
}

#[cfg(test)]
mod tests {
    use super::super::summary::summarise;
    use super::super::tests::comparison;
    use super::*;

    #[test]
    fn the_chart_library_is_embedded_without_the_typesetter() {
        let script = script();
        assert!(script.starts_with("<script type=\"text/javascript\">") && script.ends_with("</script>"));
        assert!(script.contains("plotly.js v3") && !script.contains("MathJax.loader"));
        assert_eq!(script.matches("<script").count(), 1, "the one element holds its script and fetches none");
    }

    #[test]
    fn the_front_joins_the_cells_in_the_order_of_their_time() {
        let comparison = comparison();
        let meshes = summarise(&comparison.cells);
        let cells = meshes[0].of_kind(PictureKind::Lines);
        let (lines, first) = measures(PictureKind::Lines, &cells);
        assert_eq!(lines[first].title, "Chamfer distance");
        let chart = chart(&cells, &lines, first);
        let front = &chart["measures"][first]["traces"][0];
        assert_eq!((&front["x"], &front["y"]), (&json!([2.0, 4.0]), &json!([0.5, 0.25])));
        let names = &chart["measures"][first]["traces"][3]["text"];
        assert_eq!(names, &json!(["\u{a0}\u{a0}image-precision", "\u{a0}\u{a0}brute-force"]));
        assert_eq!(chart["colors"], json!([null, 0, 1, null]));
        assert_eq!(chart["plot"]["data"].as_array().map(Vec::len), Some(4), "the front, every cell, the front's names");
        let bar = &chart["measures"][first]["traces"][2]["error_x"];
        assert_eq!((&bar["array"], &bar["arrayminus"]), (&json!([1.0]), &json!([1.0])), "from 1 to 3 ms");
        let text = chart["measures"][first]["traces"][2]["hovertext"][0].as_str().unwrap();
        assert!(text.contains("Chamfer distance: 0.5000 px") && text.ends_with("row 2"), "{text}");
    }

    #[test]
    fn a_measure_that_no_cell_has_is_not_offered() {
        let comparison = comparison();
        let meshes = summarise(&comparison.cells);
        let filled = meshes[0].of_kind(PictureKind::Fill);
        let (measures, first) = measures(PictureKind::Fill, &filled);
        assert_eq!(measures[first].title, "boundary Chamfer distance");
        assert!(measures.iter().all(|measure| measure.title != "silhouette edges missed" && measure.title != "FLIP"));
    }

    #[test]
    fn no_text_of_a_chart_ends_its_element() {
        let text = in_page(&json!({ "name": "</script><!--&" }));
        assert!(!text.contains(['<', '>', '&']));
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap()["name"], "</script><!--&");
    }

    #[test]
    fn names_of_near_dots_are_set_apart() {
        let shown = names(&["a", "b", "c", "d"], &[1.0, 1.5, 2.0, 9.0], &[Some(9.0), Some(0.5), Some(0.25), Some(0.0)]);
        let lines: Vec<usize> = shown.iter().map(|name| name.matches("<br>").count()).collect();
        assert_eq!(lines, [0, 0, 1, 0]);
    }

    #[test]
    fn series_repeat_colours_before_shapes() {
        assert_eq!([0, 7, 8, 31, 32].map(look), [[0, 0], [7, 0], [0, 1], [7, 3], [0, 0]]);
    }
}

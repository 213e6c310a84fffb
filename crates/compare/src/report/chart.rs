//! The interactive chart: error over frame time, the methods that are worth their time joined by a line.

use super::summary::{CellSummary, MeshSummary};
use crate::metrics::{Better, METRICS, MetricSpec};
use plotly::common::{Anchor, HoverInfo, Line, LineShape, Marker, Mode, Orientation, Title};
use plotly::layout::update_menu::{Button, ButtonMethod, UpdateMenu};
use plotly::layout::{Axis, AxisType, HoverMode, Legend, Margin, RangeMode};
use plotly::{Configuration, Layout, Plot, Scatter};
use serde_json::json;

/// Metric that the chart shows first.
const FIRST_METRIC: &str = "chamfer_px";

/// Colours of the methods in their order, repeated when they run out: told apart by people with colour-blindness too
/// (Okabe and Ito).
pub const COLORS: [&str; 8] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#999999"];

/// The script that draws charts, as an element of a page.
pub fn script() -> String {
    // The crate's bundle is the chart library followed by a typesetter of formulas, for which there is no use here.
    let bundle = Plot::offline_js_sources();
    let end = "</script>";
    let length = bundle.find(end).map_or(bundle.len(), |at| at + end.len());
    bundle[..length].to_owned()
}

/// The chart of a mesh as an element of a page with this id. `color_of` yields the colour of a method.
pub fn chart(id: &str, summary: &MeshSummary, color_of: impl Fn(&str) -> &'static str) -> String {
    let metrics: Vec<&MetricSpec> = METRICS.iter().filter(|metric| metric.better == Better::Lower).collect();
    let first = metrics.iter().position(|metric| metric.name == FIRST_METRIC).unwrap_or(0);
    let series: Vec<Series> = metrics.iter().map(|metric| Series::new(summary, metric)).collect();

    let mut plot = Plot::new();
    let Series { x, y, text } = &series[first];
    let front = summary.cells.len();
    plot.add_trace(
        Scatter::new(x[front].clone(), y[front].clone())
            .name("not beaten in both")
            .mode(Mode::Lines)
            .hover_info(HoverInfo::Skip)
            .line(Line::new().color("#9aa3ad").width(1.5).shape(LineShape::Hv)),
    );
    for (index, cell) in summary.cells.iter().enumerate() {
        plot.add_trace(
            Scatter::new(x[index].clone(), y[index].clone())
                .name(label(cell, &summary.cells))
                .mode(Mode::Markers)
                .hover_info(HoverInfo::Text)
                .hover_text(&text[index])
                .marker(Marker::new().size(14).color(color_of(&cell.method))),
        );
    }
    plot.set_layout(layout(&metrics, &series, first));
    plot.set_configuration(Configuration::new().display_logo(false).responsive(true));
    plot.to_inline_html(Some(id))
}

/// What the chart shows for one metric: a value a cell, then the front.
struct Series {
    x: Vec<Vec<f64>>,
    y: Vec<Vec<f64>>,
    text: Vec<String>,
}

impl Series {
    fn new(summary: &MeshSummary, metric: &MetricSpec) -> Self {
        let milliseconds = |cell: &CellSummary| cell.frame.frame_ms.median;
        let error = |cell: &CellSummary| (metric.value)(&cell.metrics);
        let front = summary.front(metric);
        let on_front = |value: &dyn Fn(&CellSummary) -> f64| {
            front.iter().map(|&index| value(&summary.cells[index])).collect::<Vec<_>>()
        };
        let mut x: Vec<Vec<f64>> = summary.cells.iter().map(|cell| vec![milliseconds(cell)]).collect();
        let mut y: Vec<Vec<f64>> = summary.cells.iter().map(|cell| vec![error(cell)]).collect();
        x.push(on_front(&milliseconds));
        y.push(on_front(&error));
        Self { x, y, text: summary.cells.iter().map(|cell| hover_text(cell, metric)).collect() }
    }

    /// Arguments of the chart library's `update`: the data of all traces, in their order, and the title of the axis.
    fn update(&self, metric: &MetricSpec) -> serde_json::Value {
        let front_first = |values: &[Vec<f64>]| {
            let (front, cells) = values.split_last().expect("the front is always there");
            std::iter::once(front).chain(cells).cloned().collect::<Vec<_>>()
        };
        let text: Vec<&str> = std::iter::once("").chain(self.text.iter().map(String::as_str)).collect();
        json!([
            { "x": front_first(&self.x), "y": front_first(&self.y), "hovertext": text },
            { "yaxis.title.text": axis_title(metric) },
        ])
    }
}

fn layout(metrics: &[&MetricSpec], series: &[Series], first: usize) -> Layout {
    let button = |(metric, series): (&&MetricSpec, &Series)| {
        Button::new().label(metric.title).method(ButtonMethod::Update).args(series.update(metric))
    };
    let menu = UpdateMenu::new()
        .active(i32::try_from(first).unwrap_or(0))
        .buttons(metrics.iter().zip(series).map(button).collect())
        .x(0.0)
        .x_anchor(Anchor::Left)
        .y(1.03)
        .y_anchor(Anchor::Bottom);
    let axis = || Axis::new().zero_line(false).grid_color("#e6e8eb").auto_margin(true);
    Layout::new()
        .height(400)
        .margin(Margin::new().left(64).right(16).top(48).bottom(56))
        .hover_mode(HoverMode::Closest)
        .legend(Legend::new().orientation(Orientation::Horizontal).y(-0.2).y_anchor(Anchor::Top))
        .update_menus(vec![menu])
        .x_axis(axis().type_(AxisType::Log).title(Title::with_text("median frame time in ms")))
        .y_axis(axis().range_mode(RangeMode::ToZero).title(Title::with_text(axis_title(metrics[first]))))
}

fn axis_title(metric: &MetricSpec) -> String {
    format!("{} in {}", metric.title, metric.unit)
}

/// The method's name, with its options where another cell has the same: a legend of long lines would take the chart's room.
fn label(cell: &CellSummary, cells: &[CellSummary]) -> String {
    let is_alone = cells.iter().filter(|other| other.method == cell.method).count() == 1;
    if is_alone || cell.options.is_empty() {
        cell.method.clone()
    } else {
        format!("{} ({})", cell.method, cell.options)
    }
}

/// The chart library reads labels as a little HTML; names of methods and options hold none of its characters.
fn hover_text(cell: &CellSummary, metric: &MetricSpec) -> String {
    let ratio = cell.frame_ratio.map(|ratio| format!("<br>{ratio:.2} x the time of brute force")).unwrap_or_default();
    let options = if cell.options.is_empty() { "default" } else { &cell.options };
    format!(
        "<b>{}</b><br>options: {options}<br>{}: {:.4} {}<br>frame: {:.2} ms median, {:.2} ms p95{ratio}",
        cell.method,
        metric.title,
        (metric.value)(&cell.metrics),
        metric.unit,
        cell.frame.frame_ms.median,
        cell.frame.frame_ms.p95,
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
    fn the_front_joins_the_methods_in_the_order_of_their_time() {
        let summary = &summarise(&comparison().records)[0];
        let metric = crate::metrics::find(FIRST_METRIC).unwrap();
        let series = Series::new(summary, metric);
        assert_eq!((&series.x[2], &series.y[2]), (&vec![2.0, 4.0], &vec![0.5, 0.25]));
        assert!(chart("chart-0", summary, |_| COLORS[0]).contains("id=\"chart-0\""));
    }
}

//! The interactive chart: error over frame time, the cells that are worth their time joined by a line.

use super::measure::Measure;
use super::summary::CellSummary;
use crate::metrics::PictureKind;
use plotly::common::{Anchor, HoverInfo, Line, LineShape, Marker, MarkerSymbol, Mode, Orientation, Title};
use plotly::layout::update_menu::{Button, ButtonMethod, UpdateMenu};
use plotly::layout::{Axis, AxisType, HoverMode, Legend, Margin, RangeMode};
use plotly::{Configuration, Layout, Plot, Scatter};
use serde_json::json;

/// Colours of series in their order, repeated when they run out: distinguishable for people with colour-blindness too
/// (Okabe and Ito).
pub const COLORS: [&str; 8] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#999999"];

/// Shapes of the dots: the first for as many series as there are colours, then the next.
const SYMBOLS: [MarkerSymbol; 4] =
    [MarkerSymbol::Circle, MarkerSymbol::Diamond, MarkerSymbol::Square, MarkerSymbol::TriangleUp];

/// The shape of the dots of a series.
pub(super) fn symbol(series: usize) -> MarkerSymbol {
    SYMBOLS[series / COLORS.len() % SYMBOLS.len()].clone()
}

/// The script that draws charts, as an element of a page.
pub fn script() -> String {
    // The crate's bundle is the chart library followed by a typesetter of formulas, for which there is no use here.
    let bundle = Plot::offline_js_sources();
    let end = "</script>";
    let length = bundle.find(end).map_or(bundle.len(), |at| at + end.len());
    bundle[..length].to_owned()
}

/// What the chart of a kind of picture shows first.
fn first_title(kind: PictureKind) -> &'static str {
    match kind {
        PictureKind::Lines => "Chamfer distance",
        PictureKind::Fill => "boundary Chamfer distance",
    }
}

/// The chart of the cells of a mesh that draw one kind of picture, as an element of a page with this id. `series_of` yields
/// which series of the page a cell is, for its colour.
pub fn chart(
    id: &str,
    kind: PictureKind,
    cells: &[&CellSummary<'_>],
    series_of: impl Fn(&CellSummary<'_>) -> usize,
) -> String {
    let has_value = |measure: &Measure| cells.iter().any(|cell| measure.value(cell).is_some());
    let measures: Vec<Measure> = Measure::of_kind(kind).into_iter().filter(has_value).collect();
    let shown: Vec<Shown> = measures.iter().map(|measure| Shown::new(cells, measure)).collect();
    let first = measures.iter().position(|measure| measure.title == first_title(kind)).unwrap_or(0);

    let mut plot = Plot::new();
    if let Some(Shown { x, y, text }) = shown.get(first) {
        let front = cells.len();
        plot.add_trace(
            Scatter::new(x[front].clone(), y[front].clone())
                .name("not beaten in both")
                .mode(Mode::Lines)
                .hover_info(HoverInfo::Skip)
                .line(Line::new().color("#9aa3ad").width(1.5).shape(LineShape::Hv)),
        );
        for (index, cell) in cells.iter().enumerate() {
            let series = series_of(cell);
            let marker = Marker::new().size(14).color(COLORS[series % COLORS.len()]).symbol(symbol(series));
            plot.add_trace(
                Scatter::new(x[index].clone(), y[index].clone())
                    .name(&cell.label)
                    .mode(Mode::Markers)
                    .hover_info(HoverInfo::Text)
                    .hover_text(&text[index])
                    .marker(marker),
            );
        }
        plot.set_layout(layout(&measures, &shown, first));
    }
    plot.set_configuration(Configuration::new().display_logo(false).responsive(true));
    plot.to_inline_html(Some(id))
}

/// What the chart shows of one measure: at most one point per cell, then the front.
struct Shown {
    x: Vec<Vec<f64>>,
    y: Vec<Vec<f64>>,
    text: Vec<String>,
}

impl Shown {
    fn new(cells: &[&CellSummary<'_>], measure: &Measure) -> Self {
        let milliseconds = |cell: &CellSummary<'_>| cell.cell.frame.frame_ms.median;
        let value = |cell: &CellSummary<'_>| measure.value(cell);
        let mut x: Vec<Vec<f64>> =
            cells.iter().map(|cell| value(cell).map(|_| milliseconds(cell)).into_iter().collect()).collect();
        let mut y: Vec<Vec<f64>> = cells.iter().map(|cell| value(cell).into_iter().collect()).collect();
        let front = measure.front(cells);
        x.push(front.iter().map(|&index| milliseconds(cells[index])).collect());
        y.push(front.iter().filter_map(|&index| value(cells[index])).collect());
        Self { x, y, text: cells.iter().map(|cell| hover_text(cell, measure)).collect() }
    }

    /// Arguments of the chart library's `update`: the data of all traces, in their order, and the title of the axis.
    fn update(&self, measure: &Measure) -> serde_json::Value {
        let front_first = |values: &[Vec<f64>]| {
            let front = values.len().saturating_sub(1);
            [&values[front..], &values[..front]].concat()
        };
        let text: Vec<&str> = std::iter::once("").chain(self.text.iter().map(String::as_str)).collect();
        json!([
            { "x": front_first(&self.x), "y": front_first(&self.y), "hovertext": text },
            { "yaxis.title.text": axis_title(measure) },
        ])
    }
}

fn layout(measures: &[Measure], shown: &[Shown], first: usize) -> Layout {
    let button = |(measure, shown): (&Measure, &Shown)| {
        Button::new().label(measure.title).method(ButtonMethod::Update).args(shown.update(measure))
    };
    let menu = UpdateMenu::new()
        .active(i32::try_from(first).unwrap_or(0))
        .buttons(measures.iter().zip(shown).map(button).collect())
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
        .y_axis(axis().range_mode(RangeMode::ToZero).title(Title::with_text(axis_title(&measures[first]))))
}

fn axis_title(measure: &Measure) -> String {
    format!("{} in {}", measure.title, measure.unit)
}

/// The chart library reads labels as a little HTML; names of methods and options hold none of its characters.
fn hover_text(summary: &CellSummary<'_>, measure: &Measure) -> String {
    let ratio =
        summary.frame_ratio.map(|ratio| format!("<br>{ratio:.2} x the time of the baseline")).unwrap_or_default();
    let value = measure.value(summary).map_or_else(|| "–".to_owned(), |value| format!("{value:.4} {}", measure.unit));
    let frame_ms = summary.cell.frame.frame_ms;
    format!(
        "<b>{}</b><br>{}: {value}<br>frame: {:.2} ms median, {:.2} ms p95{ratio}",
        summary.label, measure.title, frame_ms.median, frame_ms.p95,
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
        let measures = Measure::of_kind(PictureKind::Lines);
        let measure = measures.iter().find(|measure| measure.title == first_title(PictureKind::Lines)).unwrap();
        let shown = Shown::new(&cells, measure);
        assert_eq!((&shown.x[cells.len()], &shown.y[cells.len()]), (&vec![2.0, 4.0], &vec![0.5, 0.25]));
        assert!(chart("chart-0", PictureKind::Lines, &cells, |_| 0).contains("id=\"chart-0\""));
        let filled = chart("chart-1", PictureKind::Fill, &meshes[0].of_kind(PictureKind::Fill), |_| 0);
        assert!(filled.contains("boundary Chamfer distance in px") && !filled.contains("edges missed"));
    }
}

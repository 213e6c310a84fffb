//! The interactive chart of extraction times over faces, both axes logarithmic, with a fitted law for each method.

use super::chart::{look, symbol, with_colors};
use crate::scaling::{ExtractionRow, Series};
use plotly::common::{HoverInfo, Line, Marker, Mode, Title};
use plotly::layout::{Axis, AxisType, HoverMode, Margin};
use plotly::{Layout, Plot, Scatter};
use serde_json::Value;

/// The chart as `script.js` takes it; colours and shapes in the order of the series.
pub(super) fn chart(all: &[Series<'_>]) -> Value {
    let mut plot = Plot::new();
    let mut colors = Vec::new();
    for (index, series) in all.iter().enumerate() {
        let color = Some(look(index)[0]);
        let growth = series.growth();
        let law = growth.as_ref().map(|growth| format!(" ~ faces^{:.2}", growth.law.exponent)).unwrap_or_default();
        plot.add_trace(
            Scatter::new(
                series.rows.iter().map(|row| row.faces as f64).collect(),
                series.rows.iter().map(|row| row.median_ms).collect(),
            )
            .name(format!("{}{law}", escaped(&series.label)))
            .mode(Mode::Markers)
            .hover_info(HoverInfo::Text)
            .hover_text_array(series.rows.iter().map(|row| hover_text(row)).collect())
            .marker(Marker::new().size(9).symbol(symbol(index))),
        );
        colors.push(color);
        let Some(growth) = growth else { continue };
        let ends = growth.faces.map(|faces| faces as f64);
        plot.add_trace(
            Scatter::new(ends.to_vec(), ends.map(|faces| growth.law.at(faces)).to_vec())
                .mode(Mode::Lines)
                .hover_info(HoverInfo::Skip)
                .line(Line::new().width(1.5)),
        );
        colors.push(color);
    }
    plot.set_layout(layout());
    with_colors(plot, &colors)
}

fn layout() -> Layout {
    let axis = |title: &str| {
        let axis = Axis::new().type_(AxisType::Log).zero_line(false).auto_margin(true);
        axis.title(Title::with_text(title))
    };
    Layout::new()
        .auto_size(true)
        .show_legend(false)
        .margin(Margin::new().left(64).right(16).top(16).bottom(56))
        .hover_mode(HoverMode::Closest)
        .x_axis(axis("faces").dtick(1.0))
        .y_axis(axis("median extraction time in ms").dtick(1.0).tick_format("~g"))
}

fn hover_text(row: &ExtractionRow) -> String {
    let recall = row.recall.filter(|recall| *recall < 1.0);
    let recall = recall.map(|recall| format!("<br>finds {:.2} % of the edges", recall * 100.0)).unwrap_or_default();
    format!(
        "<b>{}</b><br>{}: {} faces, {} edges<br>{:.4} ms median, {:.4} ms p95{recall}",
        escaped(&row.label()),
        escaped(&row.mesh),
        row.faces,
        row.edges,
        row.median_ms,
        row.p95_ms,
    )
}

/// A name of a user's as the chart library shows it: labels are read as a little HTML.
fn escaped(name: &str) -> String {
    name.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scaling::{OURS, row, series};

    #[test]
    fn a_law_is_drawn_from_three_sizes_on_and_names_cannot_break_out() {
        let mut rows = vec![row(OURS, "a", "</script>", 100, 1.0), row(OURS, "a", "y", 400, 2.0)];
        let two = chart(&series(&rows)).to_string();
        assert!(!two.contains("faces^") && two.contains("\"type\":\"log\""));
        rows.push(row(OURS, "a", "z", 1600, 4.0));
        let three = chart(&series(&rows));
        assert_eq!(three["colors"], serde_json::json!([0, 0]), "dots and law");
        let three = three.to_string();
        assert!(three.contains("a ~ faces^0.50") && three.contains("&lt;/script&gt;"));
        assert!(!three.contains("</script>"));
    }
}

//! The interactive chart of extraction times over faces, both axes logarithmic, with a fitted law for each method.

use super::chart::{COLORS, symbol};
use crate::scaling::{ExtractionRow, Series};
use plotly::common::{Anchor, HoverInfo, Line, Marker, Mode, Orientation, Title};
use plotly::layout::{Axis, AxisType, HoverMode, Legend, Margin};
use plotly::{Configuration, Layout, Plot, Scatter};

/// The chart as an element of a page with this id; colours in the order of the series.
pub(super) fn chart(id: &str, all: &[Series<'_>]) -> String {
    let mut plot = Plot::new();
    for (index, series) in all.iter().enumerate() {
        let color = COLORS[index % COLORS.len()];
        let growth = series.growth();
        let law = growth.as_ref().map(|growth| format!(" ~ faces^{:.2}", growth.law.exponent)).unwrap_or_default();
        plot.add_trace(
            Scatter::new(
                series.rows.iter().map(|row| row.faces as f64).collect(),
                series.rows.iter().map(|row| row.median_ms).collect(),
            )
            .name(format!("{}{law}", escaped(&series.label)))
            .legend_group(escaped(&series.label))
            .mode(Mode::Markers)
            .hover_info(HoverInfo::Text)
            .hover_text_array(series.rows.iter().map(|row| hover_text(row)).collect())
            .marker(Marker::new().size(9).color(color).symbol(symbol(index))),
        );
        let Some(growth) = growth else { continue };
        let ends = growth.faces.map(|faces| faces as f64);
        plot.add_trace(
            Scatter::new(ends.to_vec(), ends.map(|faces| growth.law.at(faces)).to_vec())
                .legend_group(escaped(&series.label))
                .show_legend(false)
                .mode(Mode::Lines)
                .hover_info(HoverInfo::Skip)
                .line(Line::new().color(color).width(1.5)),
        );
    }
    plot.set_layout(layout());
    plot.set_configuration(Configuration::new().display_logo(false).responsive(true));
    plot.to_inline_html(Some(id))
}

fn layout() -> Layout {
    let axis = |title: &str| {
        let axis = Axis::new().type_(AxisType::Log).zero_line(false).grid_color("#e6e8eb").auto_margin(true);
        axis.title(Title::with_text(title))
    };
    Layout::new()
        .height(520)
        .margin(Margin::new().left(64).right(16).top(16).bottom(56))
        .hover_mode(HoverMode::Closest)
        .legend(Legend::new().orientation(Orientation::Horizontal).y(-0.16).y_anchor(Anchor::Top))
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

/// A name of a user's as the chart library shows it: labels are read as a little HTML, and the chart stands in a script of
/// the page, which `</script>` would end.
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
        let two = chart("id", &series(&rows));
        assert!(!two.contains("faces^") && two.contains("\"type\":\"log\""));
        rows.push(row(OURS, "a", "z", 1600, 4.0));
        let three = chart("id", &series(&rows));
        assert!(three.contains("a ~ faces^0.50") && three.contains("\\u0026lt;/script\\u0026gt;"));
        assert_eq!(three.matches("</script>").count(), 1, "only the element's own end");
    }
}

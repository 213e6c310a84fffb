//! The chart: mean width and its deviation of every variant on every mesh but the spheres, and beside it what shows through.

use super::measure::{MeshResult, Reproduction};
use silhouette_compare::plot::{FAINT_GRID, GRID, INK, line, paper, rounded, text};
use silhouette_compare::report::COLORS;
use svg::node::element::{Group, Rectangle};

/// Height of a row and of a mesh's title, in pixels.
const ROW: f64 = 18.0;
const TITLE: f64 = 56.0;

/// Left ends of the two plots, and the width of each.
const PLOTS: [f64; 2] = [150.0, 540.0];
const PLOT_WIDTH: f64 = 340.0;
const PAGE_WIDTH: f64 = 920.0;

/// Widths beyond this are cut and told in figures.
const WIDEST_PX: f64 = 6.0;

/// The width that is asked for.
const ASKED_PX: f64 = 2.0;

/// The chart, as SVG.
pub fn variants(reproduction: &Reproduction) -> String {
    let height = |mesh: &MeshResult| TITLE + ROW * mesh.variants.len() as f64 + 24.0;
    let meshes = || reproduction.meshes.iter().filter(|mesh| mesh.sphere_level.is_none());
    let total: f64 = meshes().map(height).sum();
    let mut document = paper([PAGE_WIDTH, total.max(TITLE)]);
    let mut top = 0.0;
    for mesh in meshes() {
        document = document.add(panel(mesh).set("transform", format!("translate(0 {})", rounded(top))));
        top += height(mesh);
    }
    format!("{document}\n")
}

fn panel(mesh: &MeshResult) -> Group {
    let bottom = TITLE + ROW * mesh.variants.len() as f64;
    let title = format!("{}, {} faces", mesh.name, mesh.faces);
    let mut group = Group::new().add(text(title, [12.0, 20.0], "start").set("fill", INK).set("font-weight", 600));
    let heads = ["mean width and its deviation, px", "ink that shows through, %"];
    for (left, head) in PLOTS.iter().zip(heads) {
        group = group.add(text(head, [*left, 38.0], "start"));
    }
    let width_at = |px: f64| rounded(PLOTS[0] + px.clamp(0.0, WIDEST_PX) / WIDEST_PX * PLOT_WIDTH);
    let share_at = |percent: f64| rounded(PLOTS[1] + percent.clamp(0.0, 100.0) / 100.0 * PLOT_WIDTH);
    for tick in 0..=6_u8 {
        let at = width_at(f64::from(tick));
        let stroke = if (f64::from(tick) - ASKED_PX).abs() < 0.5 { GRID } else { FAINT_GRID };
        group = group.add(line([at, TITLE - 10.0], [at, bottom]).set("stroke", stroke));
        group = group.add(text(format!("{tick}"), [at, bottom + 15.0], "middle"));
    }
    for tick in (0..=100_u8).step_by(25) {
        let at = share_at(f64::from(tick));
        group = group.add(line([at, TITLE - 10.0], [at, bottom]).set("stroke", FAINT_GRID));
        group = group.add(text(format!("{tick}"), [at, bottom + 15.0], "middle"));
    }
    for (index, result) in mesh.variants.iter().enumerate() {
        let middle = TITLE + ROW * (index as f64);
        let metrics = &result.score.metrics;
        let [mean, deviation] = [metrics.width_mean_px, metrics.width_deviation_px];
        let color = if index == 0 { COLORS[2] } else { COLORS[0] };
        group = group
            .add(text(result.variant.label, [PLOTS[0] - 12.0, middle + 4.0], "end").set("fill", INK))
            .add(bar(PLOTS[0], width_at(mean), middle, color))
            .add(
                line([width_at(mean - deviation), middle], [width_at(mean + deviation), middle])
                    .set("stroke", INK)
                    .set("stroke-width", 1.5),
            )
            .add(bar(PLOTS[1], share_at(100.0 * result.score.bleed), middle, color));
    }
    group
}

fn bar(left: f64, right: f64, middle: f64, color: &'static str) -> Rectangle {
    Rectangle::new()
        .set("x", left)
        .set("y", rounded(middle - 0.3 * ROW))
        .set("width", rounded((right - left).max(0.5)))
        .set("height", rounded(0.6 * ROW))
        .set("fill", color)
}

#[cfg(test)]
mod tests {
    use super::super::measure::tests::of_one_mesh;
    use super::*;

    #[test]
    fn every_variant_has_both_bars() {
        let Some(reproduction) = of_one_mesh("every_variant_has_both_bars") else { return };
        let chart = variants(&reproduction);
        let rows = reproduction.meshes[0].variants.len();
        assert_eq!(chart.matches("<rect").count(), 2 * rows + 1);
        assert!(!chart.contains("NaN") && !chart.contains("inf"));
    }
}

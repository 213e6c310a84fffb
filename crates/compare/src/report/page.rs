//! The page: template and chart script embedded, everything that a user named escaped.

use super::chart::{self, COLORS};
use super::extraction_chart;
use super::picture_names;
use super::summary::{CellSummary, MeshSummary, summarise};
use crate::metrics::{Better, METRICS, MetricSpec};
use crate::runner::{Comparison, PictureSet};
use crate::scaling::{ExtractionRow, Series, series};
use minijinja::{Environment, Value, context};

/// Name of the template; its ending makes the engine escape values for HTML.
const TEMPLATE: &str = "index.html";

/// The page of a comparison. It asks nothing of the network: its own policy forbids it.
pub(super) fn render(comparison: &Comparison, extractions: &[ExtractionRow]) -> Result<String, minijinja::Error> {
    let mut environment = Environment::new();
    environment.add_template(TEMPLATE, include_str!("template.html"))?;
    let summaries = summarise(&comparison.records);
    let meshes: Vec<Value> =
        summaries.iter().enumerate().map(|(index, summary)| mesh_section(comparison, index, summary)).collect();
    environment.get_template(TEMPLATE)?.render(context! {
        profile => comparison.profile.name(),
        size => comparison.profile.size(),
        views => comparison.profile.views(),
        frames => comparison.profile.frames(),
        warm_up => comparison.profile.warm_up(),
        facts => comparison.run.facts(),
        is_debug => comparison.run.build == "debug",
        is_software => comparison.run.adapter.software,
        methods => methods(comparison),
        meshes => meshes,
        left_out => comparison.left_out.iter().map(ToString::to_string).collect::<Vec<_>>(),
        extraction => extraction_section(extractions),
        metrics => METRICS.iter().map(metric_row).collect::<Vec<_>>(),
        chart_script => Value::from_safe_string(chart::script()),
    })
}

fn mesh_section(comparison: &Comparison, index: usize, summary: &MeshSummary) -> Value {
    let color_of = |method: &str| {
        let position = comparison.methods.iter().position(|entry| entry.info.name == method);
        COLORS[position.unwrap_or(0) % COLORS.len()]
    };
    let id = format!("chart-{index}");
    let rows: Vec<Value> = summary.cells.iter().map(|cell| cell_row(summary, cell, color_of(&cell.method))).collect();
    let sets = comparison.pictures.iter().enumerate().filter(|(_, set)| set.mesh == summary.mesh.name);
    context! {
        name => &summary.mesh.name,
        vertices => grouped(summary.mesh.vertices),
        edges => grouped(summary.mesh.edges),
        faces => grouped(summary.mesh.faces),
        visible_length => format!("{:.0}", summary.visible_length_px),
        chart => Value::from_safe_string(chart::chart(&id, summary, color_of)),
        rows => rows,
        pictures => sets.map(|(at, set)| picture_row(at, set)).collect::<Vec<_>>(),
    }
}

fn cell_row(summary: &MeshSummary, cell: &CellSummary, color: &str) -> Value {
    let best = |metric: &MetricSpec| {
        let values = summary.cells.iter().map(|other| (metric.value)(&other.metrics));
        metric.better == Better::Lower && values.fold(f64::INFINITY, f64::min) >= (metric.value)(&cell.metrics)
    };
    let metrics = METRICS.iter().map(|metric| {
        let value = (metric.value)(&cell.metrics);
        context! { text => metric_text(metric, value), best => best(metric) && summary.cells.len() > 1 }
    });
    let optional = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), milliseconds);
    let ratio = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |value| format!("{value:.3}"));
    let wrong = cell.edges.filter(|edges| edges.precision < 1.0 || edges.recall < 1.0);
    context! {
        method => &cell.method,
        options => &cell.options,
        color => color,
        pen => format!("{} px, {}", cell.pen.width_px, cell.pen.placement),
        metrics => metrics.collect::<Vec<_>>(),
        edges => match (cell.edges, wrong) {
            (None, _) => "draws only".to_owned(),
            (Some(_), None) => "all, exact".to_owned(),
            (Some(_), Some(edges)) => {
                format!("precision {:.4}, recall {:.4} at worst", edges.precision, edges.recall)
            }
        },
        edges_wrong => wrong.is_some(),
        prepare => milliseconds(cell.prepare.prepare_ms),
        renderer => milliseconds(cell.prepare.renderer_ms),
        bytes => megabytes(cell.prepare.bytes),
        extract => optional(cell.frame.extract_ms.map(|spread| spread.median)),
        gpu => optional(cell.frame.gpu_ms.map(|spread| spread.median)),
        median => milliseconds(cell.frame.frame_ms.median),
        p95 => milliseconds(cell.frame.frame_ms.p95),
        max => milliseconds(cell.frame.frame_ms.max),
        frame_ratio => ratio(cell.frame_ratio),
        extract_ratio => ratio(cell.extract_ratio),
    }
}

fn picture_row(index: usize, set: &PictureSet) -> Value {
    let [drawn, truth, difference] = picture_names(index, set).map(Value::from_safe_string);
    context! {
        method => &set.method, options => &set.options, view => set.view,
        width => set.drawn.width, height => set.drawn.height,
        drawn => drawn, truth => truth, difference => difference,
    }
}

/// Times of extraction over faces; nothing where no method extracts edges and there are no peers.
fn extraction_section(rows: &[ExtractionRow]) -> Option<Value> {
    let all = series(rows);
    let colors = || COLORS.iter().cycle();
    let rows: Vec<Value> = all.iter().zip(colors()).map(|(series, color)| series_row(series, color)).collect();
    (!rows.is_empty()).then(|| {
        context! { chart => Value::from_safe_string(extraction_chart::chart("chart-extraction", &all)), rows => rows }
    })
}

fn series_row(series: &Series<'_>, color: &str) -> Value {
    let growth = series.growth();
    let range = |value: fn(&ExtractionRow) -> f64, text: fn(f64) -> String| {
        let values = || series.rows.iter().map(|row| value(row));
        let [low, high] = [values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max)].map(text);
        if low == high { low } else { format!("{low} to {high}") }
    };
    context! {
        label => &series.label,
        color => color,
        meshes => series.rows.len(),
        faces => range(|row| row.faces as f64, |faces| grouped(faces as usize)),
        median => range(|row| row.median_ms, |time| format!("{time:.4}")),
        speed => range(|row| row.edges_per_second / 1e6, |speed| format!("{speed:.1}")),
        exponent => growth.as_ref().map(|growth| format!("{:.2}", growth.law.exponent)),
        r2 => growth.as_ref().map(|growth| format!("{:.3}", growth.law.r2)),
        shape => growth.map(|growth| growth.shape.unwrap_or_else(|| "all meshes".to_owned())),
        machine => series.rows.first().map(|row| &row.machine),
    }
}

fn methods(comparison: &Comparison) -> Vec<Value> {
    let mut rows: Vec<Value> = Vec::new();
    let mut seen = Vec::new();
    for entry in &comparison.methods {
        let info = entry.info;
        if seen.contains(&info.name) {
            continue;
        }
        seen.push(info.name);
        rows.push(context! {
            name => info.name,
            summary => info.summary,
            source => format!("{}. {}. {}, {}.", info.source.authors, info.source.title, info.source.venue, info.source.year),
            needs => if info.needs.is_empty() { "positions and triangles".to_owned() } else { info.needs.join(", ") },
            options => info.options.iter().map(|option| option.name).collect::<Vec<_>>().join(", "),
        });
    }
    rows
}

fn metric_row(metric: &MetricSpec) -> Value {
    let MetricSpec { name, title, unit, best, worst, summary, .. } = *metric;
    context! { name => name, title => title, unit => unit, best => best, worst => worst, summary => summary }
}

/// Shares are shown in per cent, as the head of the table says.
fn metric_text(metric: &MetricSpec, value: f64) -> String {
    if metric.unit == "share" { format!("{:.2}", value * 100.0) } else { format!("{value:.2}") }
}

fn milliseconds(value: f64) -> String {
    if value < 10.0 { format!("{value:.2}") } else { format!("{value:.1}") }
}

fn megabytes(bytes: u64) -> String {
    format!("{:.2}", bytes as f64 / 1e6)
}

/// A count with thin spaces between groups of three digits.
fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let head = digits.len() % 3;
    let groups = digits.as_bytes()[head..].chunks(3).map(|group| String::from_utf8_lossy(group).into_owned());
    let first = (head > 0).then(|| digits[..head].to_owned());
    first.into_iter().chain(groups).collect::<Vec<_>>().join("\u{202f}")
}

#[cfg(test)]
mod tests {
    use super::super::tests::comparison;
    use super::*;
    use crate::scaling::rows_of_records;

    fn rendered(comparison: &Comparison) -> String {
        let extractions = [rows_of_records(&comparison.records), comparison.peers.clone()].concat();
        render(comparison, &extractions).unwrap()
    }

    #[test]
    fn extraction_times_stand_beside_those_of_peers() {
        let page = rendered(&comparison());
        assert!(page.contains("id=\"chart-extraction\"") && page.contains("&lt;b&gt;peer: m</td>"));
        assert!(page.contains("<td>1.00</td><td>1.000</td><td>all meshes</td>"), "the peer's growth is stated");
        let alone = Comparison { peers: Vec::new(), records: Vec::new(), ..comparison() };
        assert!(!rendered(&alone).contains("chart-extraction"));
    }

    #[test]
    fn what_a_user_named_is_escaped_everywhere() {
        let comparison = comparison();
        let page = rendered(&comparison);
        let name = &comparison.records[0].mesh.name;
        assert!(!page.contains(name.as_str()) && !page.contains("<img src=x"), "the name must not break out");
        assert!(page.contains("&lt;img src=x onerror=alert(1)&gt;"));
        assert!(page.contains("{{ 7*7 }}"), "names are not templates");
        assert!(page.contains("a &lt;processor&gt;"));
    }

    #[test]
    fn what_is_left_out_is_said() {
        let reason = "3 edges join <b>".to_owned();
        let left_out = vec![crate::LeftOut { mesh: "m".to_owned(), method: "tracking", reason }];
        let page = rendered(&Comparison { left_out, ..comparison() });
        assert!(page.contains("<li>m: tracking is left out: 3 edges join &lt;b&gt;</li>"));
        assert!(!rendered(&comparison()).contains("is left out"));
    }

    #[test]
    fn the_page_asks_nothing_of_the_network() {
        let page = rendered(&comparison());
        assert!(page.contains("default-src 'none'"));
        let own = page.replace(&chart::script(), "");
        for needle in ["src=\"http", "href=\"http", "url(", "@import", "fetch("] {
            assert!(!own.contains(needle), "{needle}");
        }
    }

    #[test]
    fn the_page_shows_methods_metrics_and_pictures() {
        let comparison = comparison();
        let page = rendered(&comparison);
        for text in ["images/000-brute-force-drawn.png", "images/001-image-precision-difference.png", "id=\"chart-0\""]
        {
            assert!(page.contains(text), "{text}");
        }
        for metric in &METRICS {
            assert!(page.contains(metric.title), "{}", metric.name);
        }
        for entry in &comparison.methods {
            assert!(page.contains(entry.info.source.title), "{}", entry.info.name);
        }
    }

    #[test]
    fn counts_are_grouped() {
        assert_eq!([7, 123, 1234, 1_234_567].map(grouped), ["7", "123", "1\u{202f}234", "1\u{202f}234\u{202f}567"]);
    }
}

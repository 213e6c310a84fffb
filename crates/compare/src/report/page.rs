//! The page: template and chart script embedded, everything that a user named escaped.

use super::chart::{self, COLORS};
use super::coherence_table;
use super::extraction_chart;
use super::summary::{CellSummary, MeshSummary, baseline, summarise};
use super::where_it_errs;
use crate::coherence::metrics::COHERENCE;
use crate::machine::RunDescription;
use crate::metrics::PictureKind;
use crate::metrics::table::{Better, MetricSpec};
use crate::record::Cell;
use crate::record::label::distinguishing_options;
use crate::runner::{Comparison, PictureSet};
use crate::scaling::{ExtractionRow, Series, series};
use minijinja::{Environment, Value, context};

/// Name of the template; its ending makes the engine escape values for HTML.
const TEMPLATE: &str = "index.html";

/// The page of a comparison. It asks nothing of the network: its own policy forbids it.
pub(super) fn render(comparison: &Comparison, extractions: &[ExtractionRow]) -> Result<String, minijinja::Error> {
    let mut environment = Environment::new();
    environment.add_template(TEMPLATE, include_str!("template.html"))?;
    let summaries = summarise(&comparison.cells);
    let meshes: Vec<Value> =
        summaries.iter().enumerate().map(|(index, summary)| mesh_section(comparison, index, summary)).collect();
    let is_there = |kind: &PictureKind| comparison.cells.iter().any(|cell| cell.picture == *kind);
    let kinds = PictureKind::ALL.into_iter().filter(is_there);
    let scene = &comparison.scene;
    environment.get_template(TEMPLATE)?.render(context! {
        scene => &scene.name,
        size => scene.picture.size(),
        samples => scene.picture.samples,
        step => scene.path.step_deg.to_string(),
        scored => scene.path.scored,
        frames => scene.path.frames,
        warm_up => scene.path.warm_up,
        runs => comparison.runs.iter().map(RunDescription::facts).collect::<Vec<_>>(),
        is_debug => comparison.runs.iter().any(|run| run.build == "debug"),
        is_software => comparison.runs.iter().any(|run| run.adapter.software),
        methods => methods(comparison),
        meshes => meshes,
        left_out => comparison.left_out.iter().map(ToString::to_string).collect::<Vec<_>>(),
        extraction => extraction_section(extractions),
        metrics => kinds.flat_map(PictureKind::metrics).map(metric_row).collect::<Vec<_>>(),
        coherence_columns => COHERENCE.map(|spec| context! { title => spec.title, unit => spec.unit, summary => spec.summary }),
        chart_script => Value::from_safe_string(chart::script()),
    })
}

/// Paths of a set's pictures inside of the report. They hold no text of a user's.
pub(super) fn picture_names(index: usize, set: &PictureSet) -> [String; 3] {
    ["drawn", "truth", "difference"].map(|what| format!("images/{index:03}-{}-{what}.png", set.method))
}

/// Which series of the page a cell is: one for each method with its options, whatever the mesh.
fn series_of(cells: &[Cell], cell: &Cell) -> usize {
    let mut seen: Vec<(&str, String)> = Vec::new();
    for other in cells {
        let choice = (other.method.as_str(), other.options.to_string());
        let is_new = !seen.contains(&choice);
        if other.method == cell.method && other.options == cell.options {
            return if is_new { seen.len() } else { seen.iter().position(|one| *one == choice).unwrap_or(0) };
        }
        if is_new {
            seen.push(choice);
        }
    }
    0
}

fn mesh_section(comparison: &Comparison, index: usize, summary: &MeshSummary<'_>) -> Value {
    let series = |cell: &CellSummary<'_>| series_of(&comparison.cells, cell.cell);
    let color = |cell: &CellSummary<'_>| COLORS[series(cell) % COLORS.len()];
    let section = |kind: PictureKind| {
        let cells = summary.of_kind(kind);
        let id = format!("chart-{index}-{}", kind.name());
        let sets = comparison.pictures.iter().enumerate();
        let sets = sets.filter(|(at, set)| {
            set.mesh == summary.mesh.name && set.picture == kind && comparison.cells[*at].run == summary.run
        });
        (!cells.is_empty()).then(|| {
            context! {
                title => match kind { PictureKind::Lines => "Lines", PictureKind::Fill => "Filled pictures" },
                is_lines => kind == PictureKind::Lines,
                chart => Value::from_safe_string(chart::chart(&id, kind, &cells, series)),
                metrics => kind.metrics().map(metric_row).collect::<Vec<_>>(),
                rows => cells.iter().map(|cell| quality_row(kind, &cells, cell, color(cell))).collect::<Vec<_>>(),
                errors => cells.iter().filter_map(|cell| where_it_errs::row(cell, color(cell))).collect::<Vec<_>>(),
                pictures => sets.map(|(at, set)| picture_row(comparison, at, set)).collect::<Vec<_>>(),
            }
        })
    };
    context! {
        name => &summary.mesh.name,
        machine => (comparison.runs.len() > 1).then_some(summary.run + 1),
        vertices => grouped(summary.mesh.vertices),
        edges => grouped(summary.mesh.edges),
        faces => grouped(summary.mesh.faces),
        inward => (summary.mesh.inward_faces > 0).then(|| grouped(summary.mesh.inward_faces)),
        visible_length => format!("{:.0}", summary.visible_length_px),
        kinds => PictureKind::ALL.into_iter().filter_map(section).collect::<Vec<_>>(),
        coherence => coherence_table::rows(summary, color),
        costs => summary.cells.iter().map(|cell| cost_row(cell, color(cell))).collect::<Vec<_>>(),
    }
}

fn quality_row(kind: PictureKind, cells: &[&CellSummary<'_>], summary: &CellSummary<'_>, color: &str) -> Value {
    let is_best = |metric: &MetricSpec| {
        let value = (metric.value)(&summary.metrics);
        let others = || cells.iter().filter_map(|other| (metric.value)(&other.metrics));
        let is_beaten = |value: f64| match metric.better {
            Better::Lower => others().any(|other| other < value),
            Better::Higher => others().any(|other| other > value),
            Better::NearPenWidth => true,
        };
        cells.len() > 1 && value.is_some_and(|value| !is_beaten(value))
    };
    let metrics = kind.metrics().map(|metric| {
        let text = (metric.value)(&summary.metrics).map(|value| metric_text(metric, value));
        context! { text => text.unwrap_or_else(|| "–".to_owned()), best => is_best(metric) }
    });
    let worst = summary.cell.worst_edges();
    let is_wrong = worst.is_some_and(|edges| edges.precision < 1.0 || edges.recall < 1.0);
    context! {
        method => &summary.cell.method,
        options => summary.options.to_string(),
        color => color,
        pen => summary.cell.pen.as_ref().map(|pen| format!("{} px, {}", pen.width_px, pen.placement)),
        metrics => metrics.collect::<Vec<_>>(),
        edges => match (worst, summary.cell.recall()) {
            (Some(worst), Some(recall)) if is_wrong => {
                let percent = |share: f64| format!("{:.2} %", share * 100.0);
                let missed = format!("recall {}, worst frame {}", percent(recall), percent(worst.recall));
                let is_precise = worst.precision >= 1.0;
                if is_precise { missed } else { format!("{missed}; precision {}", percent(worst.precision)) }
            }
            (Some(_), _) => "all, exact".to_owned(),
            (None, _) => "draws only".to_owned(),
        },
        edges_wrong => is_wrong,
    }
}

fn cost_row(summary: &CellSummary<'_>, color: &str) -> Value {
    let optional = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), milliseconds);
    let ratio = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |value| format!("{value:.3}"));
    let Cell { prepare, frame, picture, .. } = summary.cell;
    context! {
        method => &summary.cell.method,
        options => summary.options.to_string(),
        color => color,
        baseline => baseline(*picture),
        prepare => milliseconds(prepare.prepare_ms),
        renderer => milliseconds(prepare.renderer_ms),
        bytes => megabytes(prepare.bytes),
        extract => optional(frame.extract_ms.map(|spread| spread.median)),
        gpu => optional(frame.gpu_ms.map(|spread| spread.median)),
        median => milliseconds(frame.frame_ms.median),
        p95 => milliseconds(frame.frame_ms.p95),
        max => milliseconds(frame.frame_ms.max),
        frame_ratio => ratio(summary.frame_ratio),
        extract_ratio => ratio(summary.extract_ratio),
    }
}

fn picture_row(comparison: &Comparison, index: usize, set: &PictureSet) -> Value {
    let [drawn, truth, difference] = picture_names(index, set).map(Value::from_safe_string);
    let options = comparison.cells.get(index).map(|cell| distinguishing_options(cell, &comparison.cells).to_string());
    context! {
        method => &set.method, options => options, frame => set.frame,
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
    let row = |entry: &crate::registry::Entry| {
        let info = entry.info();
        context! {
            name => info.name,
            summary => info.summary,
            source => format!("{}. {}. {}, {}.", info.source.authors, info.source.title, info.source.venue, info.source.year),
            needs => if info.needs.is_empty() { "positions and triangles".to_owned() } else { info.needs.join(", ") },
            options => info.options.iter().map(|option| option.name).collect::<Vec<_>>().join(", "),
        }
    };
    comparison.methods.iter().map(row).collect()
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
    use crate::metrics::METRICS;
    use crate::options::OptionSetting;
    use crate::record::EdgeScore;
    use crate::record::tests::{cell, with_coherence, with_option};
    use crate::scaling::rows_of_cells;

    fn rendered(comparison: &Comparison) -> String {
        let extractions = [rows_of_cells(&comparison.cells, &comparison.runs), comparison.peers.clone()].concat();
        render(comparison, &extractions).unwrap()
    }

    #[test]
    fn extraction_times_stand_beside_those_of_peers() {
        let page = rendered(&comparison());
        assert!(page.contains("id=\"chart-extraction\"") && page.contains("&lt;b&gt;peer: m</td>"));
        assert!(page.contains("<td>1.00</td><td>1.000</td><td>all meshes</td>"), "the peer's growth is stated");
        let alone = Comparison { peers: Vec::new(), cells: Vec::new(), ..comparison() };
        assert!(!rendered(&alone).contains("chart-extraction"));
    }

    #[test]
    fn what_a_user_named_is_escaped_everywhere() {
        let comparison = comparison();
        let page = rendered(&comparison);
        let name = &comparison.cells[0].mesh.name;
        assert!(!page.contains(name.as_str()) && !page.contains("<img src=x"), "the name must not break out");
        assert!(page.contains("&lt;img src=x onerror=alert(1)&gt;"));
        assert!(page.contains("{{ 7*7 }}"), "names are not templates");
        assert!(page.contains("a &lt;processor&gt;"));
    }

    #[test]
    fn faces_wound_inwards_are_stated_beside_what_was_drawn() {
        let mut comparison = comparison();
        assert!(!rendered(&comparison).contains("wound inwards, so that methods"));
        comparison.cells.iter_mut().for_each(|cell| cell.mesh.inward_faces = 12);
        assert!(rendered(&comparison).contains("12 faces are wound inwards, so that methods"));
    }

    #[test]
    fn what_is_left_out_is_stated() {
        let reason = "3 edges join <b>".to_owned();
        let left_out = vec![crate::LeftOut { mesh: "m".to_owned(), method: "tracking".to_owned(), reason }];
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
        for text in [
            "images/000-brute-force-drawn.png",
            "images/001-image-precision-difference.png",
            "id=\"chart-0-lines\"",
            "id=\"chart-0-fill\"",
        ] {
            assert!(page.contains(text), "{text}");
        }
        for metric in &METRICS {
            assert!(page.contains(metric.title), "{}", metric.name);
        }
        for entry in &comparison.methods {
            assert!(page.contains(entry.info().source.title), "{}", entry.info().name);
        }
    }

    #[test]
    fn a_method_with_several_options_is_shown_once_for_each() {
        let mut comparison = comparison();
        for level in [0.0, 0.5] {
            let cell = cell("sweep", "tracking", 1.0 + level, level);
            comparison.cells.push(with_option(cell, "concavity", OptionSetting::Number(level)));
        }
        let page = rendered(&comparison);
        for options in ["concavity=0", "concavity=0.5"] {
            // In the table of quality, the three of errors, and that of cost.
            let row = format!("tracking<span class=\"options\">{options}</span>");
            assert_eq!(page.matches(&row).count(), 5, "{options}");
            assert!(page.contains(&format!("tracking ({options})")), "{options} in the chart");
        }
    }

    #[test]
    fn what_a_method_misses_stands_beside_it() {
        let mut comparison = comparison();
        comparison.cells[0].views[0].edges = Some(EdgeScore { found: 3, precision: 1.0, recall: 0.75 });
        let page = rendered(&comparison);
        assert!(page.contains("<td class=\"wrong\">recall 75.00 %, worst frame 75.00 %</td>"));
        comparison.cells[0].views[0].edges = Some(EdgeScore { found: 6, precision: 0.5, recall: 0.75 });
        assert!(rendered(&comparison).contains("worst frame 75.00 %; precision 50.00 %</td>"));
    }

    #[test]
    fn where_lines_err_stands_beside_what_they_miss() {
        let page = rendered(&comparison());
        assert!(page.contains("Lines: where they err") && page.contains("<td>Misses nothing.</td>"));
    }

    #[test]
    fn coherence_is_shown_where_it_was_measured() {
        let mut comparison = comparison();
        assert!(!rendered(&comparison).contains("Coherence"));
        comparison.cells[0] = with_coherence(comparison.cells[0].clone(), 0.25);
        let page = rendered(&comparison);
        assert!(page.contains("<h3>Coherence</h3>") && page.contains("<td>25.00</td>"));
        assert!(page.contains("cannot follow a mesh that moves"));
    }

    #[test]
    fn the_page_states_what_the_clock_covers() {
        let page = rendered(&comparison());
        assert!(page.contains("A frame is one submission") && page.contains("nothing is read back inside the clock"));
        assert!(page.contains("6 of them are scored"));
    }

    #[test]
    fn counts_are_grouped() {
        assert_eq!([7, 123, 1234, 1_234_567].map(grouped), ["7", "123", "1\u{202f}234", "1\u{202f}234\u{202f}567"]);
    }
}

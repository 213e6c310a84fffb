//! The page: templates, style and scripts embedded, everything that a user named escaped.

use super::answer;
use super::chart::{self, COLORS, DARK_COLORS, look};
use super::coherence_table;
use super::evidence;
use super::extraction_chart;
use super::pictures::PictureFiles;
use super::summary::{MeshSummary, summarise};
use super::tables::{cost_row, quality_row};
use super::text::{grouped, shown_unit};
use super::where_it_errs;
use crate::coherence::metrics::COHERENCE;
use crate::machine::RunDescription;
use crate::metrics::PictureKind;
use crate::metrics::table::MetricSpec;
use crate::runner::Comparison;
use crate::scaling::{ExtractionRow, Series, series};
use minijinja::{Environment, Value, context};

/// The templates; the ending of their names makes the engine escape values for HTML.
const TEMPLATES: [(&str, &str); 5] = [
    ("index.html", include_str!("page/index.html")),
    ("macros.html", include_str!("page/macros.html")),
    ("answer.html", include_str!("page/answer.html")),
    ("tables.html", include_str!("page/tables.html")),
    ("evidence.html", include_str!("page/evidence.html")),
];

/// The page of a comparison. It asks nothing of the network: its own policy forbids it.
pub(super) fn render(
    comparison: &Comparison,
    files: &PictureFiles<'_>,
    extractions: &[ExtractionRow],
) -> Result<String, minijinja::Error> {
    let mut environment = Environment::new();
    for (name, text) in TEMPLATES {
        environment.add_template(name, text)?;
    }
    let summaries = summarise(&comparison.cells);
    let machine = |summary: &MeshSummary<'_>| (comparison.runs.len() > 1).then_some(summary.run + 1);
    let answers = summaries.iter().enumerate().flat_map(|(mesh, summary)| {
        let id = move |kind: PictureKind| format!("answer-{mesh}-{}", kind.name());
        PictureKind::ALL
            .into_iter()
            .filter_map(move |kind| answer::answer(&id(kind), kind, mesh, summary, machine(summary)))
    });
    let meshes: Vec<Value> = summaries
        .iter()
        .enumerate()
        .map(|(index, summary)| mesh_section(comparison, files, index, summary, machine(summary)))
        .collect();
    let is_there = |kind: &PictureKind| comparison.cells.iter().any(|cell| cell.picture == *kind);
    let kinds = PictureKind::ALL.into_iter().filter(is_there);
    let scene = &comparison.scene;
    environment.get_template("index.html")?.render(context! {
        style => Value::from_safe_string(style()),
        chart_script => Value::from_safe_string(chart::script()),
        script => Value::from_safe_string(include_str!("page/script.js").to_owned()),
        scene => &scene.name,
        size => scene.picture.size(),
        samples => scene.picture.samples,
        step => scene.path.step_deg.to_string(),
        scored => scene.path.scored,
        frames => scene.path.frames,
        warm_up => scene.path.warm_up,
        passes => scene.path.passes,
        runs => comparison.runs.iter().map(RunDescription::facts).collect::<Vec<_>>(),
        is_debug => comparison.runs.iter().any(|run| run.build == "debug"),
        is_software => comparison.runs.iter().any(|run| run.adapter.software),
        methods => methods(comparison),
        answers => answers.collect::<Vec<_>>(),
        meshes => meshes,
        left_out => comparison.left_out.iter().map(ToString::to_string).collect::<Vec<_>>(),
        extraction => extraction_section(extractions),
        metrics => kinds.flat_map(PictureKind::metrics).map(metric_row).collect::<Vec<_>>(),
        coherence_columns => COHERENCE.map(|spec| context! { title => spec.title, unit => shown_unit(spec.unit), summary => spec.summary }),
    })
}

/// The style sheet, with the colours of series in light and dark mode.
fn style() -> String {
    let variables = |colors: [&str; 8]| {
        let each = colors.iter().enumerate().map(|(series, color)| format!("--series-{series}: {color};"));
        each.collect::<Vec<_>>().join(" ")
    };
    let [light, dark] = [COLORS, DARK_COLORS].map(variables);
    let colors =
        format!(":root {{ {light} }}\n@media screen and (prefers-color-scheme: dark) {{ :root {{ {dark} }} }}\n");
    let dots = (0..COLORS.len()).map(|series| format!(".c{series} {{ background: var(--series-{series}); }}\n"));
    colors + &dots.collect::<String>() + include_str!("page/style.css")
}

fn mesh_section(
    comparison: &Comparison,
    files: &PictureFiles<'_>,
    index: usize,
    summary: &MeshSummary<'_>,
    machine: Option<usize>,
) -> Value {
    let section = |kind: PictureKind| {
        let cells = summary.of_kind(kind);
        let groups = files.groups(&cells);
        let id = |group: usize| format!("mesh-{index}-{}-{group}", kind.name());
        let groups = groups.iter().enumerate();
        (!cells.is_empty()).then(|| {
            context! {
                title => answer::title(kind),
                is_lines => kind == PictureKind::Lines,
                metrics => kind.metrics().map(metric_row).collect::<Vec<_>>(),
                rows => cells.iter().map(|cell| quality_row(kind, &cells, cell)).collect::<Vec<_>>(),
                errors => cells.iter().filter_map(|cell| where_it_errs::row(cell)).collect::<Vec<_>>(),
                groups => groups.map(|(at, group)| evidence::section(&id(at), comparison, files, group)).collect::<Vec<_>>(),
            }
        })
    };
    context! {
        name => &summary.mesh.name,
        machine => machine,
        vertices => grouped(summary.mesh.vertices),
        edges => grouped(summary.mesh.edges),
        faces => grouped(summary.mesh.faces),
        inward => (summary.mesh.inward_faces > 0).then(|| grouped(summary.mesh.inward_faces)),
        visible_length => format!("{:.0}", summary.visible_length_px),
        row => summary.cells.first().map(|cell| cell.row),
        kinds => PictureKind::ALL.into_iter().filter_map(section).collect::<Vec<_>>(),
        coherence => coherence_table::rows(summary),
        costs => summary.cells.iter().map(cost_row).collect::<Vec<_>>(),
    }
}

/// Times of extraction over faces; nothing where no method extracts edges and there are no peers.
fn extraction_section(rows: &[ExtractionRow]) -> Option<Value> {
    let all = series(rows);
    let chart = chart::in_page(&extraction_chart::chart(&all));
    let table = all.iter().enumerate().map(|(index, series)| series_row(rows, index, series));
    (!all.is_empty()).then(|| {
        context! { chart => Value::from_safe_string(chart), rows => table.collect::<Vec<_>>() }
    })
}

fn series_row(all: &[ExtractionRow], index: usize, series: &Series<'_>) -> Value {
    let growth = series.growth();
    let range = |value: fn(&ExtractionRow) -> f64, text: fn(f64) -> String| {
        let values = || series.rows.iter().map(|row| value(row));
        let [low, high] = [values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max)].map(text);
        if low == high { low } else { format!("{low} to {high}") }
    };
    let places = series.rows.iter().filter_map(|row| all.iter().position(|other| std::ptr::eq(other, *row)));
    let places: Vec<String> = places.map(|place| (place + 1).to_string()).collect();
    let [color, shape] = look(index);
    context! {
        label => &series.label,
        color => color,
        shape => shape,
        places => places.join(", "),
        meshes => series.rows.len(),
        faces => range(|row| row.faces as f64, |faces| grouped(faces as usize)),
        median => range(|row| row.median_ms, |time| format!("{time:.4}")),
        speed => range(|row| row.edges_per_second / 1e6, |speed| format!("{speed:.1}")),
        exponent => growth.as_ref().map(|growth| format!("{:.2}", growth.law.exponent)),
        r2 => growth.as_ref().map(|growth| format!("{:.3}", growth.law.r2)),
        fitted => growth.map(|growth| growth.shape.unwrap_or_else(|| "all meshes".to_owned())),
        machine => series.rows.first().map(|row| &row.machine),
    }
}

fn methods(comparison: &Comparison) -> Vec<Value> {
    let row = |entry: &crate::registry::Entry| {
        let info = entry.info();
        context! {
            name => info.name,
            summary => info.summary,
            source => evidence::citation(entry),
            needs => if info.needs.is_empty() { "positions and triangles".to_owned() } else { info.needs.join(", ") },
            options => info.options.iter().map(|option| option.name).collect::<Vec<_>>().join(", "),
        }
    };
    comparison.methods.iter().map(row).collect()
}

fn metric_row(metric: &MetricSpec) -> Value {
    let MetricSpec { name, title, unit, best, worst, summary, .. } = *metric;
    context! { name => name, title => title, unit => unit, shown_unit => shown_unit(unit), best => best, worst => worst, summary => summary }
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
        render(comparison, &PictureFiles::of(&comparison.pictures), &extractions).unwrap()
    }

    #[test]
    fn extraction_times_stand_beside_those_of_peers() {
        let page = rendered(&comparison());
        assert!(page.contains("data-chart=\"extraction-chart\"") && page.contains("&lt;b&gt;peer: m<span"));
        assert!(page.contains("<td>1.00</td><td>1.000</td><td>all meshes</td>"), "the peer's growth is stated");
        let alone = Comparison { peers: Vec::new(), cells: Vec::new(), ..comparison() };
        assert!(!rendered(&alone).contains("extraction-chart"));
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
            "id=\"answer-0-lines\"",
            "id=\"mesh-0-fill-0\"",
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
            // In the answer, the table of quality, the three of errors, and that of cost.
            let row = format!("tracking<span class=\"options\">{options}</span>");
            assert_eq!(page.matches(&row).count(), 6, "{options}");
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
}

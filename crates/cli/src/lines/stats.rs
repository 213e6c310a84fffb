//! What `lines --stats` says.

use silhouette_visibility::Lines;
use silhouette_visibility::plot::Drawing;
use std::io::{self, Write};
use std::time::Duration;

/// What there is to tell.
pub struct Report<'a> {
    /// Reading the meshes.
    pub load: Duration,
    /// Preparing them for any view.
    pub prepare: Duration,
    /// What was found, view by view.
    pub lines: &'a [Lines],
    /// What was drawn, where something was.
    pub drawing: Option<&'a Drawing>,
    /// Size of the file.
    pub bytes: usize,
}

/// Prints to standard error.
pub fn print(report: &Report<'_>) {
    // Where stderr is closed there is nobody to tell.
    let _ = io::stderr().write_all(text(report).as_bytes());
}

fn text(report: &Report<'_>) -> String {
    let found = report.lines.iter().map(|lines| lines.stats).reduce(|all, stats| all + stats).unwrap_or_default();
    let chains = |count: fn(&Lines) -> usize| report.lines.iter().map(count).sum::<usize>();
    let times = |stages: &[(&str, Duration)]| {
        let stage = |(name, time): &(&str, Duration)| format!("{name} {:.2} ms", time.as_secs_f64() * 1e3);
        stages.iter().map(stage).collect::<Vec<_>>().join(", ")
    };
    let mut rows = vec![
        ("once a mesh", times(&[("load", report.load), ("prepare", report.prepare)])),
        (
            "once a view",
            times(&[
                ("extract", found.extract),
                ("project", found.project),
                ("decide", found.decide),
                ("chain", found.chain),
                ("outline", found.outline),
            ]),
        ),
        (
            "found",
            format!(
                "{} edges, {} contours, {} pairs, {} events, {} sight lines, {} pieces, {} chains of {} points",
                found.edges,
                found.contours,
                found.pairs,
                found.events,
                found.sight_lines,
                found.pieces,
                chains(|lines| lines.chains.len()),
                chains(|lines| lines.chains.point_count())
            ),
        ),
    ];
    if let Some(drawing) = report.drawing {
        let (stats, unit) = (&drawing.stats, drawing.placement.unit.suffix());
        rows.push(("plot", times(&[("place to dash", stats.prepare), ("order", stats.order)])));
        rows.push((
            "drawn",
            format!(
                "{} paths of {} points (of {}), {:.1}{unit}; {} gaps of {:.1}{unit} bridged; {} repeats, {} paths of {:.1}{unit} in \
                 the ink of longer ones and {} short paths of {:.2}{unit} left out",
                stats.paths,
                stats.points,
                stats.points_placed,
                stats.drawn,
                stats.bridged.gaps,
                stats.bridged.length,
                stats.repeats,
                stats.covered.paths,
                stats.covered.length,
                stats.dropped.paths,
                stats.dropped.length
            ),
        ));
        rows.push((
            "pen-up travel",
            format!(
                "{:.1}{unit} in the order of the lines, {:.1}{unit} in the file",
                stats.travel.before, stats.travel.after
            ),
        ));
    }
    rows.push(("file", format!("{} bytes", report.bytes)));
    rows.iter().map(|(name, value)| format!("{name:<14}{value}\n")).collect()
}

//! The evidence for each method: what it drew in its worst view, where it errs, what its frames consist of, what it built, and
//! its limits, and what its publication prints. Methods that drew the same pictures share them.

use super::pictures::PictureFiles;
use super::published;
use super::sphere_map;
use super::summary::CellSummary;
use super::tables::{edges_found, who};
use super::text::{grouped, interval, metric_text, milliseconds, optional, said, shown_unit};
use super::where_it_errs;
use crate::cost::{FrameCost, Spread};
use crate::record::{CameraRecord, Cell, View};
use crate::registry::Entry;
use crate::runner::Comparison;
use minijinja::{Value, context};

/// A group of cells of one mesh that drew the same pictures, as a section whose id is `id`.
pub(super) fn section(
    id: &str,
    comparison: &Comparison,
    files: &PictureFiles<'_>,
    group: &[&CellSummary<'_>],
) -> Value {
    let first = group[0];
    let leading = first.cell.picture.leading_metric();
    let leading_text = |value: Option<f64>| optional(value, |value| metric_text(leading, value));
    let reach = sphere_map::reach_deg(first.cell);
    context! {
        id => id,
        who => group.iter().map(|cell| who(cell)).collect::<Vec<_>>(),
        leading => leading.title,
        unit => shown_unit(leading.unit),
        mean => leading_text((leading.value)(&first.metrics)),
        times => group.iter().map(|cell| milliseconds(cell.cell.frame.frame_ms.median)).collect::<Vec<_>>(),
        worst => worst(first, files),
        map => sphere_map::map(first.cell, leading).map(Value::from_safe_string),
        reach => format!("{reach:.0}"),
        views => first.cell.views.iter().enumerate().map(|(at, view)| view_row(first, at, view)).collect::<Vec<_>>(),
        members => group.iter().map(|cell| member(comparison, cell)).collect::<Vec<_>>(),
    }
}

/// The worst view, with its pictures and all its figures beside the averages.
fn worst(summary: &CellSummary<'_>, files: &PictureFiles<'_>) -> Option<Value> {
    let (set, [drawn, truth, difference]) = files.of_row(summary.row)?;
    let place = summary.cell.views.iter().position(|view| view.frame == set.frame)?;
    let view = &summary.cell.views[place];
    let figures = summary.cell.picture.metrics().map(|metric| {
        let text = |metrics| optional((metric.value)(metrics), |value| metric_text(metric, value));
        context! {
            title => metric.title, unit => shown_unit(metric.unit),
            here => text(&view.metrics), mean => text(&summary.metrics),
        }
    });
    Some(context! {
        frame => set.frame,
        place => place,
        width => set.drawn.width,
        height => set.drawn.height,
        drawn => Value::from_safe_string(drawn.to_owned()),
        truth => Value::from_safe_string(truth.to_owned()),
        difference => Value::from_safe_string(difference.to_owned()),
        figures => figures.collect::<Vec<_>>(),
        camera => camera_words(&view.camera),
    })
}

/// A camera as `silhouettes render` takes it.
fn camera_words(camera: &CameraRecord) -> String {
    let vector = |[x, y, z]: [f32; 3]| format!("{x},{y},{z}");
    let CameraRecord { size: [width, height], eye, target, up, fov_y_deg, ortho_height } = camera;
    let projection = match (fov_y_deg, ortho_height) {
        (Some(fov), _) => format!(" --fov {fov}"),
        (None, Some(height)) => format!(" --ortho {height}"),
        (None, None) => String::new(),
    };
    let [eye, target, up] = [*eye, *target, *up].map(vector);
    format!("--eye {eye} --target {target} --up {up}{projection} --size {width}x{height}")
}

fn view_row(summary: &CellSummary<'_>, at: usize, view: &View) -> Value {
    let leading = summary.cell.picture.leading_metric();
    let direction = sphere_map::direction(&view.camera).to_array().map(|part| format!("{part:.2}"));
    context! {
        place => at,
        frame => view.frame,
        direction => direction.join(", "),
        error => optional((leading.value)(&view.metrics), |value| metric_text(leading, value)),
        time => milliseconds(view.frame_ms),
        extract => optional(view.extract_ms, milliseconds),
        length => grouped(view.truth.visible_length_px.round() as usize),
    }
}

/// What a cell has of its own, whoever else drew the same.
fn member(comparison: &Comparison, summary: &CellSummary<'_>) -> Value {
    let Cell { method, options, prepare, artefacts, frame, .. } = summary.cell;
    let entry = comparison.methods.iter().find(|entry| entry.info().name == method);
    let built: u64 = artefacts.iter().map(|artefact| artefact.bytes).sum();
    let own = prepare.bytes.saturating_sub(built);
    let parts =
        artefacts.iter().map(|artefact| (artefact.name.as_str(), artefact.bytes)).chain([("the method itself", own)]);
    let artefacts = parts.map(|(name, bytes)| context! { name => name, bytes => grouped(bytes as usize) });
    context! {
        who => who(summary),
        summary => entry.map(|entry| entry.info().summary),
        source => entry.map(citation),
        choose => entry.and_then(|entry| said("Choose it when", entry.info().guide.choose_when)),
        options => options.to_string(),
        prepare => milliseconds(prepare.prepare_ms),
        renderer => milliseconds(prepare.renderer_ms),
        times => times(frame),
        frames => frame.frames,
        parts => parts_of_a_frame(frame),
        artefacts => artefacts.collect::<Vec<_>>(),
        bytes => grouped(prepare.bytes as usize),
        limits => limits(comparison, summary, entry),
        published => entry.map(|entry| published::tables(entry.info().published, &comparison.cells, summary)),
    }
}

/// Where a method was published.
pub(super) fn citation(entry: &Entry) -> String {
    let source = &entry.info().source;
    format!("{}. {}. {}, {}.", source.authors, source.title, source.venue, source.year)
}

/// Median, 95th percentile and largest value of what was timed.
fn times(frame: &FrameCost) -> Vec<Value> {
    let row = |what: &str, spread: Option<Spread>| {
        let text = |value: fn(Spread) -> f64| optional(spread.map(value), milliseconds);
        let interval = interval(spread.map(|spread| spread.interval), milliseconds);
        context! { what => what, median => text(|s| s.median), interval => interval, p95 => text(|s| s.p95), max => text(|s| s.max) }
    };
    vec![
        row("whole frame", Some(frame.frame_ms)),
        row("extraction", frame.extract_ms),
        row("render passes, device clock", frame.gpu_ms),
    ]
}

/// Shares of the median frame in per cent: extraction, render passes and the rest. Medians of parts do not add up to the median of
/// the whole, so that what is too much is taken off the rest.
fn parts_of_a_frame(frame: &FrameCost) -> Vec<Value> {
    let whole = frame.frame_ms.median;
    let share = |spread: Option<Spread>| spread.map_or(0.0, |spread| spread.median / whole);
    let [extract, gpu] = [share(frame.extract_ms), share(frame.gpu_ms)];
    let scale = 1.0 / (extract + gpu).max(1.0);
    let parts = [("extraction", extract * scale), ("render passes", gpu * scale)];
    let rest = 1.0 - parts.iter().map(|(_, share)| share).sum::<f64>();
    let parts = parts.into_iter().chain([("the rest: upload, encoding, submission, waiting", rest)]).enumerate();
    let shown = parts.filter(|(_, (_, share))| share.is_finite() && *share > 0.0);
    shown
        .map(
            |(kind, (name, share))| context! { kind => kind, name => name, percent => format!("{:.1}", 100.0 * share) },
        )
        .collect()
}

/// What a method promises, what it was measured to miss on this mesh, and what it cannot do.
fn limits(comparison: &Comparison, summary: &CellSummary<'_>, entry: Option<&Entry>) -> Vec<String> {
    let cell = summary.cell;
    let mut limits = Vec::new();
    if let Some(entry) = entry {
        let info = entry.info();
        if entry.capabilities().edges {
            limits.push(if info.exact {
                "Promises all silhouette edges and no others.".to_owned()
            } else {
                "Does not promise all silhouette edges: what it misses is measured.".to_owned()
            });
        }
        limits.extend(said("Where it fails:", info.guide.limits));
        if !info.needs.is_empty() {
            limits.push(format!("Needs more than positions and triangles: {}.", info.needs.join(", ")));
        }
    }
    if let (found, true) = edges_found(cell) {
        limits.push(format!("Edges found on this mesh: {found}."));
    }
    if let Some(errors) = cell.mean_errors() {
        limits.push(format!("Measured on this mesh: {}", where_it_errs::sentence(&errors)));
    }
    if cell.mesh.inward_faces > 0 {
        let faces = grouped(cell.mesh.inward_faces);
        limits.push(format!("This mesh has {faces} faces that are wound inwards; a method that depends on winding draws hidden lines there."));
    }
    if cell.coherence.iter().any(|record| record.metrics.is_none()) {
        limits.push("Cannot follow a mesh that moves.".to_owned());
    }
    let elsewhere = comparison.left_out.iter().filter(|left_out| left_out.method == cell.method);
    limits.extend(elsewhere.map(|left_out| format!("Refuses {}: {}", left_out.mesh, left_out.reason)));
    limits
}

#[cfg(test)]
mod tests {
    use super::super::summary::summarise;
    use super::super::tests::comparison;
    use super::*;
    use crate::record::tests::with_coherence;

    fn shares(frame: &FrameCost) -> Vec<(String, String)> {
        let text = |part: &Value, name: &str| part.get_attr(name).unwrap().to_string();
        parts_of_a_frame(frame).iter().map(|part| (text(part, "name"), text(part, "percent"))).collect()
    }

    #[test]
    fn a_frame_is_split_into_parts_that_fill_it() {
        let mut frame = comparison().cells[0].frame;
        let part = |name: &str, percent: &str| (name.to_owned(), percent.to_owned());
        let rest = "the rest: upload, encoding, submission, waiting";
        assert_eq!(shares(&frame), [part("extraction", "25.0"), part(rest, "75.0")]);
        frame.gpu_ms = frame.extract_ms.map(|spread| Spread { median: 4.0, ..spread });
        assert_eq!(shares(&frame), [part("extraction", "20.0"), part("render passes", "80.0")], "more than the whole");
        frame.frame_ms.median = 0.0;
        assert!(shares(&frame).iter().all(|(_, percent)| percent != "NaN"));
    }

    #[test]
    fn limits_come_from_promise_and_measurement() {
        let mut comparison = comparison();
        comparison.cells[0] = with_coherence(comparison.cells[0].clone(), 0.5);
        comparison.cells[0].mesh.inward_faces = 12;
        comparison.cells[0].views[0].edges.as_mut().unwrap().recall = 0.5;
        let reason = "3 edges join".to_owned();
        comparison.left_out = vec![crate::LeftOut { mesh: "n".to_owned(), method: "brute-force".to_owned(), reason }];
        let meshes = summarise(&comparison.cells);
        let said = limits(&comparison, &meshes[0].cells[0], comparison.methods.first()).join("\n");
        for words in [
            "Promises all silhouette edges",
            "Where it fails: ",
            "recall 50.00 %",
            "Misses nothing.",
            "12 faces",
            "Cannot follow a mesh that moves.",
            "Refuses n: 3 edges join",
        ] {
            assert!(said.contains(words), "{words}: {said}");
        }
    }

    #[test]
    fn the_worst_view_can_be_set_up_again() {
        let view = &comparison().cells[0].views[0];
        let words = "--eye 0,0,3 --target 0,0,0 --up 0,1,0 --fov 45 --size 8x8";
        assert_eq!(camera_words(&view.camera), words);
        let parallel = CameraRecord { fov_y_deg: None, ortho_height: Some(2.5), ..view.camera.clone() };
        assert!(camera_words(&parallel).contains("--ortho 2.5 "));
    }
}

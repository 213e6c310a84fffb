//! The answer of the report: per mesh and kind of picture the front in one sentence, one figure and one table.

use super::chart;
use super::measure::Measure;
use super::summary::{CellSummary, MeshSummary};
use super::tables::who;
use super::text::{in_unit, interval, measured, megabytes, milliseconds};
use crate::interval;
use crate::metrics::PictureKind;
use minijinja::{Value, context};
use serde_json::json;

/// The answer for pictures of one kind of the mesh with this index, as an element whose ids begin with `id`; nothing where there
/// are none.
pub(super) fn answer(
    id: &str,
    kind: PictureKind,
    mesh: usize,
    summary: &MeshSummary<'_>,
    machine: Option<usize>,
) -> Option<Value> {
    let cells = summary.of_kind(kind);
    let (measures, first) = chart::measures(kind, &cells);
    let shown = measures.get(first)?;
    let mut figure = chart::chart(&cells, &measures, first);
    // What changes with the measure beside the figure.
    for (place, measure) in measures.iter().enumerate() {
        let text = |cell: &CellSummary<'_>| measure.value(cell).map(|value| measured(measure, value));
        let between = |cell: &CellSummary<'_>| {
            interval(measure.interval(cell), |end| in_unit(measure.unit, end)).unwrap_or_default()
        };
        let values = cells.iter().map(|cell| (cell.row.to_string(), json!([text(cell), between(cell)])));
        let on_front: Vec<usize> = measure.front(&cells).iter().map(|&index| cells[index].row).collect();
        figure["measures"][place]["sentence"] = sentence(kind, measure, &cells).into();
        figure["measures"][place]["front"] = json!(on_front);
        figure["measures"][place]["values"] = serde_json::Value::Object(values.collect());
    }
    let front = shown.front(&cells);
    // Those on the front come first, by time; the others wait until a measure puts them there.
    let others = (0..cells.len()).filter(|index| !front.contains(index));
    let rows = front.iter().copied().chain(others);
    let rows = rows.map(|index| row(cells[index], shown, front.contains(&index)));
    Some(context! {
        id => id,
        mesh => mesh,
        name => &summary.mesh.name,
        machine => machine,
        kind => title(kind),
        chart => Value::from_safe_string(chart::in_page(&figure)),
        measures => measures.iter().map(|measure| measure.title).collect::<Vec<_>>(),
        first => first,
        sentence => sentence(kind, shown, &cells),
        rows => rows.collect::<Vec<_>>(),
    })
}

/// What pictures of a kind are called.
pub(super) fn title(kind: PictureKind) -> &'static str {
    match kind {
        PictureKind::Lines => "Lines",
        PictureKind::Fill => "Filled pictures",
    }
}

fn row(cell: &CellSummary<'_>, measure: &Measure, is_on_front: bool) -> Value {
    context! {
        who => who(cell),
        on_front => is_on_front,
        time => milliseconds(cell.cell.frame.frame_ms.median),
        time_interval => interval(Some(cell.cell.frame.frame_ms.interval), milliseconds),
        p95 => milliseconds(cell.cell.frame.frame_ms.p95),
        error => measure.value(cell).map(|value| measured(measure, value)),
        error_interval => interval(measure.interval(cell), |end| in_unit(measure.unit, end)),
        prepare => milliseconds(cell.cell.prepare.prepare_ms),
        bytes => megabytes(cell.cell.prepare.bytes),
    }
}

/// What the front says, in a sentence or two.
fn sentence(kind: PictureKind, measure: &Measure, cells: &[&CellSummary<'_>]) -> String {
    let verb = match kind {
        PictureKind::Lines => "draw lines",
        PictureKind::Fill => "fill pictures",
    };
    let title = measure.title;
    let mut methods: Vec<&str> = Vec::new();
    let mut count = 0;
    for cell in cells.iter().filter(|cell| measure.value(cell).is_some()) {
        count += 1;
        let method = cell.cell.method.as_str();
        if !methods.contains(&method) {
            methods.push(method);
        }
    }
    let noun = if methods.len() == count { "methods" } else { "methods and settings" };
    let front = measure.front(cells);
    let (Some(&first), Some(&last)) = (front.first(), front.last()) else {
        return format!("No method has a value of {title}.");
    };
    let time = |index: usize| cells[index].cell.frame.frame_ms.median;
    let figures = |index: usize| {
        let value = measure.value(cells[index]).map(|value| measured(measure, value)).unwrap_or_default();
        format!("{} ms per frame, {value}", milliseconds(time(index)))
    };
    let name = |index: usize| format!("{} (row {})", cells[index].label, cells[index].row);
    if count == 1 {
        return format!("{} is the only one to {verb}: {}.", name(first), figures(first));
    }
    // A median that is shorter by chance is no win.
    let ties: Vec<String> = equals(cells, measure, last).into_iter().map(name).collect();
    let ties = match ties.as_slice() {
        [] => String::new(),
        ties => format!(" As accurate, and as fast within the intervals of their times: {}.", ties.join(", ")),
    };
    if first == last {
        return format!(
            "{} is both the fastest of {count} {noun} that {verb} and the most accurate by {title}: {}.{ties}",
            name(first),
            figures(first)
        );
    }
    let ratio = time(last) / time(first);
    format!(
        "{} of {count} {noun} that {verb} are on the front: no other is both faster and closer to the truth by {title}. The fastest is \
         {}: {}. The most accurate is {}: {}, {ratio:.1} times as long.{ties}",
        front.len(),
        name(first),
        figures(first),
        name(last),
        figures(last),
    )
}

/// The other cells with the same value as one, whose time is the same within the intervals of both.
fn equals(cells: &[&CellSummary<'_>], measure: &Measure, of: usize) -> Vec<usize> {
    let interval = |index: usize| cells[index].cell.frame.frame_ms.interval;
    let value = |index: usize| measure.value(cells[index]).map(f64::to_bits);
    let is_equal =
        |&other: &usize| other != of && value(other) == value(of) && interval::overlap(interval(other), interval(of));
    (0..cells.len()).filter(is_equal).collect()
}

#[cfg(test)]
mod tests {
    use super::super::summary::summarise;
    use super::*;
    use crate::record::Cell;
    use crate::record::tests::{cell, fill_cell};

    fn said(cells: &[Cell], kind: PictureKind) -> String {
        let meshes = summarise(cells);
        let cells = meshes[0].of_kind(kind);
        let (measures, first) = chart::measures(kind, &cells);
        sentence(kind, &measures[first], &cells)
    }

    #[test]
    fn the_sentence_names_the_ends_of_the_front_with_their_rows() {
        let cells = [cell("a", "x", 4.0, 1.0), cell("a", "y", 1.0, 3.0), cell("a", "z", 5.0, 2.0)];
        assert_eq!(
            said(&cells, PictureKind::Lines),
            "2 of 3 methods that draw lines are on the front: no other is both faster and closer to the truth by Chamfer distance. \
             The fastest is y (row 2): 1.00 ms per frame, 3.00 px. The most accurate is x (row 1): 4.00 ms per frame, 1.00 px, \
             4.0 times as long."
        );
    }

    #[test]
    fn a_method_that_beats_all_and_one_alone_are_said_to() {
        let cells = [cell("a", "x", 4.0, 1.0), cell("a", "y", 1.0, 0.5), fill_cell("a", "f", 2.0, 0.0)];
        let lines = said(&cells, PictureKind::Lines);
        assert!(
            lines.starts_with("y (row 2) is both the fastest of 2 methods that draw lines and the most accurate"),
            "{lines}"
        );
        let fills = said(&cells, PictureKind::Fill);
        assert_eq!(fills, "f (row 3) is the only one to fill pictures: 2.00 ms per frame, 0.00 px.");
    }

    #[test]
    fn a_median_that_is_shorter_by_chance_is_no_win() {
        let cells =
            [cell("a", "x", 4.0, 1.0), cell("a", "y", 4.1, 1.0), cell("a", "z", 90.0, 1.0), cell("a", "w", 4.0, 2.0)];
        let lines = said(&cells, PictureKind::Lines);
        let ties = " As accurate, and as fast within the intervals of their times: y (row 2).";
        assert!(lines.starts_with("x (row 1) is both the fastest") && lines.ends_with(ties), "{lines}");
    }

    #[test]
    fn the_table_begins_with_the_front_by_time_and_holds_every_cell() {
        let cells = [cell("a", "x", 4.0, 1.0), cell("a", "z", 5.0, 2.0), cell("a", "y", 1.0, 3.0)];
        let meshes = summarise(&cells);
        let value = answer("answer-0", PictureKind::Lines, 0, &meshes[0], None).unwrap();
        let rows: Vec<Value> = value.get_attr("rows").unwrap().try_iter().unwrap().collect();
        let row = |index: usize| {
            let number = rows[index].get_attr("who").unwrap().get_attr("row").unwrap().to_string();
            (number, rows[index].get_attr("on_front").unwrap().is_true())
        };
        assert_eq!([0, 1, 2].map(row), [("3".into(), true), ("1".into(), true), ("2".into(), false)]);
        let chart = value.get_attr("chart").unwrap().to_string();
        let chart: serde_json::Value = serde_json::from_str(&chart).unwrap();
        let first = chart["first"].as_u64().unwrap() as usize;
        assert_eq!(chart["measures"][first]["front"], json!([3, 1]));
        assert_eq!(
            chart["measures"][first]["values"],
            json!({"1": ["1.00 px", ""], "2": ["2.00 px", ""], "3": ["3.00 px", ""]})
        );
    }
}

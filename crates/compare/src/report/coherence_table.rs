//! Coherence, for people: a row per cell and motion.

use super::summary::{CellSummary, MeshSummary};
use super::tables::who;
use crate::coherence::metrics::{COHERENCE, CoherenceSpec};
use crate::record::CoherenceRecord;
use minijinja::{Value, context};

/// The rows of a mesh, motion by motion, so that methods stand beside each other; none where nothing was measured.
pub(super) fn rows(summary: &MeshSummary<'_>) -> Vec<Value> {
    let mut rows: Vec<(&CellSummary<'_>, &CoherenceRecord)> = Vec::new();
    for cell in &summary.cells {
        rows.extend(cell.cell.coherence.iter().map(|record| (cell, record)));
    }
    rows.sort_by_key(|(_, record)| record.motion);
    rows.into_iter().map(|(cell, record)| row(cell, record)).collect()
}

fn row(summary: &CellSummary<'_>, record: &CoherenceRecord) -> Value {
    let values = record.metrics.map(|metrics| {
        let text = |spec: &CoherenceSpec| match (spec.value)(&metrics) {
            Some(value) if spec.unit == "share" => format!("{:.2}", value * 100.0),
            Some(value) => format!("{value:.2}"),
            None => "–".to_owned(),
        };
        COHERENCE.iter().map(text).collect::<Vec<_>>()
    });
    context! {
        who => who(summary),
        motion => record.motion.name(),
        values => values,
    }
}

//! Fig. 15: the lines of the texture against the exact visible lines of the fine mesh.

use super::baked::Baked;
use super::drawn::{SIDE_PX, camera};
use crate::directions::spread;
use crate::drawings::drawing;
use crate::error::Cause;
use crate::table::{Cell, Column, Range, Row, Table};
use silhouette_compare::drawing::{FrameStyle, Ground};
use silhouette_compare::metrics::{Ink, LineMetrics, TruePen, measure as score};
use silhouette_compare::registry::Entry;
use silhouette_compare::truth::{Truth, TruthFinder};
use silhouette_core::Progress;
use silhouette_gpu::Pen;
use silhouette_render::Gpu;
use silhouette_texture::TextureLines;

/// What is drawn: a label, options, and the width that is asked for in pixels.
const DRAWN: [(&str, &str, f64); 4] = [
    ("1 pixel wide", "width=1", 1.0),
    ("2 pixels wide", "width=2", 2.0),
    ("4 pixels wide", "width=4", 4.0),
    ("Eq. 5, as printed", "law=as-printed", 2.0),
];

/// Lines of several widths in `views` views.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn measure(gpu: &Gpu, baked: &Baked, views: u32, progress: &dyn Progress) -> Result<Table, Cause> {
    let mesh = &baked.of.subject.mesh;
    let mut finder = TruthFinder::new(mesh, progress)?;
    let truth = |direction| Ok(finder.find(&camera(mesh.mesh(), direction)?, progress)?);
    let truths: Vec<Truth> = spread(views).map(truth).collect::<Result<_, Cause>>()?;
    let entry: Entry = Entry::of::<TextureLines>().lines().into();
    let mut rows = Vec::new();
    for (label, words, pen_width_px) in DRAWN {
        let style = FrameStyle { size: [SIDE_PX; 2], pen_width_px, samples: 1, ground: Ground::Paper };
        let mut drawing = drawing(gpu, &baked.drawable(), &entry, words, style, progress)?;
        let mut scored = |truth: &Truth| -> Result<LineMetrics, Cause> {
            progress.check()?;
            drawing.draw(gpu, &truth.camera)?;
            let ink = Ink::from_picture(&drawing.picture(gpu)?);
            let pen @ Pen { width_px, .. } = drawing.pen();
            Ok(score(&ink, &truth.lines, TruePen { picture: &truth.draw(pen), width_px }))
        };
        let scores = truths.iter().map(&mut scored).collect::<Result<Vec<_>, _>>()?;
        rows.push(row(label, &scores));
    }
    let percent = |title, metric, meaning| Column::new(title, metric, "%", meaning);
    Ok(Table {
        name: "Fig. 15, lines",
        subject: baked.of.subject.label.clone(),
        about: format!("{views} views, against the exact visible lines of the fine mesh"),
        columns: vec![
            percent("missed", "missed at 2 px", "visible length without ink within 2 px"),
            percent("spurious", "spurious at 2 px", "ink farther than 2 px from the true pen"),
            Column::new("width", "mean width", "px", "mean width of the drawn lines where they are drawn"),
            Column::new("deviation", "deviation of width", "px", "standard deviation of that width"),
        ],
        rows,
        ..Table::default()
    })
}

fn row(label: &str, scores: &[LineMetrics]) -> Row {
    let values: [fn(&LineMetrics) -> f64; 4] = [
        |metrics| 100.0 * metrics.missed_2px,
        |metrics| 100.0 * metrics.spurious_2px,
        |metrics| metrics.width_mean_px,
        |metrics| metrics.width_deviation_px,
    ];
    let cells = values.map(|value| Cell::range(Range::of(scores.iter().map(value), "views spread evenly")));
    Row::new(label, cells.to_vec())
}

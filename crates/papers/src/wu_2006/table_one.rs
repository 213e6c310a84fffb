//! Table 1: sizes, frame times and sampling errors, with what a bake takes.

use super::baked::Baked;
use super::printed::{PaperRow, SIDE};
use crate::table::{Cell, Column, Comparable, Row, Table};
use silhouette_texture::sampling_error::SamplingError;

/// What was measured of one subject.
#[derive(Debug, Clone)]
pub struct Measurement {
    /// What was baked.
    pub baked: Baked,
    /// Median milliseconds of a frame of the fine mesh, and of the texture.
    pub frame_ms: [f64; 2],
    /// Eq. 3.
    pub error: SamplingError,
}

/// Frames of the texture per frame of the mesh; charts read it.
pub const SPEED_UP: &str = "speed-up";

/// Table 1.
pub fn table_one(adapter: &str, measurements: &[Measurement]) -> Table {
    let hardware = format!("the paper's card is a GeForce 7800 GT, ours {adapter}");
    let whole = |title, metric, unit, meaning| Column { digits: 0, ..Column::new(title, metric, unit, meaning) };
    Table {
        name: "Table 1",
        about: format!("{} azimuths per texel, 8 bits; 512 x 512 pixels", super::printed::AZIMUTHS),
        columns: vec![
            whole("vertices", "vertices", "", "vertices of the mesh"),
            whole("hull", "hull vertices", "", "vertices of the hull"),
            whole("texels", "texels", "", "texels along a side"),
            Column::new("offset", "offset", "%", "distance of hull and mesh over the bounding radius of the mesh"),
            Column::new("mesh", "mesh frame", "ms", "median time of a frame of the mesh"),
            Column::new("texture", "texture frame", "ms", "median time of a frame of the texture"),
            Column::new("speed-up", SPEED_UP, "×", "frames of the texture per frame of the mesh"),
            Column { digits: 3, ..Column::new("VF error", "sampling error", "%", "Eq. 3, averaged over the hull") },
            Column {
                digits: 3,
                ..Column::new("missing", "missing", "%", "of it, directions that should show the mesh")
            },
            Column::new("rays", "rays per sample", "", "rays cast per angle"),
            Column { digits: 1, ..Column::new("hull found", "hull time", "s", "time of finding the hull") },
            Column { digits: 1, ..Column::new("baked", "bake time", "s", "time of the bake on all cores") },
        ],
        rows: measurements.iter().map(|measurement| row(measurement, &hardware)).collect(),
        ..Table::default()
    }
}

fn row(Measurement { baked, frame_ms: [mesh_ms, texture_ms], error }: &Measurement, hardware: &str) -> Row {
    let subject = &baked.of.subject;
    let paper = |value: fn(&PaperRow) -> f64| subject.row.map(value);
    let model = || subject.difference().map_or(Comparable::Yes, Comparable::No);
    let timed = || Comparable::No(hardware.to_owned());
    let side = baked.texture.parts().size.width;
    let sampled = match model() {
        Comparable::Yes if side != SIDE => Comparable::No(format!("the paper's texture has {SIDE} x {SIDE} texels")),
        model => model,
    };
    let hull_vertices = baked.of.hull.mesh().positions().len();
    let cells = vec![
        Cell::one(subject.vertices() as f64).beside(paper(|row| f64::from(row.vertices)), model()),
        Cell::one(hull_vertices as f64).beside(paper(|row| f64::from(row.hull_vertices)), model()),
        Cell::one(f64::from(baked.texture.parts().size.width)).beside(paper(|_| f64::from(SIDE)), model()),
        Cell::one(baked.of.offset_percent()),
        Cell::one(*mesh_ms).beside(paper(|row| 1000.0 / row.mesh_fps), timed()),
        Cell::one(*texture_ms).beside(paper(|row| 1000.0 / row.texture_fps), timed()),
        Cell::one(mesh_ms / texture_ms).beside(paper(PaperRow::speed_up), timed()),
        Cell::one(100.0 * error.mean).beside(paper(|row| row.sampling_error_percent), sampled),
        Cell::one(100.0 * error.missing),
        Cell::one(baked.report.rays_per_sample()),
        Cell::one(baked.of.seconds),
        Cell::one(baked.seconds),
    ];
    Row::new(subject.label.clone(), cells)
}

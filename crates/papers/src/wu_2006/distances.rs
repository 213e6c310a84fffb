//! Fig. 11: frame time by projected size.

use super::baked::Baked;
use super::drawn::{Views, frame_style};
use super::timed::time;
use crate::drawings::drawing;
use crate::error::Cause;
use crate::table::{Cell, Column, Row, Table};
use silhouette_baselines::FineMesh;
use silhouette_compare::drawing::Ground;
use silhouette_compare::registry::Entry;
use silhouette_core::Progress;
use silhouette_render::Gpu;
use silhouette_texture::Texture;

/// Distances, over that from which the bounding sphere fits the picture.
const DISTANCES: [f64; 6] = [0.6, 1.0, 2.0, 4.0, 8.0, 16.0];

/// Pixels that the mesh covers; the chart reads it.
pub const COVERED: &str = "covered";
/// Frame time of the mesh over that of the texture; the chart reads it.
pub const RATIO: &str = "mesh over texture";

/// Measures one subject at all distances.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn measure(gpu: &Gpu, baked: &Baked, rounds: u32, progress: &dyn Progress) -> Result<Table, Cause> {
    let fine = baked.of.subject.mesh.mesh();
    let [fine_entry, texture_entry]: [Entry; 2] =
        [Entry::of::<FineMesh>().fill().into(), Entry::of::<Texture>().fill().into()];
    let mesh = baked.drawable();
    let mut mesh_drawing = drawing(gpu, &mesh, &fine_entry, "", frame_style(1, Ground::Transparent), progress)?;
    let mut texture = drawing(gpu, &mesh, &texture_entry, "", frame_style(1, Ground::Transparent), progress)?;
    let mut rows = Vec::new();
    for distance in DISTANCES {
        let times = time(gpu, fine, [&mut mesh_drawing, &mut texture], distance, rounds, progress)?;
        let covered_px = Views::from_afar(gpu, fine, rounds, distance, progress)?.covered_px();
        let [mesh_ms, texture_ms] = times;
        let values = [covered_px, mesh_ms, texture_ms, mesh_ms / texture_ms];
        rows.push(Row::new(format!("{distance} ×"), values.map(Cell::one).to_vec()));
    }
    Ok(Table {
        name: "Fig. 11, frame time by projected size",
        subject: baked.of.subject.label.clone(),
        about: format!(
            "{} vertices; rows are distances, over that from which all of the mesh is seen",
            fine.positions().len()
        ),
        columns: vec![
            Column {
                digits: 0,
                ..Column::new("covered", COVERED, "px", "pixels that the mesh covers, averaged over views")
            },
            Column::new("mesh", "mesh frame", "ms", "median time of a frame of the mesh"),
            Column::new("texture", "texture frame", "ms", "median time of a frame of the texture"),
            Column::new("mesh / texture", RATIO, "×", "time of the mesh over that of the texture"),
        ],
        rows,
        ..Table::default()
    })
}

//! The coarsest level of detail whose outline is no worse than a texture's.

use super::drawn::{Views, frame_style};
use crate::error::Cause;
use silhouette_baselines::{FineMesh, LodMesh};
use silhouette_compare::drawing::{Drawing, Ground};
use silhouette_compare::metrics::PictureKind;
use silhouette_compare::registry::Entry;
use silhouette_core::method::OptionValues;
use silhouette_core::{PreparedMesh, Progress};
use silhouette_render::Gpu;
use std::sync::Arc;

/// One level, drawn whatever its error is.
pub struct Level {
    /// What draws it.
    pub drawing: Drawing,
    /// Its faces.
    pub faces: usize,
    /// Bytes of the chain that begins with it.
    pub bytes: usize,
}

/// The levels of a chain, the finest first, with `samples` per pixel.
///
/// # Errors
/// [`Cause`]: a device that failed.
pub fn levels(gpu: &Gpu, lod: &LodMesh, samples: u32, progress: &dyn Progress) -> Result<Vec<Level>, Cause> {
    let entry: Entry = Entry::of::<FineMesh>().fill().into();
    let options = OptionValues::defaults(entry.info().options);
    let level = |(index, level): (usize, &silhouette_baselines::LodLevel)| -> Result<Level, Cause> {
        let mesh = Arc::new(PreparedMesh::new(Arc::clone(&level.mesh)));
        let prepared = entry.prepare(&mesh, &options, progress)?;
        let drawing = Drawing::new(gpu, &mesh, prepared, PictureKind::Fill, frame_style(samples, Ground::Transparent))?;
        let bytes = lod.levels()[index..].iter().map(silhouette_baselines::LodLevel::bytes).sum();
        Ok(Level { drawing, faces: level.mesh.face_count(), bytes })
    };
    lod.levels().iter().enumerate().map(level).collect()
}

/// The index of the coarsest level whose wrong area is at most `xor`, or 0 where none's is. `known` holds wrong areas of the
/// same views, the coarsest level's first, and gains those that are measured.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn coarsest(
    gpu: &Gpu,
    levels: &mut [Level],
    views: &Views,
    xor: f64,
    known: &mut Vec<f64>,
    progress: &dyn Progress,
) -> Result<usize, Cause> {
    for (step, index) in (0..levels.len()).rev().enumerate() {
        if step == known.len() {
            known.push(views.score(gpu, &mut levels[index].drawing, progress)?.xor);
        }
        if known[step] <= xor {
            return Ok(index);
        }
    }
    Ok(0)
}

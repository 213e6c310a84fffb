//! A chain of levels of detail of as many bytes as a texture.

use crate::error::Cause;
use silhouette_baselines::LodMesh;
use silhouette_compare::registry::{Entry, Prepared};
use silhouette_core::method::{OptionValues, PrepareError};
use silhouette_core::{PreparedMesh, Progress};
use std::sync::Arc;

/// A chain that fits and takes this share of the bytes is not made larger.
const ENOUGH: f64 = 0.95;

/// Chains that are tried to come closer to the bytes once one fits. Each simplifies the mesh anew.
const TRIES: u32 = 4;

/// `lod-mesh` with the largest chain found that takes at most `bytes`; `None` where the mesh cannot be simplified so far. Of
/// the mesh, all levels together take `of_all`.
///
/// # Errors
/// [`Cause`]: cancelled.
pub fn of_bytes(
    mesh: &Arc<PreparedMesh>,
    of_all: usize,
    bytes: usize,
    progress: &dyn Progress,
) -> Result<Option<Prepared>, Cause> {
    let all = mesh.mesh().face_count();
    // Bytes are nearly proportional to faces.
    let scaled = |faces: usize, taken: usize| (faces as f64 * bytes as f64 / taken as f64) as usize;
    let mut faces = if of_all <= bytes { all } else { scaled(all, of_all).min(all) };
    let mut best: Option<Prepared> = None;
    for attempt in 0.. {
        let Some(chain) = limited(mesh, faces, progress)? else { break };
        let taken = chain.bytes();
        let is_done = faces == all || taken as f64 > ENOUGH * bytes as f64 || attempt >= TRIES;
        if taken <= bytes {
            best = best.filter(|best| best.bytes() >= taken).or(Some(chain));
            if is_done {
                break;
            }
            faces = scaled(faces, taken).min(all);
        } else if best.is_some() && attempt >= TRIES {
            break;
        } else {
            faces = scaled(faces, taken).min(faces - 1);
        }
    }
    Ok(best)
}

/// `lod-mesh` whose finest level has at most so many faces; `None` where there are no so few.
fn limited(mesh: &Arc<PreparedMesh>, faces: usize, progress: &dyn Progress) -> Result<Option<Prepared>, Cause> {
    if faces == 0 {
        return Ok(None);
    }
    let entry: Entry = Entry::of::<LodMesh>().fill().into();
    let options = OptionValues::parse(entry.info().options, [format!("faces={faces}").as_str()])?;
    match entry.prepare(mesh, &options, progress) {
        Err(PrepareError::Mesh(_)) => Ok(None),
        prepared => Ok(Some(prepared?)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::{NoProgress, shapes};

    #[test]
    fn chains_take_nearly_the_bytes_asked_for_and_never_more() {
        let mesh = Arc::new(PreparedMesh::new(shapes::by_name("blob:5000").unwrap()));
        let of_all = limited(&mesh, 5000, &NoProgress).unwrap().unwrap().bytes();
        for bytes in [4_000, 30_000, 100_000] {
            let taken = of_bytes(&mesh, of_all, bytes, &NoProgress).unwrap().unwrap().bytes();
            assert!(taken <= bytes && taken as f64 > 0.85 * bytes as f64, "{taken} of {bytes}");
        }
        let most = of_bytes(&mesh, of_all, 10 * of_all, &NoProgress).unwrap().unwrap();
        assert_eq!(most.bytes(), of_all, "no more than there is");
        assert!(of_bytes(&mesh, of_all, 20, &NoProgress).unwrap().is_none(), "less than any mesh takes");
    }
}

//! [`true_sequence`]: the truth of consecutive frames of a motion.

use crate::coherence::links::Links;
use crate::coherence::{Motion, Sequence, TrueFrame};
use crate::truth::{TruthError, TruthFinder};
use silhouette_core::mesh::Bounds;
use silhouette_core::{Camera, PreparedMesh, Progress, Topology, TriangleMesh};
use std::sync::Arc;

/// The truth of the frames of a motion about `bounds`, normally those of the mesh. Costs as much as the truth of as many views; where the mesh moves, it is prepared anew for each frame.
///
/// # Errors
/// [`TruthError`].
pub fn true_sequence(
    mesh: &Arc<PreparedMesh>,
    bounds: &Bounds,
    motion: Motion,
    cameras: &[Camera],
    progress: &dyn Progress,
) -> Result<Sequence, TruthError> {
    let rest = mesh.mesh();
    let topology: Arc<Topology> = mesh.artefact("coherence", progress)?;
    let mut finder = TruthFinder::new(mesh, progress)?;
    let mut sequence = Sequence::default();
    for (frame, camera) in (0..).zip(cameras) {
        progress.check()?;
        let moved = moved(rest, motion, bounds, frame);
        if let Some(moved) = &moved {
            finder = TruthFinder::new(&Arc::new(PreparedMesh::new(Arc::clone(moved))), progress)?;
        }
        let truth = finder.find(camera, progress)?;
        let outline = finder.outline(camera, progress)?;
        let positions = moved.as_ref().unwrap_or(rest).positions();
        let mut seen = TrueFrame::new(truth, outline.as_ref(), &topology, positions);
        seen.positions = moved.map(|moved| moved.positions().to_vec());
        sequence.frames.push(seen);
        progress.advance(1);
    }
    for pair in sequence.frames.windows(2) {
        sequence.links.push(Links::new([&pair[0], &pair[1]], &topology, rest.positions()));
    }
    Ok(sequence)
}

/// The mesh of a frame; `None` where it rests.
fn moved(rest: &TriangleMesh, motion: Motion, bounds: &Bounds, frame: u32) -> Option<Arc<TriangleMesh>> {
    let positions = motion.positions(rest.positions(), bounds, frame)?;
    let mesh = TriangleMesh::new(positions, rest.triangles().to_vec());
    Some(Arc::new(mesh.expect("a wave of finite height keeps positions finite")))
}

//! Steps 4 to 8 for all strokes of a view, in parallel.

use crate::cutter::{CutStats, CutterScratch, StrokeCutter};
use crate::finder::{LineError, MAX_WORK};
use crate::frame::ClippedEdge;
use crate::gaps::Gap;
use crate::pieces::{Piece, emit};
use crate::propagate::{CutStroke, Propagation};
use crate::vertex_faces::VertexFaces;
use rayon::prelude::*;
use silhouette_core::Progress;
use std::sync::atomic::{AtomicU64, Ordering};

/// Strokes that a task takes: some 0.1 ms of work.
const STROKES_PER_TASK: usize = 64;

/// The pieces of all strokes, in order, and what they cost.
pub struct Decided {
    /// The pieces.
    pub pieces: Vec<Piece>,
    /// Pairs tested and events found.
    pub stats: CutStats,
    /// Sight lines cast.
    pub sight_lines: u64,
}

/// Cuts all strokes, of which `clipped` are the parts inside the picture, and decides their pieces.
///
/// # Errors
/// [`LineError`].
pub fn decide(
    cutter: &StrokeCutter<'_>,
    vertex_faces: &VertexFaces,
    clipped: &[Option<ClippedEdge>],
    progress: &dyn Progress,
) -> Result<Decided, LineError> {
    let cuts = cut_all(cutter, clipped, progress)?;
    let propagation = Propagation { strokes: cutter.strokes, sight: cutter.sight, vertex_faces };
    let (layers, sight_lines) = propagation.decide(&cuts.strokes, &cuts.gaps, progress)?;
    let mut pieces = Vec::with_capacity(cuts.gaps.len());
    for CutStroke { stroke, gaps, range, .. } in &cuts.strokes {
        emit(*stroke, *range, &cuts.gaps[gaps.clone()], |gap| layers[gaps.start + gap], &mut pieces);
    }
    Ok(Decided { pieces, stats: cuts.stats, sight_lines })
}

/// All strokes inside the picture with their gaps, in order.
#[derive(Default)]
struct Cuts {
    strokes: Vec<CutStroke>,
    gaps: Vec<Gap>,
    stats: CutStats,
}

fn cut_all(
    cutter: &StrokeCutter<'_>,
    clipped: &[Option<ClippedEdge>],
    progress: &dyn Progress,
) -> Result<Cuts, LineError> {
    progress.stage("visible lines", clipped.len() as u64);
    let work = AtomicU64::new(0);
    let cut_chunk = |scratch: &mut CutterScratch, (chunk, edges): (usize, &[Option<ClippedEdge>])| {
        if work.load(Ordering::Relaxed) > MAX_WORK {
            return Err(LineError::TooCrowded);
        }
        progress.check()?;
        let mut cuts = Cuts::default();
        for (place, edge) in edges.iter().enumerate() {
            if let Some(edge) = edge {
                let stroke = (chunk * STROKES_PER_TASK + place) as u32;
                let first = cuts.gaps.len();
                let touched = cutter.cut(stroke, edge, scratch, &mut cuts.gaps);
                cuts.strokes.push(CutStroke { stroke, gaps: first..cuts.gaps.len(), range: edge.range, touched });
            }
        }
        cuts.stats = std::mem::take(&mut scratch.stats);
        work.fetch_add(cuts.stats.work, Ordering::Relaxed);
        progress.advance(edges.len() as u64);
        Ok(cuts)
    };
    let chunks: Result<Vec<Cuts>, LineError> =
        clipped.par_chunks(STROKES_PER_TASK).enumerate().map_init(CutterScratch::default, cut_chunk).collect();
    let mut all = Cuts::default();
    for cuts in chunks? {
        let first = all.gaps.len();
        all.gaps.extend(cuts.gaps);
        all.strokes.extend(cuts.strokes.into_iter().map(|mut stroke| {
            stroke.gaps = stroke.gaps.start + first..stroke.gaps.end + first;
            stroke
        }));
        all.stats.work += cuts.stats.work;
        all.stats.pairs += cuts.stats.pairs;
        all.stats.events += cuts.stats.events;
    }
    if all.stats.work > MAX_WORK { Err(LineError::TooCrowded) } else { Ok(all) }
}

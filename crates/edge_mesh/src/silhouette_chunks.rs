//! Step 3 where the vertex stage decides and facings are exact: chunks of records without a silhouette are left out on the processor.

use crate::chunks::CHUNK;
use crate::edge_record::EdgeRecord;
use crate::method::EdgeMesh;
use rayon::prelude::*;
use silhouette_core::FaceFacings;
use std::ops::Range;
use std::sync::Arc;

/// Which chunks of the records hold a silhouette.
#[derive(Debug)]
pub(crate) struct SilhouetteChunks {
    records: Arc<[EdgeRecord]>,
    draws_back_boundaries: bool,
    held: Vec<bool>,
}

impl SilhouetteChunks {
    /// For the records of a method; none is found yet.
    pub fn new(method: &EdgeMesh) -> Self {
        let records = Arc::clone(method.records());
        let held = vec![false; records.len().div_ceil(CHUNK as usize)];
        Self { draws_back_boundaries: method.of_back_faces(false).boundaries, records, held }
    }

    /// Finds them. O(E) at most, parallel; a chunk is read up to its first silhouette.
    pub fn find(&mut self, facings: &FaceFacings) {
        let draws_back_boundaries = self.draws_back_boundaries;
        let is_silhouette =
            |record: &EdgeRecord| record.is_silhouette(|face| facings.is_front(face), draws_back_boundaries);
        let chunks = self.records.par_chunks(CHUNK as usize);
        self.held.par_iter_mut().zip(chunks).for_each(|(held, records)| *held = records.iter().any(is_silhouette));
    }

    /// The chunks that hold one, as runs.
    pub fn runs(&self) -> impl Iterator<Item = Range<u32>> + '_ {
        let mut at = 0;
        std::iter::from_fn(move || {
            let begin = at + self.held[at..].iter().position(|&held| held)?;
            let length = self.held[begin..].iter().take_while(|&&held| held).count();
            at = begin + length;
            // Chunks are fewer than edges, of which there are fewer than 2^31.
            Some(begin as u32..at as u32)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::{EdgeMeshOptions, PathChoice};
    use silhouette_core::{Method, PreparedMesh};
    use silhouette_testing::{builtin, directions, views};

    /// Every silhouette lies in a run, and on a mesh of many chunks most of them are in none.
    #[test]
    fn runs_hold_every_silhouette_and_little_else() {
        let mesh = builtin("blob:200000");
        let options = EdgeMeshOptions { path: PathChoice::VertexStage, ..EdgeMeshOptions::default() };
        let method = EdgeMesh::new(&Arc::new(PreparedMesh::new(mesh.clone())), options).unwrap();
        let mut chunks = SilhouetteChunks::new(&method);
        assert_eq!(chunks.runs().count(), 0);
        for direction in directions::octants() {
            let facings = FaceFacings::new(&mesh, &views::seen_from(3.0 * direction.as_vec3()));
            chunks.find(&facings);
            let runs: Vec<_> = chunks.runs().collect();
            assert!(runs.windows(2).all(|pair| pair[0].end < pair[1].start), "runs are apart: {runs:?}");
            for (at, record) in (0_u32..).zip(method.records().iter()) {
                let is_held = runs.iter().any(|run| run.contains(&(at / CHUNK)));
                assert!(is_held || !record.is_silhouette(|face| facings.is_front(face), false));
            }
            let held: u32 = runs.iter().map(|run| run.end - run.start).sum();
            assert!(2 * held < chunks.held.len() as u32, "{held} of {}", chunks.held.len());
        }
    }
}

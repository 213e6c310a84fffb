//! Section III-E, adaptive sampling of feature segments: the points of one view at which each feature edge is bent.
//!
//! They are the same for all faces at the edge, the silhouette points that any of them has there included, so that neighbours
//! meet without a gap. A feature segment that no visible vertex ends at is drawn as its edge.

use crate::eye::SmoothingView;
use crate::feature_segments::FeatureSegments;
use crate::sampling::{Sampling, segments};
use crate::shading_mesh::ShadingMesh;
use crate::silhouette_segments::SilhouetteSegments;
use silhouette_core::glam::DVec3;

/// Samples strictly inside feature segments, edge after edge.
#[derive(Debug, Clone, Default)]
pub struct FeatureSamples {
    /// Samples of the i-th feature edge: `first[i]..first[i + 1]`.
    first: Vec<u32>,
    samples: Vec<FeatureSample>,
}

/// A point of a feature segment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeatureSample {
    /// Parameter from the lower vertex (0) to the higher (1), both excluded.
    pub u: f64,
    /// Where it is.
    pub position: DVec3,
}

impl FeatureSamples {
    /// Samples all feature segments in a view with a tolerance in pixels. O(feature edges + samples).
    pub fn find(
        &mut self,
        mesh: &ShadingMesh,
        features: &FeatureSegments,
        silhouette: &SilhouetteSegments,
        is_visible: &[bool],
        view: &SmoothingView,
        tolerance_px: f64,
    ) {
        self.samples.clear();
        self.first.clear();
        self.first.push(0);
        for (edge, segment) in features.edges().iter().zip(features.segments()) {
            let begin = self.samples.len();
            let mut any_visible = false;
            for &half_edge in mesh.topology().half_edges(*edge) {
                let corners = mesh.triangles()[half_edge.face().index()];
                let ends = [half_edge.slot(), half_edge.next_in_face().slot()];
                let [from, to] = ends.map(|slot| is_visible[corners[slot as usize] as usize]);
                any_visible |= from || to;
                if from != to {
                    let point = silhouette.points()[silhouette.point_index(half_edge) as usize];
                    if point.u > 0.0 && point.u < 1.0 {
                        self.samples.push(FeatureSample { u: point.u, position: point.position });
                    }
                }
            }
            if any_visible {
                let curves = segment.curves().len() as f64;
                for (index, curve) in segment.curves().enumerate() {
                    let count = segments(curve, [DVec3::ZERO; 2], view, tolerance_px, Sampling::Guaranteed);
                    let from = u32::from(index == 0);
                    self.samples.extend((from..count).map(|i| {
                        let u = (index as f64 + f64::from(i) / f64::from(count)) / curves;
                        FeatureSample { u, position: segment.point(u) }
                    }));
                }
            }
            self.samples[begin..].sort_unstable_by(|a, b| a.u.total_cmp(&b.u));
            // A silhouette point that falls on a sample, or that two faces share, is one sample.
            let mut kept = begin;
            for at in begin..self.samples.len() {
                if kept == begin || self.samples[at].u.total_cmp(&self.samples[kept - 1].u).is_ne() {
                    self.samples[kept] = self.samples[at];
                    kept += 1;
                }
            }
            self.samples.truncate(kept);
            self.first.push(kept as u32);
        }
    }

    /// The samples of the i-th feature edge, from its lower vertex to its higher.
    pub fn of(&self, index: usize) -> &[FeatureSample] {
        &self.samples[self.first[index] as usize..self.first[index + 1] as usize]
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.first.as_slice()) + size_of_val(self.samples.as_slice())
    }
}

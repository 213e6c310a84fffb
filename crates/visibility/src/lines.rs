//! [`Lines`]: what is found in one view.

use crate::chains::Chains;
use crate::outline::Outline;
use silhouette_core::Camera;
use silhouette_core::glam::DVec3;
use std::ops::Add;
use std::time::Duration;

/// The lines of one view.
#[derive(Debug, Clone, PartialEq)]
pub struct Lines {
    /// The view.
    pub camera: Camera,
    /// The lines, ordered by kind, invisibility and object.
    pub chains: Chains,
    /// The outline; empty unless asked for.
    pub outline: Outline,
    /// From where points and the camera count, in the coordinates of the meshes' files: the scene's
    /// [`origin`](silhouette_core::TriangleMesh::origin).
    pub origin: DVec3,
    /// What it cost.
    pub stats: LineStats,
}

/// What finding lines cost, stage by stage. Times are wall time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct LineStats {
    /// Finding the edges to draw and the contours that hide them.
    pub extract: Duration,
    /// Projecting, clipping and binning.
    pub project: Duration,
    /// Crossings, piercings and the decision of each piece.
    pub decide: Duration,
    /// Joining pieces to chains.
    pub chain: Duration,
    /// The outline.
    pub outline: Duration,
    /// Edges looked at.
    pub edges: u64,
    /// Contour edges that may hide something.
    pub contours: u64,
    /// Pairs of an edge and a contour tested exactly.
    pub pairs: u64,
    /// Places where invisibility may change.
    pub events: u64,
    /// Sight lines cast.
    pub sight_lines: u64,
    /// Pieces decided.
    pub pieces: u64,
}

impl Add for LineStats {
    type Output = Self;

    /// What several views cost together.
    fn add(self, other: Self) -> Self {
        Self {
            extract: self.extract + other.extract,
            project: self.project + other.project,
            decide: self.decide + other.decide,
            chain: self.chain + other.chain,
            outline: self.outline + other.outline,
            edges: self.edges + other.edges,
            contours: self.contours + other.contours,
            pairs: self.pairs + other.pairs,
            events: self.events + other.events,
            sight_lines: self.sight_lines + other.sight_lines,
            pieces: self.pieces + other.pieces,
        }
    }
}

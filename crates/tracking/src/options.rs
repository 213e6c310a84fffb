//! What a user of the tracker chooses.

use crate::as_printed::{LoopOrder, WalkStart};

/// Which concave edges are searched for new silhouettes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Concavity {
    /// Those whose interior angle exceeds `pi + N` (Hall, Concavity Level Tuning). `N` in radians, 0 to pi; 0 searches
    /// all of them, larger values are faster and miss more. `N` is an absolute angle: the same surface in smaller
    /// triangles has smaller angles, so a level does not carry over from one tessellation to another.
    Above(f32),
    /// None. Without a border this is Markosian's tracking (1997): no loop is found that did not come from an old one.
    Ignored,
}

/// How sure a user wants to be that no loop is missed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Accuracy {
    /// As sure as the concavity level makes it (Hall 2003).
    #[default]
    Level,
    /// Sure: every loop of every frame. Level, tested edges, jump, the start of walks and the order of loops
    /// then play no part.
    Exact,
    /// The level is set while tracking so that about this much is missed; [`TrackingOptions::concavity`] plays no part.
    Budget(ErrorBudget),
}

/// What tracking may miss, and what it may spend to find out what it missed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorBudget {
    /// Length of silhouette that may be missed, over the whole length, 0 to 1.
    pub missed_share: f32,
    /// Faces that audits may evaluate, over those that tracking evaluates, above 0.
    pub audit_share: f32,
}

/// How many edges of each old loop are tested.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TestedEdges {
    /// All of them: a loop that splits is followed into all its parts that hold an old edge or are reached by a walk.
    #[default]
    All,
    /// One, and more only while it leads to no loop that was not found already (Hall, Single edge testing). Parts that
    /// split off without a concave edge are missed.
    Single,
}

/// What happens to a mesh with edges that Hall excludes: three or more faces, or two that disagree on which side is
/// out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MeshPolicy {
    /// It is refused; the error names edges and faces.
    #[default]
    Refuse,
    /// It is cut open there: each face has a border of its own at such an edge, and ids stay those of the mesh given.
    Cut,
}

/// Options of a [`Tracker`](crate::Tracker).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrackingOptions {
    /// How sure it is that no loop is missed. Default: by level.
    pub accuracy: Accuracy,
    /// Which concave edges are searched. Default: all, `Above(0.0)`.
    pub concavity: Concavity,
    /// How many edges of each old loop are tested. Default: all.
    pub tested_edges: TestedEdges,
    /// What happens to a mesh that cannot be tracked as it is. Default: refuse.
    pub mesh_policy: MeshPolicy,
    /// The longest move of the eye, between two frames, that is tracked: over its distance from the middle of the mesh,
    /// or over the mesh's radius where the eye is nearer than that; for orthographic views, between unit directions. So
    /// it is about the angle in radians by which the view turns. What exceeds it is a jump, after which the silhouette
    /// is found by brute force. 0 or more; 0 tracks nothing but a resting eye. Default: 0.5.
    pub jump: f64,
    /// Where the walk to a moved silhouette starts. Default: corrected.
    pub walk_start: WalkStart,
    /// In which order the half-edges of a loop are listed. Default: corrected.
    pub loop_order: LoopOrder,
}

impl Default for TrackingOptions {
    fn default() -> Self {
        Self {
            accuracy: Accuracy::default(),
            concavity: Concavity::Above(0.0),
            tested_edges: TestedEdges::default(),
            mesh_policy: MeshPolicy::default(),
            jump: 0.5,
            walk_start: WalkStart::default(),
            loop_order: LoopOrder::default(),
        }
    }
}

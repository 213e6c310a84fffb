//! Options: of the [`Tracker`](crate::Tracker), and of the method [`Tracking`](crate::Tracking) in the words of the command
//! line.

use crate::as_printed::{LoopOrder, WalkStart};

/// Which concave edges are searched for new silhouettes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Concavity {
    /// Those whose interior angle exceeds `pi + N` (Hall, Concavity Level Tuning). `N` in radians, 0 to pi; 0 searches
    /// all of them, larger values are faster and miss more. `N` is an absolute angle: the same surface in smaller
    /// triangles has smaller angles, so a level does not carry over from one tessellation to another.
    Above(f32),
    /// None. Without a boundary this is Markosian's tracking (1997): no loop is found that did not come from an old one.
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
    /// The level is set while tracking so that about this much is missed; [`TrackerOptions::concavity`] plays no part.
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

silhouette_core::option_choice! {
    /// How many edges of each old loop are tested.
    pub enum TestedEdges {
        /// All of them: a loop that splits is followed into all its parts that hold an old edge or are reached by a walk.
        All = "all",
        /// One, and more only while it leads to no loop that was not found already (Hall, Single edge testing). Parts that
        /// split off without a concave edge are missed.
        Single = "single",
    }
}

silhouette_core::option_choice! {
    /// What happens to a mesh with edges that Hall excludes: three or more faces, or two that disagree on which side is
    /// out.
    pub enum MeshPolicy {
        /// It is refused; the error names edges and faces.
        Refuse = "refuse",
        /// It is cut open there: each face has a boundary edge at such an edge, and ids stay those of the given mesh.
        Cut = "cut",
    }
}

/// Options of a [`Tracker`](crate::Tracker).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrackerOptions {
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
    /// it is about the angle in radians by which the view turns. A longer move is a jump, after which the silhouette is
    /// found by brute force. 0 or more; 0 tracks nothing but a resting eye. Default: 0.5.
    pub jump: f64,
    /// Where the walk to a moved silhouette starts. Default: corrected.
    pub walk_start: WalkStart,
    /// In which order the half-edges of a loop are listed. Default: corrected.
    pub loop_order: LoopOrder,
}

impl Default for TrackerOptions {
    fn default() -> Self {
        TrackingOptions::default().into()
    }
}

silhouette_core::method_options! {
    /// Options of [`Tracking`](crate::Tracking), one field per word of the command line. [`TrackerOptions`] is what they
    /// come to; a tracker with [exact](Accuracy::Exact) answers is [`ExactTracking`](crate::ExactTracking).
    pub struct TrackingOptions {
        /// Only concave edges whose interior angle exceeds pi by more than this are searched for new loops: 0 searches all, pi
        /// or more none, which is fast and misses what is new.
        pub concavity_rad: f64 = number("concavity", 0.0..=3.2 "rad", default 0.0, sweep linear 0.0..=1.6),
        /// Share of the silhouette's length that may be missed. Above 0 it sets the level while tracking, by what audits see
        /// missed.
        pub missed_share: f64 = number("missed-share", 0.0..=1.0, default 0.0, sweep log 0.001..=0.3),
        /// Faces that audits may evaluate, over those that tracking evaluates.
        pub audit_share: f64 = number("audit-share", 1e-6..=1000.0, default 0.1, sweep log 0.01..=1.0),
        /// How many edges of each old loop are tested: all, or one and more only where it leads nowhere.
        pub tested_edges: TestedEdges = choice("tested-edges"),
        /// What happens to a mesh with edges that cannot be tracked across: it is refused, or cut there.
        pub mesh_policy: MeshPolicy = choice("mesh"),
        /// The eye's longest move, over its distance, that is tracked; 0 finds each frame by brute force.
        pub jump: f64 = number("jump", 0.0..=1000.0, default 0.5),
        /// Where walks to a grown silhouette start: at the face that became visible, or as printed.
        pub walk_start: WalkStart = choice("walk-start"),
    }
}

impl From<TrackingOptions> for TrackerOptions {
    fn from(options: TrackingOptions) -> Self {
        let missed_share = options.missed_share as f32;
        let budget = ErrorBudget { missed_share, audit_share: options.audit_share as f32 };
        Self {
            accuracy: if missed_share > 0.0 { Accuracy::Budget(budget) } else { Accuracy::Level },
            concavity: Concavity::Above(options.concavity_rad as f32),
            tested_edges: options.tested_edges,
            mesh_policy: options.mesh_policy,
            jump: options.jump,
            walk_start: options.walk_start,
            // Loops of a method run along their half-edges.
            loop_order: LoopOrder::Corrected,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::MethodOptions;

    #[test]
    fn words_come_to_the_options_of_a_tracker() {
        let tracker = |words: &[&str]| TrackerOptions::from(TrackingOptions::parse(words.iter().copied()).unwrap());
        assert_eq!(tracker(&[]).accuracy, Accuracy::Level);
        assert_eq!(tracker(&[]).concavity, Concavity::Above(0.0));
        assert_eq!(tracker(&["concavity=0.5"]).concavity, Concavity::Above(0.5));
        let budget = Accuracy::Budget(ErrorBudget { missed_share: 0.25, audit_share: 0.5 });
        assert_eq!(tracker(&["missed-share=0.25", "audit-share=0.5"]).accuracy, budget);
        let expected = TrackerOptions {
            tested_edges: TestedEdges::Single,
            mesh_policy: MeshPolicy::Cut,
            jump: 0.0,
            walk_start: WalkStart::AsPrinted,
            ..TrackerOptions::default()
        };
        assert_eq!(tracker(&["tested-edges=single", "mesh=cut", "jump=0", "walk-start=as-printed"]), expected);
    }
}

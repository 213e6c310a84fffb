//! T. Hall, "Silhouette Tracking", 2003: the table of the section Performance.
//!
//! The paper prints frames per second of a Pentium III, on three models of which one is available: the bunny, recognised by
//! its 69 451 faces (`printed`). Beside its speed-ups over brute force stand ours, counted in faces, which no machine
//! changes, and in wall time over brute force in the same run. The paper does not say what is missed; the same rows say it
//! here. Rows that it lacks follow: tracking without a concave list, with single edges, in its exact mode and with a budget,
//! and today's extractors.
//!
//! 1. `circles`: where the eye flies. `variants`: what flies there.
//! 2. `measure`: each variant over the path. `counted`: faces evaluated; `missed`: edges, loops and length missed;
//!    `visible`: visible length missed; `timed`: time.
//! 3. `rows`: the table.

mod circles;
mod counted;
mod measure;
mod missed;
mod printed;
mod rows;
mod timed;
mod variants;
mod visible;

use crate::error::PaperError;
use crate::paper::{Measured, Paper, Run};
use silhouette_core::Method;
use silhouette_tracking::Tracking;

/// The paper.
pub static PAPER: Paper = Paper {
    name: Tracking::INFO.name,
    source: Tracking::INFO.source,
    about: "The paper's speed-ups over its own brute force stand beside ours, and beside what it does not print: how much \
            of the silhouette is missed.",
    reading: &[
        "N is the concavity level in radians: only edges whose interior angle exceeds π + N are searched for new loops. It \
         is an absolute angle, so that the same surface in smaller triangles loses more at the same N.",
        "The paper does not describe the path of its eye, and counts at high levels follow the length of the silhouette, \
         which the path decides. Counts are therefore ranges over twenty circles, 1.5 to 20 radii away and from 40 degrees \
         below the horizon to 80 above; each flight begins with a frame found by brute force, which is not counted.",
        "Everything else is measured on one of these circles, chosen by a rule that does not look at the figures: the \
         middle distance, level with the mesh. The measured frames are twelve arcs around the mesh. Between them, and for a \
         whole turn before, the eye flies on in steps of a degree: trackers keep their past, and what they miss is what is \
         missed after any long flight.",
        "Each variant flies the whole path before the next one does, several times in turn; a frame's time is its least. \
         Brute force and tracking use the same planes and the same walk along loops. Hall's brute force evaluates one face \
         after the other; in fours, four at a time, as tracking does. Tracking yields loops in the order in which it finds \
         them; loops of other methods are in a fixed order, edges are sorted and say nothing of loops.",
    ],
    default_meshes: &["builtin:blob:20000"],
    needs_gpu: false,
    measure,
};

fn measure(run: &Run<'_>) -> Result<Measured, PaperError> {
    Ok(rows::measured(run.profile, &measure::meshes(run)?))
}

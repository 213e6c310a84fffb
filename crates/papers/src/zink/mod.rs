//! J. Zink, "Fast Silhouettes", GameDev.net 2006: an edge mesh, in numbers that the article does not print.
//!
//! The article has no table. It says that the method is fast, and gives the arithmetic; what follows from both is measured, on
//! the meshes that are named and on a set of hard edges, beside what engines ship for outlines.
//!
//! 1. `printed`: the arithmetic of the article. `methods`: what is drawn.
//! 2. `sizes`: the edge mesh beside the mesh. `width_law`: how wide the article's lines come out, derived and drawn.
//! 3. `accuracy`: every method against the exact visible lines. `frames`: what a frame costs.

mod accuracy;
mod frames;
mod methods;
mod printed;
mod sizes;
mod width_law;

use crate::error::PaperError;
use crate::paper::{Measured, Paper, Run};
use silhouette_compare::Profile;
use silhouette_core::Method;
use silhouette_edge_mesh::EdgeMesh;

/// The paper.
pub static PAPER: Paper = Paper {
    name: EdgeMesh::INFO.name,
    source: EdgeMesh::INFO.source,
    about: "The article prints no measurement. Its edge mesh and ours stand beside the mesh in bytes, beside the exact visible \
            lines, and beside plain rendering in time; with them what engines use for outlines.",
    reading: &[
        "Lines are asked for 2 pixels wide. The article's lines have no width of their own: it follows from the field of view, the \
         resolution and the angle between the faces of an edge.",
        "Missed, spurious and closed corners are those of `docs/METRICS.md`, at 1 pixel; true lines are drawn with each method's own \
         pen. Jump flood draws the outline of the whole object alone, so that inner lines count as missed.",
        "Plain rendering draws all faces once, in one colour.",
    ],
    default_meshes: &["builtin:blob:20000", "builtin:knot"],
    needs_gpu: true,
    measure,
};

/// How much is measured.
struct Extent {
    /// Views per mesh; tables report median and range.
    views: u32,
    rounds: u32,
    /// Heights of the pictures in which widths are measured.
    heights: &'static [u32],
    /// The mesh whose frames are timed besides those that are named.
    largest: Option<&'static str>,
}

impl Extent {
    fn of(profile: Profile) -> Self {
        match profile {
            Profile::Quick => Self { views: 3, rounds: 5, heights: &[256, 512, 1024], largest: None },
            Profile::Full => Self { views: 8, rounds: 9, heights: &[512, 1024, 4096], largest: Some("blob:1100000") },
        }
    }
}

fn measure(run: &Run<'_>) -> Result<Measured, PaperError> {
    let (gpu, extent) = (run.gpu()?, Extent::of(run.profile));
    let size = run.profile.size();
    let mut tables = sizes::by_mesh(run)?;
    tables.push(width_law::measure(gpu, run, extent.heights)?);
    tables.extend(accuracy::by_mesh(gpu, run, extent.views, size)?);
    tables.extend(frames::by_mesh(gpu, run, extent.rounds, size, extent.largest)?);
    Ok(Measured {
        setting: format!("{} x {} pixels unless a table says otherwise", size[0], size[1]),
        tables,
        ..Measured::default()
    })
}

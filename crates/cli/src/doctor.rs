//! `silhouettes doctor`: which adapter draws, what runs where, and the remedy where nothing does.

use crate::failure::Failure;
use crate::output::Output;
use silhouette_compare::registry::{self, Yields};
use silhouette_render::{AdapterChoice, Gpu};
use std::fmt::Write;

/// Runs the command. Without an adapter it still lists what works, and fails with the remedy.
pub fn run() -> Result<(), Failure> {
    let gpu = AdapterChoice::from_env().and_then(Gpu::new);
    let mut text = format!("silhouettes {}\n", env!("CARGO_PKG_VERSION"));
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let _ = writeln!(text, "processor   {}, {threads} threads", std::env::consts::ARCH);
    match &gpu {
        Ok(gpu) => {
            let adapter = gpu.adapter();
            let _ = writeln!(text, "adapter     {adapter}");
            let times = if adapter.timestamps { "measured on the adapter" } else { "wall time only" };
            let _ = writeln!(text, "pass times  {times}");
            let _ = writeln!(text, "pictures    up to {0} x {0} pixels", adapter.max_texture_px);
        }
        Err(_) => text.push_str("adapter     none\n"),
    }
    text.push_str("\nmethod            needs        runs on\n");
    for entry in registry::all() {
        let needs = if entry.info.needs.is_empty() { "triangles".to_owned() } else { entry.info.needs.join(", ") };
        let place = match (entry.yields, gpu.is_ok()) {
            (Yields::Edges | Yields::Loops, true) => "processor; drawn on the adapter",
            (Yields::Edges | Yields::Loops, false) => "processor",
            (Yields::Lines, true) => "adapter",
            (Yields::Lines, false) => "nothing here",
        };
        let _ = writeln!(text, "{:<17} {needs:<12} {place}", entry.info.name);
    }
    Output::Stdout.write(text.as_bytes())?;
    gpu.map(drop).map_err(Failure::gpu)
}

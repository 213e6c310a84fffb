//! `silhouettes doctor`: which adapter draws, what runs where, and the remedy where nothing does.

use crate::failure::Failure;
use crate::output::Output;
use silhouette_compare::registry::{Capabilities, Registry};
use silhouette_render::{AdapterChoice, Gpu};
use std::fmt::Write;

/// Runs the command. Without an adapter it still lists what works, and fails with the remedy.
pub fn run(registry: &Registry) -> Result<(), Failure> {
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
    let _ = writeln!(text, "\n{:<17} {:<13} {:<14} runs on", "method", "needs", "yields");
    for entry in registry.entries() {
        let info = entry.info();
        let needs = if info.needs.is_empty() { "triangles".to_owned() } else { info.needs.join(", ") };
        let can = entry.capabilities();
        let _ = writeln!(text, "{:<17} {needs:<13} {:<14} {}", info.name, yields(can), place(can, gpu.is_ok()));
    }
    Output::Stdout.write(text.as_bytes())?;
    gpu.map(drop).map_err(Failure::gpu)
}

/// What a method yields, separated by commas.
fn yields(can: Capabilities) -> String {
    let named =
        [(can.edges, "edges"), (can.loops, "loops"), (can.curves, "curves"), (can.lines, "lines"), (can.fill, "fill")];
    named.into_iter().filter_map(|(has, name)| has.then_some(name)).collect::<Vec<_>>().join(", ")
}

/// Where a method runs on this machine.
fn place(can: Capabilities, has_adapter: bool) -> &'static str {
    match (can.edges || can.curves, has_adapter) {
        (true, true) => "processor; drawn on the adapter",
        (true, false) => "processor",
        (false, true) => "adapter",
        (false, false) => "nothing here",
    }
}

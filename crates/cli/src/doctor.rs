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
    text.push('\n');
    text.push_str(&methods(registry, gpu.is_ok()));
    Output::Stdout.write(text.as_bytes())?;
    gpu.map(drop).map_err(Failure::gpu)
}

/// One row per method, its columns as wide as their longest entry.
fn methods(registry: &Registry, has_adapter: bool) -> String {
    let mut rows = vec![["method", "needs", "yields", "runs on"].map(str::to_owned)];
    for entry in registry.entries() {
        let (info, can) = (entry.info(), entry.capabilities());
        let needs = if info.needs.is_empty() { "triangles".to_owned() } else { info.needs.join(", ") };
        rows.push([info.name.to_owned(), needs, yields(can), place(can, has_adapter).to_owned()]);
    }
    let [name, needs, yields] = [0, 1, 2].map(|column| rows.iter().map(|row| row[column].len()).max().unwrap_or(0));
    rows.iter().map(|[a, b, c, d]| format!("{a:<name$}  {b:<needs$}  {c:<yields$}  {d}\n")).collect()
}

/// What a method yields, separated by commas.
fn yields(can: Capabilities) -> String {
    let named = [
        (can.edges, "edges"),
        (can.loops, "loops"),
        (can.curves, "curves"),
        (can.lines, "lines"),
        (can.fill, "fill"),
        (can.triangles, "triangles"),
    ];
    named.into_iter().filter_map(|(has, name)| has.then_some(name)).collect::<Vec<_>>().join(", ")
}

/// Where a method runs on this machine.
fn place(can: Capabilities, has_adapter: bool) -> &'static str {
    match (can.edges || can.curves || can.triangles, has_adapter) {
        (true, true) => "processor; drawn on the adapter",
        (true, false) => "processor",
        (false, true) => "adapter",
        (false, false) => "nothing here",
    }
}

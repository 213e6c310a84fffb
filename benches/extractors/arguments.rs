//! The command line.

use clap::Parser;
use std::path::{Path, PathBuf};

/// Extraction times of all methods, interleaved.
#[derive(Debug, Parser)]
#[command(name = "extractors")]
pub struct Arguments {
    /// Mesh files or builtin:NAME [default: blobs of a thousand to a million faces, and models]
    meshes: Vec<String>,
    /// Views over a turn; 0 measures nothing and shows only the rows of --peers
    #[arg(long, value_name = "N", default_value_t = 40)]
    pub views: u32,
    /// Threads that methods may use
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub threads: u32,
    /// File for the measured rows, JSON Lines
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// File for the plot of time over faces (.svg)
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Rows of earlier runs or other tools, for the table and the plot; may be given several times
    #[arg(long, value_name = "FILE")]
    pub peers: Vec<PathBuf>,
    /// What `cargo bench` passes
    #[arg(long, hide = true)]
    bench: bool,
}

/// Sizes a factor of four apart.
const BLOBS: [&str; 6] = [
    "builtin:blob:1000",
    "builtin:blob:4000",
    "builtin:blob:16000",
    "builtin:blob:64000",
    "builtin:blob:256000",
    "builtin:blob:1024000",
];

/// Models that are measured where the folder of models holds them.
const MODELS: [&str; 2] = ["stanford-bunny.obj", "armadillo.obj"];

impl Arguments {
    /// Names of the meshes to measure, in their order.
    pub fn meshes(&self) -> Vec<String> {
        if self.views == 0 {
            return Vec::new();
        }
        if !self.meshes.is_empty() {
            return self.meshes.clone();
        }
        let folder = std::env::var_os("SILHOUETTES_MODELS");
        let models = folder.iter().flat_map(|folder| MODELS.map(|model| Path::new(folder).join(model)));
        let models = models.filter(|path| path.is_file()).map(|path| path.to_string_lossy().into_owned());
        BLOBS.map(str::to_owned).into_iter().chain(models).collect()
    }
}

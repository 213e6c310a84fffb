//! The command line.

use clap::Parser;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Extraction times of all methods, interleaved.
#[derive(Debug, Parser)]
#[command(name = "extractors")]
pub struct Arguments {
    /// Mesh files or builtin:NAME, with +loopN behind it Loop-subdivided N times, each to four times the faces [default:
    /// blobs of a thousand to a million faces, and the bunny and the armadillo of the folder SILHOUETTES_MODELS]
    #[arg(value_name = "MESH[+loopN]")]
    meshes: Vec<String>,
    /// Views over a turn; 0 measures nothing: it writes --export of the meshes named and shows the rows of --peers
    #[arg(long, value_name = "N", default_value_t = 40)]
    pub views: u32,
    /// Threads that methods may use; several numbers, as 1,2, are measured in turn within each view
    #[arg(long, value_name = "N[,N...]", default_value = "1", value_delimiter = ',',
          value_parser = clap::value_parser!(u32).range(1..=1024))]
    threads: Vec<u32>,
    /// Folder for the meshes as binary PLY, for benches/peers; made where there is none
    #[arg(long, value_name = "DIR")]
    pub export: Option<PathBuf>,
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
    /// Names of the meshes to measure or to export, in their order.
    pub fn meshes(&self) -> Vec<String> {
        if !self.meshes.is_empty() || self.views == 0 {
            return self.meshes.clone();
        }
        let folder = std::env::var_os("SILHOUETTES_MODELS");
        let models = folder.iter().flat_map(|folder| MODELS.map(|model| Path::new(folder).join(model)));
        let models = models.filter(|path| path.is_file()).map(|path| path.to_string_lossy().into_owned());
        BLOBS.map(str::to_owned).into_iter().chain(models).collect()
    }
    /// Numbers of threads to measure, in their order, each once.
    pub fn threads(&self) -> Vec<u32> {
        let mut seen = BTreeSet::new();
        self.threads.iter().copied().filter(|&count| seen.insert(count)).collect()
    }
}

//! The command line.

use clap::Parser;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Times of exact visible lines.
#[derive(Debug, Parser)]
#[command(name = "visible_lines")]
pub struct Arguments {
    /// Mesh files or builtin:NAME, with +loopN behind it Loop-subdivided N times, each to four times the faces; the first
    /// is the one that times are stated as ratios to [default: of the folder SILHOUETTES_MODELS the bunny, the armadillo
    /// and the bunny+loop2; a blob of 1.1 million faces, and without the folder one of 70 thousand before it]
    #[arg(value_name = "MESH[+loopN]")]
    meshes: Vec<String>,
    /// Views over a turn, and runs of the view that peers are given
    #[arg(long, value_name = "N", default_value_t = 24, value_parser = clap::value_parser!(u32).range(1..))]
    pub views: u32,
    /// Threads to use; several numbers, as 1,2, are measured in turn within each view
    #[arg(long, value_name = "N[,N...]", default_value = "1,2", value_delimiter = ',',
          value_parser = clap::value_parser!(u32).range(1..=1024))]
    threads: Vec<u32>,
    /// File for the measured rows, JSON Lines
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Rows of other tools, of benches/peers, for the table; may be given several times
    #[arg(long, value_name = "FILE")]
    pub peers: Vec<PathBuf>,
    /// What `cargo bench` passes
    #[arg(long, hide = true)]
    bench: bool,
}

/// Models that are measured where the folder of models holds them, with the levels of subdivision behind them.
const MODELS: [(&str, &str); 3] = [("stanford-bunny.obj", ""), ("armadillo.obj", ""), ("stanford-bunny.obj", "+loop2")];

/// As many faces as the bunny has, for machines without it.
const SMALL_BLOB: &str = "builtin:blob:70000";

const LARGE_BLOB: &str = "builtin:blob:1100000";

impl Arguments {
    /// Names of the meshes to measure, in their order.
    pub fn meshes(&self) -> Vec<String> {
        if !self.meshes.is_empty() {
            return self.meshes.clone();
        }
        let folder = std::env::var_os("SILHOUETTES_MODELS");
        let named =
            folder.iter().flat_map(|folder| MODELS.map(|(model, levels)| (Path::new(folder).join(model), levels)));
        let files = named.filter(|(path, _)| path.is_file());
        let mut meshes: Vec<String> =
            files.map(|(path, levels)| format!("{}{levels}", path.to_string_lossy())).collect();
        if meshes.is_empty() {
            meshes.push(SMALL_BLOB.to_owned());
        }
        meshes.push(LARGE_BLOB.to_owned());
        meshes
    }

    /// Numbers of threads to measure, in their order, each once.
    pub fn threads(&self) -> Vec<u32> {
        let mut seen = BTreeSet::new();
        self.threads.iter().copied().filter(|&count| seen.insert(count)).collect()
    }
}

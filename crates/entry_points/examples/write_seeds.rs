//! Writes the seeds of all entry points: a folder for each below the one that is named.
//!
//!     cargo run -p silhouette-entry-points --example write_seeds -- data/seeds

use silhouette_entry_points::{ALL, seeds};
use std::path::PathBuf;

fn main() -> std::io::Result<()> {
    let target = std::env::args_os().nth(1).map_or_else(|| PathBuf::from("data/seeds"), PathBuf::from);
    for (name, _) in ALL {
        let folder = target.join(name);
        std::fs::create_dir_all(&folder)?;
        for (seed, bytes) in seeds::of(name) {
            std::fs::write(folder.join(seed), bytes)?;
        }
    }
    Ok(())
}

//! Writes the tables of `docs/STABILITY.md`.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "what was found, and what went wrong, is the output")]

use clap::Parser;
use silhouette_docs::region;
use silhouette_extremes::{families, growth, matrix, page, show};
use silhouette_render::{AdapterChoice, Gpu};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Write the tables of docs/STABILITY.md anew, from what every method does at every extreme. Some minutes.
#[derive(Debug, Parser)]
struct Arguments {
    /// Only say what is not as expected, or not as the page says; exit code 1 where there is any
    #[arg(long)]
    check: bool,
    /// Draw the charts of growing errors, too
    #[arg(long, conflicts_with = "check")]
    charts: bool,
    /// Write what every method draws, and the truth beside it, as PNG files into this folder; no table is written
    #[arg(long, value_name = "DIR", conflicts_with_all = ["check", "charts"])]
    pictures: Option<PathBuf>,
    /// Look at the families alone whose title contains this
    #[arg(long, value_name = "WORD", default_value = "")]
    family: String,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("silhouette-extremes: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<ExitCode, Box<dyn Error + Send + Sync>> {
    let gpu = Gpu::new(AdapterChoice::from_env()?)?;
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(page::FILE);
    if arguments.charts {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(growth::FOLDER);
        std::fs::create_dir_all(&folder)?;
        for chart in growth::exact_charts().into_iter().chain(growth::drawn_charts(&gpu)) {
            std::fs::write(folder.join(chart.file), chart.svg())?;
            println!("{}/{}", growth::FOLDER, chart.file);
        }
    }
    let mut is_as_expected = true;
    for family in families::ALL.iter().filter(|family| family.title.contains(&arguments.family)) {
        let rows = (family.rows)();
        if let Some(folder) = &arguments.pictures {
            show::write_pictures(&gpu, &rows, folder)?.iter().for_each(|refusal| println!("{refusal}"));
            continue;
        }
        let cells = matrix::run(&gpu, &rows);
        let surprises = matrix::surprises(&rows, &cells);
        surprises.iter().for_each(|surprise| println!("{surprise}"));
        is_as_expected &= surprises.is_empty();
        let committed = std::fs::read_to_string(&file)?;
        let made = region::replaced(&committed, family.title, &page::section(family, &rows, &cells))?;
        if page::comparable(&committed) == page::comparable(&made) {
            continue;
        }
        if arguments.check {
            println!("{}: {} is not up to date; run cargo run -p silhouette-extremes", page::FILE, family.title);
            is_as_expected = false;
        } else {
            std::fs::write(&file, made)?;
            println!("{}: {}", page::FILE, family.title);
        }
    }
    Ok(if is_as_expected { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

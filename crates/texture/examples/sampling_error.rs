//! How much of the sphere a baked texture gets wrong (equation 3):
//! `cargo run --release -p silhouette-texture --example sampling_error -- MESH FILE.siltex [POINTS]`, for OBJ, PLY and OFF files.

#![allow(clippy::print_stdout, reason = "an example that prints")]

use silhouette_core::{NoProgress, load};
use silhouette_texture::sampling_error::{ErrorOptions, sampling_error};
use silhouette_texture::{VisibilityFunction, siltex};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [mesh, file, rest @ ..] = &arguments[..] else { return Err("give a mesh and its .siltex file".into()) };
    let points = rest.first().map_or(Ok(ErrorOptions::default().points), |text| text.parse())?;
    let mesh = load::load(mesh.as_ref())?;
    let texture = siltex::read(file.as_ref())?.texture;
    let visibility = VisibilityFunction::new(&mesh, &texture.parts().hull, texture.parts().rule);
    let options = ErrorOptions { points, ..ErrorOptions::default() };
    let error = sampling_error(&texture, &visibility, &options, &NoProgress)?;
    let [mean, deviation, excess, missing, shown] =
        [error.mean, error.standard_error, error.excess, error.missing, error.shown].map(|share| 100.0 * share);
    println!(
        "{mean:.3} % of the sphere (± {deviation:.3}): {excess:.3} % too much, {missing:.3} % too little; {shown:.1} % shown"
    );
    Ok(())
}

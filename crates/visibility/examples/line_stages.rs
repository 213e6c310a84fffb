//! Times the lines of one view, stage by stage: `cargo run --release -p silhouette-visibility --example line_stages -- MESH...`
//!
//! Each mesh is prepared once and seen from three quarters as the command line sees it, then from 19 more places on a
//! circle about it; the stages are those of the median.

use silhouette_core::glam::{Mat3, Vec3};
use silhouette_core::view::{Framing, ViewPreset};
use silhouette_core::{Camera, NoProgress, PreparedMesh, load};
use silhouette_visibility::{LineFinder, LineOptions, LineScene, Lines};
use std::sync::Arc;
use std::time::{Duration, Instant};

const RUNS: usize = 20;

/// A turn about the vertical axis, a full circle in all.
fn turn(run: usize) -> Mat3 {
    Mat3::from_rotation_y(run as f32 * std::f32::consts::TAU / RUNS as f32)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for path in std::env::args().skip(1) {
        let started = Instant::now();
        let mesh = load::load(path.as_ref())?;
        let loaded = started.elapsed();
        let bounds = mesh.bounds().ok_or("the mesh has no face")?;
        let (direction, up): (_, Vec3) = ViewPreset::ThreeQuarter.directions();
        let fov_y_rad = 40_f64.to_radians();
        let camera = Camera::framing(&bounds, direction, up, Framing::Perspective { fov_y_rad }, [1024, 1024])?;
        let faces = mesh.face_count();
        let started = Instant::now();
        let scene = LineScene::new(Arc::new(PreparedMesh::new(mesh)));
        let mut finder = LineFinder::for_many_views(scene, &NoProgress)?;
        let prepared = started.elapsed();
        let mut runs: Vec<(Duration, Lines)> = Vec::new();
        for run in 0..RUNS {
            let turned = turn(run).mul_vec3(camera.eye() - camera.target());
            let camera =
                Camera::new(camera.target() + turned, camera.target(), up, camera.projection(), camera.size())?;
            let started = Instant::now();
            let lines = finder.find(&camera, &LineOptions::default(), &NoProgress)?;
            runs.push((started.elapsed(), lines));
        }
        let first = runs[0].0;
        runs.sort_by_key(|(time, _)| *time);
        let (median, lines) = &runs[RUNS / 2];
        print(&path, faces, [loaded, prepared, first, *median], lines);
    }
    Ok(())
}

#[allow(clippy::print_stdout, reason = "an example's output")]
fn print(path: &str, faces: usize, [loaded, prepared, first, median]: [Duration; 4], lines: &Lines) {
    println!(
        "{path}: {faces} faces; loaded {loaded:.1?}, prepared {prepared:.1?}, first {first:.2?}, median {median:.2?}"
    );
    println!("  {:?}", lines.stats);
    let length: f64 = lines.chains.iter().map(|chain| chain.length_px()).sum();
    println!("  {} chains, {} points, {length:.0} px", lines.chains.len(), lines.chains.point_count());
}
